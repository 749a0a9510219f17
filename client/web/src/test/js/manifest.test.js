import assert from 'node:assert/strict';
import test from 'node:test';
import { fetchJson, fetchManifest, ServerError } from '../../main/js/session/manifest.js';
import { serve, skipPauses } from './support/web.js';

const URL_OF = 'http://host/m/a/manifest.json';

/**
 * @param {unknown} body
 * @param {ResponseInit} [init]
 */
const json = (body, init) => new Response(JSON.stringify(body), init);

test('the address of the archive is absolute', async (t) => {
  serve(t, () => json({ archiveUrl: 'x.jsm', bytes: 7 }));
  assert.deepEqual(await fetchManifest(URL_OF), { archiveUrl: 'http://host/m/a/x.jsm', bytes: 7 });
});

test('errors of the server become sentences', async (t) => {
  serve(t, () => json({ error: 'the model is broken', remedy: 'repair it' }, { status: 500 }));
  await assert.rejects(fetchJson(URL_OF), new ServerError('The model is broken. Repair it.'));
});

test('errors of others are told by their status', async (t) => {
  serve(t, ({ url }) => new Response('<html>', { status: url.endsWith('a') ? 404 : 403 }));
  await assert.rejects(fetchJson('http://host/a'), new ServerError('There is no such model here.'));
  await assert.rejects(fetchJson('http://host/b'), new ServerError('The server answered with status 403.'));
});

test('a page in place of JSON is an error', async (t) => {
  serve(t, () => new Response('<html>'));
  await assert.rejects(fetchJson(URL_OF), new ServerError('The server sent something that is not a description of models.'));
});

test('a server that cannot be reached is an error', async (t) => {
  serve(t, () => Promise.reject(new TypeError('no route')));
  await assert.rejects(fetchJson(URL_OF), new ServerError('The server cannot be reached.'));
});

test('a busy server is asked again when it says, and whoever waits is told', async (t) => {
  const pauses = skipPauses(t);
  const asked = serve(t, (_, number) => (number < 2 ? new Response(null, { status: 503, headers: { 'Retry-After': '2' } }) : json({ models: [] })));
  /** @type {string[]} */
  const told = [];
  assert.deepEqual(await fetchJson(URL_OF, 'default', (text) => told.push(text)), { models: [] });
  assert.equal(asked.length, 3);
  assert.deepEqual(pauses, [2000, 2000]);
  assert.deepEqual(told, ['The server is busy; trying again in 2 s (1 of 5)', 'The server is busy; trying again in 2 s (2 of 5)']);
});

test('a server that stays busy is given up', async (t) => {
  skipPauses(t);
  const asked = serve(t, () => new Response(null, { status: 429, headers: { 'Retry-After': '1' } }));
  await assert.rejects(fetchJson(URL_OF), new ServerError('The server answered with status 429.'));
  assert.equal(asked.length, 6);
});

test('a server that encodes the model is asked until it is done, however long, and whoever waits is told how far it is', async (t) => {
  const pauses = skipPauses(t);
  const preparing = (/** @type {number} */ fraction) => json({ state: 'preparing', stage: 'simplify', fraction }, { status: 202, headers: { 'Retry-After': '1' } });
  const asked = serve(t, (_, number) => (number < 9 ? preparing(number / 10) : json({ archiveUrl: 'x.jsm' })));
  /** @type {string[]} */
  const told = [];
  assert.equal((await fetchManifest(URL_OF, 'default', (text) => told.push(text))).archiveUrl, 'http://host/m/a/x.jsm');
  assert.equal(asked.length, 10);
  assert.deepEqual(pauses, Array(9).fill(1000));
  assert.equal(told[3], 'The server is preparing this model: simplify, 30%');
});

test('a server that prepares the model and then fails is told by its words', async (t) => {
  skipPauses(t);
  serve(t, (_, number) => (number === 0 ? json({}, { status: 202 }) : json({ error: 'the mesh has no face', remedy: 'give one' }, { status: 422 })));
  await assert.rejects(fetchJson(URL_OF), new ServerError('The mesh has no face. Give one.'));
});
