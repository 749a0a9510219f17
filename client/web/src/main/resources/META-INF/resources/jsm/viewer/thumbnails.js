// Pictures of models for the gallery: the first bytes of each archive, drawn once, when the card comes into sight, and kept by the browser.

import { fetchManifest } from './manifest.js';
import { Stage } from './stage.js';

/** Batches after the base are loaded up to here, so that small bases look better. */
const MOST_BYTES = 24576;
const KEPT = 'jsm-picture-';

export class Thumbnails {
  #decoder;
  #wanted = new Map();
  #waiting = [];
  #working = false;
  #stage = null;
  #worker = null;
  #images = [];
  #observer = new IntersectionObserver((entries) => this.#seen(entries), { rootMargin: '200px' });

  constructor(decoder) {
    this.#decoder = decoder;
  }

  /** Fills in the picture once it is on the screen, those with `first` before the others; resolves to the manifest. */
  show(picture, manifestUrl, first) {
    return new Promise((resolve, reject) => {
      this.#wanted.set(picture, { picture, manifestUrl, first, resolve, reject });
      this.#observer.observe(picture);
    });
  }

  #seen(entries) {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      this.#observer.unobserve(target);
      this.#waiting.push(this.#wanted.get(target));
    }
    this.#waiting.sort((a, b) => b.first - a.first);
    this.#work();
  }

  /** One after the other: pictures must not take the connection or the processor from the page. */
  async #work() {
    if (this.#working) return;
    this.#working = true;
    while (this.#waiting.length > 0) {
      const wish = this.#waiting.shift();
      await this.#fill(wish).then(wish.resolve, wish.reject);
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

  async #draw(manifest) {
    this.#stage ??= this.#makeStage();
    this.#worker ??= new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
    const { archiveUrl, archiveSha256, bytes, meshSha256 } = manifest;
    await this.#ask({ type: 'open', archiveUrl, archiveSha256, bytes, meshSha256, decoder: this.#decoder, serverPlan: false });
    this.#images = [];
    await this.#ask({ type: 'prefix', bytes: prefix(manifest.batches) });
    // Images that the browser cannot read leave the model without.
    await Promise.allSettled(this.#images);
    const source = this.#stage.picture('image/webp');
    this.#stage.clear();
    return source;
  }

  /** Sends a wish and draws what comes back until it is done. */
  #ask(message) {
    return new Promise((resolve, reject) => {
      this.#worker.onmessage = ({ data }) => {
        if (data.type === 'header') this.#stage.open(data.header);
        else if (data.type === 'picture') this.#draws(data.drawn);
        else if (data.type === 'texture') this.#images.push(this.#stage.addTexture(data.path, data.bytes));
        else if (data.type === 'done') resolve();
        else if (data.type === 'error') reject(new Error(data.message));
      };
      this.#worker.onerror = () => reject(new Error('The decoder could not be started.'));
      this.#worker.postMessage(message);
    });
  }

  #draws(drawn) {
    this.#stage.update(drawn);
    this.#worker.postMessage({ type: 'drawn' });
  }

  #makeStage() {
    const canvas = document.createElement('canvas');
    const stage = new Stage(canvas, false);
    stage.resize(320, 240, 2);
    return stage;
  }
}

function prefix(batches) {
  let end = batches[0].offset + batches[0].bytes;
  for (const batch of batches) {
    if (batch.offset + batch.bytes > MOST_BYTES) break;
    end = Math.max(end, batch.offset + batch.bytes);
  }
  return end;
}

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
