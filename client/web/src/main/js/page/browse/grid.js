// @ts-check
// Where the cards of a long list stand, and which of them are near the screen.

/** Pixels: the least width of a card, as in the page's style, and between two of them. */
const LEAST = 240;
const GAP = 18;
/** Rows beyond the screen, so that the keyboard, a screen reader and a quick finger find the next card there. */
const SPARE = 2;
/** Browsers draw no page that is much longer. */
const MOST_PIXELS = 15e6;
/** A picture's height as a share of its width, and the card's borders. */
const PICTURE = 3 / 4;
const BORDERS = 2;

/** All cards are of one size, so that a place is known without making the cards before it. */
export class Grid {
  /**
   * @param {number} count of cards
   * @param {number} width of the list
   * @param {number} text height of the words below a picture
   */
  constructor(count, width, text) {
    this.columns = Math.max(1, Math.floor((width + GAP) / (LEAST + GAP)));
    this.cardWidth = (width - GAP * (this.columns - 1)) / this.columns;
    this.cardHeight = Math.ceil((this.cardWidth - BORDERS) * PICTURE) + BORDERS + text;
    this.count = Math.min(count, this.columns * Math.floor(MOST_PIXELS / this.#pitch));
  }

  get #pitch() {
    return this.cardHeight + GAP;
  }

  get height() {
    const rows = Math.ceil(this.count / this.columns);
    return Math.max(0, rows * this.#pitch - GAP);
  }

  /** @param {number} index */
  placeOf(index) {
    const column = index % this.columns;
    return { left: column * (this.cardWidth + GAP), top: ((index - column) / this.columns) * this.#pitch };
  }

  /**
   * The cards in a part of the list, with some spare rows.
   *
   * @param {number} top
   * @param {number} bottom
   * @returns {[from: number, to: number]}
   */
  range(top, bottom) {
    const first = Math.max(0, Math.floor(top / this.#pitch) - SPARE);
    const last = Math.ceil(bottom / this.#pitch) + SPARE;
    const to = Math.min(this.count, Math.max(0, last) * this.columns);
    return [Math.min(first * this.columns, to), to];
  }
}
