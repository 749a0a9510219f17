import assert from 'node:assert/strict';
import test, { mock } from 'node:test';
import { DamagedArchive, DecoderMissing } from '../../main/js/decode/answers.js';
import { relayed } from '../../main/js/decode/load-decoder.js';

/** @import { Java } from '../../main/js/decode/decoder.js' */
/** @import { Whole } from '../../main/js/decode/load-decoder.js' */

const answer = (/** @type {unknown} */ value) => JSON.stringify({ value });

/** A decoder of batches of ten bytes, which notes what it is told. */
class FakeJava {
  staged = new Int8Array(16);
  /** @type {number[]} */
  fed = [];
  /** @type {unknown[][]} */
  heard = [];
  /** @type {unknown} */
  request = { from: 0 };

  /**
   * @param {string} name
   * @param {number} known batches
   * @param {number} brokenFrom the byte at which it stops
   */
  constructor(name, known = Infinity, brokenFrom = Infinity) {
    this.name = name;
    this.known = known;
    this.brokenFrom = brokenFrom;
  }

  /** @returns {Java} */
  get methods() {
    const hear = (/** @type {string} */ method) => (/** @type {unknown[]} */ ...args) => {
      this.heard.push([method, ...args]);
      return answer(method === 'nextRequest' ? this.request : null);
    };
    /** @type {any} */
    const methods = Object.fromEntries(['beginRound', 'nextRequest', 'beginResponse', 'arrived', 'endResponse'].map((method) => [method, hear(method)]));
    return Object.assign(methods, {
      open: () => {
        this.fed = [];
        return answer(null);
      },
      staging: () => this.staged,
      feed: (/** @type {number} */ length) => this.feed(length),
      header: () => answer({ whole: false, by: this.name }),
      bytesPerSecond: () => answer(this.heard.length),
      isComplete: () => answer(this.fed.length === 50),
    });
  }

  /** @param {number} length */
  feed(length) {
    this.fed.push(...this.staged.subarray(0, length));
    if (this.fed.length > this.brokenFrom) return JSON.stringify({ error: { kind: 'damaged', message: `damage found by the ${this.name}` } });
    const batches = Math.floor(this.fed.length / 10);
    return answer(batches < this.known ? batches : -1 - this.known);
  }
}

/** @param {number} [brokenFrom] */
function pair(brokenFrom) {
  const first = new FakeJava('first', 3, brokenFrom);
  const whole = new FakeJava('whole', Infinity, brokenFrom);
  let come = () => {};
  /** @type {(reason: Error) => void} */
  let fail = () => {};
  /** @type {Promise<Whole>} */
  const coming = new Promise((resolve, reject) => {
    come = () => resolve({ kind: 'wasm', java: whole.methods });
    fail = reject;
  });
  const load = mock.fn(() => coming);
  return { first, whole, come, fail, load, decoder: relayed(first.methods, load) };
}

const bytes = (/** @type {number} */ from, /** @type {number} */ end) => Uint8Array.from({ length: end - from }, (_, i) => from + i);

test('decodes with the first decoder until the whole one has come', async () => {
  const { first, whole, come, decoder } = pair();
  decoder.prepare();
  decoder.feed(bytes(0, 25));
  assert.deepEqual([decoder.batches, decoder.isFirst, first.fed.length, whole.fed.length], [2, true, 25, 0]);
  assert.equal(decoder.kind, 'js');
  assert.equal(decoder.isComplete, false);
  assert.deepEqual(decoder.newImages(new Set()), []);
  come();
  await new Promise(setImmediate);
  decoder.feed(bytes(25, 50));
  assert.deepEqual(whole.fed, [...bytes(0, 50)]);
  assert.deepEqual([decoder.batches, decoder.isFirst, decoder.isComplete, decoder.received], [5, false, true, 50]);
  assert.deepEqual(decoder.header, { whole: false, by: 'whole' });
  assert.equal(decoder.kind, 'wasm');
});

test('keeps what the first decoder does not know until the whole one comes', async () => {
  const { first, come, decoder } = pair();
  decoder.feed(bytes(0, 32));
  decoder.feed(bytes(32, 50));
  assert.deepEqual([decoder.batches, decoder.received, first.fed.length], [3, 50, 32]);
  const caughtUp = decoder.catchUp();
  come();
  await caughtUp;
  assert.deepEqual([decoder.batches, decoder.isFirst, decoder.isComplete], [5, false, true]);
});

test('asks for the whole decoder once, and only when something needs it', () => {
  const { load, decoder } = pair();
  decoder.feed(bytes(0, 29));
  assert.equal(load.mock.callCount(), 0);
  decoder.feed(bytes(29, 32));
  assert.equal(load.mock.callCount(), 1);
  decoder.prepare();
  assert.equal(load.mock.callCount(), 1);
});

test('tells the whole decoder what the planner has heard', async () => {
  const { first, whole, come, decoder } = pair();
  decoder.beginRound(1, 2000);
  decoder.nextRequest(2);
  decoder.beginResponse(3);
  decoder.arrived(4, 40);
  decoder.feed(bytes(0, 40));
  first.request = null;
  assert.equal(decoder.nextRequest(5), null);
  decoder.endResponse(false);
  come();
  await decoder.catchUp();
  assert.deepEqual(whole.heard, [['beginRound', 1, 2000], ['nextRequest', 2, 0], ['beginResponse', 3], ['arrived', 4, 40], ['endResponse', false]]);
  assert.equal(decoder.bytesPerSecond(6), 5);
});

test('lets the whole decoder tell the damage', async () => {
  const { come, decoder } = pair(20);
  decoder.feed(bytes(0, 20));
  decoder.feed(bytes(20, 30));
  assert.deepEqual([decoder.batches, decoder.isBroken], [2, true]);
  come();
  await assert.rejects(decoder.catchUp(), (error) => error instanceof DamagedArchive && error.message === 'damage found by the whole');
});

test('begins another archive from its start', async () => {
  const { whole, come, decoder } = pair();
  decoder.feed(bytes(0, 40));
  decoder.open();
  decoder.feed(bytes(0, 10));
  assert.equal(decoder.batches, 1);
  come();
  await decoder.catchUp();
  decoder.feed(bytes(10, 20));
  assert.deepEqual(whole.fed, [...bytes(0, 20)]);
});

test('says that the whole decoder does not come', async () => {
  const { fail, decoder } = pair();
  decoder.feed(bytes(0, 40));
  fail(new Error('gone'));
  await assert.rejects(decoder.catchUp(), (error) => error instanceof DecoderMissing && /gone/.test(error.message));
});
