// @ts-check
// When the whole decoder comes: on a slow link what the first one can decode goes before it.

import { LARGE_FACES, isTextured } from '../session/weight.js';

/** @import { Decoder } from './decoder.js' */

/** A link of 2 Mbit/s, which brings the whole decoder in less than half of a second. */
const FAST = 250_000;
/** After so long nobody else wants the link. */
const IDLE_MILLIS = 400;

export class Succession {
  #decoder;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Decoder} decoder */
  constructor(decoder) {
    this.#decoder = decoder;
  }

  /** @param {number} bytesPerSecond of the link */
  hear(bytesPerSecond) {
    const { header } = this.#decoder;
    if (bytesPerSecond >= FAST || (header?.faces ?? 0) > LARGE_FACES || isTextured(header)) this.#decoder.prepare();
  }

  /** Nothing is read. */
  rest() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#decoder.prepare(), IDLE_MILLIS);
  }

  /**
   * Something is about to be read.
   *
   * @param {number} bytesPerSecond 0 where the page's own files were kept, or came too fast to tell
   */
  begin(bytesPerSecond) {
    clearTimeout(this.#timer);
    if (bytesPerSecond === 0) this.#decoder.prepare();
    else this.hear(bytesPerSecond);
  }
}
