// Makes the GLB files beside it: npm install gltfpack@1.3.0 draco3dgltf@1.5.7 @gltf-transform/core@4.5.1
// @gltf-transform/extensions@4.5.1 && node make.mjs
import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { Document, NodeIO } from '@gltf-transform/core';
import { KHRDracoMeshCompression } from '@gltf-transform/extensions';
import draco3d from 'draco3dgltf';

const PNG = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR4nGP4z8DAAMIM/4EAAB/uBfsL2WiLAAAAAElFTkSuQmCC', 'base64');

// A band of 16 by 4 quads around the z axis. Its positions are multiples of 1/64.
function band() {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const position = [], normal = [], uv = [], color = [], index = [];
  for (let i = 0; i <= 16; i++) for (let j = 0; j <= 4; j++) {
    const x = Math.cos(i * Math.PI / 8), y = Math.sin(i * Math.PI / 8);
    position.push(Math.round(64 * x) / 64, Math.round(64 * y) / 64, j / 4);
    normal.push(x, y, 0);
    uv.push(i / 16, j / 4);
    color.push(63 * j, 15 * i, 40, 255);
    const p = 5 * i + j;
    if (i < 16 && j < 4) index.push(p, p + 5, p + 1, p + 5, p + 6, p + 1);
  }
  const texture = document.createTexture('squares').setImage(PNG).setMimeType('image/png');
  const material = document.createMaterial('band').setBaseColorTexture(texture).setBaseColorFactor([0.75, 0.5, 0.25, 1])
    .setMetallicFactor(0).setRoughnessFactor(0.5);
  const primitive = document.createPrimitive().setMaterial(material)
    .setIndices(accessor('SCALAR', new Uint16Array(index)))
    .setAttribute('POSITION', accessor('VEC3', new Float32Array(position)))
    .setAttribute('NORMAL', accessor('VEC3', new Float32Array(normal)))
    .setAttribute('TEXCOORD_0', accessor('VEC2', new Float32Array(uv)))
    .setAttribute('COLOR_0', accessor('VEC4', new Uint8Array(color)).setNormalized(true));
  const mesh = document.createMesh('band').addPrimitive(primitive);
  document.createScene().addChild(document.createNode('band').setMesh(mesh).setTranslation([1, 2, 3]));
  return document;
}

function glb(json, binary) {
  const text = JSON.stringify(json);
  const padded = Buffer.from(text.padEnd((text.length + 3) & ~3));
  const data = Buffer.concat([binary, Buffer.alloc(-binary.length & 3)]);
  const head = Buffer.alloc(20), chunk = Buffer.alloc(8);
  head.write('glTF');
  [2, 28 + padded.length + data.length, padded.length, 0x4E4F534A].forEach((v, i) => head.writeUInt32LE(v, 4 + 4 * i));
  chunk.writeUInt32LE(data.length, 0);
  chunk.writeUInt32LE(0x004E4942, 4);
  return Buffer.concat([head, padded, chunk, data]);
}

function parts(file) {
  const bytes = readFileSync(file), length = bytes.readUInt32LE(12);
  return [JSON.parse(bytes.subarray(20, 20 + length)), bytes.subarray(28 + length)];
}

const io = new NodeIO().registerExtensions([KHRDracoMeshCompression]).registerDependencies({
  'draco3d.encoder': await draco3d.createEncoderModule() });
writeFileSync('plain.glb', await io.writeBinary(band()));

const draco = band();
draco.createExtension(KHRDracoMeshCompression).setRequired(true).setEncoderOptions({
  method: KHRDracoMeshCompression.EncoderMethod.EDGEBREAKER, encodeSpeed: 0, decodeSpeed: 0,
  quantizationBits: { POSITION: 14, NORMAL: 10, TEX_COORD: 12, COLOR: 8, GENERIC: 12 } });
writeFileSync('draco-required.glb', await io.writeBinary(draco));
const [json, binary] = parts('draco-required.glb');
delete json.extensionsRequired;
writeFileSync('draco-optional.glb', glb(json, binary));

const pack = (name, ...options) => execFileSync('node',
  ['node_modules/gltfpack/cli.js', '-i', 'plain.glb', '-o', name, '-kn', ...options]);
pack('meshopt-quantized.glb', '-cc', '-ce', 'ext');
pack('meshopt-khr.glb', '-cc', '-ce', 'khr');
pack('meshopt-floats.glb', '-c', '-noq', '-ce', 'khr');
// The fallback is put into the file itself.
pack('meshopt-fallback.glb', '-cf', '-ce', 'ext');
const [packed, data] = parts('meshopt-fallback.glb');
const fallback = packed.buffers[1];
fallback.uri = 'data:application/octet-stream;base64,' + readFileSync(fallback.uri).toString('base64');
writeFileSync('meshopt-fallback.glb', glb(packed, data));
rmSync('meshopt-fallback.fallback.bin');
