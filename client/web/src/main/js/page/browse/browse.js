// @ts-check
// A search box and sorting above the cards of a catalogue that is not small, and a list that costs no more where it is long.

import * as numbers from '../../session/numbers.js';
import { controls } from './controls.js';
import { LongList, ShortList } from './lists.js';
import { Order, readWish, withWish } from './order.js';
import { dress } from './style.js';

/** @import { Model } from '../card-words.js' */
/** @import { Cards } from './lists.js' */
/** @import { Sorting } from './order.js' */

/** From so many models on, cards far from the screen are not made. */
const MANY = 200;
/** How long nobody types before the address changes, and the number of models is told. */
const REST_MILLIS = 300;

/**
 * @param {Model[]} models
 * @param {HTMLElement} list for their cards
 * @param {Cards} cards
 */
export function browse(models, list, cards) {
  dress();
  const order = new Order(models);
  const shown = models.length > MANY ? new LongList(list, cards) : new ShortList(list, cards);
  const { element, search, sorting, count } = controls(order.sortings);
  const wish = () => ({ words: search.value, sorting: /** @type {Sorting} */ (sorting.value) });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const settle = (/** @type {number} */ found) => {
    history.replaceState(history.state, '', withWish(location.href, wish()));
    count.textContent = inWords(found, models.length, search.value.trim());
  };
  const show = () => {
    const found = order.of(wish());
    shown.show(found);
    clearTimeout(timer);
    timer = setTimeout(() => settle(found.length), REST_MILLIS);
  };
  const asked = readWish(location.search, order.sortings);
  search.value = asked.words;
  sorting.value = asked.sorting;
  list.before(element);
  for (const control of [search, sorting]) {
    control.addEventListener('input', () => {
      show();
      // The first that are found are what somebody looks for.
      if (scrollY > element.offsetTop) scrollTo(0, element.offsetTop);
    });
  }
  // Whoever follows a card at once finds the words again on the way back.
  addEventListener('pagehide', () => history.replaceState(history.state, '', withWish(location.href, wish())));
  show();
}

/**
 * @param {number} found
 * @param {number} all
 * @param {string} words
 */
function inWords(found, all, words) {
  if (words === '') return `${numbers.count(all)} models`;
  return found === 0 ? `No model has “${words}” in its name.` : `${numbers.count(found)} of ${numbers.count(all)} models`;
}
