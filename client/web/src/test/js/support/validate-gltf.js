// Validates glTF files with Khronos' validator, for the encoder's tests. Prints an object with the errors of each file
// that has any: arrays of code, place and message.

import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { basename, dirname, resolve } from 'node:path';

const validator = createRequire(import.meta.url)('gltf-validator');

/** @param {string} file */
async function errors(file) {
  const report = await validator.validateBytes(new Uint8Array(await readFile(file)), {
    uri: basename(file),
    maxIssues: 0,
    externalResourceFunction: async (/** @type {string} */ uri) =>
      new Uint8Array(await readFile(resolve(dirname(file), decodeURIComponent(uri)))),
  });
  return report.issues.messages
    .filter((/** @type {{severity: number}} */ issue) => issue.severity === 0)
    .map((/** @type {{code: string, pointer: string, message: string}} */ e) => `${e.code} ${e.pointer} ${e.message}`);
}

/** @type {Record<string, string[]>} */
const found = {};
// One file per line: a command line has room for fewer than there may be.
for (const file of (await readFile(process.argv[2], 'utf8')).trim().split(/\r?\n/)) {
  const list = await errors(file);
  if (list.length > 0) found[basename(file)] = list;
}
console.log(JSON.stringify(found));
