// @ts-check
// The first bytes of an archive once more: those that the browser keeps, and over the network what it does not.

import { Download } from '../decode/download.js';
import { Kept } from '../decode/kept.js';
import { pause } from '../session/retry.js';

/** @import { Access } from '../decode/messages.js' */
/** @typedef {{ archiveUrl: string, archiveSha256?: string, access?: Access }} Place */

/** What has just arrived is kept a moment later: it is looked for so often before the network is asked. */
const TRIES = 5;
const TRY_MILLIS = 200;

export class ArchiveBytes {
  #place;
  #bytes = new Uint8Array(1 << 16);
  /** Up to here bytes came from kept pieces. */
  #kept = 0;
  length = 0;

  /** @param {Place} place */
  constructor(place) {
    this.#place = place;
  }

  /**
   * Bytes that are there.
   *
   * @param {number} from
   * @param {number} end
   */
  part(from, end) {
    return this.#bytes.subarray(from, Math.min(end, this.length));
  }

  /**
   * Resolves when the bytes before `end` are there.
   *
   * @param {number} end
   */
  async reach(end) {
    const { archiveUrl, archiveSha256, access } = this.#place;
    const kept = this.length < end ? await Kept.open(archiveUrl, archiveSha256) : null;
    for (let tries = 0; kept !== null && this.length < end && tries < TRIES; tries++) {
      if (tries > 0) await pause(TRY_MILLIS);
      for await (const piece of kept.pieces(this.#kept)) {
        this.#add(this.#kept, piece);
        this.#kept += piece.length;
        if (this.length >= end) return;
      }
    }
    if (this.length >= end) return;
    const listener = { begin() {}, end() {}, waiting() {}, bytes: (/** @type {Uint8Array} */ chunk) => this.#add(this.length, chunk) };
    await new Download(archiveUrl, listener, access).read(this.length, end, new AbortController().signal);
  }

  /**
   * @param {number} at
   * @param {Uint8Array} bytes of which some may be there
   */
  #add(at, bytes) {
    const end = at + bytes.length;
    if (end <= this.length) return;
    if (end > this.#bytes.length) {
      const more = new Uint8Array(Math.max(end, 2 * this.#bytes.length));
      more.set(this.#bytes.subarray(0, this.length));
      this.#bytes = more;
    }
    this.#bytes.set(bytes, at);
    this.length = end;
  }
}
