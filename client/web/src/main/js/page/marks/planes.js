// @ts-check
// Planes that cut a model.

import { dot, scaled } from '../../viewer/vectors.js';

/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Cut } from './cut.js' */
/** @typedef {'x' | 'y' | 'z' | 'view'} Axis */
/** @typedef {{ axis: Axis, direction: Vector, share: number, isFlipped: boolean }} Wish `direction` is that of sight, in the model's coordinates, when the plane was chosen; `share` of the model that stays, 0 to 1 */

/** @type {Record<'x' | 'y' | 'z', Vector>} */
const DIRECTIONS = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const DIGITS = 4;

/** @type {Wish} */
export const START = { axis: 'x', direction: [0, 0, 1], share: 0.5, isFlipped: false };

/**
 * @param {Wish} wish
 * @param {number[]} bounds smallest x, y, z, then largest
 * @returns {Cut}
 */
export function planeOf({ axis, direction, share, isFlipped }, bounds) {
  const along = axis === 'view' ? direction : DIRECTIONS[axis];
  const ends = [0, 1, 2].map((i) => [along[i] * bounds[i], along[i] * bounds[i + 3]]);
  const least = ends.reduce((sum, pair) => sum + Math.min(...pair), 0);
  const most = ends.reduce((sum, pair) => sum + Math.max(...pair), 0);
  const at = least + share * (most - least);
  return isFlipped ? { normal: scaled(along, -1), at: -at } : { normal: along, at };
}

/** As a part of an address. @param {Wish} wish */
export function textOf({ axis, direction, share, isFlipped }) {
  const numbers = (axis === 'view' ? [share, ...direction] : [share]).map((number) => String(Number(number.toFixed(DIGITS))));
  return [`${isFlipped ? '-' : ''}${axis}`, ...numbers].join(',');
}

/**
 * Null where the text is anything else.
 *
 * @param {string} text
 * @returns {Wish | null}
 */
export function wishOf(text) {
  const [name, ...parts] = text.split(',');
  const axis = /** @type {Axis} */ (name.replace(/^-/, ''));
  const [share, ...direction] = parts.map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (!(share >= 0 && share <= 1)) return null;
  const isFlipped = name.startsWith('-');
  if (axis !== 'view') return Object.hasOwn(DIRECTIONS, axis) && direction.length === 0 ? { ...START, axis, share, isFlipped } : null;
  const [x, y, z] = direction;
  const length = Math.hypot(x, y, z);
  if (direction.length !== 3 || !(length > 0 && length < Infinity)) return null;
  return { axis, direction: scaled([x, y, z], 1 / length), share, isFlipped };
}

/** How far before a plane a point lies. @param {Cut} cut @param {Vector} point */
export function before({ normal, at }, point) {
  return at - dot(normal, point);
}
