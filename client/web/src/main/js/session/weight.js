// @ts-check
// What models weigh beside the code that shows them.

/** @import { Header } from './header.js' */

/** Models of more faces outweigh the code by far. */
export const LARGE_FACES = 150_000;

/** @param {Header | null} header */
export function isTextured(header) {
  return header?.slots.some((slot) => 'gltf' in slot || Object.keys(slot.textures).length > 0) === true;
}
