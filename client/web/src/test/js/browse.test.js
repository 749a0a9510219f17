import assert from 'node:assert/strict';
import test from 'node:test';
import { Grid } from '../../main/js/page/browse/grid.js';
import { fold, Order, readWish, withWish } from '../../main/js/page/browse/order.js';

/** @param {Order} order @param {string} words @param {import('../../main/js/page/browse/order.js').Sorting} [sorting] */
function ids(order, words, sorting = 'name') {
  return order.of({ words, sorting }).map(({ id }) => id);
}

const order = new Order([
  { id: 'vase-10', name: 'Vase 10', faces: 20, bytes: 900, fileBytes: 5, modified: '2026-02-01T00:00:00Z' },
  { id: 'vase-2', name: 'Vase 2', faces: 500, bytes: 100, fileBytes: 5, modified: '2026-03-01T00:00:00Z' },
  { id: 'x', name: 'Émile, Büste', fileBytes: 300, modified: '2025-12-31T23:59:59Z' },
  { id: 'strasse', name: 'Große Straße' },
]);

test('case and diacritics make no difference', () => {
  assert.equal(fold('ÉMILE Büste'), 'emile buste');
  assert.equal(fold('Große Straße'), 'grosse strasse');
  assert.equal(fold('Ørsted Łódź İzmir ΣΟΦΟΣ'), 'orsted lodz izmir σοφοσ');
  assert.equal(fold('Й'), fold('и'));
});

test('marks that make another letter stay', () => {
  assert.notEqual(fold('がく'), fold('かく'));
  assert.notEqual(fold('की'), fold('का'));
  assert.equal(fold('\u304b\u3099'), fold('\u304c'));
});

test('finds the models that have all the words', () => {
  assert.deepEqual(ids(order, 'BUST emi'), ['x']);
  assert.deepEqual(ids(order, 'strasse'), ['strasse']);
  assert.deepEqual(ids(order, '  vase  1 '), ['vase-10']);
  assert.deepEqual(ids(order, 'no such'), []);
  assert.equal(ids(order, '').length, 4);
});

test('sorts, and puts last what is not known', () => {
  assert.deepEqual(ids(order, ''), ['x', 'strasse', 'vase-2', 'vase-10']);
  assert.deepEqual(ids(order, '', 'newest'), ['vase-2', 'vase-10', 'x', 'strasse']);
  assert.deepEqual(ids(order, '', 'faces'), ['vase-2', 'vase-10', 'x', 'strasse']);
  assert.deepEqual(ids(order, '', 'size'), ['vase-10', 'x', 'vase-2', 'strasse']);
});

test('offers to sort by what the catalogue knows', () => {
  assert.deepEqual(order.sortings, ['name', 'newest', 'faces', 'size']);
  assert.deepEqual(new Order([{ id: 'a', fileBytes: 3 }]).sortings, ['name', 'size']);
});

test('the address keeps a wish, and nothing else of it changes', () => {
  const address = withWish('https://x.example/g/?decoder=js#top', { words: ' große vase & co ', sorting: 'faces' });
  assert.deepEqual(readWish(new URL(address).search, ['name', 'faces']), { words: 'große vase & co', sorting: 'faces' });
  assert.match(address, /^https:\/\/x\.example\/g\/\?decoder=js&.*#top$/);
  assert.equal(withWish(address, { words: ' ', sorting: 'name' }), 'https://x.example/g/?decoder=js#top');
  assert.deepEqual(readWish('?sort=faces', ['name', 'size']), { words: '', sorting: 'name' });
  assert.deepEqual(readWish('?sort=nonsense&q=', ['name']), { words: '', sorting: 'name' });
});

test('a grid has as many columns as fit', () => {
  assert.equal(new Grid(10, 320, 90).columns, 1);
  assert.equal(new Grid(10, 497, 90).columns, 1);
  assert.equal(new Grid(10, 498, 90).columns, 2);
  assert.equal(new Grid(10, 0, 90).columns, 1);
  const grid = new Grid(10, 1140, 90);
  assert.equal(grid.columns, 4);
  const { left } = grid.placeOf(3);
  assert.ok(Math.abs(left + grid.cardWidth - 1140) < 1e-9);
  assert.deepEqual(grid.placeOf(0), { left: 0, top: 0 });
  assert.equal(grid.placeOf(9).top + grid.cardHeight, grid.height);
});

test('a grid makes what is near the screen alone', () => {
  const grid = new Grid(10_000, 1140, 90);
  const [from, to] = grid.range(100_000, 100_900);
  assert.ok(to - from <= 4 * 9, `${to - from}`);
  assert.ok(grid.placeOf(from).top < 100_000 && grid.placeOf(to - 1).top > 100_900);
  assert.deepEqual(grid.range(-500, 300)[0], 0);
  assert.equal(grid.range(grid.height - 10, grid.height + 500)[1], 10_000);
  assert.deepEqual(grid.range(grid.height + 1e6, grid.height + 2e6), [10_000, 10_000]);
  assert.deepEqual(new Grid(0, 1140, 90).range(0, 900), [0, 0]);
  assert.equal(new Grid(0, 1140, 90).height, 0);
});
