import assert from 'node:assert/strict';
import test from 'node:test';
import { crc32 } from '../../main/js/decode/crc32.js';

test('gives the check value of the catalogues', () => {
  assert.equal(crc32(new TextEncoder().encode('123456789')), 0xcbf43926);
});

test('gives zero for nothing, and no negative number', () => {
  assert.equal(crc32(new Uint8Array(0)), 0);
  assert.equal(crc32(Uint8Array.of(255, 255, 255, 255)), 0xffffffff);
});
