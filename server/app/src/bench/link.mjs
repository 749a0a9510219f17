// @ts-check
// Rounds of `jsm fetch` from `jsm serve` over a link of the kernel: two network namespaces, and tc tbf between them. Needs root, ip, tc, curl and keytool.
//
// node server/app/src/bench/link.mjs [--kbps=64,256,1000,10000,100000] [--http=1,2] [--rounds=6] [--rest=0]

import { execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const jar = path.resolve(here, '../../target/jsm.jar');
const models = path.resolve(here, '../../../../models');
if (!fs.existsSync(jar)) throw new Error(`${jar} is missing: run mvn -q -DskipTests package first`);

const options = { kbps: '64,256,1000,10000,100000', http: '1,2', rounds: '6' };
for (const argument of process.argv.slice(2)) {
  const [, name, value] = /^--(\w+)=(.*)$/.exec(argument) ?? [];
  if (!(name in options)) throw new Error(`${argument}: only ${Object.keys(options).map((o) => `--${o}=`).join(', ')} are known`);
  options[name] = value;
}

const WAIT_SECONDS = 2;
const SERVER = 'jsm-server';
const CLIENT = 'jsm-client';
const ADDRESS = '10.231.77.1';
const PORT = 8443;
const PASSWORD = 'only-for-this-run';
/** What a packet carries of what the shaper counts: 1448 of 1514 bytes. */
const PAYLOAD = 1448 / 1514;

const run = (command, ...args) => execFileSync(command, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const quietly = (...command) => {
  try {
    run(...command);
  } catch {
    // it was not there
  }
};

function tidy() {
  quietly('ip', 'netns', 'delete', SERVER);
  quietly('ip', 'netns', 'delete', CLIENT);
}

function connect() {
  tidy();
  for (const name of [SERVER, CLIENT]) {
    run('ip', 'netns', 'add', name);
    run('ip', '-n', name, 'link', 'set', 'lo', 'up');
  }
  run('ip', 'link', 'add', 'jsm-s', 'netns', SERVER, 'type', 'veth', 'peer', 'name', 'jsm-c', 'netns', CLIENT);
  run('ip', '-n', SERVER, 'address', 'add', `${ADDRESS}/24`, 'dev', 'jsm-s');
  run('ip', '-n', CLIENT, 'address', 'add', '10.231.77.2/24', 'dev', 'jsm-c');
  run('ip', '-n', SERVER, 'link', 'set', 'jsm-s', 'up');
  run('ip', '-n', CLIENT, 'link', 'set', 'jsm-c', 'up');
}

/** A buffer of 200 ms, or 20 packets where that is less. */
function shape(kbps) {
  const burst = Math.max(3200, Math.round(kbps * 1.25));
  const limit = Math.max(30000, Math.round(kbps * 25)) + burst;
  run('tc', '-n', SERVER, 'qdisc', 'replace', 'dev', 'jsm-s', 'root', 'tbf', 'rate', `${kbps}kbit`, 'burst', String(burst), 'limit', String(limit));
}

const sentBytes = () => Number(run('ip', 'netns', 'exec', SERVER, 'cat', '/sys/class/net/jsm-s/statistics/tx_bytes'));

/** The amphora with a picture of noise, so that the archive is large and quickly decoded. */
function encode(folder) {
  const source = path.join(folder, 'source');
  fs.mkdirSync(source);
  for (const file of ['amphora.obj', 'amphora.mtl']) fs.copyFileSync(path.join(models, file), path.join(source, file));
  const picture = fs.openSync(path.join(source, 'amphora.png'), 'w');
  const most = Math.max(...options.kbps.split(',').map(Number));
  let seed = 1;
  const megabyte = Buffer.alloc(1 << 20);
  for (let i = 0; i < Math.ceil((most * 125 * WAIT_SECONDS * (Number(options.rounds) + 1)) / megabyte.length); i++) {
    for (let at = 0; at < megabyte.length; at += 4) megabyte.writeUInt32LE((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0), at);
    fs.writeSync(picture, megabyte);
  }
  fs.closeSync(picture);
  const served = path.join(folder, 'served');
  fs.mkdirSync(served);
  run('java', '-Xmx3g', '-jar', jar, 'encode', '--quiet', path.join(source, 'amphora.obj'), '-o', path.join(served, 'amphora.jsm'));
  return served;
}

function certify(folder) {
  const keys = path.join(folder, 'keys.p12');
  const trusted = path.join(folder, 'trusted.p12');
  const certificate = path.join(folder, 'certificate');
  const store = (file) => ['-keystore', file, '-storepass', PASSWORD, '-storetype', 'PKCS12', '-alias', 'jsm'];
  run('keytool', '-genkeypair', '-keyalg', 'EC', '-dname', 'CN=jsm', '-ext', `san=ip:${ADDRESS}`, ...store(keys));
  run('keytool', '-exportcert', '-file', certificate, ...store(keys));
  run('keytool', '-importcert', '-noprompt', '-file', certificate, ...store(trusted));
  return { keys, trusted };
}

async function serve(folder, keys, work) {
  const child = spawn(
    'ip',
    ['netns', 'exec', SERVER, 'java', '-Xmx512m', '-jar', jar, 'serve', folder, '--host', ADDRESS, '--port', String(PORT), '--tls-keystore', keys, '--cache', path.join(work, 'cache')],
    { env: { ...process.env, JSM_KEYSTORE_PASSWORD: PASSWORD }, stdio: ['ignore', 'pipe', 'inherit'] },
  );
  await new Promise((resolve, reject) => {
    child.stdout.once('data', resolve);
    child.once('exit', () => reject(new Error('the server did not start')));
  });
  return child;
}

const pause = (millis) => new Promise((resolve) => setTimeout(resolve, millis));

/** Where the archive is; asked before the link is slow. */
const archiveUrl = () =>
  new URL(
    JSON.parse(run('ip', 'netns', 'exec', CLIENT, 'curl', '-sSk', `https://${ADDRESS}:${PORT}/m/amphora/manifest.json`)).archiveUrl,
    `https://${ADDRESS}:${PORT}/m/amphora/manifest.json`,
  ).href;

async function measure(kbps, http, url, trusted, work) {
  shape(kbps);
  const trace = path.join(work, 'trace.json');
  const before = sentBytes();
  run(
    'ip', 'netns', 'exec', CLIENT, 'java', '-Xmx3g', `-Djavax.net.ssl.trustStore=${trusted}`, `-Djavax.net.ssl.trustStorePassword=${PASSWORD}`, '-jar', jar, 'fetch', '--quiet',
    url, '-o', path.join(work, 'out.ply'), '--rounds', options.rounds, '--wait', `${WAIT_SECONDS}s`, '--trace', trace,
    ...(http === '1' ? ['--http1'] : []),
  );
  await pause(3000); // what is still in the shaper's buffer is lost, too
  const { rounds, requests } = JSON.parse(fs.readFileSync(trace, 'utf8'));
  const expected = http === '2';
  if (requests.some((r) => r.bytes > 0 && r.http2 !== expected)) throw new Error('another version of HTTP was spoken');
  const ideal = kbps * 125 * WAIT_SECONDS * PAYLOAD;
  const detail = rounds.map((r) => r.bytes / ideal);
  const later = detail.slice(1);
  const received = requests.reduce((sum, r) => sum + r.bytes, 0);
  const waits = rounds.map((r) => r.waitMillis / 1000 / WAIT_SECONDS).sort((a, b) => a - b);
  // Large packets, which the shaper splits, have one head where the wire would have many.
  const beside = Math.max(0, (sentBytes() - before) * PAYLOAD - received);
  return {
    kbps,
    http: expected ? '2' : '1.1',
    median: waits[waits.length >> 1],
    most: waits.at(-1),
    first: detail[0],
    later: later.reduce((sum, d) => sum + d, 0) / later.length,
    least: Math.min(...later),
    beside: beside / received,
    requests: requests.length / rounds.length,
  };
}

const work = fs.mkdtempSync(path.join(os.tmpdir(), 'jsm-link-'));
let server = null;
try {
  const served = encode(work);
  const { keys, trusted } = certify(work);
  connect();
  server = await serve(served, keys, work);
  const url = archiveUrl();
  console.log('| kbit/s | HTTP | wait / T: median | most | detail in % of the link: first round | later: mean | least | sent beside it, % | requests per round |');
  console.log('|---:|---|---:|---:|---:|---:|---:|---:|---:|');
  for (const kbps of options.kbps.split(',').map(Number)) {
    for (const http of options.http.split(',')) {
      const r = await measure(kbps, http, url, trusted, work);
      const percent = (share) => (100 * share).toFixed(1);
      console.log(
        `| ${r.kbps} | ${r.http} | ${r.median.toFixed(3)} | ${r.most.toFixed(3)} | ${percent(r.first)} | ${percent(r.later)} | ${percent(r.least)} | ${percent(r.beside)} | ${r.requests.toFixed(1)} |`,
      );
    }
  }
} finally {
  if (server !== null) server.kill();
  tidy();
  fs.rmSync(work, { recursive: true, force: true });
}
