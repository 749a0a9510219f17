import assert from 'node:assert/strict';
import test from 'node:test';
import { describe } from '../../main/js/page/card-words.js';

test('a card says what state its model is in', () => {
  assert.equal(describe({ state: 'new', format: 'ply' }), 'not encoded yet');
  assert.equal(describe({ state: 'preparing' }), 'being encoded');
  assert.equal(describe({ state: 'preparing', stage: 'simplify', fraction: 0.404 }), 'being encoded: simplify, 40%');
  assert.equal(describe({ state: 'failed', error: 'it has no faces' }), 'it has no faces');
  assert.match(describe({ state: 'ready', faces: 1200, bytes: 40_000 }), /faces · /);
});

test('a card does not say of an archive that it is to be encoded', () => {
  assert.match(describe({ state: 'new', format: 'jsm', fileBytes: 40_000 }), /^4\d|^39/);
  assert.match(describe({ state: 'preparing', format: 'jsm', fileBytes: 40_000 }), /kB/);
});
