// @ts-check
// Bytes and speed of jSM beside its lossless peers, on models with all their attributes but without images, which are the same in all.

import fs from 'node:fs';
import path from 'node:path';
import { commandLine, geometricMean, jsm, machine, printTable, temporary } from './model.mjs';
import { encodeMeshoptAttributes, zstd } from './codecs.mjs';
import { gltfpack, GLTFPACK_MODES } from './gltfpack.mjs';
import { parts, readGlb, triangles, withoutImages, writeGlb } from './glb.mjs';

const { files } = commandLine('attributes.mjs MODEL...');
const rows = [];
const speeds = [];
const ratios = { meshopt: [], gltfpack: [] };

for (const file of files) {
  const name = path.basename(file);
  const original = convert(file, name);
  const archive = temporary(`${name}.jsm`);
  jsm('encode', '--quiet', '--no-poster', temporary(`${name}.bare.glb`), '-o', archive);
  const info = JSON.parse(jsm('info', '--json', archive));
  const meshopt = encodeMeshoptAttributes(parts(original));
  const packed = pack(name, original);
  const bits = (bytes, count) => ((8 * bytes) / count).toFixed(1);
  const ratio = (bytes) => (bytes === undefined ? '' : (info.bytes / bytes).toFixed(3));
  rows.push([
    name, attributes(info), info.faces, info.vertices, info.wedges,
    info.bytes, bits(info.bytes, info.vertices), bits(info.bytes, info.wedges),
    meshopt, bits(meshopt, info.vertices), ratio(meshopt),
    packed?.bytes ?? '', packed ? bits(packed.bytes, info.vertices) : '', packed?.mode ?? '', ratio(packed?.bytes),
  ]);
  ratios.meshopt.push(info.bytes / meshopt);
  if (packed) ratios.gltfpack.push(info.bytes / packed.bytes);
  const bench = JSON.parse(jsm('bench', '--json', '--quiet', temporary(`${name}.bare.glb`)));
  speeds.push([name, ...['decode', 'coding', 'encode'].map((what) => (bench[`${what}FacesPerSecond`] / 1e6).toFixed(2))]);
  console.error(`${name} done`);
}

const mean = (values) => (values.length > 0 ? geometricMean(values).toFixed(3) : '');
rows.push(['geometric mean', ...Array(9).fill(''), mean(ratios.meshopt), '', '', '', mean(ratios.gltfpack)]);
console.log(`${machine()}\n\nBytes of models with attributes, without images; bpv = bits per vertex, bpw = per wedge`);
printTable(
  ['model', 'attributes', 'faces', 'vertices', 'wedges', 'jSM', 'bpv', 'bpw', 'meshopt + zstd-19', 'bpv', 'ratio', 'gltfpack -noq + zstd-19', 'bpv', 'smallest by', 'ratio'],
  rows,
);
console.log('\nMillion faces/s of CPU time, with attributes');
printTable(['model', 'jSM decode', 'jSM coding', 'jSM encode'], speeds);

/** The model as GLB without images, as jSM gives it back; also left in a file. */
function convert(file, name) {
  const whole = temporary(`${name}.whole`);
  jsm('encode', '--quiet', '--no-poster', file, '-o', `${whole}.jsm`);
  jsm('decode', '--quiet', `${whole}.jsm`, '-o', `${whole}.glb`);
  const bare = withoutImages(readGlb(`${whole}.glb`));
  writeGlb(temporary(`${name}.bare.glb`), bare);
  return bare;
}

/** The smallest of gltfpack's files that hold the very same triangles, normals aside, which it makes unit vectors anew; undefined when there is none. */
function pack(name, original) {
  const [wanted, withoutNormals] = [[], ['NORMAL']].map((except) => triangles(original, except).join('\n'));
  let best;
  for (const mode of GLTFPACK_MODES) {
    const out = temporary(`${name}.packed.glb`);
    if (!gltfpack(temporary(`${name}.bare.glb`), out, mode)) return undefined;
    const bytes = zstd(fs.readFileSync(out)).length;
    const got = readGlb(out);
    const isExact = triangles(got).join('\n') === wanted;
    if (!isExact && triangles(got, ['NORMAL']).join('\n') !== withoutNormals) console.error(`${name}: gltfpack -noq ${mode} changes more than normals, and does not count`);
    else if (best === undefined || bytes < best.bytes) best = { bytes, mode: `${mode === '' ? '-noq' : mode}${isExact ? '' : ', other normals'}` };
  }
  return best;
}

function attributes({ channels, materials }) {
  const names = channels.map((c) => ({ texcoord: 'UV', normal: 'normals', colour: 'colours' })[c.semantic] ?? c.name);
  return [...names, ...(materials > 1 ? ['materials'] : [])].join(', ');
}
