// @ts-check
// Feeds the decoder in portions, so that pictures, messages and the deadline have their turn.

import { DamagedArchive } from './answers.js';

/** @import { Decoder, Header } from './decoder.js' */
/** @import { Post } from './messages.js' */
/** @import { Pictures } from './pictures.js' */

/** No longer than this without a look at messages and the deadline. */
const YIELD_MILLIS = 50;
/** What is fed at once until the size of the base is known. */
const FIRST_PORTION = 512;

export class Feeder {
  #decoder;
  #pictures;
  #post;
  #baseBytes;
  #totalBytes;
  #yieldedAt = 0;

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

  /** @param {Uint8Array} bytes the next ones of the archive */
  feed(bytes) {
    for (let from = 0; from < bytes.length; ) {
      const part = bytes.subarray(from, from + this.#portion());
      this.#feed(part);
      from += part.length;
    }
  }

  /** Bytes that wait to be read are read before any timer or message: gives those their turn. */
  async yield() {
    if (performance.now() - this.#yieldedAt < YIELD_MILLIS) return;
    await new Promise((resolve) => setTimeout(resolve));
    this.#yieldedAt = performance.now();
  }

  /** The base is fed alone, so that the first picture waits for no more than it needs; until its size is known, a little at a time. */
  #portion() {
    const { header, batches, received } = this.#decoder;
    if (batches > 0) return Infinity;
    const base = header?.ends[0] ?? this.#baseBytes;
    return base === null ? FIRST_PORTION : Math.max(base - received, 1);
  }

  /** @param {Uint8Array} bytes */
  #feed(bytes) {
    const before = this.#decoder.header;
    this.#decoder.feed(bytes);
    const { header } = this.#decoder;
    // The first part of the header comes with the first picture, the rest a little later.
    if (header !== null && header.whole !== before?.whole) this.#open(header);
    if (this.#pictures.isDue) this.#pictures.show();
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
