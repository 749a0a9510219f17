import assert from 'node:assert/strict';
import test from 'node:test';
import { allModels } from '../../main/js/page/catalogue.js';
import { serve } from './support/web.js';

const json = (/** @type {unknown} */ body) => new Response(JSON.stringify(body));

const first = new URL('http://host/m/index.json');

test('a list of one page is all', async (t) => {
  const asked = serve(t, () => json({ total: 1, models: [{ id: 'a' }] }));
  const models = await allModels({ total: 1, models: [{ id: 'a' }] }, first, () => assert.fail('there is one page'));
  assert.deepEqual(models, [{ id: 'a' }]);
  assert.equal(asked.length, 0);
});

test('pages are followed to the last one', async (t) => {
  /** @type {Record<string, unknown>} */
  const pages = {
    'http://host/m/after-%E6%A8%A1-a.json': { next: 'after-y.json', models: [{ id: 'y' }] },
    'http://host/m/after-y.json': { models: [{ id: 'z' }] },
  };
  serve(t, ({ url }) => json(pages[url]));
  /** @type {number[][]} */
  const told = [];
  const models = await allModels({ total: 3, next: 'after-%E6%A8%A1-a.json', models: [{ id: '模-a' }] }, first, (...counts) => told.push(counts));
  assert.deepEqual(
    models.map((m) => m.id),
    ['模-a', 'y', 'z'],
  );
  assert.deepEqual(told, [
    [1, 3],
    [2, 3],
  ]);
});

test('pages of an index need not name each other', async (t) => {
  serve(t, ({ url }) => json({ models: [{ id: url.slice(-6, -5) }] }));
  /** @type {[string, number, string][]} */
  const pages = [
    ['b', 1, 'page-b.json'],
    ['c', 1, 'page-c.json'],
  ];
  const models = await allModels({ total: 3, next: 'page-b.json', pages, models: [{ id: 'a' }] }, first, () => {});
  assert.deepEqual(
    models.map((m) => m.id),
    ['a', 'b', 'c'],
  );
});
