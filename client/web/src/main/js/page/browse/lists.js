// @ts-check
// Lists of cards: one that has them all, and one that has those alone that are near the screen.

import { Grid } from './grid.js';

/** @import { Model } from '../card-words.js' */
/**
 * Makes cards and gives them up.
 *
 * @typedef {object} Cards
 * @property {(model: Model) => HTMLLIElement} make
 * @property {(card: HTMLLIElement) => void} drop a card that is not shown any more, and is not shown again
 */

/**
 * Models in an order: an array, or what stands for one.
 *
 * @typedef {object} Models
 * @property {number} length
 * @property {(index: number) => Model | undefined} at
 * @property {(model: Model) => number} indexOf below zero, or beyond the last, for one that is not among them
 */

/** Lines of text that the words below a picture take, with what is free around them: three of them, one of which is small. */
const LINES = 4.1;

/** Has a card for each model, made once. */
export class ShortList {
  #list;
  #cards;
  /** @type {Map<Model, HTMLLIElement>} */
  #made = new Map();

  /** @param {HTMLElement} list @param {Cards} cards */
  constructor(list, cards) {
    this.#list = list;
    this.#cards = cards;
  }

  /** @param {Model[]} models */
  show(models) {
    this.#list.replaceChildren(...models.map((model) => this.#card(model)));
  }

  /** @param {Model} model */
  #card(model) {
    const made = this.#made.get(model) ?? this.#cards.make(model);
    this.#made.set(model, made);
    return made;
  }
}

/** Has cards near the screen alone, in places that are computed. A card with the focus stays, wherever it is. */
export class LongList {
  #list;
  #cards;
  /** @type {Models} */
  #models = /** @type {Model[]} */ ([]);
  /** By their models. @type {Map<Model, HTMLLIElement>} */
  #shown = new Map();
  #grid = new Grid(0, 0, 0);
  #isScheduled = false;

  /** @param {HTMLElement} list @param {Cards} cards */
  constructor(list, cards) {
    this.#list = list;
    this.#cards = cards;
    list.classList.add('long');
    addEventListener('scroll', () => this.#schedule(), { passive: true });
    new ResizeObserver(() => this.#lay()).observe(list);
  }

  /** @param {Models} models */
  show(models) {
    this.#models = models;
    this.#lay();
  }

  /** Shows models that have come since. */
  refresh() {
    this.#schedule();
  }

  /** How many models there is room for. */
  get most() {
    return this.#grid.count;
  }

  #lay() {
    const text = LINES * parseFloat(getComputedStyle(this.#list).lineHeight);
    this.#grid = new Grid(this.#models.length, this.#list.clientWidth, Math.round(text));
    const { style } = this.#list;
    style.height = `${this.#grid.height}px`;
    style.setProperty('--width', `${this.#grid.cardWidth}px`);
    style.setProperty('--height', `${this.#grid.cardHeight}px`);
    this.#fill();
  }

  #schedule() {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    requestAnimationFrame(() => this.#fill());
  }

  #fill() {
    this.#isScheduled = false;
    const { top } = this.#list.getBoundingClientRect();
    const [from, to] = this.#grid.range(-top, innerHeight - top);
    const held = this.#held(from, to);
    const wanted = Array.from({ length: to - from }, (_, i) => from + i);
    if (held >= 0) wanted.push(held);
    wanted.sort((a, b) => a - b);
    const stay = new Set(wanted.map((index) => this.#models.at(index)));
    for (const [model, card] of this.#shown) if (!stay.has(model)) this.#remove(model, card);
    /** @type {Element | null} */
    let at = this.#list.firstElementChild;
    for (const index of wanted) {
      const model = this.#models.at(index);
      if (model === undefined) continue;
      const card = this.#shown.get(model) ?? this.#cards.make(model);
      this.#shown.set(model, card);
      this.#place(card, index);
      // A card that is moved in the document loses the focus: those that are there already stay.
      if (card === at) at = at.nextElementSibling;
      else this.#list.insertBefore(card, at);
    }
  }

  /** @param {Model} model @param {HTMLLIElement} card */
  #remove(model, card) {
    this.#shown.delete(model);
    card.remove();
    this.#cards.drop(card);
  }

  /** The number of the card with the focus, if that is outside a range; else -1. @param {number} from @param {number} to */
  #held(from, to) {
    for (const [model, card] of this.#shown) {
      if (!card.contains(document.activeElement)) continue;
      const index = this.#models.indexOf(model);
      return index < from || (index >= to && index < this.#models.length) ? index : -1;
    }
    return -1;
  }

  /** @param {HTMLLIElement} card @param {number} index */
  #place(card, index) {
    const { left, top } = this.#grid.placeOf(index);
    card.style.left = `${left}px`;
    card.style.top = `${top}px`;
    card.setAttribute('aria-posinset', String(index + 1));
    card.setAttribute('aria-setsize', String(this.#models.length));
  }
}
