// @ts-check
// Writes the triangles that are shown as files. Coordinates in single precision are those of the model bit for bit; in
// double precision, what is drawn is rounded.

/**
 * @typedef {object} Shape
 * @property {Float32Array<ArrayBuffer>} positions three per vertex; no two vertices have the same
 * @property {Uint32Array<ArrayBuffer>} indices three per face
 * @property {Uint8Array<ArrayBuffer> | null} colours red, green, blue, opacity per vertex
 * @property {number[]} origin what the positions count from
 */
/** @typedef {'ply' | 'stl' | 'obj' | 'off' | 'glb'} Format */
/** @typedef {BlobPart[]} Pieces */

/** Lines that are joined at once. */
const LINES = 1 << 14;

/** @type {Record<Format, (shape: Shape) => Pieces>} */
export const WRITERS = { ply, stl, obj, off, glb };

/**
 * The shape of triangles as they are drawn: vertices that differ in their normals alone are one.
 *
 * @param {Float32Array<ArrayBuffer>} positions
 * @param {Uint32Array<ArrayBuffer>} indices
 * @param {Uint8Array<ArrayBuffer> | null} colours
 * @param {number[]} origin
 * @returns {Shape}
 */
export function shapeOf(positions, indices, colours, origin) {
  const bits = new Uint32Array(positions.buffer, positions.byteOffset, positions.length);
  const paint = colours === null ? null : new Uint32Array(colours.buffer, colours.byteOffset, colours.length / 4);
  /** @type {Map<string, number>} */
  const known = new Map();
  const joined = new Map();
  /** @type {number[]} */
  const kept = [];
  const faces = indices.map((vertex) => {
    const before = joined.get(vertex);
    if (before !== undefined) return before;
    const key = `${bits[3 * vertex]},${bits[3 * vertex + 1]},${bits[3 * vertex + 2]},${paint?.[vertex] ?? 0}`;
    const at = known.get(key) ?? kept.push(vertex) - 1;
    known.set(key, at);
    joined.set(vertex, at);
    return at;
  });
  const places = new Float32Array(3 * kept.length);
  const painted = colours === null ? null : new Uint8Array(4 * kept.length);
  kept.forEach((vertex, i) => {
    places.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
    if (colours !== null) painted?.set(colours.subarray(4 * vertex, 4 * vertex + 4), 4 * i);
  });
  return { positions: places, indices: faces, colours: painted, origin };
}

/** @param {Shape} shape */
function ply({ positions, indices, colours, origin }) {
  const isMoved = origin.some((at) => at !== 0);
  const vertices = positions.length / 3;
  const number = isMoved ? 'double' : 'float';
  const names = colours === null ? [] : ['red', 'green', 'blue', ...(colours.every((value, i) => i % 4 !== 3 || value === 255) ? [] : ['alpha'])];
  const paint = names.map((name) => `property uchar ${name}\n`).join('');
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${vertices}\n${['x', 'y', 'z'].map((name) => `property ${number} ${name}\n`).join('')}${paint}element face ${
    indices.length / 3}\nproperty list uchar uint vertex_indices\nend_header\n`;
  const size = isMoved ? 8 : 4;
  const stride = 3 * size + names.length;
  const data = new DataView(new ArrayBuffer(vertices * stride));
  for (let i = 0; i < vertices; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const at = i * stride + axis * size;
      if (isMoved) data.setFloat64(at, origin[axis] + positions[3 * i + axis], true);
      else data.setFloat32(at, positions[3 * i + axis], true);
    }
    names.forEach((_, k) => data.setUint8(i * stride + 3 * size + k, colours?.[4 * i + k] ?? 0));
  }
  const faces = new DataView(new ArrayBuffer((indices.length / 3) * 13));
  for (let i = 0; i < indices.length; i++) {
    if (i % 3 === 0) faces.setUint8((i / 3) * 13, 3);
    faces.setUint32(Math.floor(i / 3) * 13 + 1 + 4 * (i % 3), indices[i], true);
  }
  return [header, data.buffer, faces.buffer];
}

/** The format has no double precision. @param {Shape} shape */
function stl({ positions, indices, origin }) {
  const data = new DataView(new ArrayBuffer(84 + 50 * (indices.length / 3)));
  data.setUint32(80, indices.length / 3, true);
  for (let face = 0; face < indices.length / 3; face++) {
    const at = 84 + 50 * face;
    const corners = [0, 1, 2].map((corner) => [0, 1, 2].map((axis) => positions[3 * indices[3 * face + corner] + axis]));
    normal(corners).forEach((value, axis) => data.setFloat32(at + 4 * axis, value, true));
    corners.forEach((place, corner) => place.forEach((value, axis) => data.setFloat32(at + 12 + 12 * corner + 4 * axis, origin[axis] + value, true)));
  }
  return [data.buffer];
}

/** @param {number[][]} corners */
function normal([a, b, c]) {
  const [u, v] = [b, c].map((to) => to.map((value, axis) => value - a[axis]));
  const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...cross);
  return length > 0 ? cross.map((value) => value / length + 0) : [0, 0, 0];
}

/** @param {Shape} shape */
function obj(shape) {
  return [...vertexLines(shape, 'v '), ...faceLines(shape, 'f ', 1)];
}

/** @param {Shape} shape */
function off(shape) {
  return [`OFF\n${shape.positions.length / 3} ${shape.indices.length / 3} 0\n`, ...vertexLines(shape, ''), ...faceLines(shape, '3 ', 0)];
}

/** Numbers are written so that they read back as the same. @param {Shape} shape @param {string} begin */
function vertexLines({ positions, origin }, begin) {
  const line = (/** @type {number} */ i) => `${begin}${[0, 1, 2].map((axis) => text(positions[3 * i + axis], origin[axis])).join(' ')}\n`;
  return pieces(positions.length / 3, line);
}

/** @param {Shape} shape @param {string} begin @param {number} first */
function faceLines({ indices }, begin, first) {
  return pieces(indices.length / 3, (i) => `${begin}${indices[3 * i] + first} ${indices[3 * i + 1] + first} ${indices[3 * i + 2] + first}\n`);
}

/** @param {number} value @param {number} origin */
function text(value, origin) {
  if (origin !== 0) return String(origin + value);
  // Nine digits are enough for single precision.
  return Object.is(value, -0) ? '-0' : String(Number(value.toPrecision(9)));
}

/** @param {number} count @param {(i: number) => string} line */
function pieces(count, line) {
  const made = [];
  for (let from = 0; from < count; from += LINES) made.push(Array.from({ length: Math.min(LINES, count - from) }, (_, i) => line(from + i)).join(''));
  return made;
}

/** @param {Shape} shape */
function glb({ positions, indices, colours, origin }) {
  const vertices = positions.length / 3;
  const parts = [indices, positions, ...(colours === null ? [] : [colours])];
  let at = 0;
  const bufferViews = parts.map(({ byteLength }, i) => {
    const view = { buffer: 0, byteOffset: at, byteLength, target: i === 0 ? 34963 : 34962 };
    at += byteLength;
    return view;
  });
  const [min, max] = [Math.min, Math.max].map((pick) => [0, 1, 2].map((axis) => positions.reduce((sum, value, i) => (i % 3 === axis ? pick(sum, value) : sum), positions[axis])));
  const json = {
    asset: { version: '2.0', generator: 'jSM' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, ...(origin.some((value) => value !== 0) && { translation: origin }) }],
    meshes: [{ primitives: [{ attributes: { POSITION: 1, ...(colours !== null && { COLOR_0: 2 }) }, indices: 0 }] }],
    accessors: [
      { bufferView: 0, componentType: 5125, count: indices.length, type: 'SCALAR' },
      { bufferView: 1, componentType: 5126, count: vertices, type: 'VEC3', min, max },
      ...(colours === null ? [] : [{ bufferView: 2, componentType: 5121, normalized: true, count: vertices, type: 'VEC4' }]),
    ],
    bufferViews,
    buffers: [{ byteLength: at }],
  };
  const said = new TextEncoder().encode(JSON.stringify(json));
  const padded = new Uint8Array(Math.ceil(said.length / 4) * 4).fill(32);
  padded.set(said);
  const head = Uint32Array.of(0x46546c67, 2, 28 + padded.length + at, padded.length, 0x4e4f534a);
  return [head, padded, Uint32Array.of(at, 0x004e4942), ...parts];
}
