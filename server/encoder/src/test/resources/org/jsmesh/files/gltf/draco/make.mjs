// Makes the Draco files in the folder below: npm install draco3d@1.5.7 && node make.mjs
// A ring of 8 by 6 quads (one has 26 by 22) that is closed in both directions, with seams of texture coordinates; some files have holes.
import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);
import { writeFileSync } from 'node:fs';
const enc = await require('draco3d').createEncoderModule({});
function ring(hole, U, V) {
  const P = [], N = [], T = [], C = [], J = [], W = [], I = [], known = new Map();
  const corner = (i, j) => {
    const key = i * 100 + j;
    if (!known.has(key)) {
      known.set(key, P.length / 3);
      const a = i % U, b = j % V, n = [a - 3.5, b - 2, 3], l = Math.hypot(...n);
      P.push(Math.trunc(2047 * a / (U - 1)), 29 * b + 7 * a, 3 * a * b);
      N.push(...n.map(x => x / l));
      T.push(Math.trunc(2047 * i / U), Math.trunc(2047 * j / V));
      C.push(20 * a, 28 * b, 200, 255);
      J.push(a, 300 * b, 0, 65535 - a);
      W.push(a / 16, b / 16, 0.25, 0);
    }
    return known.get(key);
  };
  for (let i = 0; i < U; i++) for (let j = 0; j < V; j++) {
    if (hole && (7 * i + 5 * j) % 11 === 0) continue;
    I.push(corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
  }
  return { P: new Float32Array(P), N: new Float32Array(N), T: new Float32Array(T), C: new Uint8Array(C), J: new Uint16Array(J), W: new Float32Array(W), I: new Uint32Array(I) };
}
function encode(m, method, speed, bits, all) {
  const b = new enc.MeshBuilder(), mesh = new enc.Mesh(), e = new enc.Encoder(), n = m.P.length / 3;
  b.AddFacesToMesh(mesh, m.I.length / 3, m.I);
  b.AddFloatAttributeToMesh(mesh, enc.POSITION, n, 3, m.P);
  if (all) {
  b.AddFloatAttributeToMesh(mesh, enc.NORMAL, n, 3, m.N);
  b.AddFloatAttributeToMesh(mesh, enc.TEX_COORD, n, 2, m.T);
  b.AddUInt8Attribute(mesh, enc.COLOR, n, 4, m.C);
  b.AddUInt16Attribute(mesh, enc.GENERIC, n, 4, m.J);
  b.AddFloatAttributeToMesh(mesh, enc.GENERIC, n, 4, m.W);
  }
  e.SetSpeedOptions(speed, speed);
  if (bits) for (const [kind, k] of [[enc.POSITION, 11], [enc.NORMAL, 10], [enc.TEX_COORD, 11]]) e.SetAttributeQuantization(kind, k);
  e.SetEncodingMethod(method);
  const out = new enc.DracoInt8Array(), length = e.EncodeMeshToDracoBuffer(mesh, out);
  return Uint8Array.from({ length }, (_, i) => out.GetValue(i));
}
const E = enc.MESH_EDGEBREAKER_ENCODING, S = enc.MESH_SEQUENTIAL_ENCODING;
for (const [name, hole, method, speed, bits] of [['edgebreaker-0', 0, E, 0, 1], ['edgebreaker-5', 0, E, 5, 1], ['edgebreaker-10', 0, E, 10, 1], ['holes-0', 1, E, 0, 1], ['holes-7', 1, E, 7, 1], ['floats-0', 1, E, 0, 0], ['sequential-0', 1, S, 0, 1], ['sequential-10', 0, S, 10, 0],
  ['positions-0', 1, E, 0, 1], ['positions-7', 0, E, 7, 1],
  // Draco codes symbols by valence where there are 1000 faces or more.
  ['positions-valence', 1, E, 0, 1]]) {
  const bytes = encode(name === 'positions-valence' ? ring(hole, 26, 22) : ring(hole, 8, 6), method, speed, bits, !name.startsWith('positions')); writeFileSync(`DracoFuzzTestInputs/shouldThrowNothingButPackedException/${name}.drc`, bytes);
}
