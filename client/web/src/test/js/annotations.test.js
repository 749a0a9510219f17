import assert from 'node:assert/strict';
import test from 'node:test';
import * as format from '../../main/js/page/marks/annotation-format.js';
import { cameraOf, flyTo } from '../../main/js/page/marks/camera.js';
import { meets } from '../../main/js/page/marks/pick.js';
import { Orbit } from '../../main/js/viewer/orbit.js';

/** @import { Annotation } from '../../main/js/page/marks/annotation-format.js' */

const ORIGIN = [500_000, 0, -20];
/** @type {Annotation[]} */
const WRITTEN = [
  { title: 'Größe <b>', text: 'Zwei\nZeilen', point: [1, 2, 3], camera: { eye: [4, 5, 6], target: [1, 2, 3] } },
  { title: 'Lip', text: '', point: [-1, 0.5, 0], camera: null },
];

test('what is written as a file reads as the same, in the coordinates of the model file', () => {
  const text = format.writeFile(WRITTEN, ORIGIN);
  assert.deepEqual(JSON.parse(text).annotations[0].point, [500_001, 2, -17]);
  assert.deepEqual(format.readFile(JSON.parse(text), ORIGIN), { annotations: WRITTEN, problems: [] });
});

test('leaves out what is wrong in a file, and says what', () => {
  const good = { title: 'a', point: [1, 2, 3] };
  /** @type {[unknown, RegExp][]} */
  const wrong = [
    [null, /no “title”/],
    ['x', /no “title”/],
    [{ title: ' ', point: [1, 2, 3] }, /no “title”/],
    [{ title: 'a'.repeat(201), point: [1, 2, 3] }, /longer than 200/],
    [{ ...good, text: 7 }, /“text” is no text/],
    [{ ...good, text: 'a'.repeat(5001) }, /longer than 5000/],
    [{ title: 'a' }, /three numbers/],
    [{ title: 'a', point: [1, 2] }, /three numbers/],
    [{ title: 'a', point: [1, 2, '3'] }, /three numbers/],
    [{ ...good, camera: {} }, /“camera”/],
    [{ ...good, camera: 7 }, /“camera”/],
    [{ ...good, camera: { eye: [1, 1, 1], target: [1, 1, 1] } }, /“camera”/],
  ];
  for (const [entry, reason] of wrong) {
    const { annotations, problems } = format.readFile({ annotations: [good, entry] }, [0, 0, 0]);
    assert.equal(annotations.length, 1);
    assert.match(problems.join(), reason);
    assert.match(problems.join(), /^Annotation 2 is left out/);
  }
  for (const file of [null, 7, [], {}, { annotations: {} }]) assert.match(format.readFile(file, [0, 0, 0]).problems.join(), /no list/);
  const many = format.readFile({ annotations: Array.from({ length: 501 }, () => good) }, [0, 0, 0]);
  assert.equal(many.annotations.length, 500);
  assert.match(many.problems.join(), /first 500 of 501/);
});

test('an address has annotations, and nothing else', () => {
  const text = format.textOf(WRITTEN) ?? '';
  assert.match(text, /^[\w-]+$/);
  assert.deepEqual(format.annotationsOf(text), WRITTEN);
  for (const wrong of ['', '!', 'aaaa', btoa('7'), btoa('[7]'), btoa('[["a","b",1,2]]'), btoa('{"a":1}')]) assert.deepEqual(format.annotationsOf(wrong), [], wrong);
  assert.equal(format.textOf([{ ...WRITTEN[1], text: 'a'.repeat(5000) }]), null);
});

for (const up of /** @type {const} */ (['y', 'z'])) {
  test(`the camera flies to where an annotation was written, where ${up} points up`, () => {
    Object.assign(globalThis, { matchMedia: () => ({ matches: true }) });
    const orbit = new Orbit();
    orbit.bounds = [10, 20, 30, 14, 26, 33];
    orbit.upright.chosen = up;
    orbit.turn(2.9, 0.3);
    orbit.zoom(0.5, 0.3, 0.2);
    orbit.jump();
    const camera = cameraOf(orbit);
    const { eye, target } = orbit.camera;
    orbit.turn(-5, 0.4);
    orbit.jump();
    const before = orbit.pose.theta;
    flyTo(orbit, { camera, point: camera.target });
    [...orbit.camera.eye, ...orbit.camera.target].forEach((value, i) => assert.ok(Math.abs(value - [...eye, ...target][i]) < 1e-9));
    assert.ok(Math.abs(orbit.pose.theta - before) <= Math.PI);
    flyTo(orbit, { camera: null, point: camera.eye });
    orbit.camera.target.forEach((value, i) => assert.ok(Math.abs(value - eye[i]) < 1e-9));
  });
}

test('finds out whether a mesh hides a point', async () => {
  const mesh = { positions: Float32Array.of(-1, -1, 2, 1, -1, 2, 0, 1, 2), indices: Uint32Array.of(0, 1, 2), groups: [{ slot: 0, start: 0, count: 3 }] };
  /** @type {import('../../main/js/page/marks/space.js').Ray} */
  const ray = { from: [0, 0, 5], along: [0, 0, -1] };
  assert.equal(await meets(mesh, ray, 2.9), false);
  assert.equal(await meets(mesh, ray, 3.1), true);
  assert.equal(await meets(mesh, ray, 3.1, () => false), false);
});
