// @ts-check
// The peers' pages, each the smallest that shows one model well: everything bundled, minified, packed with Brotli, kept for ever, and asked for at once.

import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import zlib from 'node:zlib';
import { buildSync } from 'esbuild';
import { encodeDraco } from './codecs.mjs';
import { readGlb, writeGlb } from './glb.mjs';
import { temporary } from './model.mjs';
import { simplify, simplifyToCount } from './simplifiers.mjs';

const BITS = 14;
const TYPES = { html: 'text/html; charset=utf-8', js: 'text/javascript', wasm: 'application/wasm', jpg: 'image/jpeg', glb: 'model/gltf-binary' };
const GUID = 'model';
const here = path.dirname(fileURLToPath(import.meta.url));
const packages = path.join(here, 'node_modules');
const gltfpack = createRequire(import.meta.url).resolve('gltfpack/cli.js');

/** A scene that three.js draws, and what a page of it needs. */
const SCENE = `
import { Box3, Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Sphere, WebGLRenderer } from 'three';
export const renderer = new WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
const scene = new Scene();
scene.background = new Color('#e4e6e9');
scene.add(new HemisphereLight('#ffffff', '#888888', 2), new DirectionalLight('#ffffff', 2));
export const camera = new PerspectiveCamera(40, innerWidth / innerHeight, .001, 1e6);
export const render = () => renderer.render(scene, camera);
export function show(model) {
  const { center, radius } = new Box3().setFromObject(model).getBoundingSphere(new Sphere());
  camera.position.set(0, 0, 3 * radius).add(center);
  camera.near = radius / 100;
  camera.far = 10 * radius;
  camera.updateProjectionMatrix();
  scene.add(model);
}`;

const GLTF_LOADER = `
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { render, show } from 'scene';
new GLTFLoader().setDRACOLoader(new DRACOLoader().setDecoderPath('draco/')).load('model.glb', ({ scene }) => {
  show(scene);
  render();
  window.shown?.('picture');
  window.shown?.('whole');
});`;

/** Its manager is told to want all triangles, so that the last level comes. */
const NEEDLE = `
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { LODsManager, setDracoDecoderLocation, useNeedleProgressive } from '@needle-tools/gltf-progressive';
import { render, renderer, show } from 'scene';
setDracoDecoderLocation('draco/');
const loader = new GLTFLoader();
useNeedleProgressive(loader, renderer);
const manager = LODsManager.get(renderer);
manager.targetTriangleDensity = 1e9;
manager.addEventListener('changed', ({ type, level }) => type === 'mesh' && level === 0 && window.shown?.('whole'));
loader.load('base.glb', ({ scene }) => {
  show(scene);
  renderer.setAnimationLoop(render);
  window.shown?.('picture');
});`;

const page = (head, body) => `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Model</title><link rel="icon" href="data:,">
<style>html,body{margin:0;height:100%}canvas,model-viewer{display:block;width:100%;height:100%}model-viewer img{width:100%;height:100%;object-fit:contain}</style>${head}</head><body>${body}</body></html>`;
const preload = (...files) => files.map((file) => `<link rel="preload" as="fetch" crossorigin href="${file}">`).join('');
const script = (file) => `<script type="module" src="${file}"></script>`;

function bundle(source) {
  const folder = fs.mkdtempSync(temporary('bundle-'));
  fs.writeFileSync(path.join(folder, 'scene.js'), SCENE);
  const { outputFiles } = buildSync({
    stdin: { contents: source, resolveDir: here },
    alias: { scene: path.join(folder, 'scene.js') },
    nodePaths: [packages],
    bundle: true, minify: true, format: 'esm', target: 'es2022', write: false, legalComments: 'none',
  });
  return Buffer.from(outputFiles[0].contents);
}

/** @returns {Buffer} a GLB file with a mesh in Draco */
function draco({ positions, indices }, extensions = {}) {
  const bin = Buffer.from(encodeDraco(positions, indices, BITS));
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3], x);
    max[i % 3] = Math.max(max[i % 3], x);
  });
  const name = 'KHR_draco_mesh_compression';
  const primitive = { attributes: { POSITION: 0 }, indices: 1, extensions: { [name]: { bufferView: 0, attributes: { POSITION: 0 } } } };
  const json = {
    asset: { version: '2.0' }, extensionsUsed: [name, ...Object.keys(extensions)], extensionsRequired: [name],
    scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [primitive], ...(Object.keys(extensions).length > 0 ? { extensions } : {}) }],
    accessors: [{ componentType: 5126, count: positions.length / 3, type: 'VEC3', min, max }, { componentType: 5125, count: indices.length, type: 'SCALAR' }],
    bufferViews: [{ buffer: 0, byteLength: bin.length }], buffers: [{ byteLength: bin.length }],
  };
  const file = temporary('draco.glb');
  writeGlb(file, { json, bin });
  return fs.readFileSync(file);
}

/** The same without compression, for gltfpack, which packs it with meshoptimizer's codec, 14 bits for positions. */
function meshopt({ positions, indices }, extension) {
  const [file, packed] = [temporary('plain.glb'), temporary('packed.glb')];
  const bin = Buffer.concat([Buffer.from(positions.buffer, positions.byteOffset, positions.byteLength), Buffer.from(Uint32Array.from(indices).buffer)]);
  const json = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3', min: [-1e9, -1e9, -1e9], max: [1e9, 1e9, 1e9] }, { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' }],
    bufferViews: [{ buffer: 0, byteLength: positions.byteLength }, { buffer: 0, byteOffset: positions.byteLength, byteLength: 4 * indices.length }], buffers: [{ byteLength: bin.length }],
  };
  writeGlb(file, { json, bin });
  execFileSync('node', [gltfpack, '-i', file, '-o', packed, '-cc', '-vp', String(BITS)], { stdio: 'ignore' });
  const glb = readGlb(packed);
  glb.json.meshes[0].extensions = { NEEDLE_progressive: extension };
  glb.json.extensionsUsed.push('NEEDLE_progressive');
  writeGlb(packed, glb);
  return fs.readFileSync(packed);
}

/** A twentieth of the faces first, then a quarter, then all. */
function needleFiles(model) {
  const extension = { guid: GUID, lods: [['whole.glb', model], ['quarter.glb', simplifyToCount(simplify, model, Math.round(model.faces / 4))]].map(([file, { positions, indices }]) => ({
    path: file, vertexCount: positions.length / 3, indexCount: indices.length, densities: [indices.length],
  })) };
  const named = { NEEDLE_progressive: { guid: GUID } };
  return {
    'base.glb': meshopt(simplifyToCount(simplify, model, Math.round(model.faces / 20)), extension),
    'quarter.glb': draco(simplifyToCount(simplify, model, Math.round(model.faces / 4)), named),
    'whole.glb': draco(model, named),
  };
}

/**
 * @param {{ positions: Float32Array, indices: Uint32Array, faces: number }} model
 * @param {Buffer} poster the picture that jSM has, too
 * @returns {Record<string, Record<string, Buffer>>} files of each peer by name
 */
export function peers(model, poster) {
  const decoders = path.join(packages, 'three/examples/jsm/libs/draco/gltf');
  const decoder = (name) => ({ [`draco/${name}`]: fs.readFileSync(path.join(decoders, name)) });
  const wasm = { ...decoder('draco_wasm_wrapper.js'), ...decoder('draco_decoder.wasm') };
  const hints = preload(...Object.keys(wasm), 'model.glb');
  const glb = draco(model);
  const viewer = '<model-viewer src="model.glb" loading="eager" camera-controls><img id="poster" slot="poster" src="poster.jpg" alt=""></model-viewer>';
  const at = '<script>self.ModelViewerElement={dracoDecoderLocation:"draco/"}</script>';
  return {
    'GLTFLoader + Draco': { 'index.html': Buffer.from(page(script('page.js') + hints, '')), 'page.js': bundle(GLTF_LOADER), 'model.glb': glb, ...wasm },
    'model-viewer + Draco': {
      'index.html': Buffer.from(page(`${at}${script('model-viewer.min.js')}${hints}`, viewer)),
      'model-viewer.min.js': fs.readFileSync(path.join(packages, '@google/model-viewer/dist/model-viewer.min.js')),
      'model.glb': glb, 'poster.jpg': poster, ...wasm,
    },
    'gltf-progressive': {
      'index.html': Buffer.from(page(script('page.js') + preload('base.glb'), '')), 'page.js': bundle(NEEDLE), ...needleFiles(model), ...decoder('draco_decoder.js'), ...wasm,
    },
  };
}

/**
 * Serves files, packed as small as Brotli can where that helps.
 *
 * @param {Record<string, Buffer>} files
 * @returns {Promise<http.Server>}
 */
export async function serve(files) {
  const answers = new Map(Object.entries(files).map(([name, bytes]) => {
    const type = TYPES[name.split('.').at(-1)];
    const small = zlib.brotliCompressSync(bytes);
    const isPacked = small.length < 0.98 * bytes.length;
    const headers = { 'Content-Type': type, 'Content-Length': isPacked ? small.length : bytes.length, 'Cache-Control': 'public, max-age=31536000, immutable' };
    return [`/${name}`, { headers: isPacked ? { ...headers, 'Content-Encoding': 'br' } : headers, body: isPacked ? small : bytes }];
  }));
  const server = http.createServer((request, response) => {
    const answer = answers.get(request.url === '/' ? '/index.html' : request.url);
    response.writeHead(answer === undefined ? 404 : 200, answer?.headers);
    response.end(answer?.body);
  });
  server.keepAliveTimeout = 120_000;
  await new Promise((ready) => server.listen(0, '127.0.0.1', () => ready(undefined)));
  return server;
}
