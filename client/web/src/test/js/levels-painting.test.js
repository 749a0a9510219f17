import assert from 'node:assert/strict';
import test from 'node:test';
import { cornersOf, cutsOf, measured, paintedByLevel } from '../../main/js/levels/painting.js';
import { colourOf, shaded } from '../../main/js/levels/palette.js';
import { squaredDistance, TriangleTree } from '../../main/js/levels/triangle-tree.js';

/** Numbers from 0 to 1 that look like chance and are the same each time. */
function numbers(seed = 1) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

/** One face from (0, 0) to (2, 2) in the plane z = height. */
function triangle(height = 0) {
  return {
    positions: Float32Array.of(0, 0, height, 2, 0, height, 0, 2, height),
    indices: Uint32Array.of(0, 1, 2),
    groups: [{ slot: 0, start: 0, count: 3 }],
    faces: 1,
  };
}

const never = { isStale: () => false };

test('the tree finds the same distances as a look at each triangle', () => {
  const next = numbers();
  for (const size of [1, 2, 5, 333]) {
    const corners = Float32Array.from({ length: 9 * size }, (_, i) => next() * 0.3 + (Math.floor(i / 9) % 7));
    const tree = new TriangleTree(corners.slice());
    for (let i = 0; i < 200; i++) {
      const [x, y, z] = [9 * next() - 1, 9 * next() - 1, 9 * next() - 1];
      let least = Infinity;
      for (let t = 0; t < corners.length; t += 9) least = Math.min(least, squaredDistance(corners, t, x, y, z));
      assert.equal(tree.distance(x, y, z), Math.sqrt(least));
    }
  }
});

test('a point is measured from plane, edges and corners of a triangle', () => {
  const p = Float32Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0);
  assert.equal(squaredDistance(p, 0, 0.5, 0.5, 3), 9);
  assert.equal(squaredDistance(p, 0, 1, -2, 0), 4);
  assert.equal(squaredDistance(p, 0, 2, 2, 0), 2);
  assert.equal(squaredDistance(p, 0, -3, -4, 0), 25);
});

test('a triangle may be a line or a point', () => {
  assert.equal(squaredDistance(Float32Array.of(0, 0, 0, 1, 0, 0, 4, 0, 0), 0, 3, 2, 0), 4);
  assert.equal(squaredDistance(Float32Array.of(1, 1, 1, 1, 1, 1, 1, 1, 1), 0, 1, 1, 3), 4);
});

test('distances inside a coarse face are seen although its corners lie on the other mesh', async () => {
  // Corners touch the other mesh, which is 1 below the middle of the longest side.
  const other = new TriangleTree(Float32Array.of(0, 0, 0, 2, 0, 0, 1, 1, -1, 0, 0, 0, 1, 1, -1, 0, 2, 0));
  const found = await measured(triangle(), other, never);
  assert.ok(found !== null);
  const n = cutsOf(1);
  assert.equal(found.positions.length, 9 * n * n);
  assert.equal(found.distances.length, 3 * n * n);
  const [x, y, z] = found.farthest.at;
  assert.deepEqual([x + y, z], [2, 0]);
  assert.equal(Math.fround(found.farthest.distance), Math.max(...found.distances));
  assert.ok(found.farthest.distance > 0.5 && found.farthest.distance < 1);
  let area = 0;
  for (let i = 0; i < found.positions.length; i += 9) {
    const [ax, ay, , bx, by, , cx, cy] = found.positions.subarray(i, i + 9);
    area += ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
  }
  assert.ok(Math.abs(area - 2) < 1e-5, `the pieces cover ${area}`);
});

test('a face that is left whole is measured in its middle', async () => {
  const other = new TriangleTree(cornersOf(triangle(-3)));
  const found = await measured(triangle(), other, { isWhole: true, isStale: () => false });
  assert.deepEqual([...(found?.distances ?? [])], [3, 3, 3]);
  assert.deepEqual([...(found?.positions ?? [])], [...triangle().positions]);
  assert.equal(found?.farthest.distance, 3);
  assert.deepEqual(found?.farthest.at, [2 / 3, 2 / 3, 0]);
});

test('a mesh of many faces is cut no further', () => {
  assert.equal(cutsOf(1e6), 1);
  assert.ok(cutsOf(500) > 8);
  assert.ok(cutsOf(0) >= 1);
});

test('each face has the colour of its level', () => {
  const snapshot = /** @type {any} */ ({ ...triangle(), indices: Uint32Array.of(0, 1, 2, 0, 0, 0, 2, 1, 0), groups: [{ slot: 1, start: 6, count: 3 }, { slot: 0, start: 0, count: 3 }], levels: Uint16Array.of(0, 9, 4) });
  const { positions, colours } = paintedByLevel(snapshot, 4);
  assert.deepEqual([...positions.subarray(0, 3)], [0, 2, 0]);
  assert.deepEqual([...colours.subarray(0, 4)], [...colourOf(1), 255]);
  assert.deepEqual([...colours.subarray(20, 24)], [...colourOf(0), 255]);
  assert.equal(colours.length, 24);
});

test('a larger number has a brighter colour', () => {
  const brightness = (/** @type {number} */ share) => colourOf(share).reduce((sum, part, i) => sum + [0.2126, 0.7152, 0.0722][i] * part, 0);
  for (let i = 0; i < 50; i++) assert.ok(brightness((i + 1) / 50) > brightness(i / 50), `at ${i}`);
  assert.deepEqual(colourOf(2), colourOf(1));
});

test('distances are shaded up to the end of the scale', () => {
  const colours = shaded(Float32Array.of(0, 2, 4, 8), 4);
  assert.deepEqual([...colours.subarray(0, 4)], [...colourOf(0), 255]);
  assert.deepEqual([...colours.subarray(8, 12)], [...colourOf(1), 255]);
  assert.deepEqual([...colours.subarray(12)], [...colourOf(1), 255]);
  assert.deepEqual([...shaded(Float32Array.of(0), 0)], [...colourOf(0), 255]);
});
