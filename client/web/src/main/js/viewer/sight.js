// @ts-check
// How far what is shown is off where it is seen.

/** @import { Figures } from '../session/figures.js' */
/** @import { Orbit } from './orbit.js' */

/** Who is off by no more cannot be told from the original. */
const UNSEEN_PIXELS = 0.5;
/** The eye is taken to be no nearer to the model, in halves of its diagonal. */
const NEAREST = 1e-3;

/**
 * How far 99.9% of the surface is off at most where the model is nearest to the eye, in pixels of the screen; infinite
 * before that is known.
 *
 * @param {Pick<Figures, 'errorQuantile'>} figures
 * @param {{ orbit: Pick<Orbit, 'camera' | 'sphere'>, size: { height: number, pixelRatio: number } }} view
 */
export function pixelError({ errorQuantile }, { orbit, size }) {
  if (errorQuantile === null) return Infinity;
  const { center, radius } = orbit.sphere;
  const { eye, fieldOfView } = orbit.camera;
  const away = Math.hypot(...eye.map((at, axis) => at - center[axis])) - radius;
  const slope = Math.tan((fieldOfView * Math.PI) / 360);
  const off = (errorQuantile / 100) * 2 * radius;
  return (off * size.height * size.pixelRatio) / (2 * slope * Math.max(away, NEAREST * radius));
}

/**
 * Whether what is shown looks like the original at its size.
 *
 * @param {Pick<Figures, 'errorQuantile'>} figures
 * @param {Parameters<typeof pixelError>[1]} view
 */
export function isAsGood(figures, view) {
  return pixelError(figures, view) <= UNSEEN_PIXELS;
}
