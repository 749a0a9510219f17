// @ts-check
// A ZIP archive whose files are stored as they are.

import { crc32 } from '../../decode/crc32.js';

/** The first of January 1980, the first day that the format knows. */
const DAY = 0x21;
const VERSION = 20;
/** Names are UTF-8. */
const FLAGS = 0x800;
const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;

/**
 * @param {{ name: string, bytes: Uint8Array<ArrayBuffer> }[]} files of less than 4 GiB together; a name has `/` between its parts
 * @returns {Blob}
 */
export function zipOf(files) {
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const index = [];
  let at = 0;
  for (const { name, bytes } of files) {
    const path = new TextEncoder().encode(name);
    /** What both heads have. */
    const common = [[VERSION, 2], [FLAGS, 2], [0, 2], [0, 2], [DAY, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4], [path.length, 2], [0, 2]];
    const head = numbers([LOCAL, 4], ...common);
    parts.push(head, path, bytes);
    index.push(numbers([CENTRAL, 4], [VERSION, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]), path);
    at += head.length + path.length + bytes.length;
  }
  const length = index.reduce((sum, part) => sum + part.length, 0);
  const end = numbers([END, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [length, 4], [at, 4], [0, 2]);
  return new Blob([...parts, ...index, end], { type: 'application/zip' });
}

/** Little-endian. @param {...number[]} pairs each a number and its bytes */
function numbers(...pairs) {
  const bytes = new Uint8Array(pairs.reduce((sum, [, length]) => sum + length, 0));
  let at = 0;
  for (const [value, length] of pairs) {
    for (let i = 0; i < length; i++) bytes[at++] = value >>> (8 * i);
  }
  return bytes;
}
