// @ts-check
// gltfpack, as WebAssembly from its npm package; without it, its columns stay empty.

import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const cli = path.join(path.dirname(fileURLToPath(import.meta.url)), 'node_modules/gltfpack/cli.js');
const isThere = fs.existsSync(cli);
if (!isThere) console.error('gltfpack is not installed (npm install --prefix server/app/src/bench): skipped');

/** Without compression of its own, and with its three kinds. */
export const GLTFPACK_MODES = ['', '-c', '-cc', '-cz'];

/** Packs with unquantized attributes, all of them, and materials as they are. False when gltfpack is not installed. */
export function gltfpack(input, output, mode) {
  if (!isThere) return false;
  const options = ['-noq', '-kv', '-km', '-ke', ...(mode === '' ? [] : [mode])];
  execFileSync(process.execPath, [cli, '-i', input, '-o', output, ...options], { stdio: ['ignore', 'ignore', 'inherit'] });
  return true;
}
