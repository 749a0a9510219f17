// @ts-check
// How long a visitor of a site of many models waits for the first cards, and for what he or she searches, over a slow link.
// node catalogue.mjs [--models=N] [--kbps=N] [--trip=MS] [--runs=N] [--chromium=PATH] [--picture=FOLDER] [--site=FOLDER]

import { execFileSync, spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { ARGUMENTS, Devtools } from './first-browser.mjs';
import { Link } from './first-link.mjs';
import { temporary } from './model.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const jar = path.resolve(here, '../../target/jsm.jar');
const MODEL = path.resolve(here, '../../../../models/planetary-gear.obj');
const NOUNS = ['amphora', 'basket', 'chair', 'dagger', 'emblem', 'figurine', 'goblet', 'helmet', 'inkwell', 'jug', 'kettle', 'lamp', 'mask', 'needle', 'ornament', 'plate', 'quiver', 'relief', 'statue', 'tablet', 'urn', 'vase', 'weight'];
/** As CatalogueWriter has them. */
const PAGE = 1000;
const FIRST = 100;
const SEARCHES = ['helmet-0123', 'v', 'kettle-02'];
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.svg': 'image/svg+xml', '.jpg': 'image/jpeg', '.wasm': 'application/wasm' };
/** Marks when cards are on the screen; runs in the page before all else. */
const OBSERVER = `window.shown = (text) => new Promise((resolve) => {
  const begin = performance.now();
  const look = () => {
    const names = [...document.querySelectorAll('.card strong')];
    const there = names.length > 0 && names.every((name) => name.textContent.startsWith(text));
    requestAnimationFrame(there || performance.now() - begin > 20000 ? () => resolve(there ? performance.now() : NaN) : look);
  };
  look();
});
window.first = window.shown('');`;

const options = { models: '1000000', kbps: '10000', trip: '40', runs: '5', chromium: 'chromium', picture: '', site: '' };
for (const arg of process.argv.slice(2)) {
  const option = /^--(\w+)=(.*)$/.exec(arg);
  if (!option || !(option[1] in options)) throw new Error(`${arg}: no such option`);
  options[option[1]] = option[2];
}

/** A site of one model, under a catalogue that lists it under many names. */
function makeSite(folder, count) {
  execFileSync('java', ['-jar', jar, 'encode', '--quiet', MODEL, '--site', folder], { stdio: ['ignore', 'ignore', 'inherit'] });
  const models = path.join(folder, 'm');
  const [real] = JSON.parse(fs.readFileSync(path.join(models, 'index.json'), 'utf8')).models;
  const each = Math.ceil(count / NOUNS.length);
  const row = (i) => {
    const name = `${NOUNS[Math.floor(i / each)]}-${String(i % each).padStart(6, '0')}`;
    const hash = createHash('sha256').update(name).digest('hex');
    return { ...real, id: name, name, manifestUrl: `${name}/manifest.json`, archiveUrl: `${name}/${hash}.jsm`, archiveSha256: hash, meshSha256: hash };
  };
  const pages = [];
  const first = Array.from({ length: Math.min(FIRST, count) }, (_, i) => row(i));
  for (let start = first.length; start < count; start += PAGE) {
    const rows = Array.from({ length: Math.min(PAGE, count - start) }, (_, i) => row(start + i));
    const json = JSON.stringify({ models: rows });
    const file = `page-${createHash('sha256').update(json).digest('hex').slice(0, 16)}.json`;
    fs.writeFileSync(path.join(models, file), json);
    pages.push([rows[0].id, rows.length, file]);
  }
  const next = pages.length > 0 ? { next: pages[0][2], pages } : {};
  fs.writeFileSync(path.join(models, 'index.json'), JSON.stringify({ total: count, ...next, models: first }));
}

/** A host that sends files as they are, as buckets do. */
function plainHost(folder) {
  const server = http.createServer((request, response) => {
    const name = path.join(folder, path.normalize(decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname)).replace(/\/$/, '/index.html'));
    fs.readFile(name, (error, bytes) => {
      response.writeHead(error ? 404 : 200, { 'Content-Type': TYPES[path.extname(name)] ?? 'application/octet-stream' });
      response.end(error ? '' : bytes);
    });
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve({ port: /** @type {import('node:net').AddressInfo} */ (server.address()).port, close: () => server.close() })));
}

/** `jsm serve` of the folder. */
function jsmHost(folder) {
  const child = spawn('java', ['-Xmx512m', '-jar', jar, 'serve', folder, '--port', '0', '--quiet'], { stdio: ['ignore', 'pipe', 'inherit'] });
  return new Promise((resolve) => {
    child.stdout.once('data', (line) => resolve({ port: Number(new URL(String(line).trim()).port), close: () => child.kill() }));
  });
}

/** One visit by a browser that has never been anywhere. @returns {Promise<Record<string, number>>} */
async function visit(port, picture) {
  const profile = temporary(`profile-${process.hrtime.bigint()}`);
  const child = spawn(options.chromium, [...ARGUMENTS, `--user-data-dir=${profile}`], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.once('close', resolve));
  const devtools = new Devtools(child);
  try {
    const { targetId } = await devtools.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await devtools.send('Target.attachToTarget', { targetId, flatten: true });
    const ask = (method, params = {}) => devtools.send(method, params, sessionId);
    const evaluate = async (expression) => (await ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true })).result.value;
    const shoot = async (name) => {
      if (picture === '') return;
      await new Promise((resolve) => setTimeout(resolve, 1500));
      fs.writeFileSync(path.join(picture, `${name}.png`), Buffer.from((await ask('Page.captureScreenshot')).data, 'base64'));
    };
    await ask('Page.enable');
    await ask('Page.addScriptToEvaluateOnNewDocument', { source: OBSERVER });
    await ask('Page.navigate', { url: `http://127.0.0.1:${port}/` });
    await new Promise((resolve) => setTimeout(resolve, 300));
    const times = { first: await evaluate('window.first') };
    await shoot('first');
    for (const text of SEARCHES) {
      const type = `(async () => { const box = document.querySelector('.browse input'); box.value = ${JSON.stringify(text)}; const at = performance.now();
        box.dispatchEvent(new Event('input')); return (await shown(box.value)) - at; })()`;
      times[text] = await evaluate(type);
      await shoot(text);
    }
    await evaluate("document.querySelector('.browse input').value = ''; document.querySelector('.browse input').dispatchEvent(new Event('input'))");
    await new Promise((resolve) => setTimeout(resolve, 500));
    times['a place in the middle'] = await evaluate(`(async () => { const at = performance.now(); scrollTo(0, document.documentElement.scrollHeight / 2);
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      while ([...document.querySelectorAll('.cards li')].some((item) => !item.querySelector('strong'))) await new Promise(requestAnimationFrame);
      return performance.now() - at; })()`);
    await shoot('middle');
    return times;
  } finally {
    devtools.send('Browser.close').catch(() => child.kill());
    await ended;
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  }
}

const site = options.site || temporary('site');
if (!fs.existsSync(path.join(site, 'm', 'index.json'))) makeSite(site, Number(options.models));
const { total } = JSON.parse(fs.readFileSync(path.join(site, 'm', 'index.json'), 'utf8'));
console.log(`${total} models, ${options.kbps} kbit/s, ${options.trip} ms; milliseconds, least and median of ${options.runs} visits\n`);
console.log(`| | first cards | ${SEARCHES.join(' | ')} | a place in the middle | bytes until the first cards |\n|---|${'--:|'.repeat(SEARCHES.length + 3)}`);
for (const [name, open] of Object.entries({ 'jsm serve': jsmHost, 'files as they are': plainHost })) {
  const host = await open(site);
  /** @type {Record<string, number>[]} */
  const visits = [];
  for (let run = 0; run < Number(options.runs); run++) {
    const link = new Link(Number(options.kbps), Number(options.trip), host.port);
    const times = await visit(await link.listen(), run === 0 && name === 'jsm serve' ? options.picture : '');
    times.bytes = link.exchanges.filter(({ path: asked }) => !/poster|page-/.test(asked)).reduce((sum, { bytes }) => sum + bytes, 0);
    visits.push(times);
    link.close();
  }
  host.close();
  const cells = Object.keys(visits[0]).map((key) => {
    const sorted = visits.map((times) => Math.round(times[key])).sort((a, b) => a - b);
    return key === 'bytes' ? sorted[0] : `${sorted[0]}, ${sorted[sorted.length >> 1]}`;
  });
  console.log(`| ${name} | ${cells.join(' | ')} |`);
}
process.exit();
