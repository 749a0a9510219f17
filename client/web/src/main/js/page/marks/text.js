// @ts-check
// Points of a model in the fragment of an address.

/** @import { Vector } from '../../viewer/vectors.js' */

/** Coordinates of models are of single precision. */
const DIGITS = 7;

/** @param {Vector[]} points */
export function textOf(points) {
  return points.flat().map((number) => String(Number(number.toPrecision(DIGITS)))).join(',');
}

/**
 * Null where the text is anything else.
 *
 * @param {string} text
 * @returns {Vector[] | null}
 */
export function pointsOf(text) {
  const numbers = text.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (numbers.length % 3 > 0 || !numbers.every(Number.isFinite)) return null;
  return Array.from({ length: numbers.length / 3 }, (_, i) => /** @type {Vector} */ (numbers.slice(3 * i, 3 * i + 3)));
}
