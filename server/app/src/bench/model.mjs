// @ts-check
// Bare models: jSM's archive of a model beside the arrays that the peers take.

import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const jar = path.resolve(here, '../../target/jsm.jar');
if (!fs.existsSync(jar)) throw new Error(`${jar} is missing: run mvn -q -DskipTests package first`);

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'jsm-bench-'));
process.on('exit', () => fs.rmSync(folder, { recursive: true, force: true }));

export const temporary = (name) => path.join(folder, name);

const java = (...args) => execFileSync('java', args, { maxBuffer: 1 << 28, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
export const jsm = (...args) => java('-jar', jar, ...args);
const bareMesh = (...args) => java('-cp', jar, path.join(here, 'BareMesh.java'), ...args);

/** Strips a model file of its attributes and encodes it, if wanted with its attributes, and with more arguments for the encoder. */
export function open(file, { encoding = [], withAttributes = false } = {}) {
  const name = path.basename(file);
  const ply = temporary(`${name}.ply`);
  const archive = temporary(`${name}.jsm`);
  bareMesh('strip', file, ply);
  jsm('encode', '--quiet', '--no-poster', ...encoding, withAttributes ? file : ply, '-o', archive);
  return { name, ply, archive, info: JSON.parse(jsm('info', '--json', archive)), ...readPly(ply) };
}

/** Another archive of an opened model: with more arguments for the encoder, or by the command of another build. */
export function encode(model, name, { encoding = [], command = jar } = {}) {
  const archive = temporary(`${model.name}.${name}.jsm`);
  java('-jar', command, 'encode', '--quiet', '--no-poster', ...encoding, model.ply, '-o', archive);
  return archive;
}

/** Faces of what is shown, mean and greatest distance to the original in % of the diagonal; see BareMesh.java for what can be shown. */
export function measure(model, shown) {
  const lines = bareMesh('distances', model.ply, ...shown).trim().split('\n');
  return lines.map((line) => {
    const [faces, mean, maximum] = line.split(' ').map(Number);
    return { faces, mean, maximum };
  });
}

/** Mean distances alone. */
export const distances = (model, shown) => measure(model, shown).map(({ mean }) => mean);

/** Positions and indices of a PLY file as BareMesh.java writes it. */
function readPly(file) {
  const bytes = fs.readFileSync(file);
  const start = bytes.indexOf('end_header\n') + 11;
  const header = bytes.toString('latin1', 0, start);
  const [vertices, faces] = ['vertex', 'face'].map((element) => Number(header.match(new RegExp(`element ${element} (\\d+)`))[1]));
  const positions = new Float32Array(bytes.buffer.slice(bytes.byteOffset + start, bytes.byteOffset + start + 12 * vertices));
  const indices = new Uint32Array(3 * faces);
  for (let f = 0; f < faces; f++) {
    for (let j = 0; j < 3; j++) indices[3 * f + j] = bytes.readUInt32LE(start + 12 * vertices + 13 * f + 1 + 4 * j);
  }
  return { positions, indices, vertices, faces };
}

export function writePly(file, positions, indices) {
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\nproperty float x\nproperty float y\nproperty float z\n`
    + `element face ${indices.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`;
  const faces = Buffer.alloc((13 * indices.length) / 3);
  indices.forEach((v, i) => faces.writeInt32LE(v, 13 * Math.floor(i / 3) + 1 + 4 * (i % 3)));
  for (let at = 0; at < faces.length; at += 13) faces[at] = 3;
  const coordinates = Buffer.from(positions.buffer, positions.byteOffset, positions.byteLength);
  fs.writeFileSync(file, Buffer.concat([Buffer.from(header), coordinates, faces]));
}

/** Where the archive is first complete in faces, with all positions known to at least so many bits: bytes up to there. */
export function bytesAtBits(model, bits) {
  const { batches, faces } = model.info;
  const batch = batches.find((b) => b.faces === faces && b.precisionBits >= bits);
  return batch.offset + batch.bytes;
}

export const geometricMean = (values) => Math.exp(values.reduce((sum, x) => sum + Math.log(x), 0) / values.length);

/** Prints rows of strings as a table in Markdown. */
export function printTable(heads, rows) {
  console.log(`\n| ${heads.join(' | ')} |`);
  console.log(`|${heads.map((_, i) => (i === 0 ? '---' : '---:')).join('|')}|`);
  for (const row of rows) console.log(`| ${row.join(' | ')} |`);
}

/** The machine, for the record. */
export function machine() {
  const cpus = os.cpus();
  return `${cpus.length} × ${cpus[0].model.trim()}, load ${os.loadavg()[0].toFixed(1)}, Node ${process.versions.node}, ${new Date().toISOString().slice(0, 10)}`;
}

/** The model files of the command line, and its options of the form --name=value. */
export function commandLine(usage) {
  const args = process.argv.slice(2);
  const options = Object.fromEntries(args.filter((a) => a.startsWith('--')).map((a) => a.slice(2).split('=')));
  const files = args.filter((a) => !a.startsWith('--'));
  if (files.length > 0) return { files, options };
  console.error(`usage: node ${usage}`);
  process.exit(2);
}
