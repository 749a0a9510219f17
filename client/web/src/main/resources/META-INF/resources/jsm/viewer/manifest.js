// @ts-check
// Asks the server for JSON, and says in words what it answers instead.

import { BACKOFF_MILLIS, inWords as waitInWords, pause, retryAfterMillis } from './retry.js';

/**
 * What a server says of a model.
 *
 * @typedef {object} Manifest
 * @property {string} archiveUrl
 * @property {string} [archiveSha256]
 * @property {string} [id]
 * @property {string} [name]
 * @property {number} [bytes]
 * @property {number} [faces]
 * @property {number} [baseBytes]
 * @property {string} [meshSha256]
 * @property {{ offset: number, bytes: number }[]} [batches]
 */
/** @typedef {(text: string) => void} Waiting told in words before another try */

export class ServerError extends Error {}

/**
 * Asks again as long as a busy server says when.
 *
 * @param {string | URL} url
 * @param {RequestCache} cache `reload` asks the server although an answer is kept
 * @param {Waiting} waiting
 * @returns {Promise<any>}
 */
export async function fetchJson(url, cache = 'default', waiting = () => {}) {
  let response = await ask(url, cache);
  for (let attempt = 1; attempt <= BACKOFF_MILLIS.length && retryAfterMillis(response) > 0; attempt++) {
    const millis = retryAfterMillis(response);
    waiting(waitInWords(millis, attempt));
    await pause(Math.max(millis, BACKOFF_MILLIS[attempt - 1]));
    response = await ask(url, cache);
  }
  // A static host may not know the type of JSON, and answers errors with a page.
  const body = await response.json().catch(() => null);
  if (!response.ok) throw new ServerError(inWords(body) ?? refusal(response.status));
  if (body === null) throw new ServerError('The server sent something that is not a description of models.');
  return body;
}

/**
 * @param {string | URL} url
 * @param {RequestCache} cache
 */
async function ask(url, cache) {
  try {
    return await fetch(url, { cache, headers: { Accept: 'application/json' } });
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
function inWords(body) {
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
 */
export async function fetchManifest(url, cache, waiting) {
  /** @type {Manifest} */
  const manifest = await fetchJson(url, cache, waiting);
  manifest.archiveUrl = new URL(manifest.archiveUrl, url).href;
  return manifest;
}
