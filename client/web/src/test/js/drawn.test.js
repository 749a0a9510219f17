import assert from 'node:assert/strict';
import test from 'node:test';
import { whenDrawn } from '../../main/js/session/drawn.js';

/** @param {import('node:test').TestContext} t */
function prepare(t, hidden = false) {
  const clock = { now: 1000, frames: /** @type {(() => void)[]} */ ([]), calls: 0, pauses: /** @type {[() => void, number][]} */ ([]) };
  t.mock.method(globalThis, 'setTimeout', (/** @type {() => void} */ then, /** @type {number} */ millis) => clock.pauses.push([then, millis]));
  t.mock.method(performance, 'now', () => clock.now);
  Object.assign(globalThis, { document: { hidden }, requestAnimationFrame: (/** @type {() => void} */ work) => clock.frames.push(work) });
  t.after(() => ['document', 'requestAnimationFrame'].forEach((name) => Reflect.deleteProperty(globalThis, name)));
  whenDrawn(() => clock.calls++);
  const run = (/** @type {number} */ now) => {
    clock.now = now;
    clock.frames.shift()?.();
  };
  return { clock, run };
}

test('calls when the frame after the next one begins', (t) => {
  const { clock, run } = prepare(t);
  run(1010);
  assert.equal(clock.calls, 0);
  run(1026);
  assert.equal(clock.calls, 1);
});

test('lets a frame that took long be followed by a pause as long', (t) => {
  const { clock, run } = prepare(t);
  run(1010);
  run(1900);
  const [[then, millis]] = clock.pauses;
  assert.deepEqual([clock.calls, millis], [0, 900]);
  then();
  assert.equal(clock.calls, 1);
});

test('does not wait for ever after a frame that took seconds', (t) => {
  const { clock, run } = prepare(t);
  run(1010);
  run(11_010);
  assert.equal(clock.pauses[0][1], 1000);
});

test('calls at once while the page is hidden', (t) => {
  assert.equal(prepare(t, true).clock.calls, 1);
});
