// @ts-check
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MOST_SORTED, orderBlended } from '../../main/js/three/blend-order.js';

/** Triangles at depths along z, of three vertices each. @param {...number} depths */
function panes(...depths) {
  return stack(depths);
}

/** @param {number[]} depths */
function stack(depths) {
  const positions = Float32Array.from(depths.flatMap((z) => [0, 0, z, 1, 0, z, 0, 1, z]));
  const indices = Uint32Array.from({ length: 3 * depths.length }, (_, i) => i);
  return { positions, indices, sorted: indices.slice() };
}

/** @type {[number, number, number]} */
const AWAY = [0, 0, 1];

test('the triangles of a blended group are drawn from the farthest to the nearest', () => {
  const mesh = { ...panes(2, 5, -1, 3), groups: [{ slot: 0, start: 0, count: 12 }] };
  orderBlended(mesh, () => true, AWAY);
  assert.deepEqual([...mesh.sorted], [3, 4, 5, 9, 10, 11, 0, 1, 2, 6, 7, 8]);
  orderBlended(mesh, () => true, [0, 0, -1]);
  assert.deepEqual([...mesh.sorted], [6, 7, 8, 0, 1, 2, 9, 10, 11, 3, 4, 5]);
});

test('triangles of the same depth keep their order', () => {
  const mesh = { ...panes(1, 1, 1), groups: [{ slot: 0, start: 0, count: 9 }] };
  orderBlended(mesh, () => true, AWAY);
  assert.deepEqual([...mesh.sorted], [0, 1, 2, 3, 4, 5, 6, 7, 8]);
});

test('opaque groups come first as they are, then blended ones from the farthest on', () => {
  const [a, b, c, d] = [0, 1, 2, 3].map((slot) => ({ slot, start: 6 * slot, count: 6 }));
  const mesh = { ...panes(0, 1, 9, 2, 5, 6, 7, 7), groups: [a, b, c, d] };
  assert.deepEqual(orderBlended(mesh, (slot) => slot === 0 || slot === 3, AWAY), [b, c, d, a]);
  assert.deepEqual([...mesh.sorted.subarray(6, 18)], [6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17]);
  assert.deepEqual([...mesh.sorted.subarray(0, 6)], [3, 4, 5, 0, 1, 2]);
});

test('the groups of a slot are sorted as one', () => {
  const [a, b, c] = [0, 1, 0].map((slot, i) => ({ slot, start: 6 * i, count: 6 }));
  const mesh = { ...panes(2, 5, 0, 0, -1, 3), groups: [a, b, c] };
  assert.deepEqual(orderBlended(mesh, (slot) => slot === 0, AWAY), [b, a, c]);
  assert.deepEqual([...mesh.sorted.subarray(0, 6)], [3, 4, 5, 15, 16, 17]);
  assert.deepEqual([...mesh.sorted.subarray(12, 18)], [0, 1, 2, 12, 13, 14]);
});

test('a group of very many triangles is left as it is', () => {
  const mesh = { ...stack(Array.from({ length: MOST_SORTED + 1 }, (_, i) => i)), groups: [{ slot: 0, start: 0, count: 3 * MOST_SORTED + 3 }] };
  orderBlended(mesh, () => true, AWAY);
  assert.equal(mesh.sorted[0], 0);
});
