// @ts-check
// Pictures of models for the gallery: the first bytes of each archive, drawn once, when the card comes into sight, and kept by the browser.

import { fetchManifest } from './manifest.js';
import { Stage } from './stage.js';

/** Batches after the base are loaded up to here, so that small bases look better. */
const MOST_BYTES = 24576;
const KEPT = 'jsm-picture-';

/** @import { Message, Wish as WorkerWish } from './messages.js' */
/** @import { Manifest } from './manifest.js' */
/**
 * @typedef {object} Wanted a picture that a card waits for
 * @property {HTMLImageElement} picture
 * @property {URL} manifestUrl
 * @property {boolean} first
 * @property {(manifest: Manifest) => void} resolve
 * @property {(reason: unknown) => void} reject
 */

export class Thumbnails {
  #decoder;
  /** @type {Map<Element, Wanted>} */
  #wanted = new Map();
  /** @type {Wanted[]} */
  #waiting = [];
  #working = false;
  /** @type {Stage | null} */
  #stage = null;
  /** @type {Worker | null} */
  #worker = null;
  #observer = new IntersectionObserver((entries) => this.#seen(entries), { rootMargin: '200px' });

  /** @param {string} decoder */
  constructor(decoder) {
    this.#decoder = decoder;
  }

  /**
   * Fills in the picture once it is on the screen, those with `first` before the others; resolves to the manifest.
   *
   * @param {HTMLImageElement} picture
   * @param {URL} manifestUrl
   * @param {boolean} first
   * @returns {Promise<Manifest>}
   */
  show(picture, manifestUrl, first) {
    return new Promise((resolve, reject) => {
      this.#wanted.set(picture, { picture, manifestUrl, first, resolve, reject });
      this.#observer.observe(picture);
    });
  }

  /** @param {IntersectionObserverEntry[]} entries */
  #seen(entries) {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      this.#observer.unobserve(target);
      const wanted = this.#wanted.get(target);
      if (wanted !== undefined) this.#waiting.push(wanted);
    }
    this.#waiting.sort((a, b) => Number(b.first) - Number(a.first));
    this.#work();
  }

  /** One after the other: pictures must not take the connection or the processor from the page. */
  async #work() {
    if (this.#working) return;
    this.#working = true;
    for (let wanted = this.#waiting.shift(); wanted !== undefined; wanted = this.#waiting.shift()) {
      await this.#fill(wanted).then(wanted.resolve, wanted.reject);
    }
    this.#working = false;
    this.#rest();
  }

  /** Gives graphics memory and the decoder back until the next card comes into sight. */
  #rest() {
    this.#stage?.dispose();
    this.#worker?.terminate();
    this.#stage = null;
    this.#worker = null;
  }

  /** @param {Wanted} wanted */
  async #fill({ picture, manifestUrl }) {
    const manifest = await fetchManifest(manifestUrl);
    const key = KEPT + manifest.archiveSha256;
    let source = localStorage.getItem(key);
    if (source === null) {
      source = await this.#draw(manifest);
      keep(key, source);
    }
    picture.src = source;
    picture.classList.remove('empty');
    return manifest;
  }

  /** @param {Manifest} manifest */
  async #draw(manifest) {
    const stage = (this.#stage ??= makeStage());
    const worker = (this.#worker ??= new Worker(new URL('worker.js', import.meta.url), { type: 'module' }));
    const { archiveUrl, archiveSha256, bytes, meshSha256 } = manifest;
    await ask(worker, stage, { type: 'open', archiveUrl, archiveSha256, bytes, meshSha256, decoder: this.#decoder, serverPlan: false });
    const images = await ask(worker, stage, { type: 'prefix', bytes: prefix(manifest.batches ?? []) });
    // Images that the browser cannot read leave the model without.
    await Promise.allSettled(images);
    const source = stage.picture('image/webp');
    stage.clear();
    return source;
  }
}

/**
 * Sends a wish and draws what comes back until it is done; resolves to the images that are being read.
 *
 * @param {Worker} worker
 * @param {Stage} stage
 * @param {WorkerWish} wish
 * @returns {Promise<Promise<void>[]>}
 */
function ask(worker, stage, wish) {
  /** @type {Promise<void>[]} */
  const images = [];
  return new Promise((resolve, reject) => {
    worker.onmessage = (/** @type {MessageEvent<Message>} */ { data }) => {
      if (data.type === 'header') {
        stage.open(data.header);
      } else if (data.type === 'picture') {
        stage.update(data.drawn);
        worker.postMessage({ type: 'drawn' });
      } else if (data.type === 'texture') {
        images.push(stage.addTexture(data.path, data.bytes));
      } else if (data.type === 'done') {
        resolve(images);
      } else if (data.type === 'error') {
        reject(new Error(data.message));
      }
    };
    worker.onerror = () => reject(new Error('The decoder could not be started.'));
    worker.postMessage(wish);
  });
}

function makeStage() {
  const stage = new Stage(document.createElement('canvas'), false);
  stage.resize(320, 240, 2);
  return stage;
}

/**
 * Bytes of the base, and of as many batches as are within a small picture's budget.
 *
 * @param {{ offset: number, bytes: number }[]} batches
 */
export function prefix(batches) {
  let end = 0;
  for (const { offset, bytes } of batches) {
    if (end > 0 && offset + bytes > MOST_BYTES) break;
    end = offset + bytes;
  }
  return end;
}

/**
 * @param {string} key
 * @param {string} source
 */
function keep(key, source) {
  try {
    localStorage.setItem(key, source);
  } catch {
    // The browser's store is full: the picture is drawn again next time.
    Object.keys(localStorage)
      .filter((other) => other.startsWith(KEPT))
      .forEach((other) => localStorage.removeItem(other));
  }
}
