import assert from 'node:assert/strict';
import test from 'node:test';
import { isSeen, setCut } from '../../main/js/page/marks/cut.js';
import { CutMaterials } from '../../main/js/page/marks/cut-materials.js';
import { lengthInWords, unitOf } from '../../main/js/page/marks/lengths.js';
import { pick } from '../../main/js/page/marks/pick.js';
import * as planes from '../../main/js/page/marks/planes.js';
import { distance, middle, project, rayThrough, stood } from '../../main/js/page/marks/space.js';
import { pointsOf, textOf } from '../../main/js/page/marks/text.js';
import { Orbit } from '../../main/js/viewer/orbit.js';

/** @import { Vector } from '../../main/js/viewer/vectors.js' */

const SIZE = { width: 800, height: 600 };

/** @param {'y' | 'z'} up */
function eye(up) {
  const orbit = new Orbit();
  orbit.bounds = [10, 20, 30, 14, 26, 33];
  orbit.upright.chosen = up;
  orbit.resize(SIZE.width, SIZE.height, { top: 48, bottom: 150 });
  orbit.turn(0.7, -0.2);
  orbit.jump();
  return orbit;
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function assertNear(a, b, tolerance = 1e-9) {
  Array.from(a).forEach((value, i) => assert.ok(Math.abs(value - b[i]) < tolerance, `${[...Array.from(a)]} ${[...Array.from(b)]}`));
}

/** Squares across z at 1, 2 and 3, from −1 to 1. */
function squares() {
  const positions = [1, 2, 3].flatMap((z) => [-1, -1, z, 1, -1, z, 1, 1, z, -1, 1, z]);
  const indices = [0, 4, 8].flatMap((first) => [first, first + 1, first + 2, first, first + 2, first + 3]);
  return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices), groups: [{ slot: 1, start: 6, count: 12 }, { slot: 0, start: 0, count: 6 }] };
}

for (const up of /** @type {const} */ (['y', 'z'])) {
  test(`a ray through the place of a point meets it, where ${up} points up`, () => {
    const orbit = eye(up);
    /** @type {Vector} */
    const point = [11, 25, 30.5];
    const place = project(orbit, SIZE, point);
    assert.ok(place !== null);
    const { from, along } = rayThrough(orbit, SIZE, place);
    const far = distance(from, point);
    assertNear(from.map((at, i) => at + far * along[i]), point);
    assert.ok(Math.abs(distance(stood(orbit, from), orbit.camera.eye)) < 1e-9);
  });
}

test('places are those of the matrices that draw', () => {
  const orbit = eye('y');
  const { view, projection } = orbit.matrices;
  const times = (/** @type {Float32Array} */ m, /** @type {number[]} */ v) => [0, 1, 2, 3].map((row) => v.reduce((sum, value, column) => sum + m[4 * column + row] * value, 0));
  const [x, y, , w] = times(projection, times(view, [13, 21, 31, 1]));
  const place = project(orbit, SIZE, [13, 21, 31]);
  assertNear([place?.x ?? 0, place?.y ?? 0], [((1 + x / w) * SIZE.width) / 2, ((1 - y / w) * SIZE.height) / 2], 0.01);
});

test('the middle of the picture is what the camera turns about, and what is behind it is nowhere', () => {
  const orbit = eye('y');
  const { eye: at, target } = orbit.camera;
  const place = project(orbit, SIZE, target);
  assertNear([place?.x ?? 0, place?.y ?? 0], [middle(orbit, SIZE).x, middle(orbit, SIZE).y]);
  assert.equal(project(orbit, SIZE, /** @type {Vector} */ (at.map((value, i) => 2 * value - target[i]))), null);
});

test('picks what is nearest, from either side, and nothing beside it', async () => {
  const mesh = squares();
  assertNear((await pick(mesh, { from: [0.3, 0.4, 9], along: [0, 0, -1] })) ?? [], [0.3, 0.4, 3]);
  assertNear((await pick(mesh, { from: [0.3, 0.4, 0], along: [0, 0, 1] })) ?? [], [0.3, 0.4, 1]);
  assertNear((await pick(mesh, { from: [0.3, 0.4, 1.5], along: [0, 0, 1] })) ?? [], [0.3, 0.4, 2]);
  assert.equal(await pick(mesh, { from: [1.3, 0.4, 9], along: [0, 0, -1] }), null);
  assert.equal(await pick(mesh, { from: [0.3, 0.4, 9], along: [0, 0, 1] }), null);
});

test('picks nothing that is cut away', async () => {
  setCut(planes.planeOf({ ...planes.START, axis: 'z', share: 0.75 }, [-1, -1, 1, 1, 1, 3]));
  assertNear((await pick(squares(), { from: [0, 0, 9], along: [0, 0, -1] }, isSeen)) ?? [], [0, 0, 2]);
  setCut(null);
  assertNear((await pick(squares(), { from: [0, 0, 9], along: [0, 0, -1] }, isSeen)) ?? [], [0, 0, 3]);
});

test('rests while it looks through many triangles', async () => {
  const { positions, indices, groups } = squares();
  const many = Uint32Array.from({ length: 18 << 16 }, (_, i) => indices[i % 18]);
  let rests = 0;
  const now = performance.now;
  let millis = 0;
  performance.now = () => (millis += 4);
  try {
    await pick({ positions, indices: many, groups: [{ ...groups[0], start: 0, count: many.length }] }, { from: [0, 0, 9], along: [0, 0, -1] }, undefined, async () => void rests++);
  } finally {
    performance.now = now;
  }
  assert.ok(rests >= 10, `${rests}`);
});

test('lengths have the unit of the file', () => {
  const header = /** @type {any} */ ({ slots: [{ colour: null }] });
  const opened = (/** @type {string} */ sourceFormat) => /** @type {any} */ ({ manifest: { sourceFormat } });
  assert.equal(unitOf({ opened: opened('PLY'), figures: { header } }), 'units');
  assert.equal(unitOf({ opened: opened('GLB'), figures: { header } }), 'metres');
  assert.equal(unitOf({ opened: null, figures: { header: /** @type {any} */ ({ slots: [{ gltf: '{}' }] }) } }), 'metres');
  assert.equal(lengthInWords(1234.567, 'units'), '1,235 units');
  assert.equal(lengthInWords(1, 'units'), '1 unit');
  assert.equal(lengthInWords(0, 'metres'), '0 µm');
  assert.equal(lengthInWords(0.0123456, 'metres'), '1.235 cm');
  assert.equal(lengthInWords(0.00045, 'metres'), '450 µm');
  assert.equal(lengthInWords(2.5, 'metres'), '2.5 m');
  assert.equal(lengthInWords(12_345, 'metres'), '12.35 km');
});

test('points of an address are those that were written', () => {
  const points = [Math.fround(1 / 3), -2, 1e-9, 4e6, 0, 7].map(Math.fround);
  const text = textOf([/** @type {Vector} */ (points.slice(0, 3)), /** @type {Vector} */ (points.slice(3))]);
  assert.deepEqual(pointsOf(text)?.flat(), points.map((value) => Number(value.toPrecision(7))));
  for (const wrong of ['', '1,2', '1,,3', '1,2,x', '1,2,Infinity']) assert.equal(pointsOf(wrong), null, wrong);
});

test('a plane leaves its share of the model', () => {
  const bounds = [0, 10, 20, 4, 20, 30];
  assert.deepEqual(planes.planeOf({ ...planes.START, share: 0.25 }, bounds), { normal: [1, 0, 0], at: 1 });
  const flipped = planes.planeOf({ ...planes.START, share: 0.25, isFlipped: true }, bounds);
  assert.ok(planes.before(flipped, [0, 0, 0]) < 0 && planes.before(flipped, [2, 0, 0]) > 0);
  const half = Math.SQRT1_2;
  const { at } = planes.planeOf({ axis: 'view', direction: [half, -half, 0], share: 1, isFlipped: false }, bounds);
  assert.ok(Math.abs(at - half * (4 - 10)) < 1e-12);
});

test('an address has a plane, and nothing else', () => {
  const wish = /** @type {planes.Wish} */ ({ axis: 'view', direction: [0.6, 0, -0.8], share: 0.125, isFlipped: true });
  assert.deepEqual(planes.wishOf(planes.textOf(wish)), wish);
  assert.equal(planes.textOf({ ...planes.START, axis: 'y' }), 'y,0.5');
  assert.deepEqual(planes.wishOf('-z,1'), { ...planes.START, axis: 'z', share: 1, isFlipped: true });
  for (const wrong of ['', 'x', 'x,2', 'x,', 'toString,0.5', 'x,0.5,1', 'view,0.5', 'view,0.5,0,0,0', 'view,0.5,1,x,0']) assert.equal(planes.wishOf(wrong), null, wrong);
});

test('materials of a cut model keep what they had, and are dressed once', () => {
  const material = /** @type {any} */ ({ side: 0, transparent: false, onBeforeCompile: (/** @type {any} */ shader) => (shader.vertexShader = 'changed'), customProgramCacheKey: () => 'own' });
  const glass = /** @type {any} */ ({ side: 0, transparent: true });
  const alone = /** @type {any} */ ({ side: 0 });
  const scene = /** @type {any} */ ({ traverse: (/** @type {any} */ see) => [{ material: [material, glass] }, { material: alone }, {}].forEach(see) });
  const materials = new CutMaterials();
  materials.dress(scene);
  materials.dress(scene);
  const shader = { vertexShader: '', fragmentShader: 'void main() {\n  if (a) { b; }\n}\n' };
  material.onBeforeCompile(shader, null);
  assert.equal(shader.vertexShader, 'changed');
  assert.equal(shader.fragmentShader.match(/gl_FrontFacing/g)?.length, 1);
  assert.match(shader.fragmentShader, /^void main\(\) \{\n {2}if \(a\) \{ b; \}\n {2}if \(!gl_FrontFacing\).*\n\}$/);
  assert.equal(material.customProgramCacheKey(), 'own cut');
  assert.deepEqual([material.side, glass.side, alone.side], [2, 0, 0]);
});
