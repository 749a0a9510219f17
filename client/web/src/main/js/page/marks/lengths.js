// @ts-check
// Lengths as people read them.

/** @import { Figures } from '../../session/figures.js' */
/** @import { Manifest } from '../../session/manifest.js' */
/** @typedef {'metres' | 'units'} Unit */

/** The language of the page's numbers. */
const LANGUAGE = 'en';
const DIGITS = 4;
/** Parts of a metre, from the smallest. @type {[number, string][]} */
const METRES = [[1e-6, 'µm'], [1e-3, 'mm'], [1e-2, 'cm'], [1, 'm'], [1e3, 'km']];

/**
 * glTF counts in metres; other files do not say in what.
 *
 * @param {{ opened: { manifest: Manifest } | null, figures: Pick<Figures, 'header'> }} session
 * @returns {Unit}
 */
export function unitOf({ opened, figures }) {
  const isGltf = opened?.manifest.sourceFormat === 'GLB' || figures.header?.slots.some((slot) => 'gltf' in slot);
  return isGltf ? 'metres' : 'units';
}

/**
 * @param {number} length
 * @param {Unit} unit
 */
export function lengthInWords(length, unit) {
  const format = (/** @type {number} */ value) => value.toLocaleString(LANGUAGE, { maximumSignificantDigits: DIGITS });
  if (unit === 'units') return `${format(length)} ${length === 1 ? 'unit' : 'units'}`;
  const [scale, name] = METRES.findLast(([least]) => length >= least) ?? METRES[0];
  return `${format(length / scale)} ${name}`;
}
