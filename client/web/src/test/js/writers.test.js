import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import test from 'node:test';
import { shapeOf, WRITERS } from '../../main/js/page/tools/writers.js';

const validator = createRequire(import.meta.url)('gltf-validator');
const F = Math.fround;
/** Two triangles with an edge in common; its ends are drawn twice, for their normals. */
const POSITIONS = Float32Array.of(0, 0, 0, F(0.1), 0, 0, 0, F(1 / 3), -0, F(0.1), 0, 0, 0, F(1 / 3), -0, 1e-7, 16777216, 3);
const INDICES = Uint32Array.of(0, 1, 2, 4, 3, 5);
const COLOURS = Uint8Array.from({ length: 24 }, (_, i) => (i < 12 ? i : i < 20 ? i - 8 : i));

/** @param {import('../../main/js/page/tools/writers.js').Format} format */
async function written(format, colours = /** @type {Uint8Array<ArrayBuffer> | null} */ (null), origin = [0, 0, 0]) {
  const bytes = await new Blob(WRITERS[format](shapeOf(POSITIONS, INDICES, colours, origin))).arrayBuffer();
  return { bytes, view: new DataView(bytes), text: new TextDecoder('latin1').decode(bytes) };
}

test('joins vertices that are drawn more than once, but not those of other colours', () => {
  const { positions, indices } = shapeOf(POSITIONS, INDICES, null, [0, 0, 0]);
  assert.deepEqual([positions.length, [...indices]], [12, [0, 1, 2, 2, 1, 3]]);
  assert.equal(shapeOf(POSITIONS, INDICES, COLOURS, [0, 0, 0]).positions.length, 12);
  const other = COLOURS.slice();
  other[13] = 99;
  assert.equal(shapeOf(POSITIONS, INDICES, other, [0, 0, 0]).positions.length, 15);
});

test('writes text whose numbers read back as the same', async () => {
  const obj = (await written('obj')).text.split('\n');
  const places = obj.filter((line) => line.startsWith('v ')).map((line) => line.split(' ').slice(1).map((word) => F(Number(word))));
  assert.deepEqual(places.flat(), [0, 0, 0, F(0.1), 0, 0, 0, F(1 / 3), -0, F(1e-7), 16777216, 3]);
  assert.deepEqual(obj.filter((line) => line.startsWith('f ')), ['f 1 2 3', 'f 3 2 4']);
  const off = (await written('off')).text.split('\n');
  assert.deepEqual([off[0], off[1], off[2], off.at(-2)], ['OFF', '4 2 0', '0 0 0', '3 2 1 3']);
});

test('writes PLY bit for bit, with colours, and in double precision where that is needed', async () => {
  const plain = await written('ply', COLOURS);
  const from = plain.text.indexOf('end_header\n') + 11;
  assert.match(plain.text, /element vertex 4\nproperty float x\n[^]*property uchar alpha\nelement face 2\n/);
  assert.equal(plain.view.getFloat32(from + 16, true), F(0.1));
  assert.deepEqual([...new Uint8Array(plain.bytes, from + 28, 4)], [4, 5, 6, 7]);
  assert.equal(plain.bytes.byteLength, from + 4 * 16 + 2 * 13);
  const opaque = await written('ply', COLOURS.map((value, i) => (i % 4 === 3 ? 255 : value)));
  assert.ok(!opaque.text.includes('alpha'));
  assert.equal(opaque.bytes.byteLength, opaque.text.indexOf('end_header\n') + 11 + 4 * 15 + 2 * 13);
  const moved = await written('ply', null, [1e9, 0, 0]);
  assert.equal(moved.view.getFloat64(moved.text.indexOf('end_header\n') + 11 + 24, true), 1e9 + F(0.1));
});

test('writes STL with normals', async () => {
  const { bytes, view } = await written('stl');
  assert.deepEqual([bytes.byteLength, view.getUint32(80, true)], [84 + 100, 2]);
  assert.deepEqual([0, 4, 8].map((at) => view.getFloat32(84 + at, true)), [0, 0, 1]);
  assert.equal(view.getFloat32(84 + 24, true), F(0.1));
});

test('writes GLB that is valid', async () => {
  for (const colours of [null, COLOURS]) {
    const { bytes } = await written('glb', colours, [5, 0, 0]);
    const report = await validator.validateBytes(new Uint8Array(bytes));
    assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages));
  }
});
