import assert from 'node:assert/strict';
import test from 'node:test';
import * as THREE from 'three';
import { MeshArrays } from '../../main/js/session/mesh-arrays.js';
import { RefinedMesh } from '../../main/js/three/refined-mesh.js';

const [NO_ERROR, INVALID_ENUM, OUT_OF_MEMORY] = [0, 0x500, 0x505];

/** A mesh, and a renderer whose graphics card has these errors to tell. @param {number[]} errors */
function prepare(errors) {
  let asked = 0;
  let lacks = 0;
  const getError = () => {
    asked++;
    return errors.shift() ?? NO_ERROR;
  };
  const renderer = /** @type {any} */ ({ getContext: () => ({ getError, NO_ERROR, OUT_OF_MEMORY, CONTEXT_LOST_WEBGL: 0x9242 }) });
  const mesh = new RefinedMesh(new THREE.Group(), false, () => lacks++);
  const arrays = new MeshArrays();
  const show = async (/** @type {number} */ step, vertices = 3) => {
    const ranges = Uint32Array.of(0, 0, 9);
    arrays.take({ step, jump: false, batches: 1, faces: 1, vertices, places: 1, groups: [0, 0, 3], tangents: [], ranges, data: new Uint32Array(9) });
    mesh.update(arrays);
    const { object } = mesh;
    /** @type {any} */ (object).onAfterRender(renderer);
    const [before] = [lacks];
    await Promise.resolve();
    return { before, lacks };
  };
  return { show, asked: () => asked };
}

test('says after its first picture that there was no memory for its buffers', async () => {
  const { show } = prepare([INVALID_ENUM, OUT_OF_MEMORY]);
  assert.deepEqual(await show(1), { before: 0, lacks: 1 });
});

test('asks the graphics card for errors when there are other buffers, not in each picture', async () => {
  const { show, asked } = prepare([]);
  for (let step = 1; step < 5; step++) assert.equal((await show(step)).lacks, 0);
  assert.equal(asked(), 1);
  await show(5, 40);
  assert.equal(asked(), 2);
});
