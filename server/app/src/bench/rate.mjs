// @ts-check
// Rate and distortion: the error of what jSM shows after B bytes, beside the best single Draco file that fits in B bytes, of meshes by either of meshoptimizer's simplifiers.

import { bytesAtBits, commandLine, distances, geometricMean, machine, open, printTable, temporary, writePly } from './model.mjs';
import { decodeDraco, encodeDraco } from './codecs.mjs';
import { simplify, simplifyInSteps } from './simplifiers.mjs';

const PERCENTS = [1, 2, 5, 10, 25, 50, 100];
const JUDGED_UP_TO = 50;
const MOST_BITS = 14;
/** No precision below this is of use to a file of more than a quarter of the bytes. */
const LEAST_BITS_OF_LARGE = 10;
const SEARCH_STEPS = 10;
const CLOSE_ENOUGH = 1.01;

/** Draco files of a simplified model. */
class Peer {
  #model;
  #simplifier;
  #simplified;

  constructor(model, simplifier) {
    this.#model = model;
    this.#simplifier = simplifier;
    this.#simplified = new Map([[model.faces, model]]);
  }

  file(faces, bits) {
    if (!this.#simplified.has(faces)) this.#simplified.set(faces, this.#simplifier(this.#model, faces));
    const { positions, indices } = this.#simplified.get(faces);
    return { faces: indices.length / 3, bits, bytes: encodeDraco(positions, indices, bits) };
  }

  /** For every precision the file with the most faces that fits, written as PLY. */
  fitting(bytes, percent) {
    const bits = precisions.filter((b) => percent < 25 || b >= LEAST_BITS_OF_LARGE);
    const files = bits.map((b) => this.#largest(bytes, b)).filter((file) => file !== null);
    return files.map((file) => {
      const ply = temporary(`${this.#simplifier.name}-${bytes}-${file.bits}.ply`);
      const { positions, indices } = decodeDraco(file.bytes);
      writePly(ply, positions, indices);
      return { ...file, ply };
    });
  }

  /** Bytes grow almost in proportion to faces, so each step aims at the budget between the nearest sizes known. */
  #largest(bytes, bits) {
    const whole = this.file(this.#model.faces, bits);
    if (whole.bytes.length <= bytes) return whole;
    let best = null;
    let low = 0;
    let lowBytes = 0;
    let high = this.#model.faces;
    let highBytes = whole.bytes.length;
    for (let step = 0; step < SEARCH_STEPS && high > CLOSE_ENOUGH * low && high - low > 1; step++) {
      const beside = step % 2 === 0 ? 0.995 : 1.005;
      const aim = Math.round(low + (beside * (high - low) * (bytes - lowBytes)) / (highBytes - lowBytes));
      const faces = Math.max(low + 1, Math.min(high - 1, Math.max(4, aim)));
      const file = this.file(faces, bits);
      if (file.faces > 0 && file.bytes.length <= bytes) {
        if (best === null || file.faces > best.faces) best = file;
        low = faces;
        lowBytes = file.bytes.length;
      } else {
        high = faces;
        highBytes = file.bytes.length;
      }
    }
    return best;
  }
}

const { files, options } = commandLine('rate.mjs [--least-bits=6] MODEL...');
const leastBits = Number(options['least-bits'] ?? 6);
const precisions = Array.from({ length: MOST_BITS + 1 - leastBits }, (_, i) => leastBits + i);
const SIMPLIFIERS = [simplify, simplifyInSteps];
const rows = [];
const means = [];
const mean = (values) => (values.length > 0 ? geometricMean(values).toFixed(3) : '');
/** Ratios per peer: where either shows something, and where both do. */
const all = SIMPLIFIERS.map(() => ({ either: [], both: [] }));

for (const file of files) {
  const model = open(file);
  const peers = SIMPLIFIERS.map((simplifier) => new Peer(model, simplifier));
  const whole = peers[0].file(model.faces, MOST_BITS).bytes.length;
  const budgets = PERCENTS.map((percent) => Math.floor((whole * percent) / 100));
  const index = model.info.batches.map((b) => b.offset + b.bytes);
  const shown = budgets.map((b) => (index[0] <= b ? `${model.archive}@${b}` : 'nothing'));
  const candidates = peers.map((peer) => budgets.map((b, i) => peer.fitting(b, PERCENTS[i])));
  const found = distances(model, ['nothing', ...shown, ...candidates.flat(2).map((c) => c.ply)]);
  const nothing = found.shift();
  const ours = found.splice(0, budgets.length);
  const best = candidates.map((fitting) => fitting.map((fits) => smallestError(fits, found.splice(0, fits.length), nothing)));
  const ratios = SIMPLIFIERS.map(() => ({ either: [], both: [] }));
  budgets.forEach((bytes, i) => {
    const isShown = shown[i] !== 'nothing';
    const beside = best.flatMap((ofPeer, p) => {
      const { error, chosen } = ofPeer[i];
      const ratio = ours[i] / error;
      if ((isShown || chosen) && PERCENTS[i] <= JUDGED_UP_TO) ratios[p].either.push(ratio);
      if (isShown && chosen && PERCENTS[i] <= JUDGED_UP_TO) ratios[p].both.push(ratio);
      return [chosen ? error.toFixed(5) : 'nothing', chosen ? `${chosen.faces} × ${chosen.bits} bits` : '', isShown || chosen ? ratio.toFixed(2) : ''];
    });
    rows.push([i === 0 ? model.name : '', `${PERCENTS[i]}%`, bytes, isShown ? ours[i].toFixed(5) : 'nothing', ...beside]);
  });
  ratios.forEach(({ either, both }, p) => {
    all[p].either.push(...either);
    all[p].both.push(...both);
  });
  means.push([model.name, ...ratios.flatMap(({ either, both }) => [mean(either), mean(both)]), index[0], whole, bytesAtBits(model, MOST_BITS)]);
  console.error(`${model.name} done`);
}

console.log(`${machine()}\n\nMean distance in % of the diagonal after B bytes; B in % of the Draco file with all faces at 14 bits. "moved": of meshes by simplifyWithUpdate, step by step`);
printTable(['model', 'B', 'bytes', 'jSM', 'best Draco file', 'its faces', 'jSM / Draco', 'best Draco file, moved', 'its faces', 'jSM / it'], rows);
means.push(['all', ...all.flatMap(({ either, both }) => [mean(either), mean(both)]), '', '', '']);
console.log(`\nGeometric mean of jSM / Draco up to ${JUDGED_UP_TO}%; nothing shown counts as one point in the middle of the box`);
printTable(
  ['model', 'jSM / Draco', 'where both show something', 'jSM / Draco, moved', 'where both show something', 'bytes of the first picture', 'Draco 14 bits', 'jSM 14 bits'],
  means,
);

/** The file closest to the model; none where nothing fits, or where a point is closer. */
function smallestError(fits, errors, nothing) {
  const error = Math.min(nothing, ...errors);
  return { error, chosen: fits[errors.indexOf(error)] };
}
