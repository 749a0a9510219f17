// @ts-check
// The controls of the levels: a slider for each side, what the colours show, and their scale.

import * as numbers from '../session/numbers.js';
import { labelled, make } from '../page/tools/make.js';
import { cssGradient } from './palette.js';

/** @import { Figures } from '../session/figures.js' */
/** @import { Farthest } from './painting.js' */
/** @import { Paint, Wish } from './service.js' */
/** @typedef {Wish['side']} Name */

/** @type {Record<Paint, string>} */
const PAINTS = { file: 'As in the file', levels: 'Level of arrival', distance: 'Distance' };
const DIGITS = 3;

/** Tells of a `change` whenever somebody wishes something else. */
export class Controls extends EventTarget {
  element = make('div', 'controls levels');
  sliders = { left: slider(), right: slider() };
  #rows = { left: row(this.sliders.left, 'Level'), right: row(this.sliders.right, 'Level on the right') };
  #comparison = make('input');
  #paint = make('select');
  #legend = make('div');
  #scale = make('div', 'scale');
  #ends = make('div', 'ends');
  #words = make('p', 'fine');

  constructor() {
    super();
    this.#comparison.type = 'checkbox';
    const check = make('label', 'check');
    check.append(this.#comparison, 'Compare two levels');
    for (const [value, text] of Object.entries(PAINTS)) this.#paint.append(new Option(text, value));
    this.#scale.style.background = cssGradient();
    this.#legend.append(this.#scale, this.#ends, this.#words);
    this.element.append(this.#rows.left.element, check, this.#rows.right.element, labelled('Colours', this.#paint), this.#legend);
    for (const control of [this.sliders.left, this.sliders.right]) control.addEventListener('input', () => this.#changed());
    this.#comparison.addEventListener('change', () => this.#changed());
    this.#paint.addEventListener('change', () => this.#changed());
    this.#lay();
  }

  get isComparing() {
    return this.#comparison.checked;
  }

  set isComparing(value) {
    this.#comparison.checked = value;
    this.#lay();
  }

  /** @returns {Paint} */
  get paint() {
    return /** @type {Paint} */ (this.#paint.value);
  }

  /**
   * Which batch somebody wishes; null for the newest.
   *
   * @param {Name} side
   */
  batches(side) {
    const { value, max } = this.sliders[side];
    return value === max ? null : Number(value);
  }

  /**
   * Takes over what has arrived. A slider at the newest level stays there.
   *
   * @param {Pick<Figures, 'batches' | 'header'>} figures
   */
  expect({ batches, header }) {
    for (const side of /** @type {const} */ (['left', 'right'])) {
      const control = this.sliders[side];
      const isNewest = control.value === control.max;
      control.max = String(batches);
      if (isNewest) control.value = control.max;
      const at = Number(control.value);
      if (header !== null) control.setAttribute('aria-valuetext', `Level ${header.batchLevels[at - 1]}, ${numbers.faces(header.batchFaces[at - 1])}`);
    }
  }

  /**
   * @param {Name} side
   * @param {string} text
   */
  describe(side, text) {
    this.#rows[side].output.textContent = text;
  }

  /**
   * Says what the colours of distances mean.
   *
   * @param {Farthest | null} most where the distance is the largest; null while it is not known
   * @param {number} diagonal
   * @param {boolean} isOriginal whether the newest level is the original
   */
  scaleOf(most, diagonal, isOriginal) {
    const text = most === null ? '…' : most.distance.toLocaleString('en', { maximumSignificantDigits: DIGITS });
    const share = most === null || diagonal === 0 ? '' : `, at most ${numbers.distance((100 * most.distance) / diagonal)} of the diagonal`;
    Object.assign(this.#legend.dataset, { most: most?.distance ?? '', at: most?.at ?? '' });
    this.#ends.replaceChildren(make('span', '', '0'), make('span', '', text));
    this.#words.textContent = `Distance from the ${isOriginal ? 'original' : 'newest level'} in the units of the model${share}.`;
  }

  /**
   * Says what the colours of levels mean.
   *
   * @param {number} last
   */
  levelsUpTo(last) {
    this.#ends.replaceChildren(make('span', '', 'Base'), make('span', '', `Level ${last}`));
    this.#words.textContent = 'The level in which each face came.';
  }

  #changed() {
    this.#lay();
    this.dispatchEvent(new Event('change'));
  }

  #lay() {
    this.#rows.right.element.hidden = !this.isComparing;
    this.#rows.left.name.textContent = this.isComparing ? 'Level on the left' : 'Level';
    for (const { name, control } of Object.values(this.#rows)) control.setAttribute('aria-label', name.textContent ?? '');
    this.#legend.hidden = this.paint === 'file';
  }
}

function slider() {
  const made = make('input');
  made.type = 'range';
  made.min = made.value = made.max = '1';
  return made;
}

/**
 * @param {HTMLInputElement} control
 * @param {string} text
 */
function row(control, text) {
  const element = make('label', 'range');
  const name = make('span', '', text);
  const output = make('output');
  element.append(name, control, output);
  return { element, name, control, output };
}
