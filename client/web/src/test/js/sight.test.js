// @ts-check

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isAsGood, pixelError } from '../../main/js/viewer/sight.js';

/** A model with a diagonal of 2, seen in a picture of 1000 pixels of the screen. @param {number} z of the eye */
function from(z) {
  const camera = /** @type {any} */ ({ eye: [5, 6, 7 + z], fieldOfView: 90 });
  return { orbit: { camera, sphere: { center: /** @type {any} */ ([5, 6, 7]), radius: 1 } }, size: { height: 500, pixelRatio: 2 } };
}

test('measures the error where the model is nearest to the eye', () => {
  // At a distance of 1 the picture is 2 high: 500 pixels for each 1.
  assert.ok(Math.abs(pixelError({ errorQuantile: 0.1 }, from(2)) - 1) < 1e-9);
  assert.ok(Math.abs(pixelError({ errorQuantile: 0.1 }, from(5)) - 0.25) < 1e-9);
});

test('is as good as the original up to half a pixel, and not before anything is known', () => {
  assert.equal(isAsGood({ errorQuantile: 0.1 }, from(2)), false);
  assert.equal(isAsGood({ errorQuantile: 0.1 }, from(4)), true);
  assert.equal(isAsGood({ errorQuantile: 0.1 }, from(0.5)), false); // within
  assert.equal(isAsGood({ errorQuantile: 0 }, from(0.5)), true);
  assert.equal(isAsGood({ errorQuantile: null }, from(1e9)), false);
});
