import assert from 'node:assert/strict';
import test from 'node:test';
import { contactShadow, SIDE } from '../../main/js/first/contact-shadow.js';

/** A square of two triangles at a height, in a file whose second or third axis points up. @param {number} height @param {'y' | 'z'} up */
function square(height, up) {
  const corners = [[0, 0], [2, 0], [2, 1], [0, 1]];
  const positions = Float32Array.from(corners.flatMap(([across, along]) => (up === 'z' ? [across, along, height] : [along, height, across])));
  return { positions, indices: Uint32Array.from([0, 1, 2, 0, 2, 3]), corners: 6, groups: [{ slot: 0, start: 0, count: 6 }] };
}

/** @param {Uint8Array} cells @param {number} across @param {number} along shares of the ground */
const at = (cells, across, along) => cells[Math.floor(along * SIDE) * SIDE + Math.floor(across * SIDE)];

test('the ground is dark beneath a model and light around it', () => {
  const { cells, place } = contactShadow(square(0, 'y'), [0, 0, 0, 1, 3, 2], 'y');
  assert.deepEqual(place.map((x) => x.toFixed(6)), ['-0.600000', '-1.100000', '0.000000', '3.200000']);
  assert.ok(at(cells, 0.5, 0.5) > 240);
  for (const [across, along] of [[0, 0], [0, 0.999], [0.999, 0], [0.5, 0.1], [0.03, 0.5]]) assert.equal(at(cells, across, along), 0);
  const edge = at(cells, 0.5, 1.1 / 3.2);
  assert.ok(edge > 90 && edge < 165, `${edge}`);
});

test('what hangs above the ground casts less', () => {
  const near = at(contactShadow(square(0.1, 'y'), [0, 0, 0, 1, 3, 2], 'y').cells, 0.5, 0.5);
  const far = at(contactShadow(square(1, 'y'), [0, 0, 0, 1, 3, 2], 'y').cells, 0.5, 0.5);
  assert.ok(near > 100 && near < 240 && far < 10, `${near}, ${far}`);
});

test('the third axis may point up', () => {
  const y = contactShadow(square(0, 'y'), [0, 0, 0, 1, 3, 2], 'y');
  const z = contactShadow(square(0, 'z'), [0, 0, 0, 2, 1, 3], 'z');
  assert.deepEqual(z, y);
});

test('it is that of poster and window', () => {
  const positions = Float32Array.from([-1, -0.5, -0.5, 1, -0.5, -0.5, 1, 0.5, -0.5, -1, -0.4, 0.5, 0, -0.5, 0.5, 0, -0.3, 0]);
  const mesh = { positions, indices: Uint32Array.from([0, 1, 2, 3, 4, 5]), corners: 6, groups: [{ slot: 0, start: 0, count: 3 }, { slot: 1, start: 3, count: 3 }] };
  const { cells } = contactShadow(mesh, [-1, -0.5, -0.5, 1, 0.5, 0.5], 'y');
  // The class ContactShadow is tried with the same.
  const places = [[48, 33], [20, 33], [75, 33], [40, 55], [30, 60], [48, 62], [0, 0]];
  assert.deepEqual(places.map(([x, z]) => cells[x * SIDE + z]), [36, 22, 21, 109, 95, 71, 0]);
  assert.equal(cells.reduce((sum, dark) => sum + dark, 0), 62287);
});

test('a model of one point, and none, have a ground', () => {
  for (const groups of [[], [{ slot: 0, start: 0, count: 3 }]]) {
    const { cells, place } = contactShadow({ positions: new Float32Array(3), indices: new Uint32Array(3), corners: 3, groups }, [0, 0, 0, 0, 0, 0], 'y');
    assert.ok(place.every(Number.isFinite));
    assert.ok(cells.every((dark) => dark === 0 || groups.length > 0));
  }
});

test('a triangle that is not where the model says costs no more than others', () => {
  const mesh = { positions: Float32Array.from([0, 0, 0, 3e38, 0, 0, 0, 0, 3e38]), indices: Uint32Array.from([0, 1, 2]), corners: 3, groups: [{ slot: 0, start: 0, count: 3 }] };
  assert.equal(contactShadow(mesh, [0, 0, 0, 1, 1, 1], 'y').cells.length, SIDE * SIDE);
});

test('thousands of large triangles upon each other darken no more than one', () => {
  const one = square(0, 'y');
  const indices = Uint32Array.from({ length: 12_000 }, (_, i) => one.indices[i % 6]);
  const many = { ...one, indices, corners: indices.length, groups: [{ slot: 0, start: 0, count: indices.length }] };
  assert.deepEqual(contactShadow(many, [0, 0, 0, 1, 3, 2], 'y'), contactShadow(one, [0, 0, 0, 1, 3, 2], 'y'));
});
