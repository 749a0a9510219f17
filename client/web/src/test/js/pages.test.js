import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { idText, prefixOf } from '../../main/js/page/browse/id-text.js';
import { Pages } from '../../main/js/page/browse/pages.js';
import { serve } from './support/web.js';

/** @import { Model } from '../../main/js/page/card-words.js' */

const url = new URL('http://host/m/index.json');
const SIZE = 10;
/** a00 … a09, b00 … b09, … z09: a page for each letter. */
const all = [...'abcdefghijklmnopqrstuvwxyz'].flatMap((letter) => Array.from({ length: SIZE }, (_, i) => ({ id: `${letter}0${i}` })));

/** @param {import('node:test').TestContext} t @param {(failure?: unknown) => void} [changed] */
function pages(t, changed = () => {}) {
  /** @type {Map<string, Model[]>} */
  const files = new Map();
  /** @type {[string, number, string][]} */
  const index = [];
  for (let start = SIZE; start < all.length; start += SIZE) {
    files.set(`http://host/m/page-${start}.json?s`, all.slice(start, start + SIZE));
    index.push([all[start].id, SIZE, `page-${start}.json?s`]);
  }
  const asked = serve(t, (request) => new Response(JSON.stringify({ models: files.get(request.url) })));
  return { asked, made: new Pages({ total: all.length, models: all.slice(0, SIZE), pages: index, next: 'x' }, url, changed) };
}

test('a prefix is found with two pages at most, wherever it begins and ends', async (t) => {
  for (const prefix of ['', 'a', 'a00', 'c', 'c05', 'z', 'z09', 'z0', '0', 'zz', 'm1', 'b']) {
    const { asked, made } = pages(t);
    const [from, to] = await made.find(prefix);
    const expected = all.filter(({ id }) => id.startsWith(prefix));
    assert.deepEqual(all.slice(from, to), expected, prefix);
    assert.ok(asked.length <= 2, `${prefix}: ${asked.length}`);
  }
});

test('models come when somebody looks at them, and have their places', async (t) => {
  /** @type {() => void} */
  let come = () => {};
  const { asked, made } = pages(t, () => come());
  const part = made.part(5, all.length);
  assert.equal(part.at(4).id, 'a09');
  assert.equal(part.indexOf(part.at(4)), 4);
  const blank = part.at(25);
  assert.equal(blank.id, '');
  assert.equal(part.indexOf(blank), 25);
  await new Promise((resolve) => (come = () => resolve(undefined)));
  assert.equal(part.at(25).id, 'd00');
  assert.equal(part.indexOf(part.at(25)), 25);
  assert.equal(asked.length, 1);
});

test('what is scrolled past is not asked for', async (t) => {
  /** @type {() => void} */
  let come = () => {};
  const { asked, made } = pages(t, () => come());
  const part = made.part(0, all.length);
  for (let i = 0; i < all.length; i += SIZE) part.at(i);
  await new Promise((resolve) => (come = () => part.at(all.length - 1).id && resolve(undefined)));
  assert.ok(asked.length <= 3, `${asked.length}`);
});

test('a search that is given up disturbs neither the next nor what is looked at', async (t) => {
  const { made } = pages(t, (failure) => assert.equal(failure, undefined));
  /** @type {string[]} */
  const stopped = [];
  t.mock.method(globalThis, 'fetch', (/** @type {URL} */ address, /** @type {RequestInit} */ { signal }) => {
    const page = Number(/\d+/.exec(address.pathname)?.[0]);
    return new Promise((resolve, reject) => {
      signal?.addEventListener('abort', () => {
        stopped.push(address.pathname);
        reject(signal.reason);
      });
      setTimeout(() => resolve(new Response(JSON.stringify({ models: all.slice(page, page + SIZE) }))), 20);
    });
  });
  const stale = made.find('c0').catch((error) => error);
  const found = made.find('k0');
  assert.ok((await stale) instanceof DOMException);
  assert.deepEqual(await found, [100, 110]);
  assert.deepEqual(stopped, ['/m/page-10.json', '/m/page-20.json']);
});

test('a model that is looked for on the wrong page has no place', (t) => {
  const part = pages(t).made.part(0, all.length);
  assert.equal(part.indexOf({ id: 'a05' }), -Infinity);
  assert.equal(part.indexOf({ id: '!' }), -Infinity);
  assert.equal(part.indexOf({ id: 'n00' }), -Infinity);
});

/** A list of two pages that changes on the server. @param {import('node:test').TestContext} t */
function living(t) {
  const ids = { first: ['a', 'b'], second: ['c', 'd'] };
  const models = (/** @type {string[]} */ some) => some.map((id) => ({ id }));
  const index = () => ({
    total: ids.first.length + ids.second.length,
    models: models(ids.first),
    pages: /** @type {[string, number, string][]} */ ([[ids.second[0], ids.second.length, 'after-b.json']]),
  });
  serve(t, ({ url: page }) => new Response(JSON.stringify(page.endsWith('index.json') ? index() : { models: models(ids.second) })));
  return { ids, index };
}

test('a list that has changed is read anew', async (t) => {
  const { ids, index } = living(t);
  let renewed = 0;
  const made = new Pages(index(), url, () => {}, () => renewed++);
  ids.second = ['bb', 'c', 'd'];
  await assert.rejects(made.find('c'), { name: 'AbortError' });
  assert.equal(renewed, 1);
  assert.equal(made.total, 5);
  assert.deepEqual(await made.find('c'), [3, 4]);
  assert.equal(made.part(0, 5).at(2)?.id, 'bb');
});

test('a list that does not agree with its index is told of, and not asked for again and again', async (t) => {
  const { ids, index } = living(t);
  const wrong = index();
  wrong.pages[0][1] = 3;
  ids.second = ['c', 'd', 'e'];
  const rows = [{ id: 'c' }, { id: 'd' }];
  const again = serve(t, ({ url: page }) => new Response(JSON.stringify(page.endsWith('index.json') ? index() : { models: rows })));
  const failure = new Promise((resolve) => {
    const made = new Pages(wrong, url, resolve, () => assert.fail('it is the same list'));
    assert.equal(made.part(0, 5).at(2)?.id, '');
  });
  assert.match(String(await failure), /not what the index says/);
  assert.equal(again.length, 2);
});

test('names are written as ids are', () => {
  const file = new URL('../../../../../server/servlet/src/test/resources/org/jsmesh/store/ids/id-text.json', import.meta.url);
  const texts = Object.entries(JSON.parse(readFileSync(file, 'utf8')));
  assert.ok(texts.length > 20);
  for (const [name, text] of texts) assert.equal(idText(name), text, name);
});

test('words lead to models in folders', () => {
  assert.equal(prefixOf('  Große Vase 1 '), 'grosse-vase-1');
  assert.equal(prefixOf('Kitchen/Big ch'), 'kitchen--big-ch');
  assert.equal(prefixOf('kitchen--big-chair'), 'kitchen--big-chair');
  assert.equal(prefixOf('Kitchen/'), 'kitchen--');
  assert.equal(prefixOf('/!!/Küche//'), 'kuche--');
  assert.equal(prefixOf('模/in off'), '模--in-off');
  assert.equal(prefixOf('!!'), '');
});
