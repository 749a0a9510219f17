// @ts-check
// What an element is to show: the address of a manifest, or that of an archive.

import { fetchManifest } from '../session/manifest.js';

/** @import { Access } from '../decode/messages.js' */
/** @import { Manifest } from '../session/manifest.js' */
/**
 * @typedef {object} Source
 * @property {() => Promise<Manifest>} manifest what is known of the archive
 * @property {() => Promise<Manifest>} renew the same, asked of the server anew
 */

/**
 * @param {string} src of a `.jsm` archive, a manifest, or a folder with one; may be relative to the page
 * @param {{ waiting?: (text: string) => void, access?: Access }} [how] `waiting` hears what a busy server says
 * @returns {Source}
 */
export function sourceOf(src, { waiting, access } = {}) {
  const url = addressOf(src);
  if (url.pathname.endsWith('.jsm')) return archiveAt(url);
  const at = url.pathname.endsWith('/') ? new URL('manifest.json', url) : url;
  return { manifest: () => fetchManifest(at, 'default', waiting, access), renew: () => fetchManifest(at, 'reload', undefined, access) };
}

/**
 * An archive without a manifest, whatever its file is called.
 *
 * @param {URL} url
 * @returns {Source}
 */
export function archiveAt(url) {
  const manifest = async () => describe(url);
  return { manifest, renew: manifest };
}

/** @param {string} src */
function addressOf(src) {
  try {
    return new URL(src, document.baseURI);
  } catch {
    throw new Error(`"${src}" is not the address of a model.`);
  }
}

/**
 * What the address of an archive says, without a manifest.
 *
 * @param {URL} url
 * @returns {Manifest}
 */
function describe(url) {
  const file = url.pathname.replace(/^.*\//, '').replace(/\.jsm$/, '');
  const archiveSha256 = /^[0-9a-f]{64}$/.test(file) ? file : undefined;
  try {
    return { archiveUrl: url.href, archiveSha256, name: decodeURIComponent(file) };
  } catch {
    return { archiveUrl: url.href, archiveSha256, name: file };
  }
}
