import assert from 'node:assert/strict';
import test from 'node:test';
import { MeshArrays } from '../../main/js/session/mesh-arrays.js';

/** @import { Changes } from '../../main/js/decode/decoder.js' */

const [POSITIONS, NORMALS, COLOURS, INDICES, TANGENTS, SECOND_SET, STARTS] = [0, 1, 2, 3, 5, 7, 10];

/**
 * A step that fills ranges with numbers that count up from a first one.
 *
 * @param {number} step
 * @param {number} vertices
 * @param {number} places
 * @param {[array: number, first: number, count: number, from: number][]} ranges
 * @returns {Changes}
 */
function changes(step, vertices, places, ...ranges) {
  const data = ranges.flatMap(([array, , count, from]) => Array.from({ length: count }, (_, i) => (array === INDICES || array === COLOURS ? from + i : bits(from + i))));
  const numbers = Uint32Array.from(ranges.flatMap(([array, first, count]) => [array, first, count]));
  return { step, jump: false, batches: 1, faces: places, vertices, places, groups: [0, 0, 0, 1, 0, 3 * places], tangents: [1], ranges: numbers, data: Uint32Array.from(data) };
}

/** @param {number} number */
function bits(number) {
  return new Uint32Array(Float32Array.of(number).buffer)[0];
}

test('has room for the whole model from the first step on', () => {
  const arrays = new MeshArrays();
  arrays.expect({ wedges: 100, faces: 98, channels: [{ semantic: 'NORMAL', name: 'normal' }] });
  arrays.take(changes(1, 4, 2, [POSITIONS, 0, 12, 1], [COLOURS, 0, 4, 0xff000000], [INDICES, 0, 6, 0]));
  const { positions, indices } = arrays;
  assert.deepEqual([positions.length, indices.length, arrays.starts.length, arrays.colours.length], [300, 294, 400, 400]);
  arrays.take(changes(2, 100, 98, [POSITIONS, 297, 3, 7], [INDICES, 3, 2, 50]));
  assert.deepEqual([arrays.generation, arrays.vertices, arrays.corners, arrays.step], [1, 100, 294, 2]);
  assert.equal(arrays.positions, positions);
  assert.equal(arrays.indices, indices);
  assert.deepEqual([...positions.subarray(294)], [0, 0, 0, 7, 8, 9]);
  assert.deepEqual([...indices.subarray(0, 7)], [0, 1, 2, 50, 51, 5, 0]);
  assert.deepEqual([...arrays.colours.subarray(4, 8)], [1, 0, 0, 255]);
  assert.deepEqual([...arrays.tangentSlots], [1]);
});

test('has room for creases of a model without normals, and for slots that grow', () => {
  const arrays = new MeshArrays();
  arrays.expect({ wedges: 100, faces: 98, slots: [/** @type {any} */ ({}), /** @type {any} */ ({}), /** @type {any} */ ({})] });
  arrays.take(changes(1, 4, 2, [POSITIONS, 0, 12, 1]));
  assert.deepEqual([arrays.positions.length, arrays.indices.length], [390, 441]);
});

test('leaves out groups without faces', () => {
  const arrays = new MeshArrays();
  arrays.take(changes(1, 4, 2, [POSITIONS, 0, 12, 1]));
  assert.deepEqual(arrays.groups, [{ slot: 1, start: 0, count: 6 }]);
});

test('makes other arrays, with what is there, when more room is needed or data of another kind comes', () => {
  const arrays = new MeshArrays();
  arrays.expect({ wedges: 10, faces: 8, channels: [{ semantic: 'NORMAL', name: 'normal' }] });
  arrays.take(changes(1, 10, 8, [POSITIONS, 0, 30, 1], [INDICES, 0, 24, 0]));
  arrays.take(changes(2, 20, 8, [POSITIONS, 30, 30, 31]));
  assert.deepEqual([arrays.generation, arrays.positions.length], [2, 78]);
  assert.deepEqual([...arrays.positions.subarray(0, 60)], Array.from({ length: 60 }, (_, i) => i + 1));
  assert.equal(arrays.indices[23], 23);
  arrays.take(changes(3, 20, 8, [SECOND_SET, 2, 2, 5]));
  assert.deepEqual([arrays.generation, arrays.uvs.map((set) => set.length), [...arrays.uvs[1].subarray(0, 4)]], [3, [0, 52, 0, 0], [0, 0, 5, 6]]);
  arrays.take(changes(4, 20, 8, [TANGENTS, 0, 4, 5]));
  assert.deepEqual([arrays.generation, arrays.tangents.length], [4, 104]);
});

test('makes room for what comes where nothing is known of the whole', () => {
  const arrays = new MeshArrays();
  arrays.expect({ wedges: null, faces: null });
  arrays.take(changes(1, 5, 3, [POSITIONS, 0, 15, 1]));
  assert.deepEqual([arrays.positions.length, arrays.indices.length], [15, 9]);
});

test('lets go of room that there is no memory for, and keeps what is there', () => {
  const arrays = new MeshArrays();
  const header = { wedges: 100, faces: 98, channels: [{ semantic: 'NORMAL', name: 'normal' }] };
  arrays.expect(header);
  arrays.take(changes(1, 4, 2, [POSITIONS, 0, 12, 1], [INDICES, 0, 6, 0]));
  arrays.fit({ ...header, wedges: 50, faces: 1 });
  assert.deepEqual([arrays.generation, arrays.positions.length, arrays.indices.length], [2, 150, 6]);
  assert.deepEqual([[...arrays.positions.subarray(0, 12)], [...arrays.indices]], [Array.from({ length: 12 }, (_, i) => i + 1), [0, 1, 2, 3, 4, 5]]);
  arrays.begin(changes(2, 20, 2, [POSITIONS, 12, 48, 13]));
  arrays.apply(24);
  arrays.fit({ ...header, wedges: 10, faces: 1 });
  assert.deepEqual([arrays.generation, arrays.positions.length], [2, 150], 'not amid a step');
  arrays.apply(Infinity);
  assert.deepEqual([arrays.generation, [...arrays.positions]], [3, Array.from({ length: 60 }, (_, i) => i + 1)]);
});

test('forgets another mesh whose steps count from one again', () => {
  const arrays = new MeshArrays();
  arrays.take(changes(1, 5, 3, [POSITIONS, 0, 15, 1], [NORMALS, 0, 15, 1]));
  arrays.take(changes(1, 5, 3, [POSITIONS, 3, 3, 40]));
  assert.deepEqual([...arrays.positions], [0, 0, 0, 40, 41, 42, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
  assert.deepEqual([arrays.generation, arrays.normals.some((x) => x !== 0)], [2, false]);
});

test('applies a step in slices, and shows its faces when it is whole', () => {
  const arrays = new MeshArrays();
  arrays.expect({ wedges: 10, faces: 8 });
  arrays.take(changes(1, 4, 2, [POSITIONS, 0, 12, 1], [INDICES, 0, 6, 0]));
  assert.deepEqual(arrays.takeFresh(), [{ name: 'positions', first: 0, count: 12 }, { name: 'indices', first: 0, count: 6 }]);
  arrays.begin(changes(2, 5, 3, [STARTS, 16, 4, 1], [POSITIONS, 12, 3, 13], [INDICES, 6, 3, 2]));
  assert.deepEqual([arrays.step, arrays.glided], [2, 0]);
  assert.equal(arrays.apply(5), false);
  assert.deepEqual(arrays.takeFresh(), [{ name: 'starts', first: 16, count: 4 }, { name: 'positions', first: 12, count: 1 }]);
  assert.deepEqual([arrays.vertices, arrays.groups[0].count], [4, 6]);
  assert.equal(arrays.apply(4), false);
  assert.deepEqual(arrays.takeFresh(), [{ name: 'positions', first: 13, count: 2 }, { name: 'indices', first: 6, count: 2 }]);
  assert.equal(arrays.apply(4), true);
  assert.deepEqual([arrays.vertices, arrays.groups[0].count, [...arrays.indices.subarray(6, 9)], [...arrays.positions.subarray(12, 15)]], [5, 9, [2, 3, 4], [13, 14, 15]]);
  assert.deepEqual(arrays.takeFresh(), [{ name: 'indices', first: 8, count: 1 }]);
  assert.equal(arrays.apply(4), true);
});
