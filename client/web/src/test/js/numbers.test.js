import assert from 'node:assert/strict';
import test from 'node:test';
import * as numbers from '../../main/js/session/numbers.js';

/** As in a language with decimal points and without marks between thousands. */
const plain = (/** @type {string} */ text) => text.replace(',', '.');

test('bytes have three digits and the unit that suits them', () => {
  const cases = { 0: '0 bytes', 999: '999 bytes', 1000: '1.00 kB', 12345: '12.3 kB', 99999: '100.0 kB', 123456: '123 kB', 7654321: '7.65 MB', 5e12: '5000 GB' };
  for (const [value, text] of Object.entries(cases)) assert.equal(plain(numbers.bytes(Number(value))).replace(/[.\s]000 G/, '000 G'), text);
});

test('one face is not called faces', () => {
  assert.equal(numbers.faces(1), '1 face');
  assert.equal(numbers.faces(0), '0 faces');
  assert.equal(numbers.faces(2), '2 faces');
});

test('counts keep all their digits, written as the page is', () => {
  assert.equal(numbers.count(1234567), '1,234,567');
});

test('nothing but everything is 100 %', () => {
  assert.equal(numbers.percent(0), '0 %');
  assert.equal(numbers.percent(0.509), '50 %');
  assert.equal(numbers.percent(0.99999), '99 %');
  assert.equal(numbers.percent(1), '100 %');
});

test('an unknown rate is a dash', () => {
  assert.equal(numbers.rate(0), '–');
  assert.equal(plain(numbers.rate(2500)), '2.50 kB/s');
});

test('errors have two digits that count', () => {
  assert.equal(numbers.distance(0), '0');
  assert.equal(numbers.distance(0.012345), '0.012 %');
});

test('errors that no picture shows are not written out', () => {
  assert.equal(numbers.distance(6.3e-10), '< 0.00001 %');
});

test('a box is given in the coordinates of the file, as precisely as its size asks for', () => {
  const digits = (/** @type {string} */ text) => text.replace(/[^\d|-]/g, '');
  const far = numbers.box([0.123, -0.544, 310.5, 20.123, 19.456, 314.25], [450000, 5411000, 0]);
  assert.equal(digits(far), '45000012|541099946|310545002012|541101946|31425');
  assert.match(numbers.box([0, 0, 0, 0, 0, 0], [0, 0, 0]), /^Coordinates from 0 \| 0 \| 0 to 0 \| 0 \| 0$/);
  assert.match(numbers.box([0, 0, 0, 0.00123456, 0, 0], [0, 0, 0]), /to 0.001235 \|/);
});
