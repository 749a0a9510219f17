import assert from 'node:assert/strict';
import test, { beforeEach } from 'node:test';
import { Session, WAIT_MILLIS } from '../../main/js/session/session.js';

/** @import { Message, Wish } from '../../main/js/decode/messages.js' */
/** @import { Listener } from '../../main/js/session/pool.js' */

/** Takes wishes and says what the test tells it to. */
class FakeWorker {
  /** @type {Wish[]} */
  wishes = [];
  isClosed = false;
  /** @type {Set<number | undefined>} */
  answered = new Set();

  /** @param {Listener} listener */
  constructor(listener) {
    this.listener = listener;
    workers.push(this);
  }

  /** @param {Wish} wish */
  send(wish) {
    this.wishes.push(wish);
  }

  /** @param {Message[]} messages */
  say(...messages) {
    for (const message of messages) {
      const [id] = this.wishes.flatMap((wish) => ('id' in wish && !this.answered.has(wish.id) ? [wish.id] : []));
      if (message.type === 'done' && message.id === undefined) this.answered.add(id);
      this.listener.hear(message.type === 'done' ? { id, ...message } : message);
    }
  }

  close() {
    this.isClosed = true;
  }
}

class FakeScreen {
  /** @type {unknown[]} */
  calls = [];
  isOffline = false;
  open = async () => {
    this.calls.push('open');
    if (this.isOffline) throw new Error('no network');
  };
  update = () => void this.calls.push('update');
  clear = () => void this.calls.push('clear');
  addTexture = async (/** @type {string[]} */ paths) => {
    this.calls.push(paths);
    if (paths[0].startsWith('bad')) throw new Error('no image');
  };
}

/** @type {FakeWorker[]} */
let workers = [];
beforeEach(() => (workers = []));

/** @type {any} */
const HEADER = { whole: true, archiveBytes: 1000, faces: 12, wedges: 8, ends: [150, 1000], batchFaces: [6, 12], batchLevels: [0, 3], errorMeans: [0.5, 0.25], errorQuantiles: [2, 1] };
/** @type {any} */
const CHANGES = { step: 1, jump: false, batches: 1, faces: 6, vertices: 0, places: 6, groups: [0, 0, 18], tangents: [], ranges: new Uint32Array(), data: new Uint32Array() };
const MANIFEST = { archiveUrl: 'http://host/a.jsm', archiveSha256: 'a', bytes: 900, faces: 10 };

function begin(renew = async () => ({ ...MANIFEST })) {
  const session = new Session((listener) => new FakeWorker(listener));
  const screen = new FakeScreen();
  session.stage = screen;
  session.open(MANIFEST, { decoder: 'auto', serverPlan: false, renew });
  return { session, screen, figures: session.figures, worker: workers[workers.length - 1] };
}

/** @param {FakeWorker} worker */
function showBase(worker) {
  worker.say({ type: 'done', complete: false }, { type: 'header', header: HEADER }, { type: 'progress', received: 150, bytesPerSecond: 9, decodeMillis: 4 });
  worker.say({ type: 'picture', batches: 1, received: 150, changes: CHANGES });
}

test('opens the archive and asks for a round', async () => {
  const { session, worker, figures } = begin();
  const round = session.refine();
  assert.deepEqual(worker.wishes.map(({ type }) => type), ['open', 'round']);
  assert.deepEqual(worker.wishes[1], { type: 'round', id: 2, waitMillis: WAIT_MILLIS });
  assert.deepEqual([figures.state, figures.totalBytes, figures.totalFaces], ['loading', 900, 10]);
  showBase(worker);
  assert.deepEqual([figures.state, figures.totalBytes, figures.totalFaces, figures.faces], ['refining', 1000, 12, 6]);
  assert.deepEqual([figures.level, figures.errorMean, figures.errorQuantile], [0, 0.5, 2]);
  worker.say({ type: 'done', complete: false });
  await round;
  assert.deepEqual([figures.state, figures.status, session.rounds[0].to], ['idle', '', 150]);
  assert.deepEqual(worker.wishes.at(-1), { type: 'drawn', used: CHANGES.data });
});

test('knows an archive that cannot be shown, and asks for nothing', () => {
  const session = new Session((listener) => new FakeWorker(listener));
  session.fail('no WebGL 2');
  session.open(MANIFEST, { decoder: 'auto', serverPlan: false, renew: async () => MANIFEST });
  const { figures, opened } = session;
  assert.deepEqual([figures.error, figures.totalBytes, figures.totalFaces, opened?.manifest], ['no WebGL 2', 900, 10, MANIFEST]);
  assert.deepEqual(workers[0].wishes, []);
});

test('is complete when the worker says so, and asks for no more', async () => {
  const { session, worker, figures } = begin();
  const all = session.complete();
  showBase(worker);
  worker.say({ type: 'proving' });
  assert.equal(figures.status, 'Comparing with the original');
  worker.say({ type: 'proved', meshSha256: 'of the mesh', modelSha256: 'of the model' }, { type: 'done', complete: true });
  await all;
  assert.deepEqual([figures.state, figures.proved, figures.sha256, figures.modelSha256], ['complete', true, 'of the mesh', 'of the model']);
  const asked = worker.wishes.length;
  await session.refine();
  assert.equal(worker.wishes.length, asked);
});

test('says that the budget is reached, and goes on with a larger one', async () => {
  const { session, worker, figures } = begin();
  const all = session.complete();
  showBase(worker);
  worker.say({ type: 'full' }, { type: 'done', complete: false });
  await all;
  assert.deepEqual([figures.state, figures.isFull, figures.isOver], ['idle', true, false]);
  session.mostFaces = 4e6;
  assert.equal(figures.isFull, false);
  assert.deepEqual(worker.wishes.at(-1), { type: 'mostFaces', faces: 4e6 });
});

test('stops at what the graphics card has memory for', () => {
  const { session, screen, worker, figures } = begin();
  session.complete();
  showBase(worker);
  const [vertices] = [session.arrays.positions.length / 3];
  const { lacksMemory } = /** @type {FakeScreen & { lacksMemory: () => void }} */ (screen);
  screen.calls = [];
  lacksMemory();
  assert.deepEqual([worker.wishes.at(-1), figures.isFull, screen.calls], [{ type: 'mostFaces', faces: 6 }, true, ['update']]);
  assert.ok(session.arrays.positions.length / 3 < vertices && session.arrays.indices.length === 18);
  session.mostFaces = Infinity;
  assert.deepEqual([session.opened?.mostFaces, figures.isFull, figures.error], [6, true, null]);
  lacksMemory();
  assert.match(figures.error ?? '', /no memory/);
  assert.deepEqual(worker.wishes.at(-1), { type: 'stop' });
});

test('an error can be tried again where that can help', async () => {
  const { session, worker, figures } = begin();
  const all = session.complete();
  showBase(worker);
  worker.say({ type: 'error', message: 'The connection broke.', retryable: true });
  await all;
  assert.deepEqual([figures.state, figures.error, figures.retryable], ['error', 'The connection broke.', true]);
  session.retry();
  assert.deepEqual([figures.state, figures.error, worker.wishes.at(-1)?.type], ['refining', null, 'complete']);
});

test('an error against which nothing helps ends it', async () => {
  const { session, worker } = begin();
  const all = session.complete();
  worker.say({ type: 'error', message: 'The archive is damaged.', retryable: false });
  await all;
  const asked = worker.wishes.length;
  await session.retry();
  assert.equal(worker.wishes.length, asked);
});

test('a lost connection is told until bytes come again', () => {
  const { session, worker, figures } = begin();
  session.refine();
  showBase(worker);
  worker.say({ type: 'waiting', text: 'Connection lost' });
  worker.say({ type: 'progress', received: 150, bytesPerSecond: 9, decodeMillis: 4 });
  assert.equal(figures.status, 'Connection lost');
  worker.say({ type: 'progress', received: 151, bytesPerSecond: 9, decodeMillis: 4 });
  assert.equal(figures.status, 'Opening');
});

test('materials that cannot be loaded are named, and the model is shown', async () => {
  const { session, screen, worker, figures } = begin();
  screen.isOffline = true;
  session.refine();
  showBase(worker);
  assert.equal(session.texturesLoading, 1);
  await new Promise(setImmediate);
  assert.deepEqual([session.texturesLoading, figures.notice, figures.error], [0, 'The materials could not be loaded (no network). Reload the page.', null]);
  assert.deepEqual(screen.calls, ['open', 'update']);
});

test('an image that cannot be read is noted, and does not stop the model', async () => {
  const { session, worker, screen, figures } = begin();
  worker.say({ type: 'texture', paths: ['bad\nname.png'], bytes: new Uint8Array(3) }, { type: 'texture', paths: ['good.png', 'again.png'], bytes: new Uint8Array(3) });
  assert.equal(session.texturesLoading, 2);
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual([session.texturesLoading, figures.notice], [0, 'The texture bad\nname.png is not an image that this browser can show.']);
  assert.deepEqual(screen.calls, [['bad\nname.png'], ['good.png', 'again.png']]);
});

test('a model that was changed on the server is shown from its beginning', async () => {
  const { session, worker, screen } = begin(async () => ({ ...MANIFEST, archiveSha256: 'b', bytes: 2000 }));
  const round = session.refine();
  showBase(worker);
  worker.say({ type: 'error', message: 'changed', retryable: false, changed: 'another' });
  while (workers.length < 2) await new Promise((resolve) => setTimeout(resolve));
  assert.equal(worker.isClosed, true);
  assert.deepEqual([session.figures.state, session.figures.faces, session.figures.totalBytes], ['loading', 0, 2000]);
  assert.equal(screen.calls.at(-1), 'clear');
  assert.match(session.renewed ?? '', /was changed on the server/);
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(workers[1].wishes.map(({ type }) => type), ['open', 'round']);
  workers[1].say({ type: 'done', complete: false });
  showBase(workers[1]);
  workers[1].say({ type: 'done', complete: false });
  await round;
});

test('a model that is gone, or as it was, is an error', async () => {
  for (const changed of /** @type {const} */ (['another', 'gone'])) {
    const { session, worker, figures } = begin(changed === 'gone' ? () => Promise.reject(new Error('404')) : undefined);
    const round = session.refine();
    worker.say({ type: 'error', message: 'changed', retryable: false, changed });
    await round;
    assert.deepEqual([figures.state, figures.error], ['error', 'changed']);
  }
  assert.equal(workers.length, 2);
});

test('a host whose tags always differ is not asked for ever', async () => {
  let versions = 0;
  const { session } = begin(async () => ({ ...MANIFEST, archiveSha256: `b${versions++}` }));
  session.refine();
  for (let i = 1; i <= 4; i++) {
    workers[i - 1].say({ type: 'error', message: 'changed', retryable: false, changed: 'another' });
    for (let turn = 0; turn < 5; turn++) await new Promise((resolve) => setTimeout(resolve));
  }
  assert.deepEqual([workers.length, versions, session.figures.state], [4, 3, 'error']);
});

test('an archive that lies elsewhere by now is shown from there', async () => {
  const { session, worker } = begin(async () => ({ ...MANIFEST, archiveUrl: 'http://other/a.jsm' }));
  showBase(worker);
  worker.say({ type: 'error', message: 'gone', retryable: false, changed: 'gone' });
  for (let i = 0; i < 100 && workers.length < 2; i++) await new Promise((resolve) => setTimeout(resolve));
  const [opened] = workers[1].wishes;
  assert.equal(opened.type === 'open' && opened.archiveUrl, 'http://other/a.jsm');
  assert.equal(session.figures.error, null);
});

test('an answer that comes after an error is not taken for that of the next wish', async () => {
  const { session, worker } = begin();
  showBase(worker);
  const first = session.complete();
  worker.say({ type: 'error', message: 'The connection broke.', retryable: true });
  await first;
  const late = Math.max(...worker.wishes.map((wish) => ('id' in wish && wish.id) || 0));
  let isOver = false;
  const second = session.complete().then(() => (isOver = true));
  worker.say({ type: 'done', id: late, complete: false });
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(isOver, false);
  worker.say({ type: 'done', id: late + 1, complete: true });
  await second;
});

test('is complete when the rest comes before the picture of a round has come to rest', async () => {
  const { session, worker, figures } = begin();
  const round = session.refine();
  showBase(worker);
  worker.say({ type: 'picture', batches: 2, received: 1000, changes: { ...CHANGES, step: 2 } }, { type: 'done', complete: false }, { type: 'complete' });
  await round;
  assert.equal(figures.state, 'complete');
});

test('shows the model once more, as slowly as before and without what is kept', async () => {
  const { session, worker, screen } = begin();
  const first = session.refine();
  session.limit = 8000;
  showBase(worker);
  const again = session.again(3000);
  assert.deepEqual([worker.isClosed, screen.calls.at(-1), session.figures.bytes, session.renewed], [true, 'clear', 0, null]);
  const [limit, opened, round] = workers[1].wishes;
  assert.deepEqual(limit, { type: 'limit', bytesPerSecond: 8000 });
  assert.ok(opened.type === 'open' && opened.archiveUrl === MANIFEST.archiveUrl && opened.archiveSha256 === undefined);
  assert.ok(round.type === 'round' && round.waitMillis === 3000);
  showBase(workers[1]);
  workers[1].say({ type: 'done', complete: false });
  await Promise.all([first, again]);
  assert.equal(session.figures.state, 'idle');
});

test('a worker that does not start is an error', async () => {
  const { session, worker, figures } = begin();
  const round = session.refine();
  worker.listener.broken('the worker did not load');
  await round;
  assert.equal(figures.error, 'The viewer could not start its decoder: the worker did not load.');
});
