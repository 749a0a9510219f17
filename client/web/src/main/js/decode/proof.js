// @ts-check
// The proof that what was decoded is what was encoded.

import { DamagedArchive } from './answers.js';

/** @import { Decoder, Proof } from './decoder.js' */
/** @import { Archive } from './messages.js' */

/**
 * The hashes of a mesh that is decoded whole.
 *
 * @param {Decoder} decoder
 * @param {Archive} archive what its manifest says
 * @returns {Proof}
 * @throws {DamagedArchive} when they are not those of the header, or of the manifest
 */
export function proven(decoder, archive) {
  const proof = decoder.proof();
  if (proof.difference !== '') throw new DamagedArchive(proof.difference);
  compare('mesh', proof.meshSha256, archive.meshSha256);
  compare('model', proof.modelSha256, archive.modelSha256);
  return proof;
}

/** @param {string} what @param {string} sha256 @param {string | undefined} expected by the manifest */
function compare(what, sha256, expected) {
  if (expected !== undefined && sha256 !== expected) throw new DamagedArchive(`its ${what} has the SHA-256 ${sha256}, but the original has ${expected}`);
}
