// @ts-check
// The simplifiers of meshoptimizer, as WebAssembly from its npm package.

import { MeshoptSimplifier } from 'meshoptimizer';

await MeshoptSimplifier.ready;

/** What still comes down by less than this in a step is stuck. */
const STUCK = 0.98;
/** More than this times the faces wanted is not reached. */
const REACHED = 1.1;

/**
 * meshoptimizer's simplification to a number of faces, without a limit on the error: vertices stay where they are. Small
 * parts may vanish only where it cannot come down to that number otherwise.
 */
export function simplify({ positions, indices }, faces) {
  let [left] = MeshoptSimplifier.simplify(indices, positions, 3, 3 * faces, 1);
  if (left.length > 3 * REACHED * faces) [left] = MeshoptSimplifier.simplify(indices, positions, 3, 3 * faces, 1, ['Prune']);
  return compact(positions, left);
}

/** Meshes of one model that have been halved so many times, each from the one before. */
const halved = new WeakMap();

/**
 * The strongest that meshoptimizer has: `simplifyWithUpdate`, which moves the vertices that stay, from half to half of the
 * faces, which is closer than in one go. Small parts vanish as above.
 */
export function simplifyInSteps(model, faces) {
  if (!halved.has(model)) halved.set(model, [{ positions: model.positions, indices: model.indices }]);
  const steps = halved.get(model);
  let from = 0;
  while (steps[from].indices.length > 6 * faces) {
    if (from + 1 === steps.length) {
      const next = step(steps[from], Math.floor(steps[from].indices.length / 6));
      if (next.indices.length >= STUCK * steps[from].indices.length) break;
      steps.push(next);
    }
    from++;
  }
  const { positions, indices } = steps[from].indices.length > 3 * faces ? step(steps[from], faces) : steps[from];
  return compact(positions, indices);
}

function step({ positions, indices }, faces) {
  const result = update(positions, indices, faces, []);
  return result.indices.length > 3 * REACHED * faces ? update(positions, indices, faces, ['Prune']) : result;
}

function update(positions, indices, faces, flags) {
  const moved = positions.slice();
  const left = indices.slice();
  const [count] = MeshoptSimplifier.simplifyWithUpdate(left, moved, 3, new Float32Array(0), 0, [], null, 3 * faces, 1, flags);
  return { positions: moved, indices: left.slice(0, count) };
}

/** Without the vertices that no face uses; the indices are changed. */
function compact(positions, indices) {
  const left = indices.slice();
  const [remap, unique] = MeshoptSimplifier.compactMesh(left);
  const kept = new Float32Array(3 * unique);
  for (let v = 0; v < remap.length; v++) {
    if (remap[v] !== 0xffffffff) kept.set(positions.subarray(3 * v, 3 * v + 3), 3 * remap[v]);
  }
  return { positions: kept, indices: left };
}

/** What a simplifier makes with as nearly so many faces as a few tries come: the target that it is given is moved by what it misses. */
export function simplifyToCount(simplifier, model, faces) {
  let best = simplifier(model, faces);
  let target = faces;
  const miss = ({ indices }) => Math.abs(indices.length / 3 - faces);
  let last = best;
  for (let i = 0; i < 4 && miss(best) > 0.03 * faces; i++) {
    target = Math.max(1, target + faces - last.indices.length / 3);
    last = simplifier(model, target);
    if (last.indices.length > 0 && miss(last) < miss(best)) best = last;
  }
  return best;
}
