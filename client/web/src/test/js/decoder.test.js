import assert from 'node:assert/strict';
import test from 'node:test';
import { Decoder } from '../../main/resources/META-INF/resources/jsm/viewer/decoder.js';
import { bytesUpTo } from './support/web.js';

/** @import { Java } from '../../main/resources/META-INF/resources/jsm/viewer/decoder.js' */

const STAGING = 40;

/** A Java side with a small buffer that moves with every call, as WebAssembly's may. */
class FakeJava {
  staged = new Int8Array(STAGING);
  /** @type {number[]} */
  fed = [];
  images = [
    { path: 'a\nb.png', width: /** @type {number | null} */ (8), bytes: bytesUpTo(100) },
    { path: 'c.png', width: 8, bytes: bytesUpTo(STAGING) },
  ];
  arrays = [Float32Array.of(...bytesUpTo(33)), new Float32Array(33), new Float32Array(0), new Uint32Array(0), Uint32Array.of(0, 1, 2), Uint32Array.of(0, 0, 3)];
  isReleased = false;

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
      draw: () => answer(this.arrays.map((array) => array.length)),
      copy: (/** @type {number} */ array, /** @type {number} */ from) => {
        const part = this.arrays[array].slice(from, from + STAGING / 4);
        this.stage(new Uint8Array(part.buffer));
        return answer(part.length);
      },
      release: () => answer((this.isReleased = true)),
      images: () => answer(this.images.map(({ path, width }) => ({ path, width }))),
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

test('copies the arrays out, in portions of the buffer', () => {
  const java = new FakeJava();
  const { vertices, positions, normals, uvs, colours, indices, groups } = new Decoder('js', java.methods).draw();
  assert.equal(vertices, 11);
  assert.deepEqual([positions, normals, uvs, colours, indices, groups], java.arrays);
  assert.equal(java.isReleased, true);
});

test('gives each image once, and a better one again', () => {
  const java = new FakeJava();
  const decoder = new Decoder('js', java.methods);
  const known = new Set();
  const both = java.images.map(({ path, bytes }) => [path, bytes]);
  assert.deepEqual(decoder.newImages(known), both);
  assert.deepEqual(decoder.newImages(known), []);
  java.images[1] = { path: 'a\nb.png', width: null, bytes: new Uint8Array(0) };
  assert.deepEqual(decoder.newImages(known), [['a\nb.png', new Uint8Array(0)]]);
});
