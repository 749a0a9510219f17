import 'fake-indexeddb/auto';
import assert from 'node:assert/strict';
import test from 'node:test';
import { Kept } from '../../main/js/decode/kept.js';
import { ArchiveBytes } from '../../main/js/levels/archive-bytes.js';
import { LevelDecoder } from '../../main/js/levels/level-decoder.js';
import { sidesOf, textOf } from '../../main/js/levels/link.js';
import { Service } from '../../main/js/levels/service.js';
import { Snapshots } from '../../main/js/levels/snapshots.js';
import { bytesUpTo, partOf, serve, skipPauses, standOn } from './support/web.js';

/** @import { Snapshot } from '../../main/js/levels/snapshots.js' */

standOn('http://host/page');

const FILE = bytesUpTo(1000);
const SHA256 = 'a'.repeat(64);
/** Six batches of 100 bytes; each brings a face, and the faces of a batch lie behind those before. */
const INDEX = { ends: [100, 200, 300, 400, 500, 600], levels: [0, 1, 1, 2, 2, 3] };
const never = () => false;

/** A decoder of archives that are mere bytes. */
class FacesDecoder {
  received = 0;
  opened = 0;
  /** Batches at which it was asked for a picture. @type {number[]} */
  shown = [];
  header = null;
  #step = 0;

  open() {
    this.received = this.#step = 0;
    this.opened++;
  }

  get batches() {
    return Math.floor(this.received / 100);
  }

  /** @param {Uint8Array} bytes */
  feed(bytes) {
    assert.equal(bytes[0], FILE[this.received]);
    this.received += bytes.length;
  }

  refine() {
    const faces = this.batches;
    this.shown.push(faces);
    const data = Uint32Array.from({ length: 3 * faces }, (_, i) => i % 3);
    return { step: ++this.#step, jump: false, faces, vertices: 3, places: faces, groups: [0, 0, 3 * faces], tangents: [], ranges: Uint32Array.of(3, 0, 3 * faces), data };
  }
}

function decoderOf(snapshots = new Snapshots()) {
  const fake = new FacesDecoder();
  const bytes = { reach: async () => {}, part: (/** @type {number} */ from, /** @type {number} */ end) => FILE.subarray(from, end) };
  return { fake, decoder: new LevelDecoder(/** @type {any} */ (fake), bytes, snapshots) };
}

/** @param {number} batch @param {number} bytes @returns {Snapshot} */
function snapshotOf(batch, bytes) {
  const none = new Float32Array();
  return { batch, faces: 0, vertices: 0, positions: none, normals: none, tangents: none, colours: new Uint8Array(bytes), uvs: [], indices: new Uint32Array(), groups: [], levels: new Uint16Array() };
}

test('each batch can be shown, and each face knows its level', async () => {
  const { decoder } = decoderOf();
  for (const batches of [6, 1, 3, 5, 2, 4]) {
    const level = await decoder.level(batches, INDEX, never);
    assert.equal(level?.batch, batches);
    assert.equal(level?.faces, batches);
    assert.deepEqual([...(level?.levels ?? [])], INDEX.levels.slice(0, batches));
    assert.equal(level?.indices.length, 3 * batches);
  }
});

test('a finer level goes on from the one before, and a level that was shown before is decoded no more', async () => {
  const { decoder, fake } = decoderOf();
  await decoder.level(2, INDEX, never);
  await decoder.level(6, INDEX, never);
  assert.equal(fake.opened, 0);
  // It stops where a level ends, too.
  assert.deepEqual(fake.shown, [1, 2, 3, 5, 6]);
  await decoder.level(3, INDEX, never);
  await decoder.level(2, INDEX, never);
  assert.equal(fake.opened, 0);
  await decoder.level(4, INDEX, never);
  assert.equal(fake.opened, 1);
});

test('a level that nobody wishes any more is given up, and decoding goes on from there', async () => {
  const { decoder, fake } = decoderOf();
  await new Promise((resolve) => setTimeout(resolve, 40));
  assert.equal(await decoder.level(6, INDEX, () => true), null);
  const level = await decoder.level(6, INDEX, never);
  assert.equal(fake.opened, 0);
  assert.deepEqual([...(level?.levels ?? [])], INDEX.levels);
});

test('after damage a level is decoded from the beginning', async () => {
  const { decoder, fake } = decoderOf();
  const { feed } = fake;
  fake.feed = (bytes) => {
    feed.call(fake, bytes);
    if (fake.received > 300) throw new Error('damage');
  };
  await assert.rejects(decoder.level(6, INDEX, never), /damage/);
  fake.feed = feed;
  assert.deepEqual([...((await decoder.level(6, INDEX, never))?.levels ?? [])], INDEX.levels);
  assert.equal(fake.opened, 1);
});

test('without room only what is wished is kept', async () => {
  const { decoder, fake } = decoderOf(new Snapshots(1));
  assert.equal((await decoder.level(6, INDEX, never))?.faces, 6);
  await decoder.level(6, INDEX, never);
  assert.equal(fake.opened, 0);
  await decoder.level(1, INDEX, never);
  assert.equal(fake.opened, 1);
});

test('levels that were used last stay', () => {
  const snapshots = new Snapshots(250);
  snapshots.add(snapshotOf(1, 100));
  snapshots.add(snapshotOf(2, 100));
  snapshots.get(1);
  snapshots.add(snapshotOf(3, 100));
  assert.deepEqual([1, 2, 3].map((batch) => snapshots.get(batch) !== null), [true, false, true]);
  assert.equal(snapshots.hasRoomFor(50), true);
  assert.equal(snapshots.hasRoomFor(51), false);
  snapshots.add(snapshotOf(4, 1000));
  assert.deepEqual([1, 3, 4].map((batch) => snapshots.get(batch) !== null), [false, false, true]);
});

test('bytes come from what the browser keeps, and the network is asked for the rest alone', async (t) => {
  const asked = serve(t, (one) => partOf(one, FILE));
  const kept = await Kept.open('http://host/a.jsm', SHA256);
  skipPauses(t);
  kept?.add(0, FILE.subarray(0, 300));
  await kept?.flush();
  const bytes = new ArchiveBytes({ archiveUrl: 'http://host/a.jsm', archiveSha256: SHA256 });
  await bytes.reach(250);
  assert.deepEqual([...bytes.part(0, 250)], [...FILE.subarray(0, 250)]);
  await bytes.reach(300);
  assert.equal(asked.length, 0);
  kept?.add(300, FILE.subarray(300, 400));
  await kept?.flush();
  await bytes.reach(400);
  assert.equal(asked.length, 0);
  await bytes.reach(600);
  assert.deepEqual(asked.map(({ range }) => range), ['bytes=400-599']);
  kept?.add(400, FILE.subarray(400, 900));
  await kept?.flush();
  await bytes.reach(900);
  assert.equal(asked.length, 1);
  assert.deepEqual([...bytes.part(0, 900)], [...FILE.subarray(0, 900)]);
});

test('what nobody keeps comes over the network', async (t) => {
  const asked = serve(t, (one) => partOf(one, FILE));
  const bytes = new ArchiveBytes({ archiveUrl: 'http://host/b.jsm' });
  await bytes.reach(500);
  assert.deepEqual(asked.map(({ range }) => range), ['bytes=0-499']);
  assert.deepEqual([...bytes.part(100, 500)], [...FILE.subarray(100, 500)]);
});

/** @param {Partial<import('../../main/js/levels/service.js').Wish>} wish */
function wishOf(wish) {
  return { side: /** @type {const} */ ('left'), id: 1, batches: 1, newest: 6, lastLevel: 3, paint: /** @type {const} */ ('file'), isWireframe: false, index: INDEX, ...wish };
}

test('of the wishes for a side the last one is answered, and each side has its own', async () => {
  /** @type {any[]} */
  const posted = [];
  const { decoder } = decoderOf();
  const service = new Service(Promise.resolve(decoder), (answer) => posted.push(answer));
  service.hear(wishOf({ id: 1, batches: 6 }));
  service.hear(wishOf({ id: 2, batches: 2 }));
  service.hear(wishOf({ id: 3, batches: 5, side: 'right' }));
  await service.hear(wishOf({ id: 4, batches: 3 }));
  while (posted.length < 2) await new Promise((resolve) => setTimeout(resolve));
  const told = posted.map(({ side, id, batches, faces }) => ({ side, id, batches, faces }));
  assert.deepEqual(told.sort((a, b) => a.id - b.id), [{ side: 'right', id: 3, batches: 5, faces: 5 }, { side: 'left', id: 4, batches: 3, faces: 3 }]);
});

test('colours are those that were wished', async () => {
  /** @type {any[]} */
  const posted = [];
  const { decoder } = decoderOf();
  const service = new Service(Promise.resolve(decoder), (answer) => posted.push(answer));
  await service.hear(wishOf({ batches: 4, paint: 'levels' }));
  await service.hear(wishOf({ batches: 4, paint: 'distance' }));
  assert.equal(posted[0].painted.colours.length, 4 * 3 * 4);
  assert.equal(posted[0].mesh, undefined);
  assert.equal(posted[1].measured.farthest.distance, 0);
});

test('a side is told why it has no answer, and the next wish has one', async () => {
  /** @type {any[]} */
  const posted = [];
  const { decoder } = decoderOf();
  let fails = true;
  const level = (/** @type {Parameters<LevelDecoder['level']>} */ ...args) => (fails ? Promise.reject(new Error('no bytes')) : decoder.level(...args));
  const service = new Service(Promise.resolve({ level }), (answer) => posted.push(answer));
  await service.hear(wishOf({ id: 7 }));
  fails = false;
  await service.hear(wishOf({ id: 8 }));
  assert.deepEqual(posted[0], { side: 'left', id: 7, error: 'The viewer stopped: no bytes.' });
  assert.equal(posted[1].id, 8);
});

test('a link keeps the levels of both sides', () => {
  for (const [sides, text] of /** @type {[import('../../main/js/levels/link.js').Sides, string | null][]} */ ([[[null], null], [[7], '7'], [[7, null], '7,newest'], [[null, 3], 'newest,3'], [[2, 40], '2,40']])) {
    assert.equal(textOf(sides), text);
    if (text !== null) assert.deepEqual(sidesOf(text), sides);
  }
  for (const wrong of ['', '0', '-1', '1.5', '1,', '1,2,3', 'x', '1,old', '1234567']) assert.equal(sidesOf(wrong), null, wrong);
});
