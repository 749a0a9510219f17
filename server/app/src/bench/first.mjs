// @ts-check
// A first visit over a slow link: when the poster, the first picture and the whole model are on the screen, and what code came for it. jSM's page from `jsm serve` beside pages of the peers.

import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { Link } from './first-link.mjs';
import { peers, serve } from './first-peers.mjs';
import { visit } from './first-browser.mjs';
import { commandLine, jsm, machine, open, printTable, temporary } from './model.mjs';

/** @import { Exchange } from './first-link.mjs' */
/** @import { Marks } from './first-browser.mjs' */

const jar = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../target/jsm.jar');
const JSM = 'jSM';
const FAST_KBPS = 1000;
const RUNS_OF_FAST = 3;
/** What a link may miss its rate by. */
const TOLERANCE = 0.02;
const TEST_SECONDS = 4;
const WARMING = 50;

const { files, options } = commandLine('first.mjs [--kbps=64,256,1000,10000] [--peers=jSM,...] [--runs=N] [--chromium=PATH] [--waterfall=FOLDER] MODEL');
const rates = (options.kbps ?? '64,256,1000,10000').split(',').map(Number);
/** Faster links have the shorter way, too. */
const roundTripOf = (kbps) => (kbps < FAST_KBPS ? 300 : 100);

function listening(server) {
  return /** @type {import('node:net').AddressInfo} */ (server.address()).port;
}

/** Sends a file over a link, which must take what its rate says. */
async function checkLink(kbps) {
  const bytes = Buffer.alloc(Math.round(TEST_SECONDS * kbps * 125), 1);
  const server = http.createServer((_, response) => response.end(bytes));
  await new Promise((ready) => server.listen(0, '127.0.0.1', () => ready(undefined)));
  const link = new Link(kbps, roundTripOf(kbps), listening(server));
  const port = await link.listen();
  await (await fetch(`http://127.0.0.1:${port}/file`)).arrayBuffer();
  link.close();
  server.close();
  server.closeAllConnections();
  const [{ begin, end, bytes: sent }] = link.exchanges;
  const took = end - begin;
  const expected = 2 * roundTripOf(kbps) + sent / (kbps / 8);
  const miss = took / expected - 1;
  console.error(`${kbps} kbit/s: ${sent} bytes in ${(took / 1000).toFixed(3)} s, ${(100 * miss).toFixed(1)}% from what they should take`);
  if (Math.abs(miss) > TOLERANCE) throw new Error(`the link of ${kbps} kbit/s misses its rate: give the machine less to do, and try again`);
}

/** Starts `jsm serve`; resolves to its process and its port. */
async function serveJsm(folder) {
  const probe = http.createServer().listen(0, '127.0.0.1');
  await new Promise((ready) => probe.once('listening', () => ready(undefined)));
  const port = listening(probe);
  await new Promise((closed) => probe.close(closed));
  const child = spawn('java', ['-Xmx512m', '-jar', jar, 'serve', folder, '--host', '127.0.0.1', '--port', String(port), '--cache', temporary('cache')], { stdio: ['ignore', 'pipe', 'inherit'] });
  await new Promise((resolve, reject) => {
    child.stdout.once('data', resolve);
    child.once('exit', () => reject(new Error('the server did not start')));
  });
  child.stdout.resume();
  return { child, port };
}

const isModel = (address) => /\.glb$|\.jsm|\/first$|\/(patches|manifest\.json)/.test(address);
const isPoster = (address) => /poster[^/]*\.jpg$/.test(address);

/**
 * Bytes of code until a time, headers and page included, of which jSM's has the poster in it.
 *
 * @param {Exchange[]} exchanges
 * @param {number} until
 * @param {number} inPage bytes of the page that are a poster
 */
function codeBytes(exchanges, until, inPage) {
  const code = exchanges.filter(({ path: address }) => !isModel(address) && !isPoster(address));
  return code.flatMap(({ chunks }) => chunks).reduce((sum, { at, bytes }) => sum + (at <= until ? bytes : 0), -inPage);
}

/** @param {string} file @param {Exchange[]} exchanges @param {Marks} marks */
function writeWaterfall(file, exchanges, marks) {
  const seconds = (time) => ((time - marks.start) / 1000).toFixed(2);
  const lines = exchanges.map(({ path: address, begin, end, bytes, chunks }) => [seconds(begin), seconds(chunks[0]?.at ?? NaN), seconds(end), String(bytes), address]);
  const marked = Object.entries(marks).filter(([name]) => name !== 'start').map(([name, at]) => `${name} ${typeof at === 'number' ? seconds(at) : at}`);
  fs.writeFileSync(file, `${['asked\tfirst\tlast\tbytes\taddress', ...lines.map((line) => line.join('\t')), ...marked].join('\n')}\n`);
}

/** One visit: seconds and bytes. */
async function measure(name, port, address, kbps, inPage, run) {
  const link = new Link(kbps, roundTripOf(kbps), port);
  const url = `http://127.0.0.1:${await link.listen()}${address}`;
  const base = options.waterfall === undefined ? undefined : path.join(options.waterfall, `${name.replace(/\W+/g, '-')}-${kbps}-${run}`);
  const patience = 60_000 + 1.5e7 / kbps;
  const marks = await visit(url, { chromium: options.chromium ?? 'chromium', patience, picture: base && `${base}.png` });
  link.close();
  if (base !== undefined) writeWaterfall(`${base}.txt`, link.exchanges, marks);
  for (const message of [marks.error, marks.trouble]) if (message !== undefined) console.error(`${name}: ${message}`);
  const seconds = (mark) => (mark === undefined ? NaN : (mark - marks.start) / 1000);
  return {
    poster: seconds(marks.poster), picture: seconds(marks.picture), fine: seconds(name === JSM ? marks.fine : marks.whole), whole: name === JSM ? seconds(marks.whole) : NaN,
    codeBefore: codeBytes(link.exchanges, marks.picture ?? Infinity, inPage), code: codeBytes(link.exchanges, Infinity, inPage),
  };
}

/** The best of several visits, figure by figure. */
function best(visits) {
  const least = (figure) => {
    const values = visits.map((v) => v[figure]).filter((x) => !Number.isNaN(x));
    return values.length === 0 ? NaN : Math.min(...values);
  };
  return Object.fromEntries(Object.keys(visits[0]).map((figure) => [figure, least(figure)]));
}

const model = open(files[0]);
const served = temporary('served');
fs.mkdirSync(served);
jsm('encode', '--quiet', model.ply, '-o', path.join(served, 'model.jsm'));
if (options.waterfall !== undefined) fs.mkdirSync(options.waterfall, { recursive: true });

const { child, port: jsmPort } = await serveJsm(served);
const servers = [];
try {
  const folder = `http://127.0.0.1:${jsmPort}/m/model/`;
  const manifest = await (await fetch(`${folder}manifest.json`)).json();
  // A server is warm: it has answered before.
  for (let i = 0; i < WARMING; i++) await (await fetch(folder)).arrayBuffer();
  const poster = Buffer.from(await (await fetch(new URL(manifest.posterUrl, folder))).arrayBuffer());
  const sites = [{ name: JSM, port: jsmPort, address: '/m/model/', inPage: poster.length }];
  for (const [name, content] of Object.entries(peers(model, poster))) {
    const server = await serve(content);
    servers.push(server);
    sites.push({ name, port: listening(server), address: '/', inPage: 0 });
  }
  const wanted = options.peers?.split(',') ?? sites.map(({ name }) => name);
  const rows = [];
  for (const kbps of rates) {
    await checkLink(kbps);
    for (const { name, port, address, inPage } of sites.filter((site) => wanted.includes(site.name))) {
      const visits = [];
      const runs = Number(options.runs ?? (kbps < FAST_KBPS ? 1 : RUNS_OF_FAST));
      for (let run = 0; run < runs; run++) visits.push(await measure(name, port, address, kbps, inPage, run));
      const { poster: first, picture, fine, whole, codeBefore, code } = best(visits);
      const seconds = (value) => (Number.isNaN(value) ? '–' : value.toFixed(2));
      rows.push([kbps, roundTripOf(kbps), name, seconds(first), seconds(picture), seconds(fine), seconds(whole), codeBefore, code]);
      console.error(rows.at(-1).join(' '));
    }
  }
  console.log(`${machine()}\n\n${model.name}, ${model.faces} faces, poster ${poster.length} bytes`);
  printTable(['kbit/s', 'round trip, ms', 'page', 'poster, s', 'first picture, s', 'all faces at 14 bits, s', 'original, s', 'code before the first picture, bytes', 'code, bytes'], rows);
} finally {
  child.kill();
  for (const server of servers) {
    server.close();
    server.closeAllConnections();
  }
}
