// Makes packed.txt beside it: npm install meshoptimizer@1.3.0 && node make.mjs
// A line has: values, level of the encoder, version, mode, filter, count, stride, packed bytes. Where the values are
// named, MeshoptDecoderTest makes them by the same formulas; otherwise they are in the line, as meshoptimizer's own
// decoder gives them.
import { writeFileSync } from 'node:fs';
import { MeshoptDecoder as decoder } from 'meshoptimizer/decoder';
import { MeshoptEncoder as encoder } from 'meshoptimizer/encoder';
await encoder.ready;
await decoder.ready;

const lines = [];
const base64 = bytes => Buffer.from(bytes).toString('base64');
const line = (values, level, version, mode, filter, count, stride, packed) =>
  lines.push([values, level, version, mode, filter, count, stride, base64(packed)].join(' '));

function noise() {
  let state = 1;
  return () => (state = (Math.imul(state, 1103515245) + 12345) >>> 0) >>> 8;
}

// Attributes without filter.
const random = noise();
const attributes = {
  bytes: (view, at, i, k) => view.setUint32(at, (i * (k + 1) & 255) * 0x01010101, true),
  shorts: (view, at, i, k) => view.setUint32(at, (i * i * 3 + 1000 * k & 0xFFFF) + (i * 7 & 0xFFFF) * 65536, true),
  floats: (view, at, i, k) => view.setFloat32(at, i * i * (k + 1) / 128, true),
  noise: (view, at) => view.setUint32(at, random() * 256, true),
  sparse: (view, at, i, k) => view.setUint32(at, i % 13 === k ? i : 7, true),
};
for (const [values, count, stride] of [['bytes', 100, 12], ['shorts', 300, 8], ['floats', 90, 12], ['noise', 20, 4],
  ['sparse', 300, 8], ['sparse', 70, 256], ['shorts', 1, 4], ['floats', 16, 4]]) {
  const bytes = new Uint8Array(count * stride), view = new DataView(bytes.buffer);
  for (let i = 0; i < count; i++) for (let k = 0; k < stride / 4; k++) attributes[values](view, i * stride + 4 * k, i, k);
  for (const [level, version] of [[2, 0], [2, 1], [3, 1]])
    line(values, level, version, 'ATTRIBUTES', 'NONE', count, stride, encoder.encodeVertexBufferLevel(bytes, count, stride, level, version));
}

// Filters.
const fraction = noise();
const numbers = Float32Array.from({ length: 64 }, () => fraction() / 2 ** 23 - 1);
const unit = size => numbers.map((_, i) => {
  const v = numbers.slice(i & ~3, (i & ~3) + size);
  return i % 4 < size ? numbers[i] / Math.hypot(...v) : Math.sign(numbers[i]);
});
for (const [filter, stride, bits, encode] of [['OCTAHEDRAL', 4, 8, () => encoder.encodeFilterOct(unit(3), 16, 4, 8)],
  ['OCTAHEDRAL', 4, 5, () => encoder.encodeFilterOct(unit(3), 16, 4, 5)], ['OCTAHEDRAL', 8, 12, () => encoder.encodeFilterOct(unit(3), 16, 8, 12)],
  ['QUATERNION', 8, 12, () => encoder.encodeFilterQuat(unit(4), 16, 8, 12)], ['EXPONENTIAL', 16, 15, () => encoder.encodeFilterExp(numbers, 16, 16, 15)],
  ['COLOR', 4, 8, () => encoder.encodeFilterColor(numbers.map(Math.abs), 16, 4, 8)], ['COLOR', 8, 12, () => encoder.encodeFilterColor(numbers.map(Math.abs), 16, 8, 12)]]) {
  const packed = encoder.encodeVertexBufferLevel(encode(), 16, stride, 2, 1), values = new Uint8Array(16 * stride);
  decoder.decodeGltfBuffer(values, 16, stride, packed, 'ATTRIBUTES', filter);
  line(base64(values), 2, 1, 'ATTRIBUTES', filter, 16, stride, packed);
}

// Indices.
const grid = (size, from) => Array.from({ length: 6 * size * size }, (_, n) => {
  const p = from + (n / 6 / size | 0) * (size + 1) + (n / 6 | 0) % size;
  return p + [0, 1, size + 1, 1, size + 2, size + 1][n % 6];
});
const index = noise();
const indices = { grid: grid(8, 0), twice: [...grid(4, 0), ...grid(4, 0)], chaos: Array.from({ length: 60 }, () => index() % 50),
  large: [...grid(3, 65500 - 16), 7, 65000, 3], soup: Array.from({ length: 30 }, (_, i) => i),
  again: [0, 1, 2, 1, 3, 2, 0, 1, 2, 1, 3, 2], down: Array.from({ length: 60 }, (_, i) => 90 - (i / 3 | 0) - [0, 1, 2, 1, 0, 2][i % 6]) };
for (const [name, values] of Object.entries(indices)) for (const stride of [2, 4]) for (const mode of ['TRIANGLES', 'INDICES']) {
  const bytes = new Uint8Array((stride === 2 ? Uint16Array : Uint32Array).from(values).buffer);
  line(name, 0, 1, mode, 'NONE', values.length, stride, encoder.encodeGltfBuffer(bytes, values.length, stride, mode));
}
writeFileSync('packed.txt', lines.join('\n') + '\n');
