// A decoder of archives that are mere bytes: batches end where the test says, and the header is there with the base.

import { DamagedArchive } from '../../../main/js/decode/answers.js';

/** @import { Decoder } from '../../../main/js/decode/decoder.js' */

export class FakeDecoder {
  kind = 'js';
  received = 0;
  batches = 0;
  /** @type {any} */
  header = null;
  prepared = 0;
  /** @type {number[]} */
  bytes = [];
  /** Sizes of what was fed. @type {number[]} */
  fed = [];
  /** @type {[string[], Uint8Array<ArrayBuffer>][]} */
  images = [];
  /** Requests of rounds. @type {any[]} */
  plans = [];
  isLate = false;
  goesOn = true;
  meshSha256 = 'of the mesh';
  modelSha256 = 'of the model';
  difference = '';
  damagedFrom = Infinity;
  isDamaged = false;
  /** Whether the damage was found while a batch was applied. */
  isHalfway = false;
  cachedResponses = 0;

  /** @param {number[]} ends of batches */
  constructor(ends) {
    this.ends = ends;
  }

  /** @returns {Decoder} */
  get asDecoder() {
    return /** @type {any} */ (this);
  }

  isFirst = false;
  isBroken = false;

  async catchUp() {}

  get isComplete() {
    return this.batches === this.ends.length;
  }

  open() {
    Object.assign(this, { received: 0, batches: 0, header: null, bytes: [], isDamaged: false });
  }

  /** @param {Uint8Array} bytes */
  feed(bytes) {
    this.fed.push(bytes.length);
    this.bytes.push(...bytes);
    this.received += bytes.length;
    if (this.received > this.damagedFrom) {
      this.isDamaged = true;
      throw new DamagedArchive('no archive');
    }
    this.batches = this.ends.filter((end) => end <= this.received).length;
    const whole = this.received >= this.ends[0];
    if (whole && this.header === null) this.header = { whole, slots: [], ends: this.ends, batchFaces: this.ends.map((_, i) => 10 * (i + 1)), archiveBytes: this.ends.at(-1) };
  }

  /** Batches that were applied before the damage are known when they are shown. */
  refine() {
    if (this.isDamaged) {
      if (this.isHalfway) throw new Error('the base has not arrived yet');
      this.batches = this.ends.filter((end) => end <= this.damagedFrom).length;
    }
    return { batches: this.batches, step: 1, jump: false, faces: 1, vertices: 3, places: 1, groups: [0, 0, 3], tangents: [], ranges: Uint32Array.of(3, 0, 3), data: Uint32Array.of(0, 1, 2) };
  }

  /** @param {Set<string>} known */
  newImages(known) {
    const fresh = this.images.filter(([paths]) => !known.has(paths[0]));
    fresh.forEach(([paths]) => known.add(paths[0]));
    return fresh;
  }

  proof() {
    return { meshSha256: this.meshSha256, modelSha256: this.modelSha256, difference: this.difference };
  }

  nextRequest() {
    return this.plans.shift() ?? null;
  }

  isOver() {
    return this.isLate && this.batches > 0;
  }

  mayGoOn() {
    return this.goesOn;
  }

  prepare() {
    this.prepared++;
  }

  bytesPerSecond() {
    return 1000;
  }

  /** @param {boolean} cached */
  endResponse(cached) {
    this.cachedResponses += Number(cached);
  }

  beginRound() {}

  beginResponse() {}

  arrived() {}
}
