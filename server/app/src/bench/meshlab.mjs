// @ts-check
// MeshLab's quadric edge collapse, through Python.

import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { temporary } from './model.mjs';

const script = path.join(path.dirname(fileURLToPath(import.meta.url)), 'meshlab.py');
const ABSENT = 3;
let isAbsent = false;

/** Files of a model with so many faces each; undefined where there is no pymeshlab. */
export function meshlab(model, targets, python) {
  const outputs = targets.map((faces) => temporary(`${model.name}.meshlab.${faces}.ply`));
  if (!isAbsent) isAbsent = !simplify(python, [model.ply, ...targets.flatMap((faces, i) => [String(faces), outputs[i]])]);
  return outputs.map((ply) => (isAbsent ? undefined : ply));
}

function simplify(python, args) {
  const { status, error, stderr } = spawnSync(python, [script, ...args], { encoding: 'utf8' });
  if (status === 0) return true;
  if (status !== ABSENT && /** @type {NodeJS.ErrnoException | undefined} */ (error)?.code !== 'ENOENT') throw new Error(`meshlab.py: ${error ?? stderr}`);
  console.error(`${python} has no pymeshlab, so there are no columns of MeshLab: pip install pymeshlab, or name another Python by --python=PATH`);
  return false;
}
