// @ts-check
// A catalogue that is too long to be loaded whole: its pages come as somebody looks at them, and the index of pages tells where a name is.

import { fetchJson } from '../../session/manifest.js';

/** @import { Model } from '../card-words.js' */
/** @import { CataloguePage } from '../catalogue.js' */

/** How long nobody scrolls before pages are asked for, which would be passed by otherwise. */
const REST_MILLIS = 100;
/** Pages that are kept: a thousand models each. */
const MOST_KEPT = 16;
/** Pages that are on the screen at a time. */
const MOST_SEEN = 3;
/** Behind every letter. */
const END = '\uffff';

/** @typedef {{ models: Promise<Model[]>, here?: Model[], stop: AbortController }} Page */

/** The models in the order of their ids, as far as they are here. */
export class Pages {
  total = 0;
  #url;
  /** @type {NonNullable<CataloguePage['pages']>} */
  #index = [];
  /** The number of models before each page. @type {number[]} */
  #starts = [];
  /** By their numbers, those first that were used longest ago. @type {Map<number, Page>} */
  #pages = new Map();
  /** Models that are not here yet, by their places. @type {Map<number, Model>} */
  #blanks = new Map();
  /** Those that are looked at, and will be asked for soon. @type {Set<number>} */
  #wanted = new Set();
  /** Those that were asked for last, to be looked at and to find something. @type {[Set<number>, Set<number>]} */
  #asked = [new Set(), new Set()];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #changed;
  #renewed;
  /** @type {Promise<boolean> | undefined} */
  #renewal;

  /**
   * @param {CataloguePage} first
   * @param {URL} url of it
   * @param {(failure?: unknown) => void} changed is told when models have come, or cannot come
   * @param {() => void} renewed is told when the list is another one: what was found and shown of it means nothing any more
   */
  constructor(first, url, changed, renewed = () => {}) {
    this.#url = url;
    this.#changed = changed;
    this.#renewed = renewed;
    this.#begin(first);
  }

  /** @param {CataloguePage} first */
  #begin({ total = 0, models, pages = [] }) {
    for (const { stop } of this.#pages.values()) stop.abort();
    this.#pages.clear();
    this.#blanks.clear();
    this.#wanted.clear();
    this.#asked = [new Set(), new Set()];
    this.total = total;
    this.#index = indexOf(models, pages, this.#url);
    this.#starts = [];
    let start = 0;
    for (const [, count] of this.#index) {
      this.#starts.push(start);
      start += count;
    }
    if (models.length > 0) this.#pages.set(0, { models: Promise.resolve(models), here: models, stop: new AbortController() });
  }

  /** Begins anew if the list has changed since. */
  #renew() {
    this.#renewal ??= fetchJson(this.#url, 'no-cache')
      .then((/** @type {CataloguePage} */ first) => {
        if (String(indexOf(first.models, first.pages, this.#url)) === String(this.#index)) return false;
        this.#begin(first);
        this.#renewed();
        return true;
      })
      .catch(() => false)
      .finally(() => (this.#renewal = undefined));
    return this.#renewal;
  }

  /**
   * The models in a part of the list, as a list knows them.
   *
   * @param {number} from
   * @param {number} to
   */
  part(from, to) {
    return { length: to - from, at: (/** @type {number} */ i) => this.#at(from + i), indexOf: (/** @type {Model} */ model) => this.#placeOf(model) - from };
  }

  /** @param {number} place */
  #at(place) {
    const number = last(this.#starts, (start) => start <= place);
    const model = this.#pages.get(number)?.here?.[place - this.#starts[number]];
    if (model !== undefined) return model;
    this.#want(number);
    const blank = this.#blanks.get(place) ?? { id: '' };
    this.#blanks.set(place, blank);
    return blank;
  }

  /** @param {Model} model */
  #placeOf(model) {
    for (const [place, blank] of this.#blanks) if (blank === model) return place;
    const number = last(this.#index, ([first]) => first <= model.id);
    const at = this.#pages.get(number)?.here?.indexOf(model) ?? -1;
    return at < 0 ? -Infinity : this.#starts[number] + at;
  }

  /** @param {number} number */
  #want(number) {
    if (this.#pages.get(number)?.here !== undefined) return;
    this.#wanted.delete(number);
    this.#wanted.add(number);
    // Whoever scrolls fast sees the last ones.
    for (const passed of this.#wanted) if (this.#wanted.size > MOST_SEEN) this.#wanted.delete(passed);
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#fetchWanted(), REST_MILLIS);
  }

  #fetchWanted() {
    this.#asked[0] = this.#wanted;
    this.#wanted = new Set();
    this.#blanks.clear();
    this.#giveUp();
    for (const number of this.#asked[0]) this.#load(number).models.then(() => this.#changed(), this.#changed);
  }

  /** What nobody wants any more. */
  #giveUp() {
    for (const [number, { here, stop }] of this.#pages) {
      if (here !== undefined || this.#asked.some((asked) => asked.has(number))) continue;
      stop.abort();
      this.#pages.delete(number);
    }
  }

  /** @param {number} number */
  #load(number) {
    const known = this.#pages.get(number);
    if (known !== undefined) {
      this.#pages.delete(number);
      this.#pages.set(number, known);
      return known;
    }
    const stop = new AbortController();
    const models = this.#fetch(this.#index[number], stop.signal).then(
      (rows) => (page.here = rows),
      async (error) => {
        if (this.#pages.get(number) === page) this.#pages.delete(number);
        const isVain = stop.signal.aborted || (await this.#renew());
        throw isVain ? new DOMException('nobody wants it', 'AbortError') : error;
      },
    );
    /** @type {Page} */
    const page = { models, stop };
    this.#pages.set(number, page);
    for (const [oldest, { here }] of this.#pages) {
      if (this.#pages.size <= MOST_KEPT) break;
      if (here !== undefined && oldest > 0) this.#pages.delete(oldest);
    }
    return page;
  }

  /** The models of a page. @param {[first: string, count: number, url: string]} row of the index @param {AbortSignal} signal */
  async #fetch([first, count, url], signal) {
    /** @type {CataloguePage} */
    const { models } = await fetchJson(new URL(url, this.#url), 'default', undefined, { signal });
    if (models.length !== count || models[0]?.id !== first) throw new Error('A page of the list is not what the index says.');
    return models;
  }

  /**
   * Where the ids are that begin with a text: two pages are asked for at most.
   *
   * @param {string} prefix
   * @returns {Promise<[from: number, to: number]>}
   */
  async find(prefix) {
    const ends = [prefix, prefix + END].map((text) => ({ text, number: last(this.#index, ([first]) => first < text) }));
    this.#asked[1] = new Set(prefix === '' ? [] : ends.map(({ number }) => number));
    this.#giveUp();
    if (prefix === '') return [0, this.total];
    return /** @type {[number, number]} */ (await Promise.all(ends.map((end) => this.#bound(end))));
  }

  /** The number of ids before a text. @param {{ text: string, number: number }} end */
  async #bound({ text, number }) {
    if (number < 0) return 0;
    const models = await this.#load(number).models;
    return this.#starts[number] + last(models, ({ id }) => id < text) + 1;
  }
}

/**
 * The first id, size and address of every page.
 *
 * @param {Model[]} models of the first one
 * @param {CataloguePage['pages']} pages that follow it
 * @param {URL} url of the first one
 * @returns {NonNullable<CataloguePage['pages']>}
 */
function indexOf(models, pages = [], url) {
  return models.length > 0 ? [[models[0].id, models.length, url.href], ...pages] : pages;
}

/**
 * The place of the last of some, in order, of which something is true; -1 for none.
 *
 * @template T
 * @param {T[]} some
 * @param {(one: T) => boolean} isTrue of none behind one of which it is not
 */
function last(some, isTrue) {
  let from = 0;
  let to = some.length;
  while (from < to) {
    const middle = (from + to) >> 1;
    if (isTrue(some[middle])) from = middle + 1;
    else to = middle;
  }
  return from - 1;
}
