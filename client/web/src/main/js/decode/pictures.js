// @ts-check
// Posts pictures of a model that is being decoded: seldom enough that drawing them does not hold up decoding.

/** @import { Decoder } from './decoder.js' */
/** @import { Post } from './messages.js' */

/** No picture sooner than this after the one before, nor sooner than this many times what the one before cost. */
const PICTURE_MILLIS = 120;
const PICTURE_COST = 5;
/** What this part of an archive brings is worth a picture earlier: as soon as the pause has been as long as the one before cost. */
const SHARE = 1 / 24;

export class Pictures {
  #decoder;
  #post;
  /** @type {Set<string>} */
  #knownImages = new Set();
  #postedBatches = 0;
  #postedBytes = 0;
  #postedAt = -Infinity;
  #cost = 0;
  #drawing = false;

  /**
   * @param {Decoder} decoder
   * @param {Post} post
   */
  constructor(decoder, post) {
    this.#decoder = decoder;
    this.#post = post;
  }

  /** The main thread has drawn the picture before. */
  drawn() {
    this.#drawing = false;
  }

  /** Whether what is decoded is worth a picture now; the first one always is. */
  get isDue() {
    const { received, header } = this.#decoder;
    const isMuch = header?.whole === true && received - this.#postedBytes >= SHARE * header.archiveBytes;
    const wait = Math.max(PICTURE_MILLIS, (isMuch ? 1 : PICTURE_COST) * this.#cost);
    return this.#postedBatches === 0 || (!this.#drawing && performance.now() > this.#postedAt + wait);
  }

  /** Posts the mesh decoded so far, and its images, unless it is already on the screen. */
  show() {
    if (this.#decoder.batches === this.#postedBatches || this.#decoder.isBroken) return;
    const start = performance.now();
    for (const [paths, bytes] of this.#decoder.newImages(this.#knownImages)) {
      this.#post({ type: 'texture', paths, bytes }, [bytes.buffer]);
    }
    this.#refine();
    this.#postedAt = performance.now();
    this.#cost = this.#postedAt - start;
  }

  /** Posts what came whole before the damage, unless that is no longer known. */
  showBeforeDamage() {
    if (this.#decoder.isBroken || this.#decoder.batches === 0) return;
    try {
      this.#refine();
    } catch {
      // A batch was sound, and yet could not be decoded: the mesh is half changed, and the picture before stays.
    }
  }

  #refine() {
    const changes = this.#decoder.refine();
    const { batches, received } = this.#decoder;
    this.#post({ type: 'picture', batches, received, changes }, [changes.ranges.buffer, changes.data.buffer]);
    this.#postedBatches = batches;
    this.#postedBytes = received;
    this.#drawing = true;
  }

  /** The archive is decoded from its beginning once more. */
  reset() {
    this.#knownImages.clear();
    this.#postedBatches = 0;
    this.#postedBytes = 0;
  }
}
