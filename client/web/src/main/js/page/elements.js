// @ts-check
// What the page's modules need of the document.

/** @import { Manifest } from '../session/manifest.js' */

/**
 * The element of the page with this id.
 *
 * @param {string} id
 */
export function element(id) {
  return typed(id, HTMLElement);
}

/**
 * The same, of a known kind.
 *
 * @template {HTMLElement} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function typed(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${type.name} with the id ${id}`);
  return found;
}

/**
 * The manifest of the model that the page was made for, with its own address; null on a page for all models.
 *
 * @returns {(Manifest & { manifestUrl: string }) | null}
 */
export function manifestOfPage() {
  const data = document.getElementById('manifest');
  return data === null ? null : JSON.parse(data.textContent ?? '');
}
