import assert from 'node:assert/strict';
import test from 'node:test';
import * as numbers from '../../main/resources/META-INF/resources/jsm/viewer/numbers.js';

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

test('counts keep all their digits', () => {
  assert.equal(numbers.count(1234567).replace(/\D/g, ''), '1234567');
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
  assert.equal(plain(numbers.distance(0.012345)), '0.012 %');
});
