// @ts-check
// Which models of a catalogue somebody looks for, and in which order they stand.

/** @import { Model } from '../card-words.js' */
/** @typedef {'name' | 'newest' | 'faces' | 'size'} Sorting */
/** @typedef {{ words: string, sorting: Sorting }} Wish */

/** @type {Record<Sorting, string>} */
export const SORTINGS = { name: 'Name', newest: 'Newest', faces: 'Most faces', size: 'Largest' };

/** Latin letters that are not taken apart into a letter and its mark. @type {Record<string, string | undefined>} */
export const LATIN = { ß: 'ss', æ: 'ae', œ: 'oe', ø: 'o', đ: 'd', ð: 'd', ħ: 'h', ı: 'i', ł: 'l', þ: 'th' };
const MARKED = new RegExp(`[${Object.keys(LATIN).join('')}ς]`, 'g');
/** Marks of Latin, Greek and Cyrillic letters. In other scripts marks make other letters. */
const MARKS = /[\u0300-\u036f]/g;

const names = new Intl.Collator('en', { numeric: true });

/** A text without case and diacritics. @param {string} text */
export function fold(text) {
  const bare = text.normalize('NFKD').replace(MARKS, '').toLowerCase().replace(MARKS, '');
  return bare.replace(MARKED, (letter) => LATIN[letter] ?? 'σ').normalize('NFC');
}

/** The models of a catalogue, ready to be looked through. */
export class Order {
  #models;
  /** @type {string[]} */
  #folded;

  /** @param {Model[]} models */
  constructor(models) {
    this.#models = [...models].sort(byName);
    this.#folded = this.#models.map(({ id, name = '' }) => fold(`${name} ${id}`));
  }

  /** How the models can be sorted: by what their catalogue knows. */
  get sortings() {
    const knows = (/** @type {keyof Model} */ member) => this.#models.some((model) => model[member] !== undefined);
    const known = { name: true, newest: knows('modified'), faces: knows('faces'), size: knows('fileBytes') || knows('bytes') };
    return /** @type {Sorting[]} */ (Object.keys(SORTINGS)).filter((sorting) => known[sorting]);
  }

  /**
   * Those that have all the words in their names. What a catalogue does not know of a model puts it last.
   *
   * @param {Wish} wish
   */
  of({ words, sorting }) {
    const parts = fold(words).split(/\s+/);
    const found = this.#models.filter((_, i) => parts.every((part) => this.#folded[i].includes(part)));
    // Sorting keeps those in the order of their names that are alike otherwise.
    if (sorting === 'newest') return found.sort((a, b) => time(b) - time(a));
    if (sorting === 'faces') return found.sort((a, b) => (b.faces ?? -1) - (a.faces ?? -1));
    if (sorting === 'size') return found.sort((a, b) => size(b) - size(a));
    return found;
  }
}

/** @param {Model} a @param {Model} b */
function byName(a, b) {
  return names.compare(a.name ?? a.id, b.name ?? b.id) || names.compare(a.id, b.id);
}

/** @param {Model} model */
function time({ modified }) {
  return Date.parse(modified ?? '') || 0;
}

/** The bytes that a visitor loads, else those of the file. @param {Model} model */
function size({ bytes, fileBytes }) {
  return bytes ?? fileBytes ?? -1;
}

/**
 * What the query of an address asks for.
 *
 * @param {string} query
 * @param {Sorting[]} sortings that there are
 * @returns {Wish}
 */
export function readWish(query, sortings) {
  const asked = new URLSearchParams(query);
  return { words: asked.get('q') ?? '', sorting: sortings.find((name) => name === asked.get('sort')) ?? 'name' };
}

/**
 * The address of the gallery with a wish in it.
 *
 * @param {string} address
 * @param {Wish} wish
 */
export function withWish(address, { words, sorting }) {
  const url = new URL(address);
  if (words.trim() === '') url.searchParams.delete('q');
  else url.searchParams.set('q', words.trim());
  if (sorting === 'name') url.searchParams.delete('sort');
  else url.searchParams.set('sort', sorting);
  return url.href;
}
