// @ts-check
// The levels that a link shows: of one side, or of two that are compared.

/** The level that has arrived last. */
const NEWEST = 'newest';

/** @typedef {[left: number | null, right?: number | null]} Sides numbers of batches; null for the newest */

/** As a part of an address; null where everybody sees the same without it. @param {Sides} sides */
export function textOf(sides) {
  return sides.length === 1 && sides[0] === null ? null : sides.map((batches) => batches ?? NEWEST).join();
}

/**
 * Null where the text is anything else.
 *
 * @param {string} text
 * @returns {Sides | null}
 */
export function sidesOf(text) {
  const sides = text.split(',');
  if (sides.length > 2 || !sides.every((side) => side === NEWEST || /^[1-9]\d{0,5}$/.test(side))) return null;
  const [left, right] = sides.map((side) => (side === NEWEST ? null : Number(side)));
  return right === undefined ? [left] : [left, right];
}
