// @ts-check
// The line between two sides of the picture, which can be moved, and what each side shows.

import { make } from '../page/tools/make.js';

/** Shares of the width: how far it can be moved, and how far a key moves it. */
const EDGE = 0.02;
const STEP = 0.02;
const LARGE_STEP = 0.1;
/** Movements by keys. @type {Record<string, (share: number) => number>} */
const KEYS = {
  ArrowLeft: (share) => share - STEP,
  ArrowRight: (share) => share + STEP,
  PageDown: (share) => share - LARGE_STEP,
  PageUp: (share) => share + LARGE_STEP,
  Home: () => 0,
  End: () => 1,
};

export class Divider {
  #moved;
  #handle = make('div', 'divider');
  /** For both sides. */
  labels = { left: make('p', 'of left'), right: make('p', 'of right') };
  /** Share of the width that the left side has. */
  share = 0.5;
  element = make('div', 'comparison');

  /** @param {() => void} moved */
  constructor(moved) {
    this.#moved = moved;
    this.element.append(this.#handle, this.labels.left, this.labels.right);
    const handle = this.#handle;
    handle.tabIndex = 0;
    handle.setAttribute('role', 'separator');
    handle.setAttribute('aria-orientation', 'vertical');
    handle.setAttribute('aria-label', 'Divider between the two levels');
    handle.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      handle.focus();
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      const { left, width } = this.element.getBoundingClientRect();
      this.#move((event.clientX - left) / width);
    });
    handle.addEventListener('keydown', (event) => {
      const move = KEYS[event.key];
      if (move === undefined) return;
      event.preventDefault();
      this.#move(move(this.share));
    });
    this.#place();
  }

  /** @param {number} share */
  #move(share) {
    this.share = Math.min(Math.max(share, EDGE), 1 - EDGE);
    this.#place();
    this.#moved();
  }

  #place() {
    this.element.style.setProperty('--share', String(this.share));
    this.#handle.setAttribute('aria-valuenow', String(Math.round(100 * this.share)));
  }
}
