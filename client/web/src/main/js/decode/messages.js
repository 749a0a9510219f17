// @ts-check
// What the page and its worker say to each other.

import { DamagedArchive, DecoderMissing, OutOfMemory } from './answers.js';
import { DownloadError } from './download.js';

/** @import { Changes, Plan } from './decoder.js' */
/** @import { Header } from '../session/header.js' */
/** @import { Entry } from './download.js' */

/**
 * How a host is asked.
 *
 * @typedef {object} Access
 * @property {RequestCredentials} [credentials]
 * @property {Record<string, string>} [headers]
 */
/**
 * An archive and what is known of it.
 *
 * @typedef {object} Archive
 * @property {string} archiveUrl
 * @property {string} [archiveSha256] without which nothing is kept
 * @property {string} [firstUrl] of its first bytes, which caches keep and the page may have asked for already
 * @property {number} [firstBytes] how many those are
 * @property {number} [bytes]
 * @property {number} [baseBytes] up to the end of the base
 * @property {string} [meshSha256]
 * @property {string} [modelSha256] of mesh and pictures
 * @property {boolean} serverPlan whether the server plans what it sends
 * @property {Access} [access]
 * @property {number} [mostFaces] after which refinement stops; all of them without it
 * @property {number[]} [link] what the page's files tell of it, as `linkTo` has it
 */
/** @typedef {{ type: 'open', id?: number, decoder: string } & Archive} Opening */
/**
 * What the page sends. The first five wait for their turn, and each is answered with `done` and its number, or `error`. What was `used` goes back, so that no
 * frame of the page has to free it.
 *
 * @typedef {Opening
 *   | { type: 'round', id?: number, waitMillis: number }
 *   | { type: 'prefix', id?: number, bytes: number }
 *   | { type: 'complete', id?: number }
 *   | { type: 'prepare', id?: number }
 *   | { type: 'drawn', used?: Uint32Array }
 *   | { type: 'serverPlan', on: boolean }
 *   | { type: 'limit', bytesPerSecond: number }
 *   | { type: 'mostFaces', faces: number }
 *   | { type: 'stop' }
 *   | { type: 'close' }} Wish
 */
/** @typedef {{ message: string, retryable: boolean, changed?: 'another' | 'gone' | null }} Trouble */
/**
 * What the worker posts. `ready` says which decoder decodes, and comes again when another one takes over.
 *
 * @typedef {{ type: 'ready', decoder: 'wasm' | 'js' }
 *   | { type: 'header', header: Header }
 *   | { type: 'plan', plan: Plan }
 *   | { type: 'progress', received: number, bytesPerSecond: number, decodeMillis: number }
 *   | { type: 'texture', paths: string[], bytes: Uint8Array<ArrayBuffer> }
 *   | { type: 'picture', batches: number, received: number, changes: Changes }
 *   | { type: 'request', request: FinishedRequest }
 *   | { type: 'waiting', text: string }
 *   | { type: 'restored', bytes: number }
 *   | { type: 'proving' }
 *   | { type: 'proved', meshSha256: string, modelSha256: string }
 *   | { type: 'complete' }
 *   | { type: 'full' }
 *   | { type: 'done', id?: number, complete: boolean }
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
