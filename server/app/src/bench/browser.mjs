// @ts-check
// Decoding speed in a browser: jSM as WebAssembly and as JavaScript beside Draco, in one page of a headless Chromium.

import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { commandLine, machine, open, printTable, temporary } from './model.mjs';
import { encodeDraco } from './codecs.mjs';

const RUNS = 12;
const PATIENCE_MILLIS = 600_000;
const here = path.dirname(fileURLToPath(import.meta.url));
const folders = {
  modules: path.resolve(here, '../../../../client/web/target/test-classes/META-INF/resources/jsm/modules'),
  draco: path.join(here, 'node_modules/draco3d'),
};
const TYPES = { html: 'text/html', js: 'text/javascript', json: 'application/json', wasm: 'application/wasm' };

const { files, options } = commandLine('browser.mjs [--chromium=PATH] [--runs=N] MODEL...');
const models = files.map((file) => {
  const model = open(file);
  return { name: model.name, faces: model.faces, jsm: fs.readFileSync(model.archive), drc: Buffer.from(encodeDraco(model.positions, model.indices, 14)) };
});

/** @type {(result: any) => void} */
let resolve = () => {};
const promise = new Promise((done) => (resolve = done));
const server = http.createServer((request, response) => {
  if (request.method === 'POST') {
    let text = '';
    request.on('data', (part) => (text += part));
    request.on('end', () => {
      response.end();
      resolve(JSON.parse(text));
    });
    return;
  }
  const body = content(request.url);
  const type = TYPES[path.extname(request.url).slice(1)] ?? 'application/octet-stream';
  response.writeHead(body === null ? 404 : 200, { 'Content-Type': type });
  response.end(body);
});
await new Promise((ready) => server.listen(0, '127.0.0.1', () => ready(undefined)));
const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());

const profile = temporary('chromium');
const chromium = spawn(options.chromium ?? 'chromium', [
  '--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
  '--disable-sync', '--disable-dev-shm-usage', '--disable-gpu', `--user-data-dir=${profile}`, `http://127.0.0.1:${port}/browser.html`,
], { stdio: 'ignore' });
chromium.on('error', (error) => resolve({ error: `${error.message}; name the browser with --chromium=PATH` }));
const timer = setTimeout(() => resolve({ error: 'the page did not answer' }), PATIENCE_MILLIS);
const result = await promise;
clearTimeout(timer);
const ended = new Promise((end) => chromium.on('close', end));
chromium.kill();
server.close();
server.closeAllConnections();
if (chromium.pid !== undefined) await ended;

if (result.error) {
  console.error(result.error);
  process.exitCode = 1;
} else {
  const version = /(?:Headless)?Chrome\/([\d.]+)/.exec(result.browser)?.[1];
  console.log(`${machine()}, Chromium ${version}\n\nMillion faces/s, best of ${options.runs ?? RUNS} runs`);
  const rows = result.models.map((millis, i) => [models[i].name, models[i].faces, ...millis.map((m) => (models[i].faces / m / 1000).toFixed(2))]);
  printTable(['model', 'faces', ...result.names], rows);
}

/** What the page asks for, or null. */
function content(address) {
  if (address === '/browser.html' || address === '/browser.js') return fs.readFileSync(path.join(here, address));
  if (address === '/models.json') return JSON.stringify(models.map(({ faces }, index) => ({ index, faces, runs: Number(options.runs ?? RUNS) })));
  const [, folder, rest] = /^\/(\w+)\/([\w./-]+)$/.exec(address) ?? [];
  if (folder === 'model') {
    const [index, type] = rest.split('.');
    return models[index]?.[type] ?? null;
  }
  if (!(folder in folders) || rest.includes('..')) return null;
  const file = path.join(folders[folder], rest);
  return fs.existsSync(file) ? fs.readFileSync(file) : null;
}
