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
 * @property {[first: string, models: number, url: string][]} [pages] first id, size and address of every page, on the first one
 */

/**
 * All models, page after page.
 *
 * @param {CataloguePage} first
 * @param {URL} url of it
 * @param {(count: number, total: number) => void} progress is told after every page but the last
 */
export async function allModels(first, url, progress) {
  /** @type {Model[]} */
  const all = [];
  for (let page = first; ; ) {
    all.push(...page.models);
    if (page.next === undefined) return all;
    progress(all.length, first.total ?? 0);
    url = new URL(page.next, url);
    page = await fetchJson(url);
  }
}
