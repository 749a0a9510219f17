import assert from 'node:assert/strict';
import test from 'node:test';
import { standOn } from './support/web.js';

standOn('https://museum.example/m/vase/');
const { linkTo } = await import('../../main/js/session/link.js');

/**
 * @param {string} name
 * @param {number} requestStart
 * @param {number} responseEnd
 * @param {number} transferSize
 */
const file = (name, requestStart, responseEnd, transferSize) => /** @type {PerformanceResourceTiming} */ ({ name: new URL(name, 'https://museum.example/').href, requestStart, responseEnd, transferSize, encodedBodySize: 800 });

test('the clock runs while something is under way', () => {
  const files = [file('page.css', 100, 400, 2000), file('worker.js', 150, 1100, 9000), file('tools.js', 61_100, 61_300, 1000)];
  assert.deepEqual(linkTo('model.jsm', files), [300, 2000, 1000, 9000, 1200, 1000]);
});

test('files of other hosts and of caches tell nothing', () => {
  const files = [file('https://cdn.example/three.js', 0, 900, 9000), file('page.css', 100, 101, 0), file('page.js', 100, 140, 300), file('worker.js', 150, 1100, 9000)];
  assert.deepEqual(linkTo('/model.jsm', files), [950, 9000]);
  assert.deepEqual(linkTo('https://cdn.example/model.jsm', files), [900, 9000]);
  assert.deepEqual(linkTo('https://nobody.example/model.jsm', files), []);
});

test('files that come at once share the link, whichever ends first', () => {
  const files = [file('worker.js', 0, 8000, 60_000), file('page.js', 0, 2000, 4000)];
  assert.deepEqual(linkTo('model.jsm', files), [2000, 4000, 8000, 60_000]);
});
