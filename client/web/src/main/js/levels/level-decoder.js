// @ts-check
// Decodes an archive up to any of its batches, beside the decoder that streams it. It goes on from the level before where it can, and begins anew where it must.

import { MeshArrays } from '../session/mesh-arrays.js';

/** @import { Changes, Decoder } from '../decode/decoder.js' */
/** @import { ArchiveBytes } from './archive-bytes.js' */
/** @import { Snapshot, Snapshots } from './snapshots.js' */
/** @typedef {{ ends: number[], levels: number[] }} Index the byte behind each batch, and its level */

/** What is fed at once. */
const PORTION = 1 << 14;
/** No longer than this without a look at newer wishes. */
const YIELD_MILLIS = 30;
/** Level of a place without a triangle. */
const NONE = 0xffff;

export class LevelDecoder {
  #decoder;
  #bytes;
  #snapshots;
  #arrays = new MeshArrays();
  /** Batches that the arrays show. */
  #shown = 0;
  #faces = 0;
  #levels = new Uint16Array().fill(NONE);
  #yieldedAt = 0;

  /**
   * @param {Decoder} decoder that nobody else feeds
   * @param {Pick<ArchiveBytes, 'reach' | 'part'>} bytes
   * @param {Snapshots} snapshots
   */
  constructor(decoder, bytes, snapshots) {
    this.#decoder = decoder;
    this.#bytes = bytes;
    this.#snapshots = snapshots;
  }

  /**
   * The mesh after so many batches; null when it is no longer wished.
   *
   * @param {number} batches at least one
   * @param {Index} index of these batches at least
   * @param {() => boolean} isStale asked now and then
   * @returns {Promise<Snapshot | null>}
   */
  async level(batches, { ends, levels }, isStale) {
    const known = this.#snapshots.get(batches);
    if (known !== null) return known;
    if (this.#decoder.batches > batches) this.#restart();
    await this.#bytes.reach(ends[batches - 1]);
    try {
      return await this.#goOn(batches, { ends, levels }, isStale);
    } catch (error) {
      // What has stopped amid a batch cannot go on.
      this.#restart();
      throw error;
    }
  }

  /**
   * @param {number} batches
   * @param {Index} index
   * @param {() => boolean} isStale
   * @returns {Promise<Snapshot | null>}
   */
  async #goOn(batches, { ends, levels }, isStale) {
    while (this.#shown < batches) {
      // A face's level is that of the batch which brings it, so no look goes over the end of a level.
      let next = Math.max(this.#decoder.batches, this.#shown + 1);
      while (next < batches && levels[next] === levels[next - 1]) next++;
      if (!(await this.#feed(ends[next - 1], isStale))) return null;
      this.#show(next, levels[next - 1]);
      if (next === batches || this.#snapshots.hasRoomFor(this.#size())) this.#snapshots.add(this.#snapshot());
    }
    return this.#snapshots.get(batches) ?? this.#snapshot();
  }

  #restart() {
    this.#decoder.open();
    this.#arrays = new MeshArrays();
    this.#levels.fill(NONE);
    this.#shown = 0;
  }

  /**
   * False when it is given up.
   *
   * @param {number} end
   * @param {() => boolean} isStale
   */
  async #feed(end, isStale) {
    const decoder = this.#decoder;
    while (decoder.received < end) {
      decoder.feed(this.#bytes.part(decoder.received, Math.min(end, decoder.received + PORTION)));
      if (performance.now() - this.#yieldedAt < YIELD_MILLIS) continue;
      await new Promise((resolve) => setTimeout(resolve));
      this.#yieldedAt = performance.now();
      if (isStale()) return false;
    }
    return true;
  }

  /**
   * @param {number} batches
   * @param {number} level of what is new
   */
  #show(batches, level) {
    const { header } = this.#decoder;
    if (header !== null) this.#arrays.expect(header);
    const changes = this.#decoder.refine();
    this.#arrays.take(changes);
    this.#shown = batches;
    this.#faces = changes.faces;
    this.#mark(changes, level);
  }

  /**
   * @param {Changes} changes
   * @param {number} level
   */
  #mark({ places, jump }, level) {
    if (places > this.#levels.length) {
      const more = new Uint16Array(2 * places).fill(NONE);
      more.set(this.#levels);
      this.#levels = more;
    }
    // Faces of another mesh lie in other places; of those nobody knows when they came.
    if (jump) this.#levels.fill(NONE);
    for (const { start, count } of this.#arrays.groups) {
      for (let place = start / 3; place < (start + count) / 3; place++) {
        if (this.#levels[place] === NONE) this.#levels[place] = level;
      }
    }
  }

  /** About how many bytes a snapshot takes. */
  #size() {
    return 40 * this.#arrays.vertices + 5 * this.#arrays.corners;
  }

  /** @returns {Snapshot} */
  #snapshot() {
    const { vertices, corners, positions, normals, tangents, colours, uvs, indices, groups } = this.#arrays;
    return {
      batch: this.#shown,
      faces: this.#faces,
      vertices,
      positions: positions.slice(0, 3 * vertices),
      normals: normals.slice(0, 3 * vertices),
      tangents: tangents.slice(0, 4 * vertices),
      colours: colours.slice(0, 4 * vertices),
      uvs: uvs.map((set) => set.slice(0, 2 * vertices)),
      indices: indices.slice(0, corners),
      groups,
      levels: this.#levels.slice(0, corners / 3),
    };
  }
}
