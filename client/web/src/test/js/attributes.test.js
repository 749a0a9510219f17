import assert from 'node:assert/strict';
import test from 'node:test';
import { angle, cameraOrbit, cameraTarget, positive } from '../../main/js/viewer/attributes.js';

test('angles come in degrees or radians', () => {
  assert.equal(angle('180deg'), Math.PI);
  assert.equal(angle(' -.5rad '), -0.5);
  for (const none of ['', 'auto', '30', '30 deg', '1.2.3deg', 'deg']) assert.equal(angle(none), null, none);
});

test('an orbit has up to three parts, each of which may be left as it is', () => {
  assert.deepEqual(cameraOrbit('90deg 1rad 2.5m'), { theta: Math.PI / 2, phi: 1, radius: 2.5 });
  assert.deepEqual(cameraOrbit('auto 90deg 150%'), { phi: Math.PI / 2, share: 1.5 });
  assert.deepEqual(cameraOrbit('0deg'), { theta: 0 });
  assert.deepEqual(cameraOrbit(''), {});
  assert.deepEqual(cameraOrbit('north pole far'), {});
});

test('a target is three lengths', () => {
  assert.deepEqual(cameraTarget('0m 1.5m -2m'), [0, 1.5, -2]);
  assert.deepEqual(cameraTarget('1 2 3'), [1, 2, 3]);
  for (const none of ['', 'auto auto auto', '1m 2m', '1m 2m 3km']) assert.equal(cameraTarget(none), null, none);
});

test('numbers that are none, or not above 0, count as not given', () => {
  assert.equal(positive('2.5', 1), 2.5);
  for (const none of [null, '', 'x', '0', '-1', 'Infinity']) assert.equal(positive(none, 7), 7, `${none}`);
});
