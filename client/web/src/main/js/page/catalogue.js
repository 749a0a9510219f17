// @ts-check
// The list of models of a server or static site.

import { fetchJson } from '../session/manifest.js';

/** @import { Model } from './card-words.js' */
/**
 * At most 1000 models in the order of their ids.
 *
 * @typedef {object} CataloguePage
 * @property {Model[]} models
 * @property {string} [next] address of the following page
 * @property {number} [total] of all pages, on the first one
 * @property {[first: string, models: number, url: string][]} [pages] first id, size and address of every following page, on the first one
 */

/**
 * All models, page after page.
 *
 * @param {CataloguePage} first
 * @param {URL} url of it
 * @param {(count: number, total: number) => void} progress is told after every page but the last
 */
export async function allModels(first, url, progress) {
  const { total = 0, pages } = first;
  const all = [...first.models];
  for (let page = first, i = 0; ; i++) {
    const next = pages === undefined ? page.next : pages[i]?.[2];
    if (next === undefined) return all;
    progress(all.length, total);
    url = new URL(next, url);
    page = await fetchJson(url);
    all.push(...page.models);
  }
}
