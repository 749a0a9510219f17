import assert from 'node:assert/strict';
import test from 'node:test';
import { budgetEnd, mostFacesFor, smallerBudget, withinBudget } from '../../main/js/session/budget.js';
import { limit } from '../../main/js/viewer/attributes.js';

/** @type {any} */
const HEADER = { whole: true, faces: 80, wedges: 41, ends: [10, 30, 40, 90], batchFaces: [20, 50, 50, 80] };

test('a device with little memory is given a million faces for each gigabyte', () => {
  assert.deepEqual([0.5, 2, 4, 8, undefined].map(mostFacesFor), [500_000, 2e6, 4e6, Infinity, Infinity]);
});

test('finds the last batch within the budget', () => {
  assert.deepEqual([50, 79, 80, 20, 1].map((faces) => budgetEnd(HEADER, faces)), [40, 40, Infinity, 10, 10]);
  assert.equal(budgetEnd(null, 5), Infinity);
  assert.equal(budgetEnd({ ...HEADER, whole: false }, 5), Infinity);
});

test('makes room for what is within the budget alone', () => {
  const { faces, wedges } = withinBudget(HEADER, 60);
  assert.deepEqual([faces, wedges], [50, 26]);
  assert.equal(withinBudget(HEADER, 80), HEADER);
  const early = { ...HEADER, whole: false, faces: null, wedges: null };
  assert.equal(withinBudget(early, 1), early);
});

test('halves what there was no memory for, and keeps what is shown', () => {
  assert.deepEqual([smallerBudget(HEADER, Infinity, 20), smallerBudget(HEADER, 60, 20), smallerBudget(HEADER, Infinity, 50)], [40, 25, 50]);
  assert.deepEqual([smallerBudget(HEADER, 50, 50), smallerBudget(null, Infinity, 0)], [null, null]);
  assert.equal(smallerBudget({ ...HEADER, whole: false, faces: null }, Infinity, 0), null);
});

test('reads a limit of faces', () => {
  assert.deepEqual(['500000', 'none', '-1', '0', 'many', null].map(limit), [500_000, Infinity, undefined, undefined, undefined, undefined]);
});
