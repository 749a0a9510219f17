import assert from 'node:assert/strict';
import test from 'node:test';
import { DamagedArchive, OutOfMemory, valueOf } from '../../main/js/decode/answers.js';

/** @param {() => string} ask */
function thrownBy(ask) {
  try {
    return assert.fail(`answered ${valueOf(ask)}`);
  } catch (error) {
    assert.ok(error instanceof Error);
    return error;
  }
}

const failing = (/** @type {string} */ kind) => () => JSON.stringify({ error: { kind, message: 'line 1\nline "2"' } });

test('gives the value, also where it is null or false', () => {
  assert.deepEqual(valueOf(() => '{"value":[1,"a\\u000ab"]}'), [1, 'a\nb']);
  assert.equal(valueOf(() => '{"value":null}'), null);
  assert.equal(valueOf(() => '{"value":false}'), false);
});

test('throws what Java answers', () => {
  const damaged = thrownBy(failing('damaged'));
  assert.ok(damaged instanceof DamagedArchive);
  assert.equal(damaged.message, 'line 1\nline "2"');
  assert.ok(thrownBy(failing('memory')) instanceof OutOfMemory);
  const call = thrownBy(failing('call'));
  assert.ok(!(call instanceof DamagedArchive) && !(call instanceof OutOfMemory));
  assert.equal(call.message, 'line 1\nline "2"');
});

test('takes a trap for damage', () => {
  const error = thrownBy(() => {
    throw new WebAssembly.RuntimeError('array element access out of bounds');
  });
  assert.ok(error instanceof DamagedArchive);
  assert.equal(error.message, 'the decoder stopped (array element access out of bounds)');
});

test('tells lack of memory from damage, in the words of each browser', () => {
  const words = ['requested new array is too large', 'Array buffer allocation failed', 'Out of memory: Cannot allocate Wasm memory'];
  for (const word of words) {
    const error = thrownBy(() => {
      throw new RangeError(word);
    });
    assert.ok(error instanceof OutOfMemory, word);
    assert.match(error.message, /Close other pages/);
  }
});
