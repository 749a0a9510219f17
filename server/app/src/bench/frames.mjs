// @ts-check
// What refining a model costs the page's main thread, frame by frame: node frames.mjs MODEL.jsm... streams each archive
// to its end in a headless Chromium and reads the processor time of all tasks from a trace. --rate=BYTES sends no more
// than so many bytes of an archive a second; --models=N streams it N times at once, of which the first is drawn; --workers=N lets
// the page start so many workers, whatever processors there are; --undrawn leaves out the triangles, which a processor
// draws where there is no graphics card.

import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const PATIENCE_MILLIS = 900_000;
const LOOK_MILLIS = 500;
const SEND_MILLIS = 50;
const CATEGORIES = 'toplevel,devtools.timeline,__metadata';
const TASKS = new Set(['RunTask', 'ThreadControllerImpl::RunTask']);
const FRAME = 'FireAnimationFrame';
/** Where the page asks for no frame, or the processor draws one for longer, every 60th of a second counts as one. */
const FRAME_MICROS = 1e6 / 60;
const here = path.dirname(fileURLToPath(import.meta.url));
const modules = path.resolve(here, '../../../../client/web/target/test-classes/META-INF/resources/jsm/modules');
/** @type {Record<string, string>} */
const TYPES = { html: 'text/html', js: 'text/javascript', json: 'application/json', wasm: 'application/wasm' };

const args = process.argv.slice(2);
const models = args.filter((arg) => !arg.startsWith('--'));
const chromium = args.find((arg) => arg.startsWith('--chromium='))?.slice('--chromium='.length) ?? 'chromium';
const number = (/** @type {string} */ name, /** @type {number} */ otherwise) => Number(args.find((arg) => arg.startsWith(`--${name}=`))?.slice(name.length + 3) ?? otherwise);
const rate = number('rate', Infinity);
const atOnce = number('models', 1);
const workers = number('workers', 0);
const isUndrawn = args.includes('--undrawn');
if (models.length === 0 || !(rate > 0) || !(atOnce > 0)) {
  console.error('usage: node frames.mjs [--chromium=PATH] [--rate=BYTES] [--models=N] [--workers=N] [--undrawn] MODEL.jsm...');
  process.exit(2);
}
/** @param {string} model an archive */
async function measure(model) {
  const server = await serve(model);
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'jsm-frames-'));
  const browser = new Browser(profile);
  try {
    const { targetId } = await browser.ask('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await browser.ask('Target.attachToTarget', { targetId, flatten: true });
    // The page leaves one processor to itself.
    if (workers > 0) await browser.ask('Emulation.setHardwareConcurrencyOverride', { hardwareConcurrency: workers + 1 }, sessionId);
    await browser.ask('Tracing.start', { categories: CATEGORIES, transferMode: 'ReportEvents' });
    await browser.ask('Page.navigate', { url: `http://127.0.0.1:${port}/frames.html?models=${atOnce}${isUndrawn ? '&undrawn' : ''}` }, sessionId);
    const { faces, steps, millis, error } = await browser.result(sessionId);
    if (error) throw new Error(error);
    const cost = summary(await browser.trace());
    return [path.basename(model), faces, steps, (millis / 1000).toFixed(1), ...cost];
  } finally {
    await browser.end();
    server.close();
    server.closeAllConnections();
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  }
}

/**
 * Total time, frames in which the page did something, the median one, 95 of 100, the dearest, and the dearest task.
 *
 * @param {any[]} events
 */
function summary(events) {
  const threads = new Set(events.filter((e) => e.name === 'thread_name' && e.args.name === 'CrRendererMain').map((e) => `${e.pid} ${e.tid}`));
  const ours = events.filter((e) => e.name === FRAME && threads.has(`${e.pid} ${e.tid}`));
  const page = `${ours[0]?.pid} ${ours[0]?.tid}`;
  const tasks = events.filter((e) => TASKS.has(e.name) && e.ph === 'X' && `${e.pid} ${e.tid}` === page).sort((a, b) => a.ts - b.ts);
  const starts = ours.map((e) => e.ts).sort((a, b) => a - b);
  /** @type {Map<string, number>} */
  const frames = new Map();
  const micros = (/** @type {any} */ task) => task.tdur ?? task.dur;
  let frame = 0;
  for (const task of tasks) {
    while (frame + 1 < starts.length && starts[frame + 1] < task.ts + task.dur) frame++;
    // What the page's own code costs to start is not what refining costs.
    if (frame === 0) continue;
    const key = `${frame} ${Math.max(0, Math.floor((task.ts - starts[frame]) / FRAME_MICROS))}`;
    frames.set(key, (frames.get(key) ?? 0) + micros(task));
  }
  const costs = [...frames.values()].sort((a, b) => a - b);
  const total = tasks.reduce((sum, task) => sum + micros(task), 0);
  const later = tasks.filter((task) => task.ts > starts[1]);
  const largest = Math.max(0, ...later.map(micros));
  const cost = (/** @type {number} */ share) => costs[Math.min(Math.floor(share * costs.length), costs.length - 1)] ?? 0;
  return [total, costs.length, cost(0.5), cost(0.95), cost(1), largest].map((x, i) => (i === 1 ? x : (x / 1000).toFixed(1)));
}

/**
 * @param {string} model
 * @returns {Promise<http.Server>}
 */
function serve(model) {
  const server = http.createServer((request, response) => {
    const address = new URL(request.url ?? '/', 'http://host').pathname;
    const file = address === '/model.jsm' ? model : address.startsWith('/modules/') ? path.join(modules, address.slice('/modules/'.length)) : path.join(here, path.basename(address));
    if (address.includes('..') || !fs.existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    const bytes = fs.readFileSync(file);
    const [, from, to] = /bytes=(\d+)-(\d*)/.exec(request.headers.range ?? '') ?? [];
    /** @type {Record<string, string>} */
    const headers = { 'Content-Type': TYPES[path.extname(file).slice(1)] ?? 'application/octet-stream', 'Accept-Ranges': 'bytes', ETag: '"1"' };
    if (from === undefined) {
      response.writeHead(200, headers).end(bytes);
      return;
    }
    const end = to === '' ? bytes.length : Math.min(bytes.length, Number(to) + 1);
    response.writeHead(206, { ...headers, 'Content-Range': `bytes ${from}-${end - 1}/${bytes.length}` });
    send(response, bytes.subarray(Number(from), end));
  });
  return new Promise((ready) => server.listen(0, '127.0.0.1', () => ready(server)));
}

/**
 * @param {http.ServerResponse} response
 * @param {Buffer} bytes
 */
async function send(response, bytes) {
  const portion = (rate * SEND_MILLIS) / 1000;
  const start = performance.now();
  for (let from = 0; from < bytes.length && !response.destroyed; from += portion) {
    response.write(bytes.subarray(from, from + portion));
    if (from + portion < bytes.length) await new Promise((resolve) => setTimeout(resolve, start + (1000 * (from + portion)) / rate - performance.now()));
  }
  response.end();
}

/** A Chromium of its own, spoken to through pipes. */
class Browser {
  #process;
  #asked = 0;
  /** @type {Map<number, { resolve: (value: any) => void, reject: (reason: Error) => void }>} */
  #waiting = new Map();
  /** @type {any[]} */
  #events = [];
  #traced = () => {};
  #text = '';

  /** @param {string} profile folder */
  constructor(profile) {
    this.#process = spawn(chromium, [
      '--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
      '--disable-dev-shm-usage', '--enable-unsafe-swiftshader', '--remote-debugging-pipe', '--window-size=320,240', `--user-data-dir=${profile}`,
    ], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    const answers = /** @type {import('node:stream').Readable} */ (this.#process.stdio[4]);
    answers.setEncoding('utf8');
    answers.on('data', (text) => this.#read(text));
  }

  /** @param {string} text */
  #read(text) {
    const parts = (this.#text + text).split('\0');
    this.#text = parts.pop() ?? '';
    for (const part of parts) this.#hear(JSON.parse(part));
  }

  /** @param {any} message */
  #hear({ id, result, error, method, params }) {
    if (method === 'Tracing.dataCollected') for (const event of params.value) this.#events.push(event);
    if (method === 'Tracing.tracingComplete') this.#traced();
    const waiting = this.#waiting.get(id);
    if (waiting === undefined) return;
    this.#waiting.delete(id);
    if (error) waiting.reject(new Error(error.message));
    else waiting.resolve(result);
  }

  /**
   * @param {string} method
   * @param {object} params
   * @param {string} [sessionId]
   * @returns {Promise<any>}
   */
  ask(method, params = {}, sessionId = undefined) {
    const id = ++this.#asked;
    const pipe = /** @type {import('node:stream').Writable} */ (this.#process.stdio[3]);
    pipe.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  /** @param {string} sessionId of the page, whose result is waited for */
  async result(sessionId) {
    for (const end = Date.now() + PATIENCE_MILLIS; Date.now() < end; ) {
      const { result } = await this.ask('Runtime.evaluate', { expression: 'globalThis.result ?? null' }, sessionId);
      if (typeof result.value === 'string') return JSON.parse(result.value);
      await new Promise((resolve) => setTimeout(resolve, LOOK_MILLIS));
    }
    throw new Error('the page did not come to its end');
  }

  /** @returns {Promise<any[]>} */
  async trace() {
    /** @type {Promise<void>} */
    const traced = new Promise((resolve) => (this.#traced = resolve));
    await this.ask('Tracing.end');
    await traced;
    return this.#events;
  }

  async end() {
    const ended = new Promise((resolve) => this.#process.on('close', resolve));
    this.#process.kill();
    await ended;
  }
}

const rows = [];
for (const model of models) rows.push(await measure(model));
console.log(`${os.cpus().length} × ${os.cpus()[0].model.trim()}, load ${os.loadavg()[0].toFixed(1)}\n`);
console.log('Processor time of the main thread in ms\n');
console.log('| model | faces | steps | s | total | frames | a frame, 50% | 95% | most | largest task |');
console.log('|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|');
for (const row of rows) console.log(`| ${row.join(' | ')} |`);
