// @ts-check
// Pictures of models for the gallery. An archive without poster is drawn: its first bytes, once, when the card comes into sight; the browser keeps the picture.

import { fetchManifest } from '../session/manifest.js';
import { MeshArrays } from '../session/mesh-arrays.js';
import { Connection } from '../session/pool.js';
import { Orbit } from '../viewer/orbit.js';
import { Pictures } from '../viewer/pictures.js';

/** Batches after the base are loaded up to here, so that small bases look better. */
const MOST_BYTES = 24576;
const KEPT = 'jsm-picture-';
const SIZE = { width: 640, height: 480 };

/** @import { Stage } from '../three/stage.js' */
/** @import { Message, Wish } from '../decode/messages.js' */
/** @import { Manifest } from '../session/manifest.js' */
/** @import { Listener } from '../session/pool.js' */
/**
 * @typedef {object} Wanted a picture that a card waits for
 * @property {HTMLImageElement} picture
 * @property {URL} manifestUrl
 * @property {boolean} first before others
 * @property {() => void} asked is called when the server is asked for the model, which it encodes then if need be
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
  #orbit = new Orbit();
  /** @type {Connection | null} */
  #connection = null;
  /** @type {Listener} */
  #listener = { hear: () => {}, broken: () => {} };
  #observer = new IntersectionObserver((entries) => this.#seen(entries), { rootMargin: '200px' });

  /** @param {string} decoder */
  constructor(decoder) {
    this.#decoder = decoder;
  }

  /**
   * Fills in the picture once it is on the screen, those with `first` before the others; resolves to the manifest.
   *
   * @param {Omit<Wanted, 'resolve' | 'reject'>} card
   * @returns {Promise<Manifest>}
   */
  show(card) {
    return new Promise((resolve, reject) => {
      this.#wanted.set(card.picture, { ...card, resolve, reject });
      this.#observer.observe(card.picture);
    });
  }

  /**
   * Nobody waits for this picture any more.
   *
   * @param {HTMLImageElement} picture
   */
  forget(picture) {
    this.#observer.unobserve(picture);
    this.#wanted.delete(picture);
    this.#waiting = this.#waiting.filter((wanted) => wanted.picture !== picture);
  }

  /** @param {IntersectionObserverEntry[]} entries */
  #seen(entries) {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      this.#observer.unobserve(target);
      const wanted = this.#wanted.get(target);
      this.#wanted.delete(target);
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
    this.#connection?.close();
    this.#stage = null;
    this.#connection = null;
  }

  /** @param {Wanted} wanted */
  async #fill({ picture, manifestUrl, asked }) {
    asked();
    const manifest = await fetchManifest(manifestUrl);
    if (manifest.posterUrl !== undefined) {
      showPoster(picture, new URL(manifest.posterUrl, manifestUrl));
      return manifest;
    }
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
    const { Stage: Loaded } = await import('../three/stage.js');
    const stage = (this.#stage ??= new Loaded(document.createElement('canvas'), this.#orbit, () => {}));
    const { archiveUrl, archiveSha256, bytes, meshSha256 } = manifest;
    this.#orbit.resize(SIZE.width, SIZE.height);
    const opened = await this.#ask(stage, { type: 'open', archiveUrl, archiveSha256, bytes, meshSha256, decoder: this.#decoder, serverPlan: false });
    const filled = await this.#ask(stage, { type: 'prefix', bytes: prefix(manifest.batches ?? []) });
    // Images that the browser cannot read leave the model without.
    await Promise.allSettled([...opened, ...filled]);
    const source = new Pictures(this.#orbit, stage).take('image/webp', SIZE, { ...SIZE, pixelRatio: 1 });
    stage.clear();
    return source;
  }

  /**
   * Sends a wish and draws what comes back until it is done; resolves to the materials and images that are being read.
   *
   * @param {Stage} stage
   * @param {Wish} wish
   * @returns {Promise<Promise<void>[]>}
   */
  #ask(stage, wish) {
    const connection = (this.#connection ??= new Connection({
      hear: (message) => this.#listener.hear(message),
      broken: (reason) => this.#listener.broken(reason),
    }));
    /** @type {Promise<void>[]} */
    const pending = [];
    const arrays = new MeshArrays();
    return new Promise((resolve, reject) => {
      const hear = (/** @type {Message} */ message) => {
        if (message.type === 'header') {
          arrays.expect(message.header);
          this.#orbit.bounds = message.header.bounds;
          this.#orbit.upright.model = message.header.up;
          pending.push(stage.open(message.header));
        } else if (message.type === 'picture') {
          arrays.take(message.changes);
          stage.update(arrays);
          connection.send({ type: 'drawn' });
        } else if (message.type === 'texture') {
          pending.push(stage.addTexture(message.paths, message.bytes));
        } else if (message.type === 'done') {
          resolve(pending);
        } else if (message.type === 'error') {
          reject(new Error(message.message));
        }
      };
      this.#listener = { hear, broken: () => reject(new Error('The decoder could not be started.')) };
      connection.send(wish);
    });
  }
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

/**
 * Shows a poster as soon as it is near the screen.
 *
 * @param {HTMLImageElement} picture
 * @param {URL} url
 */
export function showPoster(picture, url) {
  picture.loading = 'lazy';
  picture.classList.remove('empty');
  picture.src = url.href;
}
