// A decoder of archives that are mere bytes: batches end where the test says, and the header is there with the base.

import { DamagedArchive } from '../../../main/resources/META-INF/resources/jsm/viewer/answers.js';

/** @import { Decoder } from '../../../main/resources/META-INF/resources/jsm/viewer/decoder.js' */

export class FakeDecoder {
  kind = 'js';
  received = 0;
  batches = 0;
  /** @type {any} */
  header = null;
  /** @type {number[]} */
  bytes = [];
  /** Sizes of what was fed. @type {number[]} */
  fed = [];
  /** @type {[string, Uint8Array<ArrayBuffer>][]} */
  images = [];
  /** Requests of rounds. @type {any[]} */
  plans = [];
  isLate = false;
  goesOn = true;
  hash = 'of the mesh';
  damagedFrom = Infinity;
  cachedResponses = 0;

  /** @param {number[]} ends of batches */
  constructor(ends) {
    this.ends = ends;
  }

  /** @returns {Decoder} */
  get asDecoder() {
    return /** @type {any} */ (this);
  }

  get isComplete() {
    return this.batches === this.ends.length;
  }

  open() {
    Object.assign(this, { received: 0, batches: 0, header: null, bytes: [] });
  }

  /** @param {Uint8Array} bytes */
  feed(bytes) {
    this.fed.push(bytes.length);
    this.bytes.push(...bytes);
    this.received += bytes.length;
    if (this.received > this.damagedFrom) throw new DamagedArchive('no archive');
    this.batches = this.ends.filter((end) => end <= this.received).length;
    const whole = this.received >= this.ends[0];
    if (whole && this.header === null) this.header = { whole, ends: this.ends, archiveBytes: this.ends.at(-1), meshSha256: 'of the mesh' };
  }

  draw() {
    const [positions, normals, uvs] = [new Float32Array(9), new Float32Array(9), new Float32Array(0)];
    const [colours, indices, groups] = [new Uint32Array(0), Uint32Array.of(0, 1, 2), Uint32Array.of(0, 0, 3)];
    return { vertices: 3, positions, normals, uvs, colours, indices, groups };
  }

  /** @param {Set<string>} known */
  newImages(known) {
    const fresh = this.images.filter(([path]) => !known.has(path));
    fresh.forEach(([path]) => known.add(path));
    return fresh;
  }

  sha256() {
    return this.hash;
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
