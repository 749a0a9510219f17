// @ts-check
// The decoder behind one face, whether it runs as WebAssembly or as JavaScript.

import { DecoderMissing, valueOf } from './answers.js';

/** @import { Header } from '../session/header.js' */
/** @import { Relay } from './relay.js' */

/**
 * @typedef {object} Proof
 * @property {string} meshSha256 of the decoded mesh
 * @property {string} modelSha256 of the decoded mesh and pictures
 * @property {string} difference from what the header names, a clause; empty when there is none
 */
/**
 * What a step changes in the arrays to draw.
 *
 * @typedef {object} Changes
 * @property {number} step counts up from 1; 1 again with another mesh
 * @property {boolean} jump whether nothing of the picture before stays while changes are applied
 * @property {number} batches that are shown
 * @property {number} faces
 * @property {number} vertices render vertices, used or not
 * @property {number} places of triangles, used or not
 * @property {number[]} groups three numbers each: display slot, first index, indices; a slot may have several
 * @property {number[]} tangents display slots all of whose vertices have tangents
 * @property {Uint32Array<ArrayBuffer>} ranges three numbers each: array, first element, elements. The arrays are 0 positions, 1 normals, 2 colours, 3 indices, 5 tangents, 6 to 9 sets of texture coordinates, 10 starts
 * @property {Uint32Array<ArrayBuffer>} data the elements of all ranges as bits
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
/** @typedef {import('../decoder/decoder.js').Java} Java */
/** @typedef {Exclude<keyof Java, 'staging'>} Method */

export class Decoder {
  #java;
  #relay;

  /**
   * @param {'wasm' | 'js'} kind
   * @param {Java} java what DecoderMain exports
   * @param {Relay | null} relay whose methods these are, where there is a first decoder
   */
  constructor(kind, java, relay = null) {
    this.kind = kind;
    this.#java = java;
    this.#relay = relay;
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
    this.#takeOver();
    for (let from = 0; from < bytes.length; ) {
      const staging = this.#java.staging();
      const part = bytes.subarray(from, from + staging.length);
      staging.set(part);
      this.batches = this.#ask('feed', part.length);
      if (this.#relay?.isWaiting) this.prepare();
      this.received += part.length;
      from += part.length;
      if (!this.header?.whole) this.header = this.#ask('header');
    }
  }

  /** Lets the whole decoder come, if there is none yet. */
  prepare() {
    this.#relay?.whole();
  }

  /** Does the first decoder decode? It lacks images, and is never complete. */
  get isFirst() {
    return this.#relay?.isFirst ?? false;
  }

  /** Has the first decoder stumbled? Only the whole one can draw again. */
  get isBroken() {
    return this.#relay?.isBroken ?? false;
  }

  /**
   * Waits for the whole decoder where bytes need it, and lets it take over if it has come.
   *
   * @throws {DamagedArchive | DecoderMissing}
   */
  async catchUp() {
    if (this.#relay?.isWaiting) {
      try {
        await this.#relay.whole();
      } catch (reason) {
        throw new DecoderMissing(reason, 'Reload the page');
      }
    }
    this.#takeOver();
  }

  #takeOver() {
    if (!this.#relay?.isDue) return;
    this.kind = this.#relay.takeOver();
    this.header = this.#ask('header');
    this.batches = this.#ask('feed', 0);
  }

  /** @returns {boolean} */
  get isComplete() {
    return this.#ask('isComplete');
  }

  /**
   * What has changed in the arrays to draw since this was asked the last time. A decoder that has found damage goes on showing what came before it.
   *
   * @returns {Changes}
   */
  refine() {
    /** @type {Changes} */
    const changes = this.#ask('refine');
    this.batches = changes.batches;
    const ranges = Uint32Array.from(changes.ranges);
    let length = 0;
    for (let i = 2; i < ranges.length; i += 3) length += ranges[i];
    const data = new Uint32Array(length);
    for (let from = 0; from < length; ) {
      /** @type {number} */
      const count = this.#ask('copy', from);
      const { buffer, byteOffset } = this.#java.staging();
      data.set(new Uint32Array(buffer, byteOffset, count), from);
      from += count;
    }
    return { ...changes, ranges, data };
  }

  /**
   * Images that can be shown and were not given before, as [paths, bytes]: textures that have arrived whole, and previews of others.
   *
   * @param {Set<string>} known keeps what was given
   */
  newImages(known) {
    /** @type {{ paths: string[], width: number | null }[]} */
    const images = this.#ask('images');
    /** @type {[string[], Uint8Array<ArrayBuffer>][]} */
    const fresh = [];
    images.forEach((image, index) => {
      const key = JSON.stringify(image);
      if (known.has(key)) return;
      known.add(key);
      fresh.push([image.paths, this.#image(index)]);
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
   * How the whole of what was decoded compares with the hashes of the header.
   *
   * @returns {Proof}
   */
  proof() {
    return this.#ask('proof');
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
