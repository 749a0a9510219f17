import 'fake-indexeddb/auto';
import assert from 'node:assert/strict';
import test from 'node:test';
import { DamagedArchive } from '../../main/js/decode/answers.js';
import { ArchiveStream } from '../../main/js/decode/archive-stream.js';
import { Kept } from '../../main/js/decode/kept.js';
import { FakeDecoder } from './support/fake-decoder.js';
import { bytesUpTo, partOf, serve, skipPauses, standOn, streamOf } from './support/web.js';

standOn('http://host/page');

const FILE = bytesUpTo(1000);
const ENDS = [150, 400, 700, 1000];
const URL_OF = 'http://host/a.jsm';

/**
 * @param {import('node:test').TestContext} t
 * @param {object} [archive] what is known of it
 * @param {(asked: import('./support/web.js').Asked, number: number) => Response} [answer]
 */
function open(t, archive = {}, answer = (one) => partOf(one, FILE)) {
  const asked = serve(t, answer);
  const decoder = new FakeDecoder(ENDS);
  /** @type {any[]} */
  const posted = [];
  const stream = new ArchiveStream(decoder.asDecoder, { archiveUrl: URL_OF, serverPlan: false, ...archive }, (message) => {
    posted.push(message);
    if (message.type === 'picture') queueMicrotask(() => stream.drawn());
  });
  const ranges = () => asked.map((one) => one.range);
  const of = (/** @type {string} */ type) => posted.filter((message) => message.type === type);
  return { asked, decoder, posted, stream, ranges, of };
}

/** @param {number} from @param {number} end */
const plan = (from, end) => ({ from, end, fromBatch: ENDS.filter((e) => e <= from).length, endBatch: -1, bytesPerSecond: 5000, waitMillis: 1500 });

test('a preview reads the first bytes and no more', async (t) => {
  const { stream, decoder, ranges, posted } = open(t);
  await stream.prefix(400);
  assert.deepEqual(ranges(), ['bytes=0-399']);
  assert.deepEqual(decoder.bytes, [...FILE.slice(0, 400)]);
  const told = posted.filter(({ type }) => type === 'header' || type === 'picture').map(({ type, batches }) => batches ?? type);
  assert.deepEqual(told, ['header', 1, 2]);
});

test('the base is fed alone, so that its picture waits for nothing else', async (t) => {
  const { stream, decoder, of } = open(t, { baseBytes: 150 });
  await stream.prefix(400);
  assert.deepEqual(decoder.fed, [100, 50, 50, 100, 100]);
  assert.equal(of('picture')[0].received, 150);
});

test('without the size of the base the first bytes are fed a little at a time', async (t) => {
  const { stream, decoder } = open(t, {}, () => new Response(FILE.slice(0, 1000), { status: 206, headers: { 'Content-Range': 'bytes 0-999/1000' } }));
  await stream.prefix(1000);
  assert.deepEqual(decoder.fed, [512, 488]);
});

test('the whole is compared with the original', async (t) => {
  const { stream, of, posted, ranges } = open(t, { meshSha256: 'of the mesh', modelSha256: 'of the model' });
  await stream.complete();
  assert.deepEqual(ranges(), ['bytes=0-']);
  assert.equal(stream.isComplete, true);
  assert.deepEqual(posted.slice(-2), [{ type: 'proving' }, { type: 'proved', meshSha256: 'of the mesh', modelSha256: 'of the model' }]);
  await stream.complete();
  assert.equal(of('proved').length, 1);
});

test('another mesh than the original is an error', async (t) => {
  const { stream, of } = open(t, { meshSha256: 'of another' });
  await assert.rejects(stream.complete(), /its mesh has the SHA-256 of the mesh, but the original has of another/);
  assert.deepEqual(of('proved'), []);
});

test('other pictures than those of the original are an error', async (t) => {
  const { stream, of } = open(t, { modelSha256: 'of other pictures' });
  await assert.rejects(stream.complete(), /its model has the SHA-256 of the model, but the original has of other pictures/);
  assert.deepEqual(of('proved'), []);
});

test('what differs from the header is an error, in the words of the decoder', async (t) => {
  const { stream, decoder, of } = open(t);
  decoder.difference = 'the picture wood.png is not the one that was encoded';
  await assert.rejects(stream.complete(), (error) => error instanceof DamagedArchive && error.message.includes('wood.png'));
  assert.deepEqual(of('proved'), []);
});

test('without hashes in a manifest those of the header count', async (t) => {
  const { stream, of } = open(t);
  await stream.complete();
  assert.equal(of('proved').length, 1);
});

test('an index of another length than the file is an error', async (t) => {
  const { stream } = open(t, {}, (one) => partOf(one, bytesUpTo(1001)));
  await assert.rejects(stream.prefix(400), /its index describes 1000 bytes, but the file has 1001/);
});

test('a round asks for what the planner says until it says no more', async (t) => {
  const { stream, decoder, ranges, of } = open(t);
  decoder.plans = [plan(0, 400), plan(400, 700)];
  await stream.round(60_000);
  assert.deepEqual(ranges(), ['bytes=0-399', 'bytes=400-699']);
  assert.deepEqual(of('plan').map((message) => message.plan), [plan(0, 400), plan(400, 700)]);
  assert.equal(of('picture').at(-1).batches, 3);
  assert.deepEqual(of('request').map(({ request }) => [request.from, request.bytes, request.cached]), [[0, 400, false], [400, 300, false]]);
});

test('a plan is clipped to the file', async (t) => {
  const { stream, decoder, ranges } = open(t, { bytes: 1000 });
  decoder.plans = [plan(0, 16384)];
  await stream.round(60_000);
  assert.deepEqual(ranges(), ['bytes=0-999']);
});

test('a file that ends before its base is damaged', async (t) => {
  const { stream, decoder } = open(t, { bytes: 1000 });
  decoder.received = 1000;
  decoder.plans = [plan(1000, 1100)];
  await assert.rejects(stream.round(60_000), /it ends at byte 1000, before its first picture/);
});

test('a response that the deadline overtakes belongs to the next round', { timeout: 10_000 }, async (t) => {
  /** @type {ReadableStreamDefaultController | undefined} */
  let sender;
  const { stream, decoder, ranges, of } = open(t, {}, () => {
    const body = new ReadableStream({ start: (controller) => void (sender = controller) });
    return new Response(body, { status: 206, headers: { 'Content-Range': 'bytes 0-699/1000' } });
  });
  decoder.plans = [plan(0, 700)];
  const first = stream.round(60_000);
  while (sender === undefined) await new Promise((resolve) => setTimeout(resolve));
  decoder.isLate = true;
  sender.enqueue(FILE.slice(0, 200));
  await first;
  assert.equal(of('picture').at(-1).batches, 1);
  decoder.isLate = false;
  const second = stream.round(60_000);
  sender.enqueue(FILE.slice(200, 700));
  sender.close();
  await second;
  assert.deepEqual(ranges(), ['bytes=0-699']);
  assert.equal(of('picture').at(-1).batches, 3);
});

test('a response that nobody waits for is given up when the planner says', { timeout: 10_000 }, async (t) => {
  /** @type {ReadableStreamDefaultController | undefined} */
  let sender;
  const { stream, decoder, of } = open(t, {}, () => {
    const body = new ReadableStream({ start: (controller) => void (sender = controller) });
    return new Response(body, { status: 206, headers: { 'Content-Range': 'bytes 0-699/1000' } });
  });
  decoder.plans = [plan(0, 700)];
  decoder.goesOn = false;
  decoder.isLate = true;
  const round = stream.round(60_000);
  while (sender === undefined) await new Promise((resolve) => setTimeout(resolve));
  sender.enqueue(FILE.slice(0, 200));
  await round;
  while (of('request').length === 0) await new Promise((resolve) => setTimeout(resolve));
  assert.equal(of('request')[0].request.bytes, 200);
});

test('a stop ends the round with what is there', { timeout: 10_000 }, async (t) => {
  const { stream, decoder, of } = open(t, {}, () => new Response(new ReadableStream(), { status: 206, headers: { 'Content-Range': 'bytes 0-699/1000' } }));
  decoder.plans = [plan(0, 700), plan(0, 700)];
  const round = stream.round(60_000);
  while (of('plan').length === 0) await new Promise((resolve) => setTimeout(resolve));
  stream.stop();
  await round;
  assert.equal(of('plan').length, 1);
});

test('the server plans where it may, from a whole batch on', async (t) => {
  const { stream, decoder, asked } = open(t, { serverPlan: true }, (one) => (one.range === null ? new Response(streamOf(FILE.slice(150, 400))) : partOf(one, FILE)));
  await stream.prefix(150);
  decoder.plans = [plan(150, 400)];
  await stream.round(60_000);
  assert.equal(asked[1].url, 'http://host/a/patches?from=1&bytesPerSecond=5000&waitMillis=1500');
  await stream.prefix(450);
  decoder.plans = [plan(450, 1000)];
  await stream.round(60_000);
  assert.deepEqual(asked.slice(2).map((one) => one.range), ['bytes=400-449', 'bytes=450-699']);
});

test('whoever waits is told of a lost connection', async (t) => {
  skipPauses(t, (millis) => millis === 250);
  const { stream, of } = open(t, {}, (one, number) => partOf(one, FILE, number === 0 ? { breaksAt: 200 } : {}));
  await stream.prefix(400);
  assert.deepEqual(of('waiting'), [{ type: 'waiting', text: 'Connection lost; trying again (1 of 5)' }]);
});

test('errors are told in words', async (t) => {
  const { stream, posted } = open(t);
  await stream.fail(new DamagedArchive('no archive'));
  await stream.fail(new Error('a bug'));
  assert.deepEqual(posted, [
    { type: 'error', message: 'The archive is damaged: no archive.', retryable: false },
    { type: 'error', message: 'The viewer stopped: a bug.', retryable: false },
  ]);
});

test('the next visit asks only for what is missing', async (t) => {
  const archiveSha256 = 'a'.repeat(64);
  const first = open(t, { archiveSha256 });
  await first.stream.prefix(400);
  t.mock.restoreAll();
  const second = open(t, { archiveSha256 });
  await second.stream.complete();
  assert.deepEqual(second.ranges(), ['bytes=400-']);
  assert.deepEqual(second.decoder.bytes, [...FILE]);
  assert.deepEqual(second.of('restored'), [{ type: 'restored', bytes: 400 }]);
  t.mock.restoreAll();
  const preview = open(t, { archiveSha256 });
  await preview.stream.prefix(170);
  assert.deepEqual(preview.ranges(), []);
  assert.equal(preview.decoder.received, 170);
});

test('what was kept and is no archive comes over the network instead', async (t) => {
  const archiveSha256 = 'b'.repeat(64);
  const kept = await Kept.open(URL_OF, archiveSha256);
  kept?.add(0, new Uint8Array(300));
  await kept?.flush();
  const { stream, decoder, ranges, of } = open(t, { archiveSha256, baseBytes: 150 });
  decoder.damagedFrom = 200;
  const reopen = decoder.open.bind(decoder);
  decoder.open = () => {
    reopen();
    decoder.damagedFrom = Infinity;
  };
  await stream.complete();
  assert.deepEqual(ranges(), ['bytes=0-']);
  assert.deepEqual(of('restored'), [{ type: 'restored', bytes: 0 }]);
  assert.deepEqual(decoder.bytes, [...FILE]);
  assert.deepEqual(of('picture').slice(0, 2).map((message) => message.batches), [1, 1]);
});

test('refinement stops at the last batch within the budget, says so, and goes on when there is more', async (t) => {
  const archiveSha256 = 'd'.repeat(64);
  const { stream, decoder, of, ranges } = open(t, { archiveSha256, baseBytes: 150, mostFaces: 25 });
  await stream.complete();
  assert.deepEqual([decoder.received, stream.isComplete], [400, false]);
  assert.deepEqual(of('picture').at(-1).batches, 2);
  assert.deepEqual(of('full'), [{ type: 'full' }]);
  decoder.plans = [plan(400, 700)];
  await stream.round(1000);
  assert.deepEqual([ranges().length, decoder.received, of('full').length], [1, 400, 2]);
  stream.mostFaces = Infinity;
  await stream.complete();
  assert.deepEqual([stream.isComplete, of('full').length], [true, 2]);
  assert.deepEqual(decoder.bytes, [...FILE]);
  const next = open(t, { archiveSha256 });
  await next.stream.complete();
  assert.deepEqual([next.ranges(), next.decoder.bytes], [[], [...FILE]]);
});

test('a budget smaller than the base gives the base', async (t) => {
  const { stream, decoder } = open(t, { baseBytes: 150, mostFaces: 5 });
  decoder.plans = [plan(0, 700)];
  await stream.round(1000);
  assert.equal(decoder.received, 150);
});

test('what came whole before damage is shown', async (t) => {
  const { stream, decoder, of, posted } = open(t, { baseBytes: 150 });
  decoder.damagedFrom = 800;
  const error = await stream.complete().catch((reason) => reason);
  const before = of('picture').length;
  assert.ok(of('picture').every(({ batches }) => batches < 3));
  await stream.fail(error);
  assert.deepEqual(of('picture').slice(before).map(({ batches }) => batches), [3]);
  assert.equal(posted.at(-1).message, 'The archive is damaged: no archive.');
});

test('the picture before stays when damage has left half a batch', async (t) => {
  const { stream, decoder, of } = open(t, { baseBytes: 150 });
  Object.assign(decoder, { damagedFrom: 800, isHalfway: true });
  const error = await stream.complete().catch((reason) => reason);
  const before = of('picture').length;
  await stream.fail(error);
  assert.ok(before > 0);
  assert.deepEqual([of('picture').length, of('error').length], [before, 1]);
});

test('what is kept of a damaged archive is dropped', async (t) => {
  const archiveSha256 = 'c'.repeat(64);
  const { stream, decoder } = open(t, { archiveSha256 });
  await stream.prefix(400);
  decoder.damagedFrom = 500;
  const error = await stream.complete().catch((reason) => reason);
  assert.ok(error instanceof DamagedArchive);
  await stream.fail(error);
  const pieces = [];
  for await (const piece of (await Kept.open(URL_OF, archiveSha256))?.pieces() ?? []) pieces.push(piece);
  assert.deepEqual(pieces, []);
});
