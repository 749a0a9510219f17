// @ts-check
// Cuts the model open by a plane. What is seen of its inside has one flat tone. The cut stays when the controls are closed.

import { section } from '../marks/section.js';
import { labelled, make } from './make.js';

/** @import { Axis } from '../marks/planes.js' */
/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Place } from './place.js' */

/** @type {[Axis, string][]} */
const AXES = [['x', 'X axis'], ['y', 'Y axis'], ['z', 'Z axis'], ['view', 'Towards me']];
const STEPS = 1000;

/** @param {JsmViewerElement} viewer @param {Session} session @param {Place} place */
export async function use(viewer, session, place) {
  const cut = await section(viewer, session, place);
  if (cut === null) return undefined;
  const axis = make('select');
  for (const [value, text] of AXES) axis.append(new Option(text, value));
  const slider = make('input');
  Object.assign(slider, { type: 'range', min: '0', max: String(STEPS), step: '1' });
  const flip = make('button', '', 'The other side');
  const off = make('button', '', 'Whole again');
  const buttons = make('div', 'pair');
  for (const button of [flip, off]) button.type = 'button';
  buttons.append(flip, off);
  place.element.append(labelled('Across', axis), labelled('Position', slider), buttons);
  place.element.classList.add('section');
  const show = () => {
    axis.value = cut.wish.axis;
    slider.value = String(Math.round(cut.wish.share * STEPS));
    slider.setAttribute('aria-valuetext', `${Math.round(100 * cut.wish.share)} percent`);
    off.disabled = !cut.isOn;
  };
  // Whoever opens the tool wants to see inside.
  if (!cut.isOn) cut.change({});
  axis.addEventListener('change', () => cut.change({ axis: /** @type {Axis} */ (axis.value) }));
  slider.addEventListener('input', () => cut.change({ share: Number(slider.value) / STEPS }));
  flip.addEventListener('click', () => cut.change({ isFlipped: !cut.wish.isFlipped }));
  off.addEventListener('click', () => {
    cut.end();
    axis.focus();
  });
  cut.addEventListener('change', show);
  show();
  return () => cut.removeEventListener('change', show);
}

/** Shows what the address says, without controls. @param {JsmViewerElement} viewer @param {Session} session @param {Place} place */
export async function restore(viewer, session, place) {
  await section(viewer, session, place);
}
