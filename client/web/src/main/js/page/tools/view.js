// @ts-check
// What every link to a view has: where the camera is, and how the model is drawn.

import { UNCOVERED } from '../../viewer/orbit.js';
import { typed } from '../elements.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Orbit } from '../../viewer/orbit.js' */
/** @import { State } from './state.js' */

const DEGREES = Math.PI / 180;

/**
 * @param {State} state
 * @param {JsmViewerElement} viewer
 * @param {Session} session
 */
export function addView(state, viewer, session) {
  const { view } = viewer;
  if (view === null) return;
  state.add('camera', { write: () => writeCamera(view.orbit), read: (text) => takeCamera(text, view.orbit, session) });
  state.add('shading', {
    write: () => (view.shading === 'smooth' ? null : view.shading),
    read: (text) => {
      const control = typed('shading', HTMLSelectElement);
      if ([...control.options].some(({ value }) => value === text)) choose(control, text);
    },
  });
  state.add('wireframe', {
    write: () => (viewer.hasAttribute('wireframe') ? 'on' : null),
    read: (text) => tick(typed('wireframe', HTMLInputElement), text === 'on'),
  });
}

/**
 * The first part of an archive knows the bounds of the model less well: unless somebody moves the camera meanwhile, it is
 * placed anew when the whole header has come.
 *
 * @param {string} text
 * @param {Orbit} orbit
 * @param {Pick<Session, 'figures' | 'addEventListener' | 'removeEventListener'>} session
 */
export function takeCamera(text, orbit, session) {
  readCamera(text, orbit);
  const { moves } = orbit;
  const look = () => {
    if (!session.figures.header?.whole) return;
    session.removeEventListener('change', look);
    if (orbit.moves === moves) readCamera(text, orbit);
  };
  session.addEventListener('change', look);
}

/**
 * Angles in degrees; the distance as a share of that from which all of the model is seen, so that windows of any shape show as
 * much of it; and the target from the middle of the model in halves of its diagonal.
 *
 * @param {Pick<Orbit, 'isTouched' | 'pose' | 'sphere' | 'framingRadius'>} orbit
 * @returns {string | null} null while all of the model is shown
 */
export function writeCamera(orbit) {
  if (!orbit.isTouched) return null;
  const { pose, sphere } = orbit;
  const { theta, phi, radius, target } = pose;
  const turned = ((theta / DEGREES) % 360) + (theta < 0 ? 360 : 0);
  const moved = target.map((at, i) => (at - sphere.center[i]) / sphere.radius);
  return [turned, phi / DEGREES, radius / orbit.framingRadius(UNCOVERED), ...moved].map((number) => String(Number(number.toFixed(4)))).join(',');
}

/**
 * @param {string} text
 * @param {Pick<Orbit, 'moveTo' | 'jump' | 'sphere' | 'framingRadius'>} orbit
 */
export function readCamera(text, orbit) {
  const numbers = text.split(',').map(Number);
  const [theta, phi, share, ...moved] = numbers;
  if (numbers.length !== 6 || !numbers.every(Number.isFinite) || share <= 0) return;
  const { center, radius } = orbit.sphere;
  const [x, y, z] = moved.map((by, i) => center[i] + by * radius);
  orbit.moveTo({ theta: theta * DEGREES, phi: phi * DEGREES, target: [x, y, z] });
  orbit.moveTo({ radius: share * orbit.framingRadius(UNCOVERED) });
  orbit.jump();
}

/** @param {HTMLSelectElement} control @param {string} value */
function choose(control, value) {
  control.value = value;
  control.dispatchEvent(new Event('change'));
}

/** @param {HTMLInputElement} control @param {boolean} on */
function tick(control, on) {
  control.checked = on;
  control.dispatchEvent(new Event('change'));
}
