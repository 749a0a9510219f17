// @ts-check
// Asks the server for JSON, and says in words what it answers instead.

import { BACKOFF_MILLIS, inWords as waitInWords, pause, retryAfterMillis } from './retry.js';

/**
 * What a server says of a model.
 *
 * @typedef {object} Manifest
 * @property {string} archiveUrl
 * @property {string} [firstUrl] of the archive's first bytes
 * @property {number} [firstBytes] how many those are
 * @property {string} [archiveSha256]
 * @property {string} [id]
 * @property {string} [name]
 * @property {number} [bytes]
 * @property {number} [faces]
 * @property {number} [baseBytes]
 * @property {string} [meshSha256]
 * @property {string} [modelSha256] of mesh and pictures
 * @property {string} [posterUrl] of a picture of the model
 * @property {string} [annotationsUrl] of what people wrote about the model, relative to the archive's
 * @property {string} [sourceFormat] of the model file, such as `PLY` or `GLB`
 * @property {{ offset: number, bytes: number }[]} [batches]
 */
/** @import { Access } from '../decode/messages.js' */
/** @typedef {(text: string) => void} Waiting told in words before another try */

/** A server that prepares a model is not asked again sooner. */
const LEAST_MILLIS = 500;

export class ServerError extends Error {}

/**
 * Asks again as long as a busy server says when, and until a server has encoded the model.
 *
 * @param {string | URL} url
 * @param {RequestCache} cache `reload` asks the server although an answer is kept
 * @param {Waiting} waiting
 * @param {Access & { signal?: AbortSignal }} access
 * @returns {Promise<any>}
 */
export async function fetchJson(url, cache = 'default', waiting = () => {}, access = {}) {
  let response = await ask(url, cache, access);
  for (let attempt = 1; ; ) {
    const millis = retryAfterMillis(response);
    const isPreparing = response.status === 202;
    if (!isPreparing && (millis === 0 || attempt > BACKOFF_MILLIS.length)) break;
    waiting(isPreparing ? preparingInWords(await response.json().catch(() => null)) : waitInWords(millis, attempt));
    await pause(Math.max(millis, isPreparing ? LEAST_MILLIS : BACKOFF_MILLIS[attempt++ - 1]));
    response = await ask(url, cache, access);
  }
  // A static host may not know the type of JSON, and answers errors with a page.
  const body = await response.json().catch(() => null);
  // What a server advises when there is no such model is for those who publish it.
  if (!response.ok) throw new ServerError((response.status === 404 ? null : wordsOf(body)) ?? refusal(response.status));
  if (body === null) throw new ServerError('The server sent something that is not a description of models.');
  return body;
}

/**
 * What a server does that has to encode a model first.
 *
 * @param {{ stage?: string, fraction?: number } | null} state
 */
function preparingInWords(state) {
  const percent = Math.round(100 * Number(state?.fraction ?? 0));
  return `The server is preparing this model${state?.stage ? `: ${state.stage}, ${percent}%` : ''}`;
}

/**
 * @param {string | URL} url
 * @param {RequestCache} cache
 * @param {Access & { signal?: AbortSignal }} access
 */
async function ask(url, cache, { credentials, headers, signal }) {
  try {
    return await fetch(url, { cache, credentials, signal, headers: { ...headers, Accept: 'application/json' } });
  } catch {
    throw new ServerError('The server cannot be reached.');
  }
}

/** @param {number} status */
function refusal(status) {
  return status === 404 ? 'There is no such model here.' : `The server answered with status ${status}.`;
}

/**
 * The server's errors say what is wrong and what to do.
 *
 * @param {{ error?: unknown, remedy?: string } | null} body
 */
export function wordsOf(body) {
  if (typeof body?.error !== 'string') return null;
  const sentence = (/** @type {string} */ text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
  return body.remedy ? `${sentence(body.error)} ${sentence(body.remedy)}` : sentence(body.error);
}

/**
 * A manifest with absolute addresses.
 *
 * @param {string | URL} url
 * @param {RequestCache} [cache]
 * @param {Waiting} [waiting]
 * @param {Access} [access]
 */
export async function fetchManifest(url, cache, waiting, access) {
  /** @type {Manifest} */
  const manifest = await fetchJson(url, cache, waiting, access);
  return absolute(manifest, url);
}

/**
 * The manifest with absolute addresses.
 *
 * @param {Manifest} manifest
 * @param {string | URL} url of the manifest
 * @returns {Manifest}
 */
export function absolute(manifest, url) {
  const from = (/** @type {string} */ address) => new URL(address, url).href;
  const { archiveUrl, firstUrl, posterUrl } = manifest;
  return { ...manifest, archiveUrl: from(archiveUrl), ...(firstUrl && { firstUrl: from(firstUrl) }), ...(posterUrl && { posterUrl: from(posterUrl) }) };
}

/**
 * Whether a model has another archive now.
 *
 * @param {Manifest} now
 * @param {Manifest} before
 * @param {boolean} isGone whether the archive is no longer where it was
 */
export function isAnother(now, before, isGone) {
  if (isGone && now.archiveUrl !== before.archiveUrl) return true;
  return now.archiveSha256 === undefined ? !isGone : now.archiveSha256 !== before.archiveSha256;
}
