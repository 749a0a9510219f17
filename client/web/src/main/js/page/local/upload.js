// @ts-check
// Sends a model to the server, and hears how far its encoding is.

import { fetchJson, wordsOf } from '../../session/manifest.js';

/** @typedef {(text: string, fraction: number | null) => void} Tell how far it is */
/** @typedef {{ state: string, stage?: string, fraction?: number, error?: string, remedy?: string, manifestUrl?: string }} Status */

const LONGEST_ID = 80;
const STATUS_MILLIS = 700;

/**
 * Whether the server takes models.
 *
 * @param {URL} modelsUrl
 */
export async function takesModels(modelsUrl) {
  try {
    const { ok, headers } = await fetch(new URL('model', modelsUrl), { method: 'OPTIONS', cache: 'no-store' });
    return ok && /\bPOST\b/.test(headers.get('Allow') ?? '');
  } catch {
    return false;
  }
}

/** The id that a server would give a file. @param {string} fileName */
export function idOf(fileName) {
  const stem = fileName.replace(/^.*\//, '').replace(/\.gz$/i, '').replace(/\.[^.]*$/, '');
  const plain = stem.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
  const id = plain.replace(/[^a-z0-9]+/g, '-').slice(0, LONGEST_ID).replace(/^-|-$/g, '');
  return id === '' ? 'model' : id;
}

/**
 * Sends a model; resolves to the address of its status.
 *
 * @param {URL} url of the model
 * @param {Blob} body
 * @param {{ fileName: string, token: string, tell: Tell, signal: AbortSignal }} how
 * @returns {Promise<URL>}
 */
export function send(url, body, { fileName, token, tell, signal }) {
  const address = new URL(url);
  // The server looks at the extension alone.
  address.search = `name=model${/\.[a-z0-9]+(\.gz)?$/i.exec(fileName)?.[0] ?? ''}`;
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    const fail = (/** @type {string} */ text) => reject(new Error(text));
    request.upload.onprogress = ({ loaded, total }) => tell('Sending', loaded / total);
    request.onerror = () => fail('The server cannot be reached, or broke the connection. Send the model again.');
    request.onload = () => {
      const location = request.getResponseHeader('Location');
      if (request.status === 202 && location !== null) resolve(new URL(location, url));
      else if (request.status === 401) fail('The server does not know this token. Ask whoever runs the server for one.');
      else fail(wordsOf(parsed(request.responseText)) ?? `The server answered with status ${request.status}.`);
    };
    signal.addEventListener('abort', () => {
      request.abort();
      reject(signal.reason);
    });
    request.open('POST', address);
    request.setRequestHeader('Authorization', `Bearer ${token}`);
    request.setRequestHeader('Accept', 'application/json');
    request.send(body);
  });
}

/** @param {string} text */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}

/**
 * Resolves to the address of the model's page when it is encoded.
 *
 * @param {URL} statusUrl
 * @param {{ tell: Tell, signal: AbortSignal }} how
 * @returns {Promise<URL>}
 */
export async function encoded(statusUrl, { tell, signal }) {
  for (;;) {
    /** @type {Status} */
    const status = await fetchJson(statusUrl, 'no-store');
    if (signal.aborted) throw signal.reason;
    if (status.state === 'failed') throw new Error(wordsOf(status) ?? 'The model could not be encoded.');
    if (status.state === 'ready') {
      const manifestUrl = new URL(status.manifestUrl ?? 'manifest.json', statusUrl);
      return new URL(`.${manifestUrl.search}`, manifestUrl); // a signature opens the page, too
    }
    tell(status.state === 'queued' ? 'Waiting for other models' : `Encoding: ${status.stage ?? ''}`, status.fraction ?? null);
    await new Promise((resolve) => setTimeout(resolve, STATUS_MILLIS));
  }
}
