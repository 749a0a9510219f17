// @ts-check
// The decoder behind one face, whether it runs as WebAssembly or as JavaScript.

import { valueOf } from './answers.js';
import { loadWebAssembly } from './decoder-wasm.js';

/**
 * How a display slot looks: those faces that are drawn with one material.
 *
 * @typedef {object} Slot
 * @property {[number, number, number, number] | null} colour red, green, blue, opacity, or null for the viewer's own
 * @property {string | null} texture path of the colour texture
 * @property {boolean} gltf colours are linear and texture coordinates count from the top, as glTF has them
 * @property {number} metallic 0 to 1, or -1 when the material does not say
 * @property {number} roughness 0 to 1, or -1 when the material does not say
 */
/**
 * What an archive says of itself: totals, identity, and the columns of its index, one element per batch.
 *
 * @typedef {object} Header
 * @property {boolean} whole false while only its first part has arrived, which knows the first batches alone; totals are then null
 * @property {number | null} faces
 * @property {number | null} vertices
 * @property {number | null} wedges
 * @property {string | null} meshSha256
 * @property {number | null} levels
 * @property {number[]} bounds smallest x, y, z, then largest
 * @property {{ semantic: string, name: string }[]} channels
 * @property {Slot[]} slots
 * @property {number} archiveBytes
 * @property {number[]} ends the byte behind each batch
 * @property {number[]} batchFaces
 * @property {number[]} batchLevels
 * @property {number[]} precisionBits
 * @property {number[]} errorMeans in percent of the diagonal
 */
/**
 * The arrays of a mesh as a graphics card takes them; those that the mesh lacks are empty.
 *
 * @typedef {object} Drawn
 * @property {number} vertices
 * @property {Float32Array<ArrayBuffer>} positions
 * @property {Float32Array<ArrayBuffer>} normals
 * @property {Float32Array<ArrayBuffer>} uvs
 * @property {Uint32Array<ArrayBuffer>} colours red, green, blue, alpha from the lowest byte on, sRGB
 * @property {Uint32Array<ArrayBuffer>} indices
 * @property {Uint32Array<ArrayBuffer>} groups three numbers each: display slot, first index, indices
 */
/**
 * What the planner asks for.
 *
 * @typedef {object} Plan
 * @property {number} from first byte
 * @property {number} end the byte behind the last one
 * @property {number} fromBatch
 * @property {number} endBatch the batch behind the last one; -1 when the index is not known yet
 * @property {number} bytesPerSecond
 * @property {number} waitMillis
 */
/** @typedef {typeof import('./decoder/decoder.js')} Java */
/** @typedef {Exclude<keyof Java, 'staging'>} Method */

/**
 * Loads WebAssembly, or JavaScript when it is asked for or the browser knows no WebAssembly GC.
 *
 * @param {string} wanted 'wasm', 'js', or else what the browser can
 */
export async function loadDecoder(wanted) {
  if (wanted !== 'js') {
    try {
      const methods = await loadWebAssembly(new URL('decoder/decoder.wasm', import.meta.url));
      return new Decoder('wasm', /** @type {Java} */ (/** @type {unknown} */ (methods)));
    } catch (reason) {
      if (wanted === 'wasm') throw new DecoderMissing(reason, 'Reload the page, or leave decoder=wasm out of its address');
    }
  }
  try {
    return new Decoder('js', await import('./decoder/decoder.js'));
  } catch (reason) {
    throw new DecoderMissing(reason, 'Reload the page');
  }
}

/** The decoder cannot be loaded, in words. */
export class DecoderMissing extends Error {
  /**
   * @param {unknown} reason
   * @param {string} remedy
   */
  constructor(reason, remedy) {
    super(`The decoder could not be loaded (${reason instanceof Error ? reason.message : reason}). ${remedy}.`);
  }
}

export class Decoder {
  #java;

  /**
   * @param {'wasm' | 'js'} kind
   * @param {Java} java what DecoderMain exports
   */
  constructor(kind, java) {
    this.kind = kind;
    this.#java = java;
    this.received = 0;
    this.batches = 0;
    /** @type {Header | null} */
    this.header = null;
    this.open();
  }

  /** Forgets the archive before. */
  open() {
    this.#ask('open');
    this.received = 0;
    this.batches = 0;
    this.header = null;
  }

  /**
   * Decodes the next bytes of the archive.
   *
   * @param {Uint8Array} bytes
   * @throws {DamagedArchive}
   */
  feed(bytes) {
    for (let from = 0; from < bytes.length; ) {
      const staging = this.#java.staging();
      const part = bytes.subarray(from, from + staging.length);
      staging.set(part);
      this.batches = this.#ask('feed', part.length);
      this.received += part.length;
      from += part.length;
      if (!this.header?.whole) this.header = this.#ask('header');
    }
  }

  /** @returns {boolean} */
  get isComplete() {
    return this.#ask('isComplete');
  }

  /**
   * Copies of the arrays to draw.
   *
   * @returns {Drawn}
   */
  draw() {
    /** @type {number[]} */
    const counts = this.#ask('draw');
    const drawn = {
      vertices: counts[0] / 3,
      positions: this.#copy(0, new Float32Array(counts[0])),
      normals: this.#copy(1, new Float32Array(counts[1])),
      uvs: this.#copy(2, new Float32Array(counts[2])),
      colours: this.#copy(3, new Uint32Array(counts[3])),
      indices: this.#copy(4, new Uint32Array(counts[4])),
      groups: this.#copy(5, new Uint32Array(counts[5])),
    };
    this.#ask('release');
    return drawn;
  }

  /**
   * Fills in an array of the mesh, which comes in portions.
   *
   * @template {Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>} T
   * @param {number} array
   * @param {T} into
   * @returns {T}
   */
  #copy(array, into) {
    for (let from = 0; from < into.length; ) {
      /** @type {number} */
      const count = this.#ask('copy', array, from);
      const { buffer, byteOffset } = this.#java.staging();
      into.set(into instanceof Float32Array ? new Float32Array(buffer, byteOffset, count) : new Uint32Array(buffer, byteOffset, count), from);
      from += count;
    }
    return into;
  }

  /**
   * Images that can be shown and were not given before, as [path, bytes]: textures that have arrived whole, and previews of others.
   *
   * @param {Set<string>} known keeps what was given
   */
  newImages(known) {
    /** @type {{ path: string, width: number | null }[]} */
    const images = this.#ask('images');
    /** @type {[string, Uint8Array<ArrayBuffer>][]} */
    const fresh = [];
    images.forEach((image, index) => {
      const key = JSON.stringify(image);
      if (known.has(key)) return;
      known.add(key);
      fresh.push([image.path, this.#image(index)]);
    });
    return fresh;
  }

  /** @param {number} index */
  #image(index) {
    /** @type {number} */
    let left = this.#ask('copyImage', index, 0);
    const bytes = new Uint8Array(left);
    while (left > 0) {
      const staging = this.#java.staging();
      const part = staging.subarray(0, Math.min(staging.length, left));
      bytes.set(part, bytes.length - left);
      left -= part.length;
      if (left > 0) this.#ask('copyImage', index, bytes.length - left);
    }
    return bytes;
  }

  /**
   * Identity of the mesh decoded so far, from its faces.
   *
   * @returns {string}
   */
  sha256() {
    return this.#ask('sha256');
  }

  /**
   * @param {number} now
   * @param {number} waitMillis
   */
  beginRound(now, waitMillis) {
    this.#ask('beginRound', now, waitMillis);
  }

  /**
   * The planner's next request, or null.
   *
   * @param {number} now
   * @returns {Plan | null}
   */
  nextRequest(now) {
    return this.#ask('nextRequest', now, this.received);
  }

  /** @param {number} now */
  beginResponse(now) {
    this.#ask('beginResponse', now);
  }

  /**
   * @param {number} now
   * @param {number} bytes
   */
  arrived(now, bytes) {
    this.#ask('arrived', now, bytes);
  }

  /** @param {boolean} cached */
  endResponse(cached) {
    this.#ask('endResponse', cached);
  }

  /**
   * Whether what is there is to be shown now, though a response is under way.
   *
   * @param {number} now
   * @returns {boolean}
   */
  isOver(now) {
    return this.#ask('isOver', now);
  }

  /**
   * Whether, after the round, the rest of a response is read on.
   *
   * @param {number} now
   * @param {number} bytesLeft
   * @returns {boolean}
   */
  mayGoOn(now, bytesLeft) {
    return this.#ask('mayGoOn', now, bytesLeft);
  }

  /**
   * @param {number} now
   * @returns {number}
   */
  bytesPerSecond(now) {
    return this.#ask('bytesPerSecond', now);
  }

  /**
   * @template {Method} M
   * @param {M} method
   * @param {Parameters<Java[M]>} args
   */
  #ask(method, ...args) {
    return valueOf(() => Reflect.apply(this.#java[method], undefined, args));
  }
}
