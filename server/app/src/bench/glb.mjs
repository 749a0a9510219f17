// @ts-check
// Binary glTF as jSM and gltfpack write it: one buffer, perhaps with meshopt compression.

import fs from 'node:fs';
import { MeshoptDecoder } from 'meshoptimizer';

await MeshoptDecoder.ready;

const COMPONENTS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const ARRAYS = { 5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

export function readGlb(file) {
  const bytes = fs.readFileSync(file);
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + length));
  return { json, bin: bytes.subarray(28 + length) };
}

export function writeGlb(file, { json, bin }) {
  const text = Buffer.from(JSON.stringify(json));
  const body = [Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')]), Buffer.concat([bin, Buffer.alloc(-bin.length & 3)])];
  const head = Buffer.alloc(12);
  head.write('glTF');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(28 + body[0].length + body[1].length, 8);
  const chunks = ['JSON', 'BIN\0'].flatMap((type, i) => {
    const start = Buffer.alloc(8);
    start.writeUInt32LE(body[i].length);
    start.write(type, 4, 'latin1');
    return [start, body[i]];
  });
  fs.writeFileSync(file, Buffer.concat([head, ...chunks]));
}

/** The same without images and what refers to them. */
export function withoutImages({ json, bin }) {
  const { images, textures, samplers, ...rest } = structuredClone(json);
  const drop = (value) => {
    if (value === null || typeof value !== 'object') return value;
    if (Array.isArray(value)) return value.map(drop);
    return Object.fromEntries(Object.entries(value).filter(([key]) => !key.endsWith('Texture') && key !== 'textures').map(([key, v]) => [key, drop(v)]));
  };
  if (rest.materials) rest.materials = drop(rest.materials);
  const gone = new Set((images ?? []).map((image) => image.bufferView));
  const numbers = [];
  const kept = [];
  let length = 0;
  rest.bufferViews = rest.bufferViews.filter((view, i) => {
    numbers.push(numbers.length - gone.size + [...gone].filter((g) => g > i).length);
    if (gone.has(i)) return false;
    kept.push(bin.subarray(view.byteOffset, view.byteOffset + view.byteLength), Buffer.alloc(-view.byteLength & 3));
    view.byteOffset = length;
    length += view.byteLength + (-view.byteLength & 3);
    return true;
  });
  for (const accessor of rest.accessors) accessor.bufferView = numbers[accessor.bufferView];
  rest.buffers = [{ byteLength: length }];
  return { json: rest, bin: Buffer.concat(kept) };
}

/** Per primitive its indices, and per attribute in order of names its raw values: `{ name, components, array }`. */
export function parts(glb) {
  const { json } = glb;
  const used = json.nodes.filter((node) => node.mesh !== undefined);
  for (const node of used) if (node.matrix || node.scale || node.rotation || node.translation) throw new Error('a node moves its mesh');
  return json.meshes.flatMap((mesh) => mesh.primitives).map((primitive) => ({
    indices: Uint32Array.from(values(glb, primitive.indices).array),
    attributes: Object.keys(primitive.attributes).sort().map((name) => ({ name, ...values(glb, primitive.attributes[name]) })),
  }));
}

function values({ json, bin }, index) {
  const accessor = json.accessors[index];
  const type = ARRAYS[accessor.componentType];
  const components = COMPONENTS[accessor.type];
  const view = json.bufferViews[accessor.bufferView];
  const coded = view.extensions?.KHR_meshopt_compression ?? view.extensions?.EXT_meshopt_compression;
  const width = components * type.BYTES_PER_ELEMENT;
  const stride = coded?.byteStride ?? view.byteStride ?? width;
  let bytes = bin.subarray(view.byteOffset ?? 0, (view.byteOffset ?? 0) + view.byteLength);
  if (coded) {
    bytes = new Uint8Array(coded.count * coded.byteStride);
    const source = bin.subarray(coded.byteOffset ?? 0, (coded.byteOffset ?? 0) + coded.byteLength);
    MeshoptDecoder.decodeGltfBuffer(bytes, coded.count, coded.byteStride, source, coded.mode, coded.filter);
  }
  const packed = new Uint8Array(accessor.count * width);
  for (let i = 0; i < accessor.count; i++) {
    const at = (accessor.byteOffset ?? 0) + i * stride;
    packed.set(bytes.subarray(at, at + width), i * width);
  }
  return { components, array: new type(packed.buffer) };
}

/** What a model is, whatever the order: per triangle the bits of all its corners from the smallest one on, sorted. Materials are left out, and attributes that are named. */
export function triangles(glb, except = []) {
  const all = parts(glb).flatMap(({ indices, attributes }) => {
    const rows = attributes.filter(({ name }) => !except.includes(name)).map(({ components, array }) => ({ bits: array instanceof Float32Array ? new Uint32Array(array.buffer) : array, components }));
    const corner = (v) => rows.map(({ bits, components }) => bits.subarray(v * components, (v + 1) * components).join(' ')).join(' ');
    return Array.from({ length: indices.length / 3 }, (_, f) => {
      const [a, b, c] = [0, 1, 2].map((j) => corner(indices[3 * f + j]));
      return [[a, b, c], [b, c, a], [c, a, b]].map((turned) => turned.join(', ')).sort()[0];
    });
  });
  return all.sort();
}
