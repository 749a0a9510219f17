// @ts-check
// Feeds the decoder in portions, so that pictures, messages and the deadline have their turn.

import { budgetEnd } from '../session/budget.js';
import { DamagedArchive } from './answers.js';

/** @import { Decoder } from './decoder.js' */
/** @import { Header } from '../session/header.js' */
/** @import { Post } from './messages.js' */
/** @import { Pictures } from './pictures.js' */

/** No longer than this without a look at messages and the deadline. */
const YIELD_MILLIS = 50;
/** What is fed at once until the size of the base is known. */
const FIRST_PORTION = 512;
/** What is fed at once later: a fast link brings more than one picture's worth. */
const PORTION = 1 << 14;

export class Feeder {
  #decoder;
  #pictures;
  #post;
  #baseBytes;
  #totalBytes;
  #yieldedAt = 0;
  /** Time that decoding has taken. */
  millis = 0;
  /** After these nothing is fed. */
  mostFaces = Infinity;

  /**
   * @param {Decoder} decoder
   * @param {Pictures} pictures
   * @param {Post} post
   * @param {number | null} baseBytes up to the end of the base, where that is known
   * @param {() => number | null} totalBytes of the file, where they are known
   */
  constructor(decoder, pictures, post, baseBytes, totalBytes) {
    this.#decoder = decoder;
    this.#pictures = pictures;
    this.#post = post;
    this.#baseBytes = baseBytes;
    this.#totalBytes = totalBytes;
  }

  /** The byte behind the last one that is to be fed. */
  get limit() {
    return budgetEnd(this.#decoder.header, this.mostFaces);
  }

  /** Whether that has been fed. */
  get isFull() {
    return this.#decoder.received >= this.limit;
  }

  /** @param {Uint8Array} bytes the next ones of the archive, of which those behind the limit are left out */
  async feed(bytes) {
    for (let from = 0; from < bytes.length; ) {
      const room = this.limit - this.#decoder.received;
      if (room <= 0) return;
      const part = bytes.subarray(from, from + Math.min(room, this.#portion()));
      this.#feed(part);
      from += part.length;
      await this.#yield();
    }
  }

  /** Has everything decoded that was fed: where that needs the whole decoder, it is waited for. */
  async catchUp() {
    const before = this.#state();
    await this.#decoder.catchUp();
    this.#look(before);
  }

  /** Bytes that wait to be read are read before any timer or message: gives those their turn. */
  async #yield() {
    if (performance.now() - this.#yieldedAt < YIELD_MILLIS) return;
    await new Promise((resolve) => setTimeout(resolve));
    this.#yieldedAt = performance.now();
  }

  /** The base is fed alone, so that the first picture waits for no more than it needs; until its size is known, a little at a time. */
  #portion() {
    const { header, batches, received } = this.#decoder;
    if (batches > 0) return PORTION;
    const base = header?.ends[0] ?? this.#baseBytes;
    return base === null ? FIRST_PORTION : Math.max(base - received, 1);
  }

  /** @param {Uint8Array} bytes */
  #feed(bytes) {
    const before = this.#state();
    const begin = performance.now();
    this.#decoder.feed(bytes);
    this.millis += performance.now() - begin;
    this.#look(before);
    if (this.#pictures.isDue) this.#pictures.show();
  }

  #state() {
    return { whole: this.#decoder.header?.whole, isFirst: this.#decoder.isFirst };
  }

  /**
   * The first part of the header comes with the first picture, the rest a little later; the whole decoder knows more of it, and images.
   *
   * @param {{ whole: boolean | undefined, isFirst: boolean }} before
   */
  #look(before) {
    const { header, isFirst } = this.#decoder;
    const isOther = isFirst !== before.isFirst;
    if (header !== null && (isOther || header.whole !== before.whole)) this.#open(header);
    if (isOther) this.#pictures.reset();
  }

  /** @param {Header} header */
  #open(header) {
    const total = this.#totalBytes();
    if (header.whole && total !== null && total !== header.archiveBytes) {
      throw new DamagedArchive(`its index describes ${header.archiveBytes} bytes, but the file has ${total}`);
    }
    this.#post({ type: 'header', header });
  }
}
