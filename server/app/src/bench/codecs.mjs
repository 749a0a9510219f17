// @ts-check
// The peers: Draco and the codec of meshoptimizer, both as WebAssembly from their npm packages.

import { execFileSync } from 'node:child_process';
import zlib from 'node:zlib';
import draco3d from 'draco3d';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';

const [encoders, decoders] = await Promise.all([draco3d.createEncoderModule({}), draco3d.createDecoderModule({})]);
await Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready]);

/** Draco at compression level 10: edgebreaker, the slowest and densest setting. */
export function encodeDraco(positions, indices, bits) {
  return dracoFile(indices, (encoder, builder, mesh) => {
    builder.AddFloatAttributeToMesh(mesh, encoders.POSITION, positions.length / 3, 3, positions);
    encoder.SetAttributeQuantization(encoders.POSITION, bits);
  });
}

/** The same with integers for positions, which come back as they are. Draco aborts on some: it throws. */
export function encodeDracoIntegers(cells, indices) {
  return dracoFile(indices, (_, builder, mesh) => builder.AddInt32AttributeToMesh(mesh, encoders.POSITION, cells.length / 3, 3, cells));
}

function dracoFile(indices, addPositions) {
  const encoder = new encoders.Encoder();
  const builder = new encoders.MeshBuilder();
  const mesh = new encoders.Mesh();
  const out = new encoders.DracoInt8Array();
  builder.AddFacesToMesh(mesh, indices.length / 3, indices);
  addPositions(encoder, builder, mesh);
  encoder.SetSpeedOptions(0, 0);
  encoder.SetEncodingMethod(encoders.MESH_EDGEBREAKER_ENCODING);
  const bytes = new Int8Array(encoder.EncodeMeshToDracoBuffer(mesh, out));
  for (let i = 0; i < bytes.length; i++) bytes[i] = out.GetValue(i);
  for (const object of [out, mesh, builder, encoder]) encoders.destroy(object);
  return bytes;
}

/** Decodes into Draco's own mesh, and hands it to `use` together with the decoder. */
function withDracoMesh(bytes, use) {
  const decoder = new decoders.Decoder();
  const mesh = new decoders.Mesh();
  if (!decoder.DecodeArrayToMesh(bytes, bytes.length, mesh).ok()) throw new Error('Draco does not decode its own file');
  const result = use(decoder, mesh);
  decoders.destroy(mesh);
  decoders.destroy(decoder);
  return result;
}

export function decodeDraco(bytes) {
  return withDracoMesh(bytes, (decoder, mesh) => {
    const attribute = decoder.GetAttributeByUniqueId(mesh, 0);
    const values = new decoders.DracoFloat32Array();
    decoder.GetAttributeFloatForAllPoints(mesh, attribute, values);
    const positions = Float32Array.from({ length: values.size() }, (_, i) => values.GetValue(i));
    const indices = new Uint32Array(3 * mesh.num_faces());
    const face = new decoders.DracoInt32Array();
    for (let f = 0; f < mesh.num_faces(); f++) {
      decoder.GetFaceFromMesh(mesh, f, face);
      for (let j = 0; j < 3; j++) indices[3 * f + j] = face.GetValue(j);
    }
    decoders.destroy(face);
    decoders.destroy(values);
    return { positions, indices };
  });
}

/** Seconds of CPU time: the best of several runs. */
function fastest(run) {
  let best = Infinity;
  for (let i = 0; i < 15; i++) {
    const start = process.cpuUsage();
    run();
    const { user, system } = process.cpuUsage(start);
    best = Math.min(best, (user + system) / 1e6);
  }
  return best;
}

export const dracoDecodeSeconds = (bytes) => fastest(() => withDracoMesh(bytes, () => 0));

/** Positions in meshoptimizer's order, and the faces by its codec. */
export function meshoptOrder({ positions, indices, vertices }) {
  const ordered = indices.slice();
  const [remap, unique] = MeshoptEncoder.reorderMesh(ordered, true, true);
  const moved = new Float32Array(3 * unique);
  for (let v = 0; v < vertices; v++) {
    if (remap[v] !== 0xffffffff) moved.set(positions.subarray(3 * v, 3 * v + 3), 3 * remap[v]);
  }
  const faces = MeshoptEncoder.encodeIndexBuffer(new Uint8Array(ordered.buffer), ordered.length, 4);
  return { moved, faces, vertices: unique, indices: ordered.length };
}

/** meshoptimizer's codec with float32 positions and zstd on top: lossless; the smaller of both versions of the vertex codec. */
export function encodeMeshopt(model) {
  const { moved, ...order } = meshoptOrder(model);
  const coded = [0, 1].map((version) => {
    const points = MeshoptEncoder.encodeVertexBufferLevel(new Uint8Array(moved.buffer), order.vertices, 12, 3, version);
    return { points, ...order, bytes: zstd(Buffer.concat([points, order.faces])).length };
  });
  return coded[0].bytes < coded[1].bytes ? coded[0] : coded[1];
}

/** The same for models with attributes, of which each has a stream of its own: bytes of all primitives with zstd on top, by the better version of the vertex codec. */
export function encodeMeshoptAttributes(primitives) {
  const bytes = [0, 1].map((version) => zstd(Buffer.concat(primitives.flatMap((primitive) => attributeStreams(primitive, version)))).length);
  return Math.min(...bytes);
}

function attributeStreams({ indices, attributes }, version) {
  const ordered = indices.slice();
  const [remap, unique] = MeshoptEncoder.reorderMesh(ordered, true, true);
  const faces = MeshoptEncoder.encodeIndexBuffer(new Uint8Array(ordered.buffer), ordered.length, 4);
  const streams = attributes.map(({ array, components }) => {
    const width = components * array.BYTES_PER_ELEMENT;
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    const moved = new Uint8Array(width * unique);
    for (let v = 0; v < remap.length; v++) {
      if (remap[v] !== 0xffffffff) moved.set(bytes.subarray(v * width, (v + 1) * width), remap[v] * width);
    }
    return MeshoptEncoder.encodeVertexBufferLevel(moved, unique, width, 3, version);
  });
  return [...streams, faces];
}

export function meshoptDecodeSeconds(coded) {
  const points = new Uint8Array(12 * coded.vertices);
  const faces = new Uint8Array(4 * coded.indices);
  return fastest(() => {
    MeshoptDecoder.decodeVertexBuffer(points, coded.vertices, 12, coded.points);
    MeshoptDecoder.decodeIndexBuffer(faces, coded.indices, 4, coded.faces);
  });
}

/** Level 19: Node's own zstd where there is one, else the command. */
export function zstd(bytes) {
  /** @type {any} Node 18 does not know zstd. */
  const { zstdCompressSync, constants } = zlib;
  if (zstdCompressSync) return zstdCompressSync(bytes, { params: { [constants.ZSTD_c_compressionLevel]: 19 } });
  return execFileSync('zstd', ['-19', '-c', '-q', '--no-check'], { input: bytes, maxBuffer: 1 << 28 });
}
