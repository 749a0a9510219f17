// @ts-check
// Writes the original of an archive as a model file, and encodes model files, with the project's own Java code.

import { DamagedArchive, valueOf } from '../../decode/answers.js';
import { loadWebAssembly, compile } from '../../decode/decoder-wasm.js';
import { inWords } from '../../decode/messages.js';
import { messageOf } from '../../session/errors.js';
import { ArchiveBytes } from '../../levels/archive-bytes.js';

/** @import { Place } from '../../levels/archive-bytes.js' */
/** @typedef {{ path: string, file: Blob }} Given */
/**
 * @typedef {{ place: Place, bytes: number, fileName: string }} Decoding an archive of so many bytes, and the name of the model file, which tells its format
 * @typedef {{ model: string, given: Given[], mostFaces: number }} Encoding the path of the model file among those that are given
 * @typedef {Decoding | Encoding} Work
 */
/** @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} MadeFile */
/** @typedef {{ stage: string, fraction: number }} Progress of an encoding: what is being done, and how far that is, 0 to 1 */
/** @typedef {{ files: MadeFile[], notes: string[] }} Made the first one is the model or the archive; notes say what it does not hold */

const MODULE = new URL('../../decoder/workshop.wasm', import.meta.url);
const ARCHIVE = 'archive.jsm';
/** The page hears no more often how far it is. */
const PAUSE_MILLIS = 100;
/**
 * What the workshop imports beside what decoders do. It has one thread, so nothing ever waits.
 *
 * @param {(fraction: number) => void} progress
 */
const glueOf = (progress) => ({ teavmMath: Math, teavmAsync: { offer: () => 0 }, workshop: { progress } });

/** What WorkshopMain exports: each method but `staging` answers JSON. */
class Workshop {
  /** @param {any} java */
  constructor(java) {
    this.java = java;
  }

  /** @param {string} path @param {Uint8Array} bytes */
  give(path, bytes) {
    valueOf(() => this.java.begin(path, bytes.length));
    for (let at = 0; at < bytes.length; ) {
      const staging = this.java.staging();
      const part = bytes.subarray(at, at + staging.length);
      staging.set(part);
      valueOf(() => this.java.append(part.length));
      at += part.length;
    }
  }

  /** @param {number} file @param {number} length */
  take(file, length) {
    const bytes = new Uint8Array(length);
    for (let at = 0; at < length; ) {
      const left = valueOf(() => this.java.copy(file, at));
      const { buffer, byteOffset, byteLength } = this.java.staging();
      const part = new Uint8Array(buffer, byteOffset, Math.min(left, byteLength));
      bytes.set(part, at);
      at += part.length;
    }
    return bytes;
  }
}

/**
 * @param {Workshop} shop
 * @param {Work} work
 */
async function answer(shop, work) {
  if ('model' in work) {
    for (const { path, file } of work.given) shop.give(path, new Uint8Array(await file.arrayBuffer()));
    return valueOf(() => shop.java.encode(work.model, work.mostFaces));
  }
  const archive = new ArchiveBytes(work.place);
  await archive.reach(work.bytes);
  shop.give(ARCHIVE, archive.part(0, work.bytes));
  return valueOf(() => shop.java.decode(ARCHIVE, work.fileName));
}

addEventListener('message', async (/** @type {MessageEvent<Work>} */ { data }) => {
  try {
    let toldAt = -Infinity;
    const glue = glueOf((fraction) => {
      const now = performance.now();
      if (now - toldAt < PAUSE_MILLIS) return;
      toldAt = now;
      postMessage({ stage: valueOf(() => shop.java.stage()), fraction });
    });
    const shop = new Workshop(await loadWebAssembly(await compile(MODULE), glue));
    /** @type {{ files: { name: string, bytes: number }[], notes: string[] }} */
    const { files, notes } = await answer(shop, data);
    const made = files.map(({ name, bytes }, file) => ({ name, bytes: shop.take(file, bytes) }));
    postMessage({ files: made, notes }, { transfer: made.map(({ bytes }) => bytes.buffer) });
  } catch (error) {
    postMessage({ error: 'model' in data ? inWordsOfReader(error) : inWords(error).message });
  }
});

/** What a reader says of a model file has its place, reason and remedy already. @param {unknown} error */
function inWordsOfReader(error) {
  if (error instanceof DamagedArchive) return error.message;
  return `${messageOf(error)}. Encode the model with jsm encode, and drop the .jsm file here.`;
}
