// @ts-check
// Draco without loss: the positions of most models are decimals, or multiples of a power of two. Their numbers as integers come back exactly.

import { encodeDracoIntegers } from './codecs.mjs';

/** Coordinates that are not on the lattice: as many may be sent beside it, each with its place. */
const MOST_EXCEPTIONS = 0.002;
const BYTES_OF_EXCEPTION = 16;
const LARGEST = 2 ** 30;

/** Such a file, its bytes with what is beside it, and what the lattice is; undefined where no lattice holds the model, or Draco fails. */
export function encodeDracoLattice({ positions, indices }) {
  for (const family of [decimals(), digits(), binary()]) {
    for (const { name, cell, value } of family) {
      const lattice = onLattice(positions, cell, value);
      const file = lattice && draco(lattice, indices);
      if (!file) continue;
      const beside = lattice.exceptions > 0 ? `, ${lattice.exceptions} beside` : '';
      return { file, bytes: file.length + BYTES_OF_EXCEPTION * lattice.exceptions, name: name + beside };
    }
  }
  return undefined;
}

function* decimals() {
  for (let k = 0; k <= 9; k++) yield { name: `10^-${k}`, ...multiples(10 ** k) };
}

function* binary() {
  for (let k = 0; k <= 24; k++) yield { name: `2^-${k}`, ...multiples(2 ** k) };
}

function multiples(scale) {
  return { cell: (x) => Math.round(x * scale), value: (x, cell) => cell / scale };
}

/** Numbers with so many significant digits: cells grow tenfold with every decade. */
function* digits() {
  for (let count = 4; count <= 8; count++) {
    for (let finest = 2; finest <= 12; finest++) yield { name: `${count} digits`, ...significant(count, finest) };
  }
}

function significant(count, finest) {
  const split = (x) => {
    let decade = 0;
    let mantissa = Math.round(Math.abs(x) * 10 ** finest);
    while (mantissa >= 10 ** count && decade < 12) mantissa = Math.round(Math.abs(x) * 10 ** (finest - ++decade));
    return { decade, mantissa };
  };
  return {
    cell: (x) => {
      const { decade, mantissa } = split(x);
      const size = decade === 0 ? mantissa : 10 ** count + (decade - 1) * 9 * 10 ** (count - 1) + mantissa - 10 ** (count - 1);
      return x < 0 ? -size : size;
    },
    value: (x) => {
      const { decade, mantissa } = split(x);
      return Math.sign(x) * Number(`${mantissa}e${decade - finest}`);
    },
  };
}

function onLattice(positions, cell, value) {
  const cells = new Int32Array(positions.length);
  let exceptions = 0;
  for (let i = 0; i < cells.length; i++) {
    const at = cell(positions[i]);
    if (Math.abs(at) >= LARGEST) return undefined;
    if (Math.fround(value(positions[i], at)) !== positions[i] && ++exceptions > MOST_EXCEPTIONS * cells.length) return undefined;
    cells[i] = at;
  }
  return { cells, exceptions };
}

function draco({ cells }, indices) {
  try {
    const file = encodeDracoIntegers(cells, indices);
    return file.length > 0 ? file : undefined;
  } catch {
    return undefined; // Draco's WebAssembly aborts on some models
  }
}
