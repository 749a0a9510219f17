// @ts-check
// The cards of a catalogue that is not loaded whole, and a search by the beginnings of ids.

import { messageOf } from '../../session/errors.js';
import * as numbers from '../../session/numbers.js';
import { make } from '../tools/make.js';
import { controls } from './controls.js';
import { prefixOf } from './id-text.js';
import { LongList } from './lists.js';
import { readWish, withWish } from './order.js';
import { Pages } from './pages.js';
import { dress } from './style.js';

/** @import { Model } from '../card-words.js' */
/** @import { CataloguePage } from '../catalogue.js' */
/** @import { Cards } from './lists.js' */

/** How long nobody types before pages are asked for. */
const REST_MILLIS = 150;

/**
 * @param {CataloguePage} first
 * @param {URL} url of it
 * @param {HTMLElement} list for the cards
 * @param {Cards} cards
 */
export function browsePages(first, url, list, cards) {
  dress();
  const { element, search, count } = controls([]);
  search.placeholder = 'Beginning of folder/name';
  search.setAttribute('aria-label', 'Search models by the beginning of folder and name');
  const fail = (/** @type {unknown} */ error) => {
    if (!(error instanceof DOMException)) count.textContent = `${messageOf(error)} The list may have changed: reload the page.`;
  };
  const shown = new LongList(list, { ...cards, make: (model) => (model.id === '' ? blank() : cards.make(model)) });
  const changed = (/** @type {unknown} */ failure) => (failure === undefined ? shown.refresh() : fail(failure));
  const pages = new Pages(first, url, changed, () => show());
  let asked = 0;
  const show = async () => {
    const mine = ++asked;
    const words = search.value.trim();
    history.replaceState(history.state, '', withWish(location.href, { words, sorting: 'name' }));
    try {
      const prefix = prefixOf(words);
      const [from, to] = await pages.find(prefix);
      if (mine !== asked) return;
      shown.show(pages.part(from, to));
      count.textContent = inWords(to - from, pages.total, prefix) + (shown.most < to - from ? `; the first ${numbers.count(shown.most)} are listed` : '');
    } catch (error) {
      if (mine === asked) fail(error);
    }
  };
  search.value = readWish(location.search, []).words;
  list.before(element);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  search.addEventListener('input', () => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      show();
      if (scrollY > element.offsetTop) scrollTo(0, element.offsetTop);
    }, REST_MILLIS);
  });
  return show();
}

/** A card whose model is on its way. */
function blank() {
  const item = make('li');
  item.append(make('div', 'card'));
  return item;
}

/**
 * @param {number} found
 * @param {number} all
 * @param {string} prefix
 */
function inWords(found, all, prefix) {
  if (prefix === '') return `${numbers.count(all)} models`;
  return found === 0 ? `No model’s id begins with “${prefix}”.` : `${numbers.count(found)} of ${numbers.count(all)} models`;
}
