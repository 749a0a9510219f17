// @ts-check
// A large mesh to time the encoder with: node sphere.mjs FREQUENCY OUT.ply writes a bumpy sphere of 8 · FREQUENCY² faces
// (500: 2 million) as binary PLY, the same bytes on every machine but for the last digit of a sine.

import { writeFileSync } from 'node:fs';

const [frequency, out] = [Number(process.argv[2]), process.argv[3]];
if (!Number.isInteger(frequency) || frequency < 1 || !out) {
  console.error('usage: node sphere.mjs FREQUENCY OUT.ply');
  process.exit(2);
}

const WAVES = [[0.08, 3, 1, 2], [0.05, 5, 7, 2], [0.03, 11, 6, 13], [0.015, 23, 29, 17], [0.006, 61, 47, 53], [0.003, 101, 131, 113]];
const positions = [];
const ids = new Map(); // by lattice point
const corners = [];
let seed = 1;

/** A number from 0 to 1, always the same ones (Park and Miller 1988). */
function random() {
  seed = (seed * 48271) % 2147483647;
  return seed / 2147483647;
}

/** The vertex over the point (x, y, z) of an octahedron, |x| + |y| + |z| = frequency. */
function vertex(x, y, z) {
  const key = ((x + frequency) * (2 * frequency + 1) + y + frequency) * 2 + (z < 0 ? 1 : 0);
  let id = ids.get(key);
  if (id !== undefined) return id;
  id = positions.length / 3;
  ids.set(key, id);
  const bent = [x, y, z].map((c) => Math.sin(((c / frequency) * Math.PI) / 2)); // more even triangles
  const length = Math.hypot(...bent);
  const [a, b, c] = bent.map((d) => d / length);
  let r = 1 + ((random() - 0.5) * 0.1 * Math.PI) / 2 / frequency;
  for (const [height, i, j, k] of WAVES) r += height * Math.sin(i * a + j * b + k * c + height * 10);
  positions.push(a * r, b * r, c * r);
  return id;
}

for (let octant = 0; octant < 8; octant++) {
  const [sx, sy, sz] = [octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1];
  const at = (i, j) => vertex(sx * i, sy * j, sz * (frequency - i - j));
  const face = (a, b, c) => (sx * sy * sz > 0 ? corners.push(a, b, c) : corners.push(a, c, b));
  for (let i = 0; i < frequency; i++) {
    for (let j = 0; i + j < frequency; j++) {
      face(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j < frequency - 1) face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

const faces = corners.length / 3;
const header = Buffer.from(`ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\n`
  + 'property float x\nproperty float y\nproperty float z\n'
  + `element face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`);
const body = Buffer.alloc(4 * positions.length + 13 * faces);
positions.forEach((value, i) => body.writeFloatLE(value, 4 * i));
for (let f = 0, p = 4 * positions.length; f < faces; f++, p += 13) {
  body[p] = 3;
  for (let k = 0; k < 3; k++) body.writeInt32LE(corners[3 * f + k], p + 1 + 4 * k);
}
writeFileSync(out, Buffer.concat([header, body]));
console.error(`${faces} faces, ${positions.length / 3} vertices`);
