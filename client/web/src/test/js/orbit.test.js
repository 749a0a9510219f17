import assert from 'node:assert/strict';
import test from 'node:test';
import { Orbit } from '../../main/js/viewer/orbit.js';
import { cross, dot } from '../../main/js/viewer/vectors.js';

/** @typedef {[number, number, number]} Vector */

const BOX = [-3, 10, 4, 5, 12, 5];
const CORNERS = [-3, 5].flatMap((x) => [10, 12].flatMap((y) => [4, 5].map((z) => /** @type {Vector} */ ([x, y, z]))));

/**
 * Where a point of the world is in the picture: across and up, from −1 to 1, and its depth.
 *
 * @param {Orbit} orbit
 * @param {Vector} point
 */
function seen({ matrices: { view, projection } }, [x, y, z]) {
  const times = (/** @type {Float32Array} */ m, /** @type {number[]} */ v) => [0, 1, 2, 3].map((row) => v.reduce((sum, value, column) => sum + m[4 * column + row] * value, 0));
  const [a, b, c, w] = times(projection, times(view, [x, y, z, 1]));
  return [a / w, b / w, c / w];
}

/** @param {number} width @param {number} height @param {{ top: number, bottom: number }} [inset] */
function framed(width, height, inset) {
  const orbit = new Orbit();
  orbit.bounds = BOX;
  orbit.resize(width, height, inset);
  return orbit;
}

test('all of the model is in the picture, and fills it in one direction', () => {
  for (const [width, height] of [[400, 300], [300, 900], [1000, 200]]) {
    const places = CORNERS.map((corner) => seen(framed(width, height), corner));
    const farthest = Math.max(...places.flatMap(([x, y]) => [Math.abs(x), Math.abs(y)]));
    assert.ok(Math.abs(farthest - 0.96) < 1e-5, `${farthest}`);
    assert.ok(places.every(([, , depth]) => depth > -1 && depth < 1));
  }
});

test('what covers the picture is left free', () => {
  const orbit = framed(400, 600, { top: 50, bottom: 250 });
  const heights = CORNERS.map((corner) => seen(orbit, corner)[1]);
  const pixelsFromTop = heights.map((y) => 300 * (1 - y));
  assert.ok(Math.min(...pixelsFromTop) >= 50 && Math.max(...pixelsFromTop) <= 350, `${pixelsFromTop}`);
});

test('a model that stands on its third axis is framed as it stands', () => {
  const orbit = new Orbit();
  orbit.bounds = [-1, -1, -9, 1, 1, 9];
  orbit.resize(300, 300);
  const lying = orbit.pose.radius;
  orbit.upright.model = 'z';
  assert.notEqual(orbit.pose.radius, lying);
  assert.ok(Math.abs(seen(orbit, [0, 9, 0])[0]) < 1e-6);
});

test('the axes stay at right angles, right-handed', () => {
  const orbit = framed(400, 300);
  orbit.turn(2, -0.4);
  orbit.jump();
  const { right, up, back } = orbit.camera.axes;
  [dot(right, up), dot(up, back), dot(back, right)].forEach((product) => assert.ok(Math.abs(product) < 1e-12));
  assert.ok(dot(cross(right, up), back) > 0.999);
});

test('what lies beneath the cursor stays there when the camera comes nearer', () => {
  const orbit = framed(400, 300, { top: 40, bottom: 100 });
  const { target, axes: { right, up } } = orbit.camera;
  // In the plane of the target, as a rule.
  const at = /** @type {Vector} */ (target.map((value, i) => value + 0.8 * right[i] + 0.5 * up[i]));
  const [x, y] = seen(orbit, at);
  orbit.zoom(0.5, x, y);
  orbit.jump();
  const [toX, toY] = seen(orbit, at);
  assert.ok(Math.hypot(toX - x, toY - y) < 1e-5, `${toX - x} ${toY - y}`);
});

test('a movement comes to its end, however many pictures are drawn', () => {
  for (const millis of [4, 16, 90]) {
    const orbit = framed(400, 300);
    orbit.turn(1, 0.2);
    let steps = 0;
    while (orbit.step(millis)) assert.ok(++steps < 1000);
    const { theta, phi } = orbit.pose;
    assert.deepEqual(orbit.camera.eye, (orbit.jump(), orbit.camera.eye));
    assert.ok(Math.abs(theta - 1 - Math.atan2(0.55, 1)) < 1e-9 && phi > 0);
  }
});

test('stays framed until somebody moves the camera', () => {
  const orbit = framed(400, 300);
  const before = orbit.pose.radius;
  orbit.resize(200, 300);
  assert.ok(orbit.pose.radius > before);
  orbit.turn(0.1, 0);
  const { radius } = orbit.pose;
  orbit.resize(400, 300);
  orbit.bounds = [0, 0, 0, 100, 100, 100];
  assert.equal(orbit.pose.radius, radius);
  orbit.frame();
  assert.ok(orbit.pose.radius > radius);
});

test('a window of another shape shows as much of the model', () => {
  const orbit = framed(400, 300);
  orbit.turn(0.5, 0.1);
  orbit.zoom(1.1);
  orbit.jump();
  const isSeen = () => CORNERS.every((corner) => seen(orbit, corner).every((at) => Math.abs(at) <= 1));
  const { eye } = orbit.camera;
  assert.ok(isSeen());
  orbit.refit(100, 300, { top: 20, bottom: 90 });
  assert.notDeepEqual(orbit.camera.eye, eye);
  orbit.refit(100, 300, { top: 0, bottom: 0 });
  assert.ok(isSeen());
  const there = orbit.camera.eye;
  orbit.jump();
  assert.deepEqual(orbit.camera.eye, there);
  orbit.refit(400, 300);
  orbit.camera.eye.forEach((at, i) => assert.ok(Math.abs(at - eye[i]) < 1e-9));
});

test('starts where the page says', () => {
  const orbit = framed(400, 300);
  const { radius } = orbit.pose;
  orbit.start = { theta: 0, share: 2 };
  orbit.resize(400, 300);
  assert.equal(orbit.pose.theta, 0);
  assert.notEqual(orbit.pose.radius, radius);
});

test('goes where the page says later, also when somebody has moved it', () => {
  const orbit = framed(400, 300);
  orbit.turn(1, 0);
  orbit.jump();
  const { theta } = orbit.pose;
  const { eye } = orbit.camera;
  orbit.start = { radius: 7, theta: theta + 1, target: [1, 2, 3], share: 1 };
  assert.deepEqual(orbit.camera.eye, eye);
  orbit.step(16);
  const between = orbit.camera.eye;
  assert.notDeepEqual(between, eye);
  orbit.jump();
  assert.deepEqual([orbit.pose.radius, orbit.pose.theta, orbit.pose.target], [7, theta + 1, [1, 2, 3]]);
  assert.notDeepEqual(orbit.camera.eye, between);
});

test('where visitors want no motion, it is there with the next picture', (context) => {
  /** @type {string[]} */
  const asked = [];
  const matchMedia = (/** @type {string} */ query) => ({ matches: asked.push(query) > 0 });
  Object.assign(globalThis, { matchMedia });
  context.after(() => Reflect.deleteProperty(globalThis, 'matchMedia'));
  const orbit = framed(400, 300);
  orbit.start = { radius: 7, theta: 1, target: [1, 2, 3], share: 1 };
  const before = orbit.camera.eye;
  assert.equal(orbit.step(16), false);
  const { eye } = orbit.camera;
  assert.notDeepEqual(eye, before);
  assert.deepEqual((orbit.jump(), orbit.camera.eye), eye);
  assert.deepEqual(new Set(asked), new Set(['(prefers-reduced-motion: reduce)']));
});

test('neither poles nor the inside of a model are reached', () => {
  const orbit = framed(400, 300);
  orbit.turn(0, 100);
  for (let i = 0; i < 100; i++) orbit.zoom(0.5);
  assert.ok(orbit.pose.phi < Math.PI && orbit.pose.radius > 0);
  for (let i = 0; i < 100; i++) orbit.zoom(2);
  assert.ok(orbit.pose.radius < 100);
});

test('a model of one point has a camera, too', () => {
  const orbit = new Orbit();
  orbit.bounds = [1, 1, 1, 1, 1, 1];
  assert.ok(orbit.camera.eye.every(Number.isFinite));
  assert.ok([...orbit.matrices.projection].every(Number.isFinite));
});

test('nothing but the room around the model lies before the nearest depth', () => {
  const orbit = framed(400, 300);
  const { center, radius } = orbit.sphere;
  const distance = Math.hypot(...orbit.camera.eye.map((x, k) => x - center[k]));
  assert.ok(Math.abs(orbit.camera.near - (distance - 2 * radius)) < 1e-9, `${orbit.camera.near}`);
  orbit.moveTo({ radius: 0.1 * radius });
  orbit.jump();
  assert.equal(orbit.camera.near, radius / 200);
});
