// @ts-check
// What the gallery says of a model.

import * as numbers from '../session/numbers.js';

/**
 * What the list says of a model.
 *
 * @typedef {object} Model
 * @property {string} id
 * @property {string} [name]
 * @property {string} [format] of its file, `jsm` for an archive
 * @property {number} [fileBytes]
 * @property {string} [modified] when it was changed last, as ISO 8601 has it
 * @property {string} [state] `new`: nobody has asked for it; `preparing`, `ready` or `failed`
 * @property {string} [stage] what is being done while it is prepared
 * @property {number} [fraction] of that, 0 to 1
 * @property {string} [error]
 * @property {number} [faces]
 * @property {number} [bytes]
 * @property {string} [manifestUrl]
 * @property {string} [posterUrl]
 */

/**
 * The words of a card, by the state of its model.
 *
 * @param {Omit<Model, 'id'>} model
 */
export function describe({ state, stage, fraction = 0, error, faces, bytes, format, fileBytes }) {
  if (state === 'failed') return error ?? 'cannot be encoded';
  if (state !== 'ready' && format === 'jsm') return fileBytes ? numbers.bytes(fileBytes) : '';
  if (state === 'preparing') return stage === undefined ? 'being encoded' : `being encoded: ${stage}, ${Math.round(100 * fraction)}%`;
  const facts = [];
  if (faces) facts.push(numbers.faces(faces));
  if (bytes) facts.push(numbers.bytes(bytes));
  return facts.length === 0 ? 'not encoded yet' : facts.join(' · ');
}
