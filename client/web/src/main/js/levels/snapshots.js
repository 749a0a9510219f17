// @ts-check
// Meshes of levels that were decoded before: the least recently used go first.

/** @import { Group } from '../session/mesh-arrays.js' */
/**
 * The mesh after a batch, as it is drawn.
 *
 * @typedef {object} Snapshot
 * @property {number} batch how many batches it is made of
 * @property {number} faces
 * @property {number} vertices
 * @property {Float32Array<ArrayBuffer>} positions
 * @property {Float32Array<ArrayBuffer>} normals
 * @property {Float32Array<ArrayBuffer>} tangents
 * @property {Uint8Array<ArrayBuffer>} colours
 * @property {Float32Array<ArrayBuffer>[]} uvs
 * @property {Uint32Array<ArrayBuffer>} indices
 * @property {Group[]} groups
 * @property {Uint16Array<ArrayBuffer>} levels in which the triangles came, by their places among the indices
 */

/** All snapshots together. */
export const MOST_BYTES = 160e6;

export class Snapshots {
  #mostBytes;
  #bytes = 0;
  /** The one that was used last is at the end. @type {Map<number, Snapshot>} */
  #all = new Map();

  constructor(mostBytes = MOST_BYTES) {
    this.#mostBytes = mostBytes;
  }

  /** @param {number} batch */
  get(batch) {
    const found = this.#all.get(batch);
    if (found === undefined) return null;
    this.#all.delete(batch);
    this.#all.set(batch, found);
    return found;
  }

  /** @param {Snapshot} snapshot which stays at least until the next one comes */
  add(snapshot) {
    this.#remove(snapshot.batch);
    this.#all.set(snapshot.batch, snapshot);
    this.#bytes += bytesOf(snapshot);
    for (const batch of this.#all.keys()) {
      if (this.#bytes <= this.#mostBytes || batch === snapshot.batch) break;
      this.#remove(batch);
    }
  }

  /**
   * Whether so large a snapshot is worth a place although nobody has asked for it.
   *
   * @param {number} bytes
   */
  hasRoomFor(bytes) {
    return this.#bytes + bytes <= this.#mostBytes;
  }

  /** @param {number} batch */
  #remove(batch) {
    const found = this.#all.get(batch);
    if (found === undefined) return;
    this.#all.delete(batch);
    this.#bytes -= bytesOf(found);
  }
}

/** @param {Snapshot} snapshot */
export function bytesOf({ positions, normals, tangents, colours, uvs, indices, levels }) {
  return [positions, normals, tangents, colours, ...uvs, indices, levels].reduce((sum, array) => sum + array.byteLength, 0);
}
