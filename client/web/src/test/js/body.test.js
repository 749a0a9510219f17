import assert from 'node:assert/strict';
import test from 'node:test';
import { Body } from '../../main/js/decode/body.js';
import { bytesUpTo, streamOf } from './support/web.js';

const FILE = bytesUpTo(250);
const NEVER = new AbortController().signal;
/** @type {<T>(promise: Promise<T>) => Promise<T>} */
const asItIs = (promise) => promise;

/** @param {ReadableStream} stream */
function open(stream, { at = 1000, outlives = false } = {}) {
  const life = new AbortController();
  return { life, body: new Body(new Response(stream), life, at, outlives) };
}

test('gives no more than is wished, and what was read too far the next time', async () => {
  const { body } = open(streamOf(FILE));
  assert.deepEqual(await body.next(30, NEVER, asItIs), FILE.slice(0, 30));
  assert.equal(body.at, 1030);
  assert.deepEqual(await body.next(1000, NEVER, asItIs), FILE.slice(30, 100));
  assert.deepEqual(await body.next(1000, NEVER, asItIs), FILE.slice(100, 200));
  assert.deepEqual(await body.next(1000, NEVER, asItIs), FILE.slice(200, 250));
  assert.equal(body.at, 1250);
  assert.equal(await body.next(1000, NEVER, asItIs), null);
});

test('an abort gives the answer up', { timeout: 10_000 }, async () => {
  const { body, life } = open(new ReadableStream());
  const abort = new AbortController();
  const next = body.next(10, abort.signal, asItIs);
  abort.abort();
  assert.equal(await next, null);
  assert.equal(life.signal.aborted, true);
});

test('an answer that outlives the abort is read on without a gap', { timeout: 10_000 }, async () => {
  /** @type {ReadableStreamDefaultController | undefined} */
  let sender;
  const { body, life } = open(new ReadableStream({ start: (controller) => void (sender = controller) }), { outlives: true });
  const abort = new AbortController();
  const next = body.next(10, abort.signal, asItIs);
  abort.abort();
  assert.equal(await next, null);
  assert.equal(life.signal.aborted, false);
  sender?.enqueue(FILE);
  assert.deepEqual(await body.next(10, NEVER, asItIs), FILE.slice(0, 10));
});

test('a failure of the network is the guard’s to name', async () => {
  const { body } = open(streamOf(new Uint8Array(0), true));
  const guard = (/** @type {Promise<any>} */ promise) => promise.catch(() => Promise.reject(new RangeError('guarded')));
  await assert.rejects(body.next(10, NEVER, guard), RangeError);
});
