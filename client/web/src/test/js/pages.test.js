import assert from 'node:assert/strict';
import test from 'node:test';
import { prefixOf } from '../../main/js/page/browse/browse-pages.js';
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

test('prefixes are written as ids are', () => {
  assert.equal(prefixOf('  Große Vase 1'), 'grosse-vase-1');
  assert.equal(prefixOf('Émile, '), 'emile');
  assert.equal(prefixOf('模型'), '模型');
});
