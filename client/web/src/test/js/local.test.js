import assert from 'node:assert/strict';
import { File } from 'node:buffer';
import test from 'node:test';
import { archiveAmong, filesOf, modelAmong } from '../../main/js/page/local/dropped.js';
import { encoded, idOf, takesModels } from '../../main/js/page/local/upload.js';
import { zipOf } from '../../main/js/page/local/zip.js';
import { crc32 } from '../../main/js/decode/crc32.js';

Object.assign(globalThis, { File });

/** A file as a folder of the browser has it. @param {string} fullPath @returns {any} */
const entry = (fullPath) => ({ fullPath, isDirectory: false, file: (/** @type {(file: File) => void} */ take) => take(new File([], fullPath)) });

/** A folder that gives its entries one by one. @param {string} fullPath @param {any[]} entries @returns {any} */
const folder = (fullPath, entries) => {
  const left = [...entries];
  return { fullPath, isDirectory: true, createReader: () => ({ readEntries: (/** @type {(some: any[]) => void} */ take) => take(left.splice(0, 1)) }) };
};

/** @param {...string} paths @returns {any[]} */
const given = (...paths) => paths.map((path) => ({ path, file: new File([], path) }));

/** @param {(url: string, options: any) => { status?: number, headers?: Record<string, string>, body?: unknown }} answer */
function serve(answer) {
  Object.assign(globalThis, {
    fetch: async (/** @type {URL} */ url, /** @type {any} */ options) => {
      const { status = 200, headers = {}, body = {} } = answer(url.href, options);
      return new Response(status === 204 ? null : JSON.stringify(body), { status, headers });
    },
  });
}

test('finds all files of a folder, by their paths in it', async () => {
  const files = await filesOf([folder('/chair', [entry('/chair/chair.obj'), folder('/chair/maps', [entry('/chair/maps/wood.png')]), entry('/chair/chair.mtl')])]);
  assert.deepEqual(files.map(({ path }) => path), ['chair.obj', 'maps/wood.png', 'chair.mtl']);
});

test('takes files as they are, and what is no file not at all', async () => {
  const file = /** @type {any} */ (new File(['x'], 'chair.jsm'));
  assert.deepEqual(await filesOf([null, file]), [{ path: 'chair.jsm', file }]);
  assert.deepEqual(await filesOf([]), []);
});

test('tells archives, models and companions apart', () => {
  assert.equal(archiveAmong(given('a.ply', 'b.JSM'))?.path, 'b.JSM');
  assert.equal(archiveAmong(given('jsm.txt')), null);
  assert.equal(modelAmong(given('a.png', 'a.mtl', 'a.stl', 'a.OBJ'))?.path, 'a.OBJ');
  assert.equal(modelAmong(given('a.bin', 'a.gltf', 'a.png'))?.path, 'a.gltf');
  assert.equal(modelAmong(given('chair.ply.gz'))?.path, 'chair.ply.gz');
  assert.equal(modelAmong(given('chair.zip', 'readme.txt'))?.path, 'chair.zip');
  assert.equal(modelAmong(given('readme.txt', 'form')), null);
});

test('names a model as the server would', () => {
  assert.equal(idOf('Big Chair.obj'), 'big-chair');
  assert.equal(idOf('scans/Café_2 (final).ply.gz'), 'cafe-2-final');
  assert.equal(idOf('椅子.obj'), 'model');
  assert.equal(idOf(`${'a'.repeat(79)} b.obj`), 'a'.repeat(79));
});

test('learns from the server whether it takes models', async () => {
  const url = new URL('http://host/m/');
  serve((asked, { method }) => {
    assert.deepEqual([asked, method], ['http://host/m/model', 'OPTIONS']);
    return { status: 204, headers: { Allow: 'GET, HEAD, OPTIONS, POST' } };
  });
  assert.equal(await takesModels(url), true);
  serve(() => ({ status: 204, headers: { Allow: 'GET, HEAD, OPTIONS' } }));
  assert.equal(await takesModels(url), false);
  serve(() => ({ status: 405, headers: { Allow: 'GET, POST' } }));
  assert.equal(await takesModels(url), false);
  serve(() => {
    throw new Error('no host');
  });
  assert.equal(await takesModels(url), false);
});

test('waits for the encoding and gives the page of the model', async () => {
  const states = [{ state: 'queued' }, { state: 'encoding', stage: 'simplify', fraction: 0.5 }, { state: 'ready', manifestUrl: '../chair-obj-abcdef/manifest.json' }];
  serve(() => ({ body: states.shift() }));
  /** @type {[string, number | null][]} */
  const told = [];
  const page = await encoded(new URL('http://host/m/chair/status'), { tell: (...words) => told.push(words), signal: new AbortController().signal });
  assert.equal(page.href, 'http://host/m/chair-obj-abcdef/');
  assert.deepEqual(told, [['Waiting for other models', null], ['Encoding: simplify', 0.5]]);
});

test('says why a server could not encode a model', async () => {
  serve(() => ({ body: { state: 'failed', error: 'chair.obj, line 3: x is no number', remedy: 'correct the line' } }));
  const waiting = encoded(new URL('http://host/m/chair/status'), { tell() {}, signal: new AbortController().signal });
  await assert.rejects(waiting, { message: 'Chair.obj, line 3: x is no number. Correct the line.' });
});

test('stores files in a ZIP archive as they are', async () => {
  const files = [{ name: 'chair.obj', bytes: Uint8Array.of(118, 32, 49) }, { name: 'maps/wööd.png', bytes: new Uint8Array(70000).fill(7) }];
  const bytes = Buffer.from(await zipOf(files).arrayBuffer());
  const end = bytes.length - 22;
  assert.equal(bytes.readUInt32LE(end), 0x06054b50);
  assert.equal(bytes.readUInt16LE(end + 10), 2);
  let at = bytes.readUInt32LE(end + 16);
  for (const { name, bytes: content } of files) {
    assert.equal(bytes.readUInt32LE(at), 0x02014b50);
    const length = bytes.readUInt16LE(at + 28);
    assert.equal(bytes.toString('utf8', at + 46, at + 46 + length), name);
    assert.equal(bytes.readUInt32LE(at + 16), crc32(content));
    const local = bytes.readUInt32LE(at + 42);
    assert.equal(bytes.readUInt32LE(local), 0x04034b50);
    assert.equal(bytes.readUInt32LE(local + 18), content.length);
    const from = local + 30 + bytes.readUInt16LE(local + 26);
    assert.deepEqual(bytes.subarray(from, from + content.length), Buffer.from(content));
    at += 46 + length;
  }
  assert.equal(at, end);
});
