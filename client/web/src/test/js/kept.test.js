import 'fake-indexeddb/auto';
import assert from 'node:assert/strict';
import test from 'node:test';
import { Kept } from '../../main/js/decode/kept.js';
import { bytesUpTo } from './support/web.js';

let archives = 0;
/** A name that no archive had before. */
const fresh = () => (++archives).toString(16).padStart(64, '0');

/**
 * @param {string} sha256
 * @param {number} [mostBytes]
 */
async function open(sha256, mostBytes) {
  const kept = await Kept.open('http://host/a.jsm?x', sha256, mostBytes);
  assert.ok(kept !== null);
  return kept;
}

/** @param {string} sha256 */
async function read(sha256, url = 'http://host/a.jsm') {
  const bytes = [];
  for await (const piece of (await Kept.open(url, sha256))?.pieces() ?? []) bytes.push(...piece);
  return bytes;
}

test('gives back what was added', async () => {
  const sha256 = fresh();
  const kept = await open(sha256);
  kept.add(0, bytesUpTo(500).subarray(0, 200));
  await kept.flush();
  kept.add(200, bytesUpTo(500).subarray(200));
  await kept.flush();
  assert.deepEqual(await read(sha256), [...bytesUpTo(500)]);
});

test('nothing is kept of an archive without an identity', async () => {
  assert.equal(await Kept.open('http://host/a.jsm', undefined), null);
  assert.equal(await Kept.open('http://host/a.jsm', 'ABC'), null);
});

test('another host’s word for the same archive is not believed', async () => {
  const sha256 = fresh();
  const kept = await open(sha256);
  kept.add(0, bytesUpTo(10));
  await kept.flush();
  assert.deepEqual(await read(sha256, 'http://other/a.jsm'), []);
  assert.deepEqual(await read(sha256, 'http://host/b.jsm'), []);
});

test('no byte is kept twice, and none behind a gap', async () => {
  const sha256 = fresh();
  const [one, other] = [await open(sha256), await open(sha256)];
  one.add(0, bytesUpTo(300).subarray(0, 200));
  await one.flush();
  other.add(100, bytesUpTo(300).subarray(100, 250));
  await other.flush();
  other.add(280, bytesUpTo(300).subarray(280));
  await other.flush();
  assert.deepEqual(await read(sha256), [...bytesUpTo(300).subarray(0, 250)]);
});

test('a jump begins another piece', async () => {
  const sha256 = fresh();
  const kept = await open(sha256);
  kept.add(0, bytesUpTo(50));
  kept.add(60, bytesUpTo(50));
  await kept.flush();
  assert.deepEqual(await read(sha256), [...bytesUpTo(50)]);
});

test('a damaged piece and all behind it are dropped', async () => {
  const sha256 = fresh();
  const kept = await open(sha256);
  for (const from of [0, 100, 200]) {
    kept.add(from, bytesUpTo(300).subarray(from, from + 100));
    await kept.flush();
  }
  await change(`${sha256} http://host/a.jsm`, 100, (piece) => ({ ...piece, crc: piece.crc ^ 1 }));
  assert.deepEqual(await read(sha256), [...bytesUpTo(100)]);
  const again = await open(sha256);
  again.add(100, bytesUpTo(300).subarray(100));
  await again.flush();
  assert.deepEqual(await read(sha256), [...bytesUpTo(300)]);
});

test('the archive that was not used for longest goes first', async (t) => {
  let now = Date.now() + 1e6;
  t.mock.method(Date, 'now', () => (now += 1000));
  const names = [fresh(), fresh(), fresh()];
  for (const name of names.slice(0, 2)) {
    const kept = await open(name);
    kept.add(0, bytesUpTo(400));
    await kept.flush();
  }
  await read(names[0]);
  const last = await open(names[2], 1000);
  last.add(0, bytesUpTo(400));
  await last.flush();
  assert.deepEqual(await Promise.all(names.map(async (name) => (await read(name)).length)), [400, 0, 400]);
});

test('an archive that is too large is not kept on', async () => {
  const sha256 = fresh();
  const kept = await open(sha256, 250);
  kept.add(0, bytesUpTo(200));
  await kept.flush();
  kept.add(200, bytesUpTo(100));
  await kept.flush();
  assert.equal((await read(sha256)).length, 200);
});

test('an archive that is forgotten is gone, and takes no more', async () => {
  const sha256 = fresh();
  const kept = await open(sha256);
  kept.add(0, bytesUpTo(200));
  await kept.flush();
  kept.add(200, bytesUpTo(100));
  await kept.forget();
  kept.add(0, bytesUpTo(100));
  await kept.flush();
  assert.deepEqual(await read(sha256), []);
});

/**
 * Changes a piece in the database.
 *
 * @param {string} key
 * @param {number} from
 * @param {(piece: any) => object} how
 * @returns {Promise<void>}
 */
function change(key, from, how) {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open('jsm-archives');
    opening.onerror = () => reject(opening.error);
    opening.onsuccess = () => {
      const transaction = opening.result.transaction('pieces', 'readwrite');
      const pieces = transaction.objectStore('pieces');
      const reading = pieces.get([key, from]);
      reading.onsuccess = () => pieces.put(how(reading.result));
      transaction.oncomplete = () => {
        opening.result.close();
        resolve();
      };
    };
  });
}
