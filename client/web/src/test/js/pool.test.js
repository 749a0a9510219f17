import assert from 'node:assert/strict';
import test, { beforeEach } from 'node:test';
import { standOn } from './support/web.js';

const PAGE = new URL('../../main/js/page/index.html', import.meta.url).href;
standOn(PAGE);
const HOST = 'https://models.example/';

const { Connection } = await import('../../main/js/session/pool.js');

class FakeWorker extends EventTarget {
  /** @type {MessagePort[]} */
  ports = [];
  isTerminated = false;

  constructor() {
    super();
    workers.push(this);
  }

  /** @param {unknown} _ @param {MessagePort[]} ports */
  postMessage(_, ports) {
    this.ports.push(...ports);
  }

  terminate() {
    this.isTerminated = true;
  }
}

/** @type {FakeWorker[]} */
let workers = [];
Object.assign(globalThis, { Worker: FakeWorker });
beforeEach(() => (workers = []));

/** @type {string[]} */
const heard = [];
const connect = () => new Connection({ hear: (message) => void heard.push(message.type), broken: (reason) => void heard.push(reason) });

/** @param {number} cores */
function machineOf(cores) {
  Object.defineProperty(globalThis, 'navigator', { value: { hardwareConcurrency: cores }, configurable: true });
}

test('models share as many workers as the machine has cores to spare, four at most', () => {
  for (const [cores, most] of [[1, 1], [2, 1], [4, 3], [64, 4]]) {
    machineOf(cores);
    workers = [];
    const connections = Array.from({ length: 9 }, connect);
    assert.equal(workers.length, most);
    const counts = workers.map(({ ports }) => ports.length);
    assert.ok(Math.max(...counts) - Math.min(...counts) <= 1, `${counts}`);
    connections.forEach((connection) => connection.close());
    assert.ok(workers.every(({ isTerminated }) => isTerminated));
  }
});

test('wishes and answers go through a port of their own, and end with it', async () => {
  machineOf(2);
  heard.length = 0;
  const [a, b] = [connect(), connect()];
  const [{ ports }] = workers;
  let sent = 0;
  const wish = new Promise((resolve) => {
    ports[0].onmessage = ({ data }) => {
      sent++;
      resolve(data);
    };
  });
  a.send({ type: 'stop' });
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(sent, 0); // until the worker runs
  workers[0].dispatchEvent(new Event('message'));
  assert.deepEqual(await wish, { type: 'stop' });
  ports[1].postMessage({ type: 'proving' });
  while (heard.length === 0) await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(heard, ['proving']);
  a.close();
  assert.equal(workers[0].isTerminated, false);
  b.close();
  assert.equal(workers[0].isTerminated, true);
});

test('what is known of the link when the worker runs goes with an archive', async () => {
  machineOf(2);
  const connection = connect();
  const [{ ports }] = workers;
  const wish = new Promise((resolve) => (ports[0].onmessage = ({ data }) => resolve(data)));
  connection.send({ type: 'open', archiveUrl: `${HOST}a.jsm`, decoder: 'js', serverPlan: false });
  const entries = [{ name: `${HOST}worker.js`, requestStart: 100, responseEnd: 350, transferSize: 4000, encodedBodySize: 3700 }];
  performance.getEntriesByType = () => /** @type {any} */ (entries);
  workers[0].dispatchEvent(new Event('message'));
  assert.deepEqual(await wish, { type: 'open', archiveUrl: `${HOST}a.jsm`, decoder: 'js', serverPlan: false, link: [250, 4000] });
  connection.close();
});

test('all models of a worker hear that it did not load, and the next one gets another', () => {
  machineOf(2);
  heard.length = 0;
  const broken = [connect(), connect()];
  workers[0].dispatchEvent(new Event('error'));
  assert.deepEqual(heard, ['the worker did not load', 'the worker did not load']);
  const next = connect();
  assert.equal(workers.length, 2);
  [...broken, next].forEach((connection) => connection.close());
});
