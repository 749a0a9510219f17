// @ts-check
// Decoding speed in a browser: jSM as WebAssembly and as JavaScript, from dense archives and from light ones, beside its
// peers, in one page of a headless Chromium. --decoder=NAME=FOLDER adds another build of jSM, from the folder of its
// checkout; its archives are encoded by its own command. It may be given several times.

import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { commandLine, encode, geometricMean, machine, open, printTable, temporary } from './model.mjs';
import { encodeDraco, encodeMeshopt } from './codecs.mjs';
import { encodeDracoLattice } from './lattice.mjs';
import { clockOfPages } from './processes.mjs';

const RUNS = 12;
const PATIENCE_MILLIS = 1_800_000;
const here = path.dirname(fileURLToPath(import.meta.url));
const modulesOf = (checkout) => path.join(checkout, 'client/web/target/test-classes/META-INF/resources/jsm/modules');
const TYPES = { html: 'text/html', js: 'text/javascript', mjs: 'text/javascript', json: 'application/json', wasm: 'application/wasm' };

const { files, options } = commandLine('browser.mjs [--chromium=PATH] [--runs=N] [--decoder=NAME=FOLDER]... MODEL...');
const runs = Number(options.runs ?? RUNS);
const others = process.argv.filter((arg) => arg.startsWith('--decoder=')).map((arg) => {
  const [, name, checkout] = /^--decoder=([^=]+)=(.+)$/.exec(arg) ?? [];
  const command = path.join(checkout ?? '', 'server/app/target/jsm.jar');
  if (checkout && fs.existsSync(command) && fs.existsSync(modulesOf(checkout))) return { name, checkout, command };
  console.error(`${arg}: there is no build of jSM; name a checkout in which mvn -q -DskipTests package has run`);
  return process.exit(2);
});
const folders = {
  'build-0': modulesOf(path.resolve(here, '../../../..')),
  draco: path.join(here, 'node_modules/draco3d'),
  three: path.join(here, 'node_modules/three/examples/jsm/libs/draco'),
  meshopt: path.join(here, 'node_modules/meshoptimizer'),
  ...Object.fromEntries(others.map(({ checkout }, i) => [`build-${i + 1}`, modulesOf(checkout)])),
};

const both = (name, row) => [{ name: `${name}, Wasm`, kind: 'wasm', ...row }, { name: `${name}, JS`, kind: 'js', ...row }];
const decoders = [
  ...both('jSM', { sort: 'jsm', build: 0, archive: (model) => model.archive }),
  ...both('jSM fast', { sort: 'jsm', build: 0, archive: (model) => encode(model, 'fast', { encoding: ['--quality', 'fast'] }) }),
  ...others.flatMap(({ name, command }, i) => both(name, { sort: 'jsm', build: i + 1, archive: (model) => encode(model, `build-${i + 1}`, { command }) })),
  ...both('Draco', { sort: 'draco' }),
  { name: 'Draco, integers of a lattice, Wasm', sort: 'lattice', kind: 'wasm' },
  { name: 'meshopt, Wasm', sort: 'meshopt', kind: 'wasm' },
];

const models = files.map((file) => {
  const model = open(file);
  const made = new Map(); // what both kinds of a decoder take
  const rows = decoders.map(({ sort, archive }) => {
    const key = archive ?? sort;
    if (!made.has(key)) made.set(key, archive ? { file: fs.readFileSync(archive(model)) } : peer(sort, model));
    return made.get(key);
  });
  console.error(`${model.name} is encoded`);
  return { name: model.name, faces: model.faces, rows };
});

/** What a peer's decoder takes; null where it cannot encode the model. */
function peer(sort, model) {
  if (sort === 'draco') return { file: Buffer.from(encodeDraco(model.positions, model.indices, 14)) };
  if (sort === 'lattice') return latticeFile(encodeDracoLattice(model));
  const { points, faces, vertices, indices } = encodeMeshopt(model);
  return { file: Buffer.concat([points, faces]), points: points.length, vertices, indices };
}

function latticeFile(found) {
  return found ? { file: Buffer.from(found.file) } : null;
}

/** @type {(result: any) => void} */
let resolve = () => {};
const promise = new Promise((done) => (resolve = done));
let clock = () => 0;
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
clock = clockOfPages(chromium.pid);
chromium.on('error', (error) => resolve({ error: `${error.message}; name the browser with --chromium=PATH` }));
const timer = setTimeout(() => resolve({ error: 'the page did not answer' }), PATIENCE_MILLIS);
const result = await promise;
clearTimeout(timer);
const isCpuTime = clock() > 0;
const ended = new Promise((end) => chromium.on('close', end));
chromium.kill();
server.close();
server.closeAllConnections();
if (chromium.pid !== undefined) await ended;
fs.rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 }); // other processes of it may write for a moment yet

if (result.error) {
  console.error(result.error);
  process.exitCode = 1;
} else {
  const version = /(?:Headless)?Chrome\/([\d.]+)/.exec(result.browser)?.[1];
  console.log(`${machine()}, Chromium ${version}\n\nMillion faces/s ${isCpuTime ? "of the page's processor time" : 'of the time of day'}, best of ${runs} rounds, in turns`);
  const speed = (i, d) => (result.millis[i][d] === null ? null : models[i].faces / result.millis[i][d] / 1000);
  const rows = models.map(({ name, faces }, i) => [name, faces, ...decoders.map((_, d) => speed(i, d)?.toFixed(2) ?? '–')]);
  const means = decoders.map((_, d) => geometricMean(models.map((__, i) => speed(i, d)).filter((value) => value !== null)).toFixed(2));
  printTable(['model', 'faces', ...decoders.map(({ name }) => name)], [...rows, ['geometric mean', '', ...means]]);
}

/** What the page asks for, or null. */
function content(address) {
  if (address === '/browser.html' || address === '/browser.js') return fs.readFileSync(path.join(here, address));
  if (address === '/clock') return String(clock());
  if (address === '/task.json') return JSON.stringify(task());
  const [, folder, rest] = /^\/([\w-]+)\/([\w./-]+)$/.exec(address) ?? [];
  if (folder === 'model') {
    const [index, row] = rest.split('/');
    return models[index]?.rows[row]?.file ?? null;
  }
  if (!(folder in folders) || rest.includes('..')) return null;
  const file = path.join(folders[folder], rest);
  return fs.existsSync(file) ? fs.readFileSync(file) : null;
}

function task() {
  return {
    decoders: decoders.map(({ sort, build, kind }) => ({ sort, build, kind })),
    models: models.map(({ faces, rows }, index) => ({ index, faces, runs, rows: rows.map((row) => row && { ...row, file: undefined }) })),
  };
}
