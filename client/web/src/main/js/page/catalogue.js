// @ts-check
// The list of models of a server or static site.

import { fetchJson } from '../session/manifest.js';

/** @import { Model } from './card-words.js' */

/**
 * A page of the list has at most 1000 models and names the next one.
 *
 * @param {URL} first
 * @param {(count: number, total: number) => void} progress is told after every page but the last
 */
export async function allModels(first, progress) {
  /** @type {Model[]} */
  const all = [];
  let total = 0;
  for (let page = first; ; ) {
    /** @type {{ models: Model[], next?: string, total?: number }} */
    const { models, next, total: told = total } = await fetchJson(page);
    all.push(...models);
    if (next === undefined) return all;
    progress(all.length, (total = told));
    page = new URL(next, page);
  }
}
