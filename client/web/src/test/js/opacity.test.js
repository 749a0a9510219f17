// @ts-check
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maskOf, mayHaveOpacity, opacityOf } from '../../main/js/three/opacity.js';

/** @param {...number} alphas */
const pixels = (...alphas) => alphas.flatMap((alpha) => [200, 100, 50, alpha]);

test('an image whose pixels are all but opaque is opaque', () => {
  assert.equal(opacityOf(pixels(255, 255, 250)), 'opaque');
});

test('an image that is unseen everywhere has no opacity', () => {
  assert.equal(opacityOf(pixels(0, 0, 0)), 'opaque');
});

test('an image with few pixels between seen and unseen has holes', () => {
  assert.equal(opacityOf(pixels(255, 255, 0, 0, 128)), 'holes');
  assert.equal(opacityOf(pixels(255, 255, 15)), 'holes');
});

test('an image with many pixels between seen and unseen is glass', () => {
  assert.equal(opacityOf(pixels(255, 128, 128, 0)), 'glass');
  assert.equal(opacityOf(pixels(128, 128)), 'glass');
});

test('a mask is the alpha of an image', () => {
  assert.deepEqual([...maskOf(pixels(255, 0, 128))], [255, 255, 255, 255, 0, 0, 0, 0, 128, 128, 128, 128]);
});

test('a mask is the brightness of an image without alpha', () => {
  const rgba = [255, 255, 255, 255, 0, 0, 0, 255, 0, 255, 0, 255];
  assert.deepEqual([...maskOf(rgba)], [255, 255, 255, 255, 0, 0, 0, 0, 182, 182, 182, 182]);
});

test('JPEG and BMP have no opacity, other images may', () => {
  assert.equal(mayHaveOpacity(Uint8Array.of(0xff, 0xd8, 0xff)), false);
  assert.equal(mayHaveOpacity(Uint8Array.of(0x42, 0x4d, 0)), false);
  assert.equal(mayHaveOpacity(Uint8Array.of(0x89, 0x50, 0x4e)), true);
});
