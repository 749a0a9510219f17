// @ts-check
// Bytes and decoding speed of jSM beside its peers, on models stripped of their attributes.

import { bytesAtBits, commandLine, geometricMean, jsm, machine, open, printTable } from './model.mjs';
import { dracoDecodeSeconds, encodeDraco, encodeMeshopt, meshoptDecodeSeconds } from './codecs.mjs';
import { encodeDracoLattice } from './lattice.mjs';
import { pcodecBytes } from './pcodec.mjs';

const BITS = 14;
const { files, options } = commandLine('peers.mjs [--python=python3] [--sizes] MODEL...');
const sizes = [];
const lossless = [];
const speeds = [];
const ratios = { lossless: [], best: [], stage: [] };

for (const file of files) {
  const model = open(file);
  const meshopt = encodeMeshopt(model);
  const draco = encodeDraco(model.positions, model.indices, BITS);
  const staged = bytesAtBits(model, BITS);
  ratios.lossless.push(model.info.bytes / meshopt.bytes);
  ratios.stage.push(staged / draco.length);
  const perVertex = (bytes) => ((8 * bytes) / model.vertices).toFixed(2);
  sizes.push([
    model.name, model.faces, model.vertices,
    model.info.bytes, perVertex(model.info.bytes), meshopt.bytes, (model.info.bytes / meshopt.bytes).toFixed(3),
    staged, perVertex(staged), draco.length, (staged / draco.length).toFixed(3),
  ]);
  lossless.push([model.name, model.info.bytes, ...besides(model, meshopt.bytes)]);
  console.error(`${model.name} done`);
  if ('sizes' in options) continue;
  const bench = JSON.parse(jsm('bench', '--json', '--quiet', model.ply));
  const million = (facesPerSecond) => (facesPerSecond / 1e6).toFixed(2);
  speeds.push([
    model.name,
    million(bench.decodeFacesPerSecond),
    million(bench.codingFacesPerSecond),
    million(bench.encodeFacesPerSecond),
    million(model.faces / dracoDecodeSeconds(draco)),
    million(model.faces / meshoptDecodeSeconds(meshopt)),
  ]);
}

/** What the lossless peers need, and the best of them. */
function besides(model, meshopt) {
  const lattice = encodeDracoLattice(model);
  const pcodec = pcodecBytes(model, options.python ?? 'python3');
  const best = Math.min(meshopt, lattice?.bytes ?? Infinity, pcodec ?? Infinity);
  ratios.best.push(model.info.bytes / best);
  return [meshopt, lattice?.bytes ?? 'none', lattice?.name ?? '', pcodec ?? '', (model.info.bytes / best).toFixed(3)];
}

const mean = (values) => geometricMean(values).toFixed(3);
sizes.push(['geometric mean', '', '', '', '', '', mean(ratios.lossless), '', '', '', mean(ratios.stage)]);
console.log(`${machine()}\n\nBytes; bpv = bits per vertex`);
printTable(
  ['model', 'faces', 'vertices', 'jSM lossless', 'bpv', 'meshopt + zstd-19', 'ratio', `jSM, all faces at ≥ ${BITS} bits`, 'bpv', `Draco ${BITS} bits`, 'ratio'],
  sizes,
);
lossless.push(['geometric mean', '', '', '', '', '', mean(ratios.best)]);
console.log('\nLossless: bytes of the peers');
printTable(['model', 'jSM', 'meshopt + zstd-19', 'Draco, integers of a lattice', 'the lattice', 'pcodec + meshopt, zstd-19', 'jSM / best'], lossless);
if (!('sizes' in options)) {
  console.log('\nMillion faces/s of CPU time');
  printTable(['model', 'jSM decode', 'jSM coding', 'jSM encode', 'Draco decode (Wasm)', 'meshopt decode (Wasm)'], speeds);
}
