// @ts-check
// Which models are not left to the small renderer while they stream. Others look the same with it, so three.js need not
// share a slow link with them.

import { LARGE_FACES } from '../session/weight.js';

/** @import { Header } from '../session/header.js' */
/** @import { MeshArrays } from '../session/mesh-arrays.js' */

/**
 * The small renderer copies the whole mesh for each step, which takes too long with much of a large one.
 *
 * @param {Header | null} header
 * @param {Pick<MeshArrays, 'corners'>} arrays
 */
export function isLargeMesh(header, { corners }) {
  return (header?.faces ?? 0) > LARGE_FACES && corners > LARGE_FACES;
}
