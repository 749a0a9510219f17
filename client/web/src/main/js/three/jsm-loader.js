// @ts-check
// Loads streamed models for three.js, by its own conventions.

import { Loader } from 'three';
import { Session, WAIT_MILLIS } from '../session/session.js';
import { setWorkerUrl } from '../session/pool.js';
import { sourceOf } from '../viewer/source.js';
import { JsmModel } from './jsm-model.js';

/** @import { LoadingManager } from 'three' */
/** @typedef {(event: ProgressEvent) => void} OnProgress bytes of the archive */
/** @typedef {{ signal?: AbortSignal }} Options */

export { JsmModel };

/**
 * `const model = await new JsmLoader().loadAsync(url); scene.add(model);`
 *
 * The model is there with its first picture, and goes on refining for the rest of the time that a round takes; after
 * that with `model.refine(seconds)`, `model.complete()`, or by itself with `model.setTargetError(pixels)`.
 */
export class JsmLoader extends Loader {
  #waitMillis = WAIT_MILLIS;
  #decoder = 'auto';
  /** @type {number | undefined} */
  #maxFaces;
  /** Models that have no picture yet. @type {Set<AbortController>} */
  #loading = new Set();

  /** @param {LoadingManager} [manager] */
  constructor(manager) {
    super(manager);
  }

  /**
   * Where worker and decoder are, if they do not lie beside this file.
   *
   * @param {string} path of a folder
   */
  setDecoderPath(path) {
    setWorkerUrl(new URL('jsm-worker.js', new URL(path.endsWith('/') ? path : `${path}/`, document.baseURI)));
    return this;
  }

  /** @param {'auto' | 'wasm' | 'js'} kind */
  setDecoder(kind) {
    this.#decoder = kind;
    return this;
  }

  /** The time that a round takes. @param {number} seconds */
  setWaitSeconds(seconds) {
    this.#waitMillis = 1000 * seconds;
    return this;
  }

  /** After so many a model stops refining. @param {number} faces Infinity for no limit; else it depends on the device's memory */
  setMaxFaces(faces) {
    this.#maxFaces = faces;
    return this;
  }

  /**
   * @param {string} url of a manifest or an archive
   * @param {(model: JsmModel) => void} [onLoad]
   * @param {OnProgress} [onProgress]
   * @param {(error: unknown) => void} [onError]
   * @param {Options} [options]
   */
  load(url, onLoad, onProgress, onError, options) {
    this.loadAsync(url, onProgress, options).then(onLoad, (error) => {
      if (onError) onError(error);
      else console.error(error);
    });
  }

  /**
   * Resolves when there is something to see.
   *
   * @param {string} url of a manifest or an archive
   * @param {OnProgress} [onProgress]
   * @param {Options} [options]
   * @returns {Promise<JsmModel>}
   */
  async loadAsync(url, onProgress, { signal } = {}) {
    const address = this.manager.resolveURL(this.path + url);
    const life = new AbortController();
    const abort = () => life.abort(signal?.reason);
    signal?.addEventListener('abort', abort);
    if (signal?.aborted) abort();
    this.#loading.add(life);
    this.manager.itemStart(address);
    try {
      return await this.#begin(address, life.signal, onProgress);
    } catch (error) {
      this.manager.itemError(address);
      throw error;
    } finally {
      this.manager.itemEnd(address);
      this.#loading.delete(life);
      signal?.removeEventListener('abort', abort);
    }
  }

  /**
   * @param {string} address
   * @param {AbortSignal} signal
   * @param {OnProgress} [onProgress]
   */
  async #begin(address, signal, onProgress) {
    signal.throwIfAborted();
    const access = { credentials: this.withCredentials ? /** @type {const} */ ('include') : /** @type {const} */ ('same-origin'), headers: this.requestHeader };
    const source = sourceOf(address, { access });
    const session = new Session();
    const model = new JsmModel(session, this.#waitMillis);
    try {
      const manifest = await interrupted(source.manifest(), signal);
      model.name = manifest.name ?? manifest.id ?? '';
      session.open(manifest, { decoder: this.#decoder, serverPlan: false, renew: source.renew, access, mostFaces: this.#maxFaces });
      await interrupted(this.#firstPicture(session, onProgress), signal);
      return model;
    } catch (error) {
      model.dispose();
      throw error;
    }
  }

  /**
   * @param {Session} session
   * @param {OnProgress} [onProgress]
   * @returns {Promise<void>}
   */
  #firstPicture(session, onProgress) {
    return new Promise((resolve, reject) => {
      session.addEventListener('change', () => {
        const { bytes, totalBytes, batches, error } = session.figures;
        onProgress?.(new ProgressEvent('progress', { loaded: bytes, total: totalBytes, lengthComputable: totalBytes > 0 }));
        if (error !== null) reject(new Error(error));
        else if (batches > 0) resolve();
      });
      session.refine(this.#waitMillis);
    });
  }

  /** Gives up what has no picture yet. */
  abort() {
    this.#loading.forEach((life) => life.abort(new DOMException('the loader was told to stop', 'AbortError')));
    return this;
  }

  dispose() {
    this.abort();
  }
}

/**
 * @template T
 * @param {Promise<T>} work
 * @param {AbortSignal} signal
 * @returns {Promise<T>}
 */
function interrupted(work, signal) {
  return new Promise((resolve, reject) => {
    const abort = () => reject(signal.reason);
    if (signal.aborted) abort();
    signal.addEventListener('abort', abort);
    work.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
  });
}
