// @ts-check
// Posts pictures of a model that is being decoded: seldom enough that drawing them does not hold up decoding.

/** @import { Decoder } from './decoder.js' */
/** @import { Post } from './messages.js' */

/** No picture sooner than this after the one before, nor sooner than this many times what the one before cost. */
const PICTURE_MILLIS = 120;
const PICTURE_COST = 5;

export class Pictures {
  #decoder;
  #post;
  /** @type {Set<string>} */
  #knownImages = new Set();
  #postedBatches = 0;
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
    const wait = Math.max(PICTURE_MILLIS, PICTURE_COST * this.#cost);
    return this.#postedBatches === 0 || (!this.#drawing && performance.now() > this.#postedAt + wait);
  }

  /** Posts the mesh decoded so far, and its images, unless it is already on the screen. */
  show() {
    const { batches, received } = this.#decoder;
    if (batches === this.#postedBatches) return;
    const start = performance.now();
    for (const [path, bytes] of this.#decoder.newImages(this.#knownImages)) {
      this.#post({ type: 'texture', path, bytes }, [bytes.buffer]);
    }
    const drawn = this.#decoder.draw();
    const arrays = [drawn.positions, drawn.normals, drawn.uvs, drawn.colours, drawn.indices, drawn.groups];
    this.#post(
      { type: 'picture', batches, received, drawn },
      arrays.map((array) => array.buffer),
    );
    this.#postedBatches = batches;
    this.#drawing = true;
    this.#postedAt = performance.now();
    this.#cost = this.#postedAt - start;
  }

  /** The archive is decoded from its beginning once more. */
  reset() {
    this.#knownImages.clear();
    this.#postedBatches = 0;
  }
}
