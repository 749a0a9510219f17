import assert from 'node:assert/strict';
import test from 'node:test';
import { axis, UpChoice, Upright, withUp } from '../../main/js/session/up.js';

/** @returns {Pick<Storage, 'getItem' | 'setItem'>} */
function store() {
  /** @type {Map<string, string>} */
  const kept = new Map();
  return { getItem: (key) => kept.get(key) ?? null, setItem: (key, value) => void kept.set(key, value) };
}

test('takes axes and nothing else', () => {
  assert.equal(axis('y'), 'y');
  assert.equal(axis('z'), 'z');
  for (const other of ['unknown', 'x', '', null, undefined, 'Z']) assert.equal(axis(other), null);
});

test('keeps the choice for each model', () => {
  const shared = store();
  new UpChoice('a', shared).keep('z');
  assert.equal(new UpChoice('a', shared).kept, 'z');
  assert.equal(new UpChoice('b', shared).kept, null);
  new UpChoice('a', shared).keep('y');
  assert.equal(new UpChoice('a', shared).kept, 'y');
});

test('takes nothing that the page did not write', () => {
  assert.equal(new UpChoice('a', { getItem: () => 'sideways', setItem: () => {} }).kept, null);
});

test('goes on where the browser keeps nothing', () => {
  const closed = () => {
    throw new Error('closed');
  };
  const choice = new UpChoice('a', { getItem: closed, setItem: closed });
  choice.keep('z');
  assert.equal(choice.kept, null);
  new UpChoice('a', null).keep('z');
  assert.equal(new UpChoice('a', null).kept, null);
});

test('puts the axis into the address and leaves the rest', () => {
  assert.equal(withUp('http://h/?m=a&shading=flat', 'z'), 'http://h/?m=a&shading=flat&up=z');
  assert.equal(withUp('http://h/?m=%E6%A8%A1&up=z', 'y'), 'http://h/?m=%E6%A8%A1&up=y');
});

test('stands as chosen, else as the archive says, else on y', () => {
  const upright = new Upright();
  /** @type {string[]} */
  const told = [];
  upright.addEventListener('change', () => told.push(upright.axis));
  upright.model = 'unknown';
  upright.model = 'z';
  upright.chosen = 'y';
  upright.model = 'z';
  upright.chosen = null;
  assert.deepEqual(told, ['y', 'z', 'y', 'y', 'z']);
});
