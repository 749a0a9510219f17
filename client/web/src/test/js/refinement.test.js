import assert from 'node:assert/strict';
import test from 'node:test';
import { Refinement } from '../../main/js/session/refinement.js';

const POSITIONS = 0;

/**
 * A step that changes so many elements.
 *
 * @param {number} step
 * @param {number} elements
 */
function changes(step, elements, jump = false) {
  const data = new Uint32Array(elements).fill(step);
  return { step, jump, batches: step, faces: 1, vertices: Math.ceil(elements / 3), places: 1, groups: [0, 0, 3 * step], tangents: [], ranges: Uint32Array.of(POSITIONS, 0, elements), data };
}

/** @param {number} [glideMillis] */
function prepare(glideMillis = 200) {
  /** @type {((now: number) => void)[]} */
  const frames = [];
  /** How far vertices had glided whenever something was shown. @type {number[]} */
  const shown = [];
  /** @type {number[]} */
  const applied = [];
  const refinement = new Refinement(({ glided }) => shown.push(glided), glideMillis, (work) => frames.push(work));
  const { arrays } = refinement;
  arrays.expect({ wedges: 1e6, faces: 1 });
  const take = (/** @type {number} */ step, /** @type {number} */ elements, jump = false) => refinement.take(changes(step, elements, jump), () => applied.push(step));
  const run = (/** @type {number} */ now) => frames.shift()?.(now);
  return { arrays, frames, shown, applied, refinement, take, run };
}

test('shows the first step at once', () => {
  const { arrays, frames, shown, applied, refinement, take } = prepare();
  take(1, 1e6);
  assert.deepEqual([shown, applied, frames.length, refinement.isResting], [[1], [1], 0, true]);
  assert.equal(arrays.groups[0].count, 3);
});

test('applies a large step over some frames, then lets its vertices glide', async () => {
  const { arrays, frames, shown, applied, refinement, take, run } = prepare();
  take(1, 3);
  take(2, 300_000);
  const settled = refinement.settled();
  assert.equal(frames.length, 1);
  run(1000);
  run(1016);
  assert.deepEqual([applied, arrays.glided, arrays.groups[0].count], [[1], 0, 3]);
  run(1032);
  assert.deepEqual([applied, arrays.glided, arrays.groups[0].count], [[1, 2], 0, 6]);
  run(1082);
  assert.equal(arrays.glided, 0.25);
  run(1300);
  assert.deepEqual([shown, frames.length, refinement.isResting], [[1, 0, 0, 0, 0.25, 1], 0, true]);
  await settled;
});

test('begins the next step when the vertices of the one before have glided', () => {
  const { applied, take, run, arrays } = prepare();
  take(1, 3);
  take(2, 3);
  take(3, 3);
  run(1000);
  run(1100);
  assert.deepEqual([applied, arrays.step, arrays.glided], [[1, 2], 2, 0.5]);
  run(1180);
  run(1220);
  assert.deepEqual([applied, arrays.step, arrays.glided], [[1, 2, 3], 3, 0]);
});

test('does not glide when nobody wants motion, nor when nothing of the picture stays', () => {
  const still = prepare(0);
  still.take(1, 3);
  still.take(2, 3);
  still.run(1000);
  assert.deepEqual([still.applied, still.arrays.glided, still.frames.length], [[1, 2], 1, 0]);
  const jumping = prepare();
  jumping.take(1, 3);
  jumping.take(2, 3);
  jumping.take(3, 1e6, true);
  jumping.run(1000);
  jumping.run(1016);
  assert.deepEqual([jumping.applied, jumping.arrays.step, jumping.arrays.glided, jumping.frames.length], [[1, 2, 3], 3, 1, 0]);
});

test('gives up what is left for another model', async () => {
  const { refinement, take, run, shown, applied } = prepare();
  take(1, 3);
  take(2, 3);
  const settled = refinement.settled();
  const other = refinement.another();
  await settled;
  run(1000);
  assert.deepEqual([applied, shown.length, other.arrays.step], [[1], 1, 0]);
});

test('gives a slow graphics card three times as much with each frame, and lets nothing glide', () => {
  const { applied, arrays, take, run, frames, shown } = prepare();
  take(1, 3);
  take(2, 900_000);
  for (const now of [1000, 1400]) run(now);
  assert.deepEqual([applied, arrays.glided, frames.length], [[1], 0, 1]);
  run(1800);
  assert.deepEqual([applied, arrays.step, arrays.glided, frames.length, shown.length], [[1, 2], 2, 1, 0, 4]);
});

test('does not slice a step while the page is hidden', (t) => {
  const { applied, take, run, frames } = prepare();
  Object.assign(globalThis, { document: { hidden: true } });
  t.after(() => Reflect.deleteProperty(globalThis, 'document'));
  take(1, 3);
  take(2, 2_500_000);
  run(1000);
  assert.deepEqual([applied, frames.length], [[1, 2], 0]);
});

test('gives up when there is no memory for a step, and keeps what is shown', async () => {
  let lacks = 0;
  /** @type {((now: number) => void)[]} */
  const frames = [];
  const refinement = new Refinement(() => {}, 200, (work) => frames.push(work), () => lacks++);
  refinement.take(changes(1, 3), () => {});
  refinement.take({ ...changes(2, 3), vertices: 1e15 }, () => assert.fail('it is not applied'));
  const settled = refinement.settled();
  frames.shift()?.(1000);
  await settled;
  const { arrays } = refinement;
  assert.deepEqual([lacks, refinement.isResting, arrays.step, arrays.isWhole, arrays.groups[0].count, frames.length], [1, true, 1, true, 3, 0]);
  assert.deepEqual([...arrays.positions.subarray(0, 3)], [...new Float32Array(Uint32Array.of(1, 1, 1).buffer)]);
});
