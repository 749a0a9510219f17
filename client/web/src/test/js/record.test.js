import assert from 'node:assert/strict';
import test from 'node:test';
import { rows } from '../../main/js/page/tools/facts.js';
import { bytesAt, facesOf, parts, Record } from '../../main/js/page/tools/record.js';
import { Figures } from '../../main/js/session/figures.js';

/** @import { Round } from '../../main/js/session/figures.js' */

/** @param {number} from @param {number} to @param {number} at @param {number} millis @returns {Round} */
function round(from, to, at, millis) {
  return { kind: 'round', from, to, at, millis, plans: [] };
}

test('counts the time of rounds, not that between them', () => {
  const rounds = [round(0, 100, 1000, 2000), round(100, 300, 90_000, 1000)];
  assert.deepEqual(new Record().points(rounds, 0).filter(({ bytes }) => bytes > 0), [
    { seconds: 2, bytes: 100 },
    { seconds: 2, bytes: 100 },
    { seconds: 3, bytes: 300 },
  ]);
});

test('follows the round that goes on', () => {
  const record = new Record();
  /** @type {Round} */
  const going = { kind: 'round', from: 100, at: 50_000, plans: [] };
  const rounds = [round(0, 100, 1000, 2000), going];
  record.sample(rounds, 150, 50_500);
  record.sample(rounds, 190, 51_000);
  assert.deepEqual(record.points(rounds, 0).slice(-2), [{ seconds: 2.5, bytes: 150 }, { seconds: 3, bytes: 190 }]);
  Object.assign(going, { to: 200, millis: 1200 });
  record.sample(rounds, 200, 99_000);
  assert.deepEqual(record.points(rounds, 0).slice(-2), [{ seconds: 3, bytes: 190 }, { seconds: 3.2, bytes: 200 }]);
});

test('begins anew with the model, and with what was kept', () => {
  const rounds = [round(0, 900, 0, 1000), round(900, 1000, 0, 1000), round(0, 500, 0, 4000)];
  assert.deepEqual(new Record().points(rounds, 0).at(-1), { seconds: 4, bytes: 500 });
  assert.equal(new Record().points([round(0, 900, 0, 1000)], 800)[0].bytes, 800);
});

test('keeps few points of a long round', () => {
  const record = new Record();
  /** @type {Round[]} */
  const rounds = [{ kind: 'complete', from: 0, at: 0, plans: [] }];
  for (let i = 1; i <= 5000; i++) record.sample(rounds, i, 10 * i);
  const points = record.points(rounds, 0);
  assert.ok(points.length > 200 && points.length < 450, `${points.length}`);
  assert.deepEqual(points.at(-1), { seconds: 50, bytes: 5000 });
});

test('gives the throughput of equal parts of the time', () => {
  const points = [{ seconds: 0, bytes: 0 }, { seconds: 2, bytes: 100 }, { seconds: 4, bytes: 500 }];
  assert.deepEqual(parts(points, 4), { seconds: 4, rates: [50, 50, 200, 200], bytes: [50, 100, 300, 500] });
  assert.deepEqual(parts([{ seconds: 0, bytes: 7 }], 2), { seconds: 0, rates: [0, 0], bytes: [7, 7] });
  assert.equal(bytesAt(points, 99), 500);
});

test('knows the faces of so many bytes', () => {
  const faces = [0, 99, 100, 299, 300, 9999].map((bytes) => facesOf([100, 200, 300], [10, 20, 30], bytes));
  assert.deepEqual(faces, [0, 0, 10, 20, 30, 30]);
});

test('says what is known, and nothing of what is not', () => {
  const figures = new Figures();
  const session = { figures, rounds: [], bytesPerSecond: 0, decodeMillis: 12.4, decoder: null, pictures: 0 };
  const before = rows(session, { bytes: 0, textures: 0 }).map(([name]) => name);
  assert.ok(!before.includes('Decoder') && !before.includes('Levels') && !before.includes('Bits per face'));
  /** @type {any} */
  const header = { whole: true, archiveBytes: 1500, faces: 1000, vertices: 502, ends: [500, 1500], batchFaces: [10, 1000], batchLevels: [0, 1], levels: 1, precisionBits: [12, 16],
    slots: [], channels: [{ semantic: 'COLOUR', name: '' }], meshSha256: 'ab' };
  figures.take({ type: 'header', header });
  Object.assign(figures, { faces: 10, bytes: 600, batches: 1 });
  figures.take({ type: 'request', request: { url: '', from: 0, end: 600, status: 206, bytes: 600, cached: true, at: 0 } });
  const after = new Map(rows({ ...session, decoder: 'wasm' }, { bytes: 2048, textures: 2 }));
  assert.deepEqual(
    ['Faces', 'Vertices of the original', 'Bytes', 'Batches', 'Requests', 'Time to decode', 'On the graphics card', 'Decoder', 'Bits per face', 'Bits of a coordinate', 'Attributes']
      .map((name) => after.get(name)),
    ['10 of 1,000', '502', '600 of 1,500', '1 of 2', '1, 1 from the cache', '12 ms', '2.05 kB, 2 textures', 'WebAssembly', '12.0', '16', 'colour'],
  );
});
