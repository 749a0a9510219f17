// @ts-check
// Levels of detail: the error of jSM's beside those of meshoptimizer's simplifiers and of MeshLab's quadric edge collapse, at the number of faces that jSM's level has.

import path from 'node:path';
import { commandLine, geometricMean, jsm, machine, measure, open, printTable, temporary, writePly } from './model.mjs';
import { meshlab } from './meshlab.mjs';
import { simplify, simplifyInSteps, simplifyToCount } from './simplifiers.mjs';

const PERCENTS = [50, 10, 5, 2, 1];
/** What is further from jSM's number of faces is marked. */
const NOTED = 0.03;
/** And from here on does not count. */
const NOT_COUNTED = 0.1;
const PEERS = ['meshoptimizer', 'meshoptimizer, vertices moved', 'MeshLab'];

const { files, options } = commandLine('lod.mjs [--quality=NAME] [--attributes] [--python=python3] MODEL...');
const encoding = 'quality' in options ? ['--quality', options.quality] : [];
const rows = [];
/** Ratios per level and peer. */
const ratios = PERCENTS.map(() => PEERS.map(() => []));

for (const file of files) {
  const model = open(file, { encoding, withAttributes: 'attributes' in options });
  const ours = PERCENTS.map((percent) => level(model, percent));
  const targets = ours.map(({ faces }) => faces);
  const shown = [
    ours.map(({ ply }) => ply),
    ...[simplify, simplifyInSteps].map((simplifier) => targets.map((faces) => meshoptimizer(simplifier, model, faces))),
    meshlab(model, targets, options.python ?? 'python3'),
  ];
  const found = measure(model, shown.flat().filter((ply) => ply !== undefined));
  const measured = shown.map((plys) => plys.map((ply) => (ply === undefined ? undefined : found.shift())));
  PERCENTS.forEach((percent, i) => {
    const [our, ...theirs] = measured.map((all) => all[i]);
    const compared = theirs.map((their) => compare(our, their, targets[i]));
    compared.forEach((one, p) => {
      if (one?.counts) ratios[i][p].push({ name: model.name, ...one });
    });
    rows.push([
      i === 0 ? model.name : '', `${percent}%`, targets[i], ...theirs.map((their) => count(their, targets[i])),
      our.mean.toFixed(5), ...errors('mean', theirs, compared), our.maximum.toFixed(3), ...errors('maximum', theirs, compared),
    ]);
  });
  console.error(`${model.name} done`);
}

const how = [options.quality && `--quality ${options.quality}`, 'attributes' in options ? 'jSM with attributes' : 'without attributes'].filter(Boolean).join(', ');
console.log(`${machine()}\n\nErrors in % of the diagonal, ${how}. (n): another number of faces, when it is more than ${100 * NOTED}% off; it does not count in the means from ${100 * NOT_COUNTED}% on`);
const beside = (what) => [`${what} jSM`, ...PEERS.flatMap((peer) => [peer, 'ratio'])];
printTable(['model', 'level', 'faces', ...PEERS, ...beside('mean'), ...beside('max')], rows);
console.log('\nAll models: jSM / peer, geometric mean and worst');
printTable(
  ['level', ...PEERS.flatMap((peer) => [`models beside ${peer}`, 'mean error', 'worst', 'max error', 'worst'])],
  PERCENTS.map((percent, i) => [`${percent}%`, ...ratios[i].flatMap((all) => [all.length, ...summary(all, 'mean'), ...summary(all, 'maximum')])]),
);

/** What a visitor sees of an archive at a share of the faces: a file, and its faces. */
function level(model, percent) {
  const ply = temporary(`${model.name}.${percent}.ply`);
  const said = jsm('decode', model.archive, '--faces', String(Math.round((model.faces * percent) / 100)), '-o', ply);
  return { ply, faces: Number(said.match(/: (\d+) faces, /)[1]) };
}

function meshoptimizer(simplifier, model, faces) {
  const { positions, indices } = simplifyToCount(simplifier, model, faces);
  if (indices.length === 0) return undefined;
  const ply = temporary(`${model.name}.${simplifier.name}.${faces}.ply`);
  writePly(ply, positions, indices);
  return ply;
}

function compare(our, their, faces) {
  if (their === undefined) return undefined;
  return { mean: our.mean / their.mean, maximum: our.maximum / their.maximum, counts: miss(their, faces) < NOT_COUNTED };
}

function miss(their, faces) {
  return Math.abs(their.faces / faces - 1);
}

function count(their, faces) {
  if (their === undefined) return '';
  return miss(their, faces) > NOTED ? `(${their.faces})` : their.faces;
}

function errors(what, theirs, compared) {
  const digits = what === 'mean' ? 5 : 3;
  return theirs.flatMap((their, p) => (their === undefined ? ['', ''] : [their[what].toFixed(digits), ratio(compared[p], what)]));
}

function ratio(compared, what) {
  const text = compared[what].toFixed(2);
  return compared.counts ? text : `(${text})`;
}

function summary(all, what) {
  const sound = all.filter((r) => Number.isFinite(r[what]) && r[what] > 0);
  if (sound.length === 0) return ['', ''];
  const worst = sound.reduce((a, b) => (b[what] > a[what] ? b : a));
  return [geometricMean(sound.map((r) => r[what])).toFixed(3), `${worst[what].toFixed(2)} ${path.parse(worst.name).name}`];
}
