import assert from 'node:assert/strict';
import test, { beforeEach } from 'node:test';
import { Session, WAIT_MILLIS } from '../../main/resources/META-INF/resources/jsm/viewer/session.js';

/** @import { Message, Wish } from '../../main/resources/META-INF/resources/jsm/viewer/messages.js' */

/** Takes wishes and says what the test tells it to. */
class FakeWorker extends EventTarget {
  /** @type {Wish[]} */
  wishes = [];
  isTerminated = false;

  constructor() {
    super();
    workers.push(this);
  }

  /** @param {Wish} wish */
  postMessage(wish) {
    this.wishes.push(wish);
  }

  /** @param {Message[]} messages */
  say(...messages) {
    for (const data of messages) this.dispatchEvent(new MessageEvent('message', { data }));
  }

  terminate() {
    this.isTerminated = true;
  }
}

class FakeScreen {
  /** @type {unknown[]} */
  calls = [];
  open = () => void this.calls.push('open');
  update = () => void this.calls.push('update');
  clear = () => void this.calls.push('clear');
  addTexture = async (/** @type {string} */ path) => {
    this.calls.push(path);
    if (path.startsWith('bad')) throw new Error('no image');
  };
}

/** @type {FakeWorker[]} */
let workers = [];
Object.assign(globalThis, { Worker: FakeWorker });
beforeEach(() => (workers = []));

/** @type {any} */
const HEADER = { whole: true, archiveBytes: 1000, faces: 12, batchLevels: [0, 3], errorMeans: [0.5, 0.25] };
/** @type {any} */
const DRAWN = { indices: new Uint32Array(18) };
const MANIFEST = { archiveUrl: 'http://host/a.jsm', archiveSha256: 'a', bytes: 900, faces: 10 };

function begin(renew = async () => ({ ...MANIFEST })) {
  const session = new Session();
  const screen = new FakeScreen();
  session.stage = screen;
  session.open(MANIFEST, 'auto', false, renew);
  return { session, screen, figures: session.figures, worker: workers[workers.length - 1] };
}

/** @param {FakeWorker} worker */
function showBase(worker) {
  worker.say({ type: 'done', complete: false }, { type: 'header', header: HEADER }, { type: 'progress', received: 150, bytesPerSecond: 9 });
  worker.say({ type: 'picture', batches: 1, received: 150, drawn: DRAWN });
}

test('opens the archive and asks for a round', async () => {
  const { session, worker, figures } = begin();
  const round = session.refine();
  assert.deepEqual(worker.wishes.map(({ type }) => type), ['open', 'round']);
  assert.deepEqual(worker.wishes[1], { type: 'round', waitMillis: WAIT_MILLIS });
  assert.deepEqual([figures.state, figures.totalBytes, figures.totalFaces], ['loading', 900, 10]);
  showBase(worker);
  assert.deepEqual([figures.state, figures.totalBytes, figures.totalFaces, figures.faces], ['refining', 1000, 12, 6]);
  assert.deepEqual([figures.level, figures.errorMean], [0, 0.5]);
  worker.say({ type: 'done', complete: false });
  await round;
  assert.deepEqual([figures.state, figures.status, session.rounds[0].to], ['idle', '', 150]);
  assert.deepEqual(worker.wishes.at(-1), { type: 'drawn' });
});

test('is complete when the worker says so, and asks for no more', async () => {
  const { session, worker, figures } = begin();
  const all = session.complete();
  showBase(worker);
  worker.say({ type: 'proving' });
  assert.equal(figures.status, 'Comparing with the original');
  worker.say({ type: 'identical', sha256: 'of the mesh' }, { type: 'done', complete: true });
  await all;
  assert.deepEqual([figures.state, figures.identical, figures.sha256], ['complete', true, 'of the mesh']);
  const asked = worker.wishes.length;
  await session.refine();
  assert.equal(worker.wishes.length, asked);
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
  worker.say({ type: 'progress', received: 150, bytesPerSecond: 9 });
  assert.equal(figures.status, 'Connection lost');
  worker.say({ type: 'progress', received: 151, bytesPerSecond: 9 });
  assert.equal(figures.status, 'Opening');
});

test('an image that cannot be read is noted, and does not stop the model', async () => {
  const { session, worker, screen, figures } = begin();
  worker.say({ type: 'texture', path: 'bad\nname.png', bytes: new Uint8Array(3) }, { type: 'texture', path: 'good.png', bytes: new Uint8Array(3) });
  assert.equal(session.texturesLoading, 2);
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual([session.texturesLoading, figures.notice], [0, 'The texture bad\nname.png is not an image that this browser can show.']);
  assert.deepEqual(screen.calls, ['bad\nname.png', 'good.png']);
});

test('a model that was changed on the server is shown from its beginning', async () => {
  const { session, worker, screen } = begin(async () => ({ ...MANIFEST, archiveSha256: 'b', bytes: 2000 }));
  const round = session.refine();
  showBase(worker);
  worker.say({ type: 'error', message: 'changed', retryable: false, changed: 'another' });
  while (workers.length < 2) await new Promise((resolve) => setTimeout(resolve));
  assert.equal(worker.isTerminated, true);
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

test('a worker that does not start is an error', async () => {
  const { session, worker, figures } = begin();
  const round = session.refine();
  worker.dispatchEvent(new Event('error'));
  await round;
  assert.equal(figures.error, 'The viewer could not start its decoder: the worker did not load.');
});
