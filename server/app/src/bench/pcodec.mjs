// @ts-check
// pcodec, a codec for columns of numbers, through Python: lossless positions beside meshoptimizer's codec for the faces.

import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { meshoptOrder, zstd } from './codecs.mjs';
import { temporary } from './model.mjs';

const script = path.join(path.dirname(fileURLToPath(import.meta.url)), 'columns.py');
const ABSENT = 3;
let isAbsent = false;

/** Bytes of positions and faces, in meshoptimizer's order; undefined where there is no pcodec. */
export function pcodecBytes(model, python) {
  if (isAbsent) return undefined;
  const { moved, faces } = meshoptOrder(model);
  const points = temporary(`${model.name}.points`);
  fs.writeFileSync(points, moved);
  const { status, error, stdout, stderr } = spawnSync(python, [script, points], { encoding: 'utf8' });
  if (status === 0) return Number(stdout) + zstd(faces).length;
  if (status !== ABSENT && /** @type {NodeJS.ErrnoException | undefined} */ (error)?.code !== 'ENOENT') throw new Error(`columns.py: ${error ?? stderr}`);
  isAbsent = true;
  console.error(`${python} has no pcodec, so its column stays empty: pip install pcodec, or name another Python by --python=PATH`);
  return undefined;
}
