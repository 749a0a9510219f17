// @ts-check
// The plane that cuts the model, as all tools know it.

import { dot } from '../../viewer/vectors.js';

/** @import { Vector } from '../../viewer/vectors.js' */
/** @typedef {{ normal: Vector, at: number }} Cut in the coordinates of the model: what lies farther along the normal is cut away */

/** @type {Cut | null} */
let current = null;

/** @param {Cut | null} cut */
export function setCut(cut) {
  current = cut;
}

/** @param {Vector} point */
export function isSeen(point) {
  return current === null || dot(current.normal, point) <= current.at;
}
