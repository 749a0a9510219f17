import assert from 'node:assert/strict';
import test from 'node:test';
import { fileName } from '../../main/js/page/tools/names.js';
import { linkTo } from '../../main/js/page/tools/share.js';
import { State } from '../../main/js/page/tools/state.js';
import { readCamera, takeCamera, writeCamera } from '../../main/js/page/tools/view.js';
import { Orbit } from '../../main/js/viewer/orbit.js';

/** A part that keeps what it reads. @param {string | null} [value] */
function part(value = null) {
  return {
    value,
    write() {
      return this.value;
    },
    /** @param {string} text */
    read(text) {
      this.value = text;
    },
  };
}

/** @param {number} width @param {number} height */
function framed(width, height) {
  const orbit = new Orbit();
  orbit.bounds = [100, 200, 300, 104, 206, 303];
  orbit.resize(width, height, { top: 48, bottom: 120 });
  return orbit;
}

test('writes the parts of a view that differ from what everybody sees', () => {
  const state = new State();
  state.add('camera', part('30,75,1'));
  state.add('lod', part());
  state.add('words', part('a b&c=d'));
  assert.equal(state.write(), 'camera=30,75,1&words=a%20b%26c%3Dd');
});

test('gives each part what the address says of it, also when it is added later', () => {
  const state = new State();
  const [early, late, absent] = [part(), part(), part()];
  state.add('words', early);
  state.read('#words=a%20b%26c%3Dd&lod=3');
  assert.deepEqual([early.value, state.isWanted('words'), state.isWanted('lod')], ['a b&c=d', false, true]);
  state.add('lod', late);
  state.add('other', absent);
  assert.deepEqual([late.value, absent.value, state.isWanted('lod')], ['3', null, false]);
});

test('takes the camera to the same place', () => {
  const before = framed(800, 600);
  before.turn(-7, 0.4);
  before.zoom(0.3, 0.2, -0.1);
  const after = framed(800, 600);
  readCamera(writeCamera(before) ?? '', after);
  const { target, theta, phi, radius } = after.pose;
  assert.ok(Math.abs(radius / before.pose.radius - 1) < 1e-3);
  assert.ok(Math.abs(phi - before.pose.phi) < 1e-5);
  assert.ok(Math.abs(Math.sin(theta - before.pose.theta)) < 1e-5);
  target.forEach((at, i) => assert.ok(Math.abs(at - before.pose.target[i]) < 1e-3));
  assert.ok(after.isTouched);
  assert.deepEqual(after.camera.target, target);
});

test('shows all of the model in a narrow window that a wide one shows', () => {
  const wide = framed(1200, 600);
  wide.zoom(1);
  const narrow = framed(300, 600);
  const whole = narrow.pose.radius;
  readCamera(writeCamera(wide) ?? '', narrow);
  assert.ok(narrow.pose.radius >= whole && narrow.pose.radius < 1.5 * whole);
  const same = framed(1200, 600);
  same.resize(1200, 600, { top: 48, bottom: 300 });
  readCamera(writeCamera(wide) ?? '', same);
  assert.ok(Math.abs(same.pose.radius / wide.pose.radius - 1) < 1e-3);
});

test('places the camera anew when the bounds are exact, unless somebody has moved it meanwhile', () => {
  const before = framed(800, 600);
  before.turn(1, 0.2);
  before.zoom(0.4);
  const link = writeCamera(before) ?? '';
  for (const isMoved of [false, true]) {
    /** @type {any} */
    const session = Object.assign(new EventTarget(), { figures: { header: { whole: false } } });
    const orbit = framed(1000, 300);
    orbit.bounds = [99, 200, 300, 105, 206, 305];
    takeCamera(link, orbit, session);
    orbit.refit(300, 600);
    if (isMoved) orbit.turn(0.1, 0);
    orbit.bounds = [100, 200, 300, 104, 206, 303];
    session.figures.header.whole = true;
    session.dispatchEvent(new Event('change'));
    assert.equal(writeCamera(orbit) === link, !isMoved);
  }
});

test('says nothing of a camera that nobody has moved, and ignores what is no camera', () => {
  const orbit = framed(800, 600);
  assert.equal(writeCamera(orbit), null);
  for (const text of ['', '1,2,3', '1,2,0,0,0,0', '1,2,x,0,0,0', '1,2,-1,0,0,0', '1,2,1,0,0,0,0']) readCamera(text, orbit);
  assert.equal(orbit.isTouched, false);
});

test('puts a view into the address of the page and leaves the rest', () => {
  assert.equal(linkTo('http://h/?m=a&shading=flat', 'z', 'camera=1,2&lod=3'), 'http://h/?m=a&up=z#camera=1,2&lod=3');
  assert.equal(linkTo('http://h/m/a/#old', undefined, ''), 'http://h/m/a/');
});

test('names files as every system takes them', () => {
  assert.equal(fileName('Amphora'), 'Amphora');
  assert.equal(fileName('a/b:c?.ply'), 'a-b-c-.ply');
  assert.equal(fileName('../x'), 'x');
  assert.equal(fileName(' ? '), 'model');
});
