import assert from 'node:assert/strict';
import test from 'node:test';
import { Download } from '../../main/js/decode/download.js';
import { Limiter } from '../../main/js/decode/limiter.js';
import { bytesUpTo, partOf, serve, skipPauses, standOn } from './support/web.js';

standOn('http://host/page');

const NEVER = new AbortController().signal;

test('waits as long as a slow link takes, and makes up for late timers', async (t) => {
  let now = 5000;
  const pauses = skipPauses(t);
  const limiter = new Limiter(8000, () => now);
  assert.equal(limiter.portion, 400);
  await limiter.spend(400, NEVER); // within what may be caught up on
  await limiter.spend(400, NEVER);
  now += 70; // 20 late
  await limiter.spend(400, NEVER);
  now += 1000; // nobody reads: nothing is saved up but one portion
  await limiter.spend(800, NEVER);
  assert.deepEqual(pauses, [50, 30, 50]);
});

test('does not hold up whoever gives up', { timeout: 5000 }, async () => {
  const life = new AbortController();
  const limiter = new Limiter(1);
  const spent = limiter.spend(1e6, life.signal);
  life.abort();
  await spent;
  await limiter.spend(1e6, life.signal);
});

test('brings every byte of a download, in portions of the link', async (t) => {
  const pauses = skipPauses(t, (millis) => millis < 10_000);
  const file = bytesUpTo(1000);
  serve(t, (one) => partOf(one, file));
  /** @type {number[]} */
  const sizes = [];
  const listener = { begin() {}, bytes: (/** @type {Uint8Array} */ chunk) => void sizes.push(chunk.length), end() {}, waiting() {} };
  const download = new Download('http://host/a.jsm', listener);
  let now = 0;
  download.limiter = new Limiter(1000, () => now++);
  await download.read(0, 1000, NEVER);
  assert.deepEqual(sizes, Array.from({ length: 20 }, () => 50));
  assert.ok(pauses.length > 15, `${pauses.length} pauses`);
});
