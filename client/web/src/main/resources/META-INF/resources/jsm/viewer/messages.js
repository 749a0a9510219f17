// @ts-check
// What the page and its worker say to each other.

import { DamagedArchive, OutOfMemory } from './answers.js';
import { DecoderMissing } from './decoder.js';
import { DownloadError } from './download.js';

/** @import { Drawn, Header, Plan } from './decoder.js' */
/** @import { Entry } from './download.js' */

/**
 * An archive and what is known of it.
 *
 * @typedef {object} Archive
 * @property {string} archiveUrl
 * @property {string} [archiveSha256] without which nothing is kept
 * @property {number} [bytes]
 * @property {number} [baseBytes] up to the end of the base
 * @property {string} [meshSha256]
 * @property {boolean} serverPlan whether the server plans what it sends
 */
/** @typedef {{ type: 'open', decoder: string } & Archive} Opening */
/**
 * What the page sends. The first four wait for their turn, and each is answered with `done` or `error`.
 *
 * @typedef {Opening
 *   | { type: 'round', waitMillis: number }
 *   | { type: 'prefix', bytes: number }
 *   | { type: 'complete' }
 *   | { type: 'drawn' }
 *   | { type: 'serverPlan', on: boolean }
 *   | { type: 'stop' }} Wish
 */
/** @typedef {{ message: string, retryable: boolean, changed?: 'another' | 'gone' | null }} Trouble */
/**
 * What the worker posts.
 *
 * @typedef {{ type: 'ready', decoder: 'wasm' | 'js' }
 *   | { type: 'header', header: Header }
 *   | { type: 'plan', plan: Plan }
 *   | { type: 'progress', received: number, bytesPerSecond: number }
 *   | { type: 'texture', path: string, bytes: Uint8Array<ArrayBuffer> }
 *   | { type: 'picture', batches: number, received: number, drawn: Drawn }
 *   | { type: 'request', request: FinishedRequest }
 *   | { type: 'waiting', text: string }
 *   | { type: 'restored', bytes: number }
 *   | { type: 'proving' }
 *   | { type: 'identical', sha256: string }
 *   | { type: 'complete' }
 *   | { type: 'done', complete: boolean }
 *   | { type: 'error' } & Trouble} Message
 */
/** @typedef {Entry & { cached: boolean, at: number }} FinishedRequest */
/** @typedef {(message: Message, transfer?: ArrayBuffer[]) => void} Post */

/**
 * What went wrong, for people.
 *
 * @param {unknown} error
 * @returns {Trouble}
 */
export function inWords(error) {
  const message = error instanceof Error ? error.message : String(error);
  if (error instanceof DecoderMissing || error instanceof OutOfMemory) return { message, retryable: false };
  if (error instanceof DamagedArchive) return { message: `The archive is damaged: ${message}.`, retryable: false };
  if (error instanceof DownloadError) return { message, retryable: error.retryable, changed: error.changed };
  return { message: `The viewer stopped: ${message}.`, retryable: false };
}
