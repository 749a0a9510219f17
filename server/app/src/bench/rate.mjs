// @ts-check
// Rate and distortion: the error of what jSM shows after B bytes, beside the best single Draco file that fits in B bytes.

import { bytesAtBits, commandLine, distances, geometricMean, machine, open, printTable, temporary, writePly } from './model.mjs';
import { decodeDraco, encodeDraco, simplify } from './codecs.mjs';

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
  #simplified;

  constructor(model) {
    this.#model = model;
    this.#simplified = new Map([[model.faces, model]]);
  }

  file(faces, bits) {
    if (!this.#simplified.has(faces)) this.#simplified.set(faces, simplify(this.#model, faces));
    const { positions, indices } = this.#simplified.get(faces);
    return { faces: indices.length / 3, bits, bytes: encodeDraco(positions, indices, bits) };
  }

  /** For every precision the file with the most faces that fits, written as PLY. */
  fitting(bytes, percent) {
    const bits = precisions.filter((b) => percent < 25 || b >= LEAST_BITS_OF_LARGE);
    const files = bits.map((b) => this.#largest(bytes, b)).filter((file) => file !== null);
    return files.map((file) => {
      const ply = temporary(`draco-${bytes}-${file.bits}.ply`);
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
const rows = [];
const means = [];
const mean = (values) => (values.length > 0 ? geometricMean(values).toFixed(3) : '');
const all = [];
const allShown = [];

for (const file of files) {
  const model = open(file);
  const peer = new Peer(model);
  const whole = peer.file(model.faces, MOST_BITS).bytes.length;
  const budgets = PERCENTS.map((percent) => Math.floor((whole * percent) / 100));
  const index = model.info.batches.map((b) => b.offset + b.bytes);
  const shown = budgets.map((b) => (index[0] <= b ? `${model.archive}@${b}` : 'nothing'));
  const candidates = budgets.map((b, i) => peer.fitting(b, PERCENTS[i]));
  const found = distances(model, [...shown, ...candidates.flat().map((c) => c.ply), 'nothing']);
  const nothing = found.pop();
  const ours = found.splice(0, budgets.length);
  const ratios = [];
  const bothShown = [];
  budgets.forEach((bytes, i) => {
    const errors = found.splice(0, candidates[i].length);
    const theirs = Math.min(nothing, ...errors);
    const best = candidates[i][errors.indexOf(theirs)];
    const ratio = ours[i] / theirs;
    const shows = [shown[i] !== 'nothing', best !== undefined];
    if (shows.includes(true) && PERCENTS[i] <= JUDGED_UP_TO) ratios.push(ratio);
    if (!shows.includes(false) && PERCENTS[i] <= JUDGED_UP_TO) bothShown.push(ratio);
    rows.push([
      i === 0 ? model.name : '', `${PERCENTS[i]}%`, bytes,
      shows[0] ? ours[i].toFixed(5) : 'nothing',
      shows[1] ? theirs.toFixed(5) : 'nothing',
      shows[1] ? `${best.faces} × ${best.bits} bits` : '',
      shows.includes(true) ? ratio.toFixed(2) : '',
    ]);
  });
  all.push(...ratios);
  allShown.push(...bothShown);
  means.push([model.name, mean(ratios), mean(bothShown), index[0], whole, bytesAtBits(model, MOST_BITS)]);
  console.error(`${model.name} done`);
}

console.log(`${machine()}\n\nMean distance in % of the diagonal after B bytes; B in % of the Draco file with all faces at 14 bits`);
printTable(['model', 'B', 'bytes', 'jSM', 'best Draco file', 'its faces', 'jSM / Draco'], rows);
means.push(['all', mean(all), mean(allShown), '', '', '']);
console.log(`\nGeometric mean of jSM / Draco up to ${JUDGED_UP_TO}%; nothing shown counts as one point in the middle of the box`);
printTable(['model', 'jSM / Draco', 'where both show something', 'bytes of the first picture', 'Draco 14 bits', 'jSM 14 bits'], means);
