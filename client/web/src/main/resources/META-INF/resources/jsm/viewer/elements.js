// @ts-check
// What the page's modules need of the document.

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

/** @param {unknown} error */
export function messageOf(error) {
  return error instanceof Error ? error.message : String(error);
}
