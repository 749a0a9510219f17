import assert from 'node:assert/strict';
import test from 'node:test';
import { BACKOFF_MILLIS, inWords, pause, retryAfterMillis } from '../../main/js/session/retry.js';

/**
 * @param {number} status
 * @param {string} [after]
 */
const answer = (status, after) => new Response(null, { status, headers: after === undefined ? {} : { 'Retry-After': after } });

test('a busy server says how long it wants to be left alone', () => {
  assert.equal(retryAfterMillis(answer(503, '3')), 3000);
  assert.equal(retryAfterMillis(answer(429, '3')), 3000);
});

test('nobody waits longer than half a minute', () => {
  assert.equal(retryAfterMillis(answer(503, '3600')), 30_000);
});

test('other answers, and dates, say nothing of it', () => {
  assert.equal(retryAfterMillis(answer(503)), 0);
  assert.equal(retryAfterMillis(answer(500, '3')), 0);
  assert.equal(retryAfterMillis(answer(503, 'Fri, 31 Dec 1999 23:59:59 GMT')), 0);
});

test('a pause ends when it is over', { timeout: 10_000 }, () => pause(1));

test('a pause ends when it is given up', { timeout: 10_000 }, async () => {
  const abort = new AbortController();
  const pausing = pause(1e6, abort.signal);
  abort.abort();
  await pausing;
  await pause(1e6, abort.signal);
});

test('whoever waits is told why, for how long, and how often it has been tried', () => {
  assert.equal(inWords(0, 2), `Connection lost; trying again (2 of ${BACKOFF_MILLIS.length})`);
  assert.equal(inWords(1500, 1), `The server is busy; trying again in 1.5 s (1 of ${BACKOFF_MILLIS.length})`);
});
