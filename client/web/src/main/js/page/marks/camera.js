// @ts-check
// Brings the camera to a place of the model.

import { wantsMotion } from '../../session/motion.js';
import { lain, stood } from './space.js';
import { difference, sum } from '../../viewer/vectors.js';

/** @import { Orbit } from '../../viewer/orbit.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Annotation } from './annotation-format.js' */

/** Where the camera is, in the coordinates of the model. @param {Orbit} orbit */
export function cameraOf(orbit) {
  const { eye, target } = orbit.camera;
  const { center } = orbit.sphere;
  const laid = (/** @type {Vector} */ at) => sum(center, lain(orbit, difference(at, center)));
  return { eye: laid(eye), target: laid(target) };
}

/**
 * Flies to where an annotation is seen; at once where the system asks for less motion.
 *
 * @param {Orbit} orbit
 * @param {Pick<Annotation, 'camera' | 'point'>} annotation
 */
export function flyTo(orbit, { camera, point }) {
  if (camera === null) {
    orbit.moveTo({ target: stood(orbit, point) });
  } else {
    const target = stood(orbit, camera.target);
    const [x, y, z] = difference(stood(orbit, camera.eye), target);
    const radius = Math.hypot(x, y, z);
    const { theta } = orbit.pose;
    // The shorter way round.
    const turn = Math.atan2(x, z) - theta;
    orbit.moveTo({ target, radius, phi: Math.acos(y / radius), theta: theta + turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)) });
  }
  if (!wantsMotion()) orbit.jump();
}
