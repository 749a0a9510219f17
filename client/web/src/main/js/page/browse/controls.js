// @ts-check
// A search box and a choice of sortings above the cards.

import { labelled, make } from '../tools/make.js';
import { SORTINGS } from './order.js';

/** @import { Sorting } from './order.js' */

/** @param {Sorting[]} sortings */
export function controls(sortings) {
  const element = make('form', 'browse');
  element.setAttribute('role', 'search');
  const search = make('input');
  Object.assign(search, { type: 'search', placeholder: 'Search models', autocomplete: 'off', spellcheck: false });
  search.setAttribute('aria-label', 'Search models by name');
  search.setAttribute('aria-keyshortcuts', '/');
  const sorting = make('select');
  for (const name of sortings) sorting.append(new Option(SORTINGS[name], name));
  sorting.setAttribute('aria-label', 'Sort by');
  const label = labelled('Sort by', sorting);
  const count = make('p');
  count.setAttribute('role', 'status');
  element.append(search, ...(sortings.length > 0 ? [label] : []), count);
  element.addEventListener('submit', (event) => event.preventDefault());
  addEventListener('keydown', (event) => {
    if (event.key !== '/' || event.ctrlKey || event.metaKey || event.altKey || document.activeElement === search) return;
    event.preventDefault();
    search.focus();
    search.select();
  });
  return { element, search, sorting, count };
}
