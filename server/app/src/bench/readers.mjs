// @ts-check
// Memory of 'jsm serve' with many readers that take nothing: node readers.mjs [--java=OPTIONS] [READERS...] (default 0 500 2000)

import { execFileSync, spawn } from 'node:child_process';
import { createHash, randomBytes } from 'node:crypto';
import fs from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const jar = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../target/jsm.jar');
if (!fs.existsSync(jar)) throw new Error(`${jar} is missing: run mvn -q -DskipTests package first`);
const java = process.argv.slice(2).filter((arg) => arg.startsWith('--java=')).flatMap((arg) => arg.slice(7).split(' '));
const counts = process.argv.slice(2).filter((arg) => /^\d+$/.test(arg)).map(Number);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'jsm-readers-'));
const children = [];
process.on('exit', () => {
  for (const child of children) child.kill();
  fs.rmSync(folder, { recursive: true, force: true });
});

// A tetrahedron with a picture of noise, larger than what the kernel takes for a reader.
fs.writeFileSync(path.join(folder, 'large.obj'), 'mtllib large.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n'
  + 'f 1/1 2/2 3/3\nf 1/1 4/2 2/3\nf 2/1 4/2 3/3\nf 1/1 3/2 4/3\n');
fs.writeFileSync(path.join(folder, 'large.mtl'), 'newmtl a\nmap_Kd large.png\n');
fs.writeFileSync(path.join(folder, 'large.png'), Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), randomBytes(16_000_000)]));
const archive = path.join(folder, 'large.jsm');
execFileSync('java', ['-jar', jar, 'encode', '--quiet', path.join(folder, 'large.obj'), '-o', archive]);
const sha256 = createHash('sha256').update(fs.readFileSync(archive)).digest('hex');

const server = spawn('java', [...java, '-jar', jar, 'serve', archive, '--port', '0', '--management-port', '0', '--max-connections-per-address', '100000',
  '--max-requests-per-address', '100000'], { stdio: ['ignore', 'pipe', 'pipe'] });
children.push(server);
const [port, management] = await Promise.all([
  said(server.stdout, /:(\d+)\//),
  said(server.stderr, /metrics at port (\d+)/),
]);

/** The number that a process prints. */
function said(stream, pattern) {
  return new Promise((resolve, reject) => {
    let text = '';
    stream.on('data', (part) => {
      text += part;
      const match = pattern.exec(text);
      if (match) resolve(Number(match[1]));
    });
    stream.on('end', () => reject(new Error(`the server ended: ${text}`)));
  });
}

async function metrics() {
  const text = await (await fetch(`http://127.0.0.1:${management}/metrics`)).text();
  const sum = (name, label = '') => text.split('\n').filter((line) => line.startsWith(name) && line.includes(label))
    .reduce((total, line) => total + Number(line.split(' ').at(-1)), 0);
  return {
    running: sum('jsm_requests_running '),
    heap: sum('jvm_memory_used_bytes', 'area="heap"'),
    direct: sum('jvm_buffer_memory_used_bytes', 'id="direct"'),
    threads: sum('jvm_threads_live_threads '),
  };
}

function residentBytes() {
  // Without the pages of mapped files, which belong to the page cache.
  return Number(/RssAnon:\s+(\d+) kB/.exec(fs.readFileSync(`/proc/${server.pid}/status`, 'utf8'))[1]) * 1024;
}

const sockets = [];
async function reader() {
  const socket = new net.Socket();
  sockets.push(socket);
  socket.on('error', () => {});
  await new Promise((resolve) => socket.connect({ port, host: '127.0.0.1' }, () => resolve(undefined)));
  socket.pause();
  socket.write(`GET /m/large/${sha256}.jsm HTTP/1.1\r\nHost: h\r\n\r\n`);
}

const megabytes = (bytes) => (bytes / 1e6).toFixed(1);
console.log('| readers | requests running | heap that lives, MB | direct memory, MB | anonymous memory of the process, MB | threads |\n|---:|---:|---:|---:|---:|---:|');
for (const count of counts.length ? counts : [0, 500, 2000]) {
  while (sockets.length < count) await reader();
  for (let i = 0; i < 100 && (await metrics()).running < count; i++) await new Promise((resolve) => setTimeout(resolve, 100));
  await new Promise((resolve) => setTimeout(resolve, 3000));
  for (let i = 0; i < 2; i++) execFileSync('jcmd', [String(server.pid), 'GC.run'], { stdio: 'ignore' });
  const now = await metrics();
  console.log(`| ${count} | ${now.running} | ${megabytes(now.heap)} | ${megabytes(now.direct)} | ${megabytes(residentBytes())} | ${now.threads} |`);
}
process.exit(0);
