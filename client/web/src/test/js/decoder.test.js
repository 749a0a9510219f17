import assert from 'node:assert/strict';
import test from 'node:test';
import { Decoder } from '../../main/js/decode/decoder.js';
import { bytesUpTo } from './support/web.js';

/** @import { Java } from '../../main/js/decode/decoder.js' */

const STAGING = 40;

/** A Java side with a small buffer that moves with every call, as WebAssembly's may. */
class FakeJava {
  staged = new Int8Array(STAGING);
  /** @type {number[]} */
  fed = [];
  images = [
    { paths: ['a\nb.png', 'c.png'], width: /** @type {number | null} */ (8), bytes: bytesUpTo(100) },
    { paths: ['d.png'], width: 8, bytes: bytesUpTo(STAGING) },
  ];
  changes = { step: 4, jump: false, batches: 2, faces: 9, vertices: 11, places: 9, groups: [0, 0, 27], tangents: [0], ranges: [0, 3, 20, 3, 9, 8] };
  data = Uint32Array.from({ length: 28 }, (_, i) => 3e9 + i);

  /** @returns {Java} */
  get methods() {
    const answer = (/** @type {unknown} */ value) => JSON.stringify({ value });
    /** @type {any} */
    const methods = {
      open: () => answer(null),
      staging: () => this.staged,
      feed: (/** @type {number} */ length) => {
        this.fed.push(...new Uint8Array(this.staged.buffer, 0, length));
        return answer(this.fed.length >= 60 ? 1 : 0);
      },
      header: () => answer(this.fed.length < 50 ? null : { whole: this.fed.length >= 90 }),
      refine: () => answer(this.changes),
      copy: (/** @type {number} */ from) => {
        const part = this.data.slice(from, from + STAGING / 4);
        this.stage(new Uint8Array(part.buffer));
        return answer(part.length);
      },
      images: () => answer(this.images.map(({ paths, width }) => ({ paths, width }))),
      copyImage: (/** @type {number} */ index, /** @type {number} */ from) => {
        const { bytes } = this.images[index];
        this.stage(bytes.subarray(from, from + STAGING));
        return answer(bytes.length - from);
      },
    };
    return methods;
  }

  /** @param {Uint8Array} bytes */
  stage(bytes) {
    this.staged = new Int8Array(STAGING);
    new Uint8Array(this.staged.buffer).set(bytes);
  }
}

test('feeds through the buffer, in portions of its size', () => {
  const java = new FakeJava();
  const decoder = new Decoder('js', java.methods);
  const bytes = bytesUpTo(95);
  decoder.feed(bytes.subarray(0, 49));
  assert.deepEqual([decoder.received, decoder.batches, decoder.header], [49, 0, null]);
  decoder.feed(bytes.subarray(49));
  assert.deepEqual([decoder.received, decoder.batches, decoder.header], [95, 1, { whole: true }]);
  assert.deepEqual(java.fed, [...bytes]);
  decoder.open();
  assert.deepEqual([decoder.received, decoder.batches, decoder.header], [0, 0, null]);
});

test('copies changed elements out, in portions of the buffer', () => {
  const java = new FakeJava();
  const changes = new Decoder('js', java.methods).refine();
  assert.deepEqual(changes, { ...java.changes, ranges: Uint32Array.from(java.changes.ranges), data: java.data });
});

test('gives each image once, and a better one again', () => {
  const java = new FakeJava();
  const decoder = new Decoder('js', java.methods);
  const known = new Set();
  const both = java.images.map(({ paths, bytes }) => [paths, bytes]);
  assert.deepEqual(decoder.newImages(known), both);
  assert.deepEqual(decoder.newImages(known), []);
  java.images[1] = { paths: ['a\nb.png', 'c.png'], width: null, bytes: new Uint8Array(0) };
  assert.deepEqual(decoder.newImages(known), [[['a\nb.png', 'c.png'], new Uint8Array(0)]]);
});
