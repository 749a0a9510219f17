import assert from 'node:assert/strict';
import test from 'node:test';
import { Download, DownloadError } from '../../main/js/decode/download.js';
import { bytesUpTo, partOf, serve, skipPauses, standOn, streamOf } from './support/web.js';

standOn('http://host/page');

const FILE = bytesUpTo(1000);
const NEVER = new AbortController().signal;

function listen() {
  /** @type {number[]} */
  const bytes = [];
  /** @type {import('../../main/js/decode/download.js').Entry[]} */
  const entries = [];
  /** @type {string[]} */
  const told = [];
  const listener = {
    begin() {},
    bytes: (/** @type {Uint8Array} */ chunk) => void bytes.push(...chunk),
    end: (/** @type {typeof entries[0]} */ entry) => void entries.push(entry),
    waiting: (/** @type {string} */ text) => void told.push(text),
  };
  return { bytes, entries, told, download: new Download('http://host/a.jsm', listener) };
}

test('reads a range, and the next with the tag of the first', async (t) => {
  const asked = serve(t, (one) => partOf(one, FILE));
  const { download, bytes } = listen();
  await download.read(0, 300, NEVER);
  assert.equal(download.totalBytes, 1000);
  await download.read(300, null, NEVER);
  assert.deepEqual(bytes, [...FILE]);
  assert.deepEqual(asked.map((one) => [one.range, one.ifRange]), [['bytes=0-299', null], ['bytes=300-', '"a"']]);
});

test('goes on at the byte where the connection broke', async (t) => {
  const pauses = skipPauses(t, (millis) => millis < 10_000);
  const asked = serve(t, (one, number) => partOf(one, FILE, number === 0 ? { breaksAt: 450 } : {}));
  const { download, bytes, entries, told } = listen();
  await download.read(0, 900, NEVER);
  assert.deepEqual(bytes, [...FILE.slice(0, 900)]);
  assert.deepEqual(asked.map((one) => one.range), ['bytes=0-899', 'bytes=450-899']);
  assert.deepEqual(entries.map((entry) => entry.bytes), [450, 450]);
  assert.deepEqual(told, ['Connection lost; trying again (1 of 5)']);
  assert.deepEqual(pauses, [250]);
  assert.equal(download.isInterrupted, false);
});

test('goes on after an answer that ended early', async (t) => {
  skipPauses(t, (millis) => millis < 10_000);
  const asked = serve(t, (one, number) => (number > 0 ? partOf(one, FILE) : new Response(streamOf(FILE.slice(0, 70)), { status: 206, headers: { 'Content-Range': 'bytes 0-299/1000' } })));
  const { download, bytes } = listen();
  await download.read(0, 300, NEVER);
  assert.deepEqual(bytes, [...FILE.slice(0, 300)]);
  assert.equal(asked[1].range, 'bytes=70-299');
});

test('gives up after five more tries', async (t) => {
  const pauses = skipPauses(t, (millis) => millis < 10_000);
  const asked = serve(t, () => Promise.reject(new TypeError('no route.')));
  await assert.rejects(listen().download.read(0, 300, NEVER), (error) => {
    assert.ok(error instanceof DownloadError);
    assert.equal(error.message, 'http://host/a.jsm cannot be fetched (no route). Check the address and the connection.');
    return error.retryable;
  });
  assert.equal(asked.length, 6);
  assert.deepEqual(pauses, [250, 500, 1000, 2000, 4000]);
});

test('leaves a busy server alone for as long as it says', async (t) => {
  const pauses = skipPauses(t, (millis) => millis < 10_000);
  serve(t, (one, number) => (number > 0 ? partOf(one, FILE) : new Response(null, { status: 503, headers: { 'Retry-After': '3' } })));
  const { download, told } = listen();
  await download.read(0, 300, NEVER);
  assert.deepEqual(pauses, [3000]);
  assert.deepEqual(told, ['The server is busy; trying again in 3 s (1 of 5)']);
});

test('reads the one answer of a host without ranges on and on', async (t) => {
  const asked = serve(t, () => new Response(streamOf(FILE), { headers: { 'Content-Length': '1000', ETag: '"a"' } }));
  const { download, bytes, entries } = listen();
  await download.read(0, 120, NEVER);
  assert.equal(bytes.length, 120);
  assert.equal(download.totalBytes, 1000);
  await download.read(120, null, NEVER);
  assert.deepEqual(bytes, [...FILE]);
  assert.equal(asked.length, 1);
  assert.deepEqual(entries.map((entry) => [entry.from, entry.bytes, entry.status]), [[0, 120, 200], [120, 880, 200]]);
});

test('skips what it has of a whole file', async (t) => {
  serve(t, () => new Response(streamOf(FILE), { headers: { 'Content-Length': '1000' } }));
  const { download, bytes } = listen();
  await download.read(730, 800, NEVER);
  assert.deepEqual(bytes, [...FILE.slice(730, 800)]);
});

/**
 * @param {import('node:test').TestContext} t
 * @param {(one: import('./support/web.js').Asked) => Response} then answers all but the first range
 */
async function secondRange(t, then) {
  serve(t, (one, number) => (number === 0 ? partOf(one, FILE) : then(one)));
  const { download } = listen();
  await download.read(0, 300, NEVER);
  return download.read(300, 600, NEVER).then(
    () => assert.fail('it was read'),
    (error) => error,
  );
}

test('sees that the file is another by its tag', async (t) => {
  const error = await secondRange(t, (one) => partOf(one, FILE, { etag: '"b"' }));
  assert.equal(error.changed, 'another');
  assert.equal(error.retryable, false);
});

test('does not mind a weak tag', async (t) => {
  const error = await secondRange(t, (one) => partOf(one, bytesUpTo(999), { etag: 'W/"b"' }));
  assert.match(error.message, /it has 999 bytes instead of 1000/);
});

test('asks with no weak tag', async (t) => {
  const asked = serve(t, (one) => partOf(one, FILE, { etag: 'W/"a"' }));
  const { download } = listen();
  await download.read(0, 300, NEVER);
  await download.read(300, 600, NEVER);
  assert.deepEqual(asked.map((one) => one.ifRange), [null, null]);
});

test('sees that the file is another by its length', async (t) => {
  assert.equal((await secondRange(t, (one) => partOf(one, bytesUpTo(1001)))).changed, 'another');
  t.mock.restoreAll();
  assert.equal((await secondRange(t, () => new Response(null, { status: 416 }))).changed, 'another');
});

test('sees that the file is gone', async (t) => {
  const error = await secondRange(t, () => new Response(null, { status: 404 }));
  assert.deepEqual([error.changed, error.retryable], ['gone', false]);
});

test('takes no other range than it asked for', async (t) => {
  const error = await secondRange(t, () => new Response('x', { status: 206, headers: { 'Content-Range': 'bytes 0-0/1000' } }));
  assert.equal(error.message, 'The server answered with another range than it was asked for.');
});

test('asks a host that does not plan for ranges from then on', async (t) => {
  const asked = serve(t, (one) => (one.range === null ? new Response(null, { status: 404 }) : partOf(one, FILE)));
  const { download, bytes } = listen();
  await download.read(0, 300, NEVER, { plannedUrl: 'http://host/patches' });
  await download.read(300, 600, NEVER, { plannedUrl: 'http://host/patches' });
  assert.equal(download.isPlanned, false);
  assert.deepEqual(bytes, [...FILE.slice(0, 600)]);
  assert.deepEqual(asked.map((one) => one.range), [null, 'bytes=0-299', 'bytes=300-599']);
});

test('takes as many bytes as a planning server sends', async (t) => {
  const asked = serve(t, () => new Response(streamOf(FILE.slice(0, 420))));
  const { download, bytes } = listen();
  await download.read(0, 300, NEVER, { plannedUrl: 'http://host/patches' });
  assert.equal(bytes.length, 420);
  assert.equal(asked.length, 1);
});

test('ends quietly when it is given up', { timeout: 10_000 }, async (t) => {
  serve(t, () => new Response(new ReadableStream(), { status: 206, headers: { 'Content-Range': 'bytes 0-299/1000' } }));
  const abort = new AbortController();
  const { download, bytes } = listen();
  const reading = download.read(0, 300, abort.signal);
  setTimeout(() => abort.abort(), 5);
  await reading;
  assert.deepEqual(bytes, []);
});

test('a silent connection counts as broken', async (t) => {
  skipPauses(t);
  serve(t, (one, number) => (number > 0 ? partOf(one, FILE) : new Response(new ReadableStream(), { status: 206, headers: { 'Content-Range': 'bytes 0-299/1000' } })));
  const { download, bytes } = listen();
  await assert.rejects(download.read(0, 300, NEVER, { endsAtStall: true }), /The server is silent: nothing came for 10 s\. What has arrived is kept\./);
  assert.deepEqual(bytes, []);
});

test('a request without an answer is given up before the next one', async (t) => {
  skipPauses(t);
  /** @type {AbortSignal[]} */
  const signals = [];
  t.mock.method(globalThis, 'fetch', (/** @type {string} */ _, /** @type {{ signal: AbortSignal }} */ { signal }) => {
    assert.ok(signals.every((before) => before.aborted));
    signals.push(signal);
    return new Promise(() => {});
  });
  const { download } = listen();
  await assert.rejects(download.read(0, 300, NEVER), /nothing came for 10 s/);
  assert.equal(signals.length, 6);
  assert.ok(signals.at(-1)?.aborted);
});

test('an error of whoever takes the bytes is no matter of the network', async (t) => {
  const asked = serve(t, (one) => partOf(one, FILE));
  const { download } = listen();
  download.listener.bytes = () => {
    throw new RangeError('mine');
  };
  await assert.rejects(download.read(0, 300, NEVER), RangeError);
  assert.equal(asked.length, 1);
});
