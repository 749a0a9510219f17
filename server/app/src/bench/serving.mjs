// @ts-check
// Requests per second and CPU time per request of 'jsm serve' beside nginx: the same archive, the same ranges, on loopback, in turns.
// node serving.mjs [--rounds=N] [--seconds=N] [--connections=N] [--java=OPTIONS] [--serve=OPTIONS] [ARCHIVE]

import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const jar = path.resolve(here, '../../target/jsm.jar');
for (const command of ['wrk', 'nginx']) {
  if (spawnSync(command, ['-v']).error) throw new Error(`${command} is missing: install it first`);
}
if (!fs.existsSync(jar)) throw new Error(`${jar} is missing: run mvn -q -DskipTests package first`);
const TICKS_PER_SECOND = Number(execFileSync('getconf', ['CLK_TCK'], { encoding: 'utf8' }));
const SIZES = [20_000, 1_000_000];

const options = { rounds: 5, seconds: 5, connections: 32, java: '', serve: '' };
const files = [];
for (const arg of process.argv.slice(2)) {
  const option = /^--(\w+)=(.*)$/.exec(arg);
  if (option && option[1] in options) options[option[1]] = option[2];
  else files.push(arg);
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'jsm-serving-'));
fs.chmodSync(folder, 0o755); // nginx started by root gives its rights up
const children = [];
process.on('exit', () => {
  for (const child of children) child.kill();
  fs.rmSync(folder, { recursive: true, force: true });
});

const archive = path.join(folder, 'models', 'model.jsm');
fs.mkdirSync(path.dirname(archive));
if (files.length > 0) fs.copyFileSync(files[0], archive);
else {
  const ply = path.join(folder, 'sphere.ply');
  execFileSync('node', [path.join(here, 'sphere.mjs'), '300', ply], { stdio: 'ignore' });
  execFileSync('java', ['-jar', jar, 'encode', '--quiet', ply, '-o', archive]);
}
const bytes = fs.readFileSync(archive);
const sha256 = createHash('sha256').update(bytes).digest('hex');
const target = `m/model/${sha256}.jsm`;
if (bytes.length < SIZES.at(-1)) throw new Error(`${archive} has only ${bytes.length} bytes`);

/** A port that is free now. */
function freePort() {
  return new Promise((resolve) => {
    const server = net.createServer().listen(0, '127.0.0.1', () => {
      const { port } = /** @type {net.AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });
}

async function startNginx() {
  const port = await freePort();
  const root = path.join(folder, 'nginx');
  fs.mkdirSync(path.join(root, 'm', 'model'), { recursive: true });
  fs.copyFileSync(archive, path.join(root, target));
  fs.writeFileSync(path.join(root, 'nginx.conf'), `
daemon off; pid ${root}/pid; error_log ${root}/error.log; worker_processes auto;
events { worker_connections 4096; }
http {
  access_log off; sendfile on; tcp_nopush on; keepalive_requests 1000000000; server_tokens off;
  types { model/vnd.jsm jsm; }
  client_body_temp_path ${root}/a; proxy_temp_path ${root}/b; fastcgi_temp_path ${root}/c; uwsgi_temp_path ${root}/d; scgi_temp_path ${root}/e;
  server { listen 127.0.0.1:${port} backlog=4096; root ${root}; add_header Cache-Control "public, max-age=31536000, immutable, no-transform"; }
}`);
  const child = spawn('nginx', ['-p', root, '-c', path.join(root, 'nginx.conf'), '-e', path.join(root, 'error.log')], { stdio: 'inherit' });
  children.push(child);
  return { name: 'nginx', pid: child.pid, root: `http://127.0.0.1:${port}/` };
}

// One address asks for everything here.
const UNLIMITED = ['--max-request-rate', '1000000', '--request-burst', '1000000'];

async function startJsm() {
  const port = await freePort();
  const words = (text) => text.split(' ').filter(Boolean);
  const child = spawn('java', [...words(options.java), '-jar', jar, 'serve', path.dirname(archive), '--port', String(port), ...UNLIMITED, ...words(options.serve)],
    { stdio: ['ignore', 'ignore', 'inherit'] });
  children.push(child);
  return { name: 'jsm', pid: child.pid, root: `http://127.0.0.1:${port}/` };
}

async function awaitAnswer(server) {
  for (let i = 0; i < 200; i++) {
    try {
      const answer = await fetch(server.root + target);
      const body = Buffer.from(await answer.arrayBuffer());
      if (answer.status === 503) throw new TypeError('it is being opened');
      if (!body.equals(bytes)) throw new Error(`${server.name} does not send the archive: ${answer.status} ${body.length}`);
      return;
    } catch (error) {
      if (!(error instanceof TypeError)) throw error;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
  throw new Error(`${server.name} does not answer`);
}

/** CPU seconds, user and system, of a process and its children that live. */
function cpuSeconds(pid) {
  let ticks = 0;
  const pids = [pid, ...fs.readFileSync(`/proc/${pid}/task/${pid}/children`, 'utf8').split(' ').filter(Boolean)];
  for (const each of pids) {
    const fields = fs.readFileSync(`/proc/${each}/stat`, 'latin1').replace(/^.*\) /s, '').split(' ');
    ticks += Number(fields[11]) + Number(fields[12]);
  }
  return ticks / TICKS_PER_SECOND;
}

function load(server, size, seconds) {
  const before = cpuSeconds(server.pid);
  const out = execFileSync('wrk', ['-t1', `-c${options.connections}`, `-d${seconds}s`, '-H', `Range: bytes=0-${size - 1}`, server.root + target], { encoding: 'utf8' });
  const cpu = cpuSeconds(server.pid) - before;
  const requests = Number(/(\d+) requests in/.exec(out)[1]);
  const spent = Number(/requests in ([\d.]+)s/.exec(out)[1]);
  if (/Non-2xx|Socket errors/.test(out)) throw new Error(`${server.name}: ${out}`);
  return { rate: requests / spent, cpuMicros: (cpu / requests) * 1e6 };
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const servers = [await startNginx(), await startJsm()];
for (const server of servers) await awaitAnswer(server);
console.log(`${os.cpus().length} × ${os.cpus()[0].model}, Node ${process.version}, ${options.rounds} rounds of ${options.seconds} s, ${options.connections} connections`);
console.log('| bytes | round | nginx req/s | jsm req/s | ratio | nginx CPU µs | jsm CPU µs | ratio |\n|---:|---:|---:|---:|---:|---:|---:|---:|');
for (const size of SIZES) {
  load(servers[1], size, Math.max(8, options.seconds)); // the JVM compiles meanwhile
  const rows = [];
  for (let round = 1; round <= options.rounds; round++) {
    const [nginx, jsm] = servers.map((server) => load(server, size, options.seconds));
    rows.push([nginx.rate, jsm.rate, jsm.rate / nginx.rate, nginx.cpuMicros, jsm.cpuMicros, jsm.cpuMicros / nginx.cpuMicros]);
    print(size, round, rows.at(-1));
  }
  print(size, 'median', rows[0].map((_, column) => median(rows.map((row) => row[column]))));
}
process.exit(0);

/**
 * @param {number} size
 * @param {number | string} round
 * @param {number[]} row
 */
function print(size, round, [a, b, c, d, e, f]) {
  console.log(`| ${size} | ${round} | ${a.toFixed(0)} | ${b.toFixed(0)} | ${c.toFixed(2)} | ${d.toFixed(1)} | ${e.toFixed(1)} | ${f.toFixed(2)} |`);
}
