// @ts-check
// The page's side of a streamed model: sends wishes to the worker, keeps the figures, and draws what comes back.

/** The constant time that a user waits per round. */
export const WAIT_MILLIS = 2000;
/** A host whose tags differ from one answer to the next must not be asked for ever. */
const MOST_RENEWALS = 3;

import { Figures } from './figures.js';

/** @import { Round } from './figures.js' */
/** @import { Manifest } from './manifest.js' */
/** @import { Message, Wish } from './messages.js' */

/** @typedef {{ manifest: Manifest, decoder: string, serverPlan: boolean, renew: () => Promise<Manifest> }} Opened */
/** @typedef {Pick<import('./stage.js').Stage, 'open' | 'update' | 'addTexture' | 'clear'>} Screen where pictures go */

export class Session extends EventTarget {
  #worker;
  /** @type {Opened | null} */
  #opened = null;
  #renewals = 0;
  /** @type {{ wish: Wish['type'], resolve: () => void }[]} */
  #pending = [];
  /** @type {Screen | null} */
  #stage = null;
  /** @type {'round' | 'complete' | null} */
  #lastWish = null;
  #wishStatus = '';
  #interrupted = false;

  constructor() {
    super();
    this.figures = new Figures();
    this.bytesPerSecond = 0;
    /** @type {'wasm' | 'js' | null} */
    this.decoder = null;
    /** @type {Round[]} */
    this.rounds = [];
    this.pictures = 0;
    this.texturesLoading = 0;
    /** @type {string | null} */
    this.renewed = null;
    this.#worker = this.#startWorker();
  }

  #startWorker() {
    const worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }) => this.#hear(data));
    worker.addEventListener('error', (event) => this.#fail(`The viewer could not start its decoder: ${event.message || 'the worker did not load'}.`, false));
    return worker;
  }

  /**
   * Where pictures go; to be set before the task that opens the session ends.
   *
   * @param {Screen} stage
   */
  set stage(stage) {
    this.#stage = stage;
  }

  /**
   * Opens an archive.
   *
   * @param {Manifest} manifest says where it is and, where known, its bytes, faces and identity
   * @param {string} decoder
   * @param {boolean} serverPlan
   * @param {() => Promise<Manifest>} renew asks for the manifest as it is now
   */
  open(manifest, decoder, serverPlan, renew) {
    this.#opened = { manifest, decoder, serverPlan, renew };
    this.figures.totalBytes = manifest.bytes ?? 0;
    this.figures.totalFaces = manifest.faces ?? 0;
    const { archiveUrl, archiveSha256, bytes, baseBytes, meshSha256 } = manifest;
    return this.#post({ type: 'open', archiveUrl, archiveSha256, bytes, baseBytes, meshSha256, decoder, serverPlan });
  }

  /** One more round of T seconds; resolves when it is over. */
  refine() {
    return this.#wish({ type: 'round', waitMillis: WAIT_MILLIS }, 'Refining');
  }

  /** The original; resolves when it has arrived. */
  complete() {
    return this.#wish({ type: 'complete' }, 'Loading the original');
  }

  /** Tries again what failed. */
  retry() {
    this.figures.error = null;
    return this.#lastWish === 'complete' ? this.complete() : this.refine();
  }

  /** Gives up what is being loaded; what has arrived stays. */
  stop() {
    this.#send({ type: 'stop' });
  }

  /** @param {boolean} on */
  set serverPlan(on) {
    if (this.#opened !== null) this.#opened.serverPlan = on;
    this.#send({ type: 'serverPlan', on });
  }

  /**
   * The model cannot be opened at all.
   *
   * @param {string} message
   */
  fail(message) {
    this.#fail(message, false);
  }

  dispose() {
    this.#worker.terminate();
  }

  /**
   * @param {Extract<Wish, { type: 'round' | 'complete' }>} message
   * @param {string} status
   */
  async #wish(message, status) {
    if (this.figures.isOver) return;
    this.#lastWish = message.type;
    this.figures.error = null;
    if (this.figures.batches > 0) this.figures.state = 'refining';
    else this.figures.state = 'loading';
    this.#wishStatus = this.figures.batches > 0 ? status : 'Opening';
    this.figures.status = this.#wishStatus;
    this.rounds.push({ kind: message.type, from: this.figures.bytes, at: performance.now(), plans: [] });
    this.#changed();
    await this.#post(message);
    const round = this.rounds.at(-1);
    if (round !== undefined) Object.assign(round, { to: this.figures.bytes, millis: performance.now() - round.at });
  }

  /**
   * Sends a wish; resolves when it is answered.
   *
   * @param {Wish} wish
   * @returns {Promise<void>}
   */
  #post(wish) {
    return new Promise((resolve) => {
      this.#pending.push({ wish: wish.type, resolve });
      this.#send(wish);
    });
  }

  /** @param {Wish} wish */
  #send(wish) {
    this.#worker.postMessage(wish);
  }

  /** @param {Message} data */
  #hear(data) {
    const { figures } = this;
    figures.take(data);
    switch (data.type) {
      case 'ready':
        this.decoder = data.decoder;
        break;
      case 'header':
        this.#stage?.open(data.header);
        break;
      case 'plan':
        this.rounds.at(-1)?.plans.push(data.plan);
        break;
      case 'progress':
        if (this.#interrupted && data.received > figures.bytes) {
          this.#interrupted = false;
          figures.status = this.#wishStatus;
        }
        figures.bytes = data.received;
        this.bytesPerSecond = data.bytesPerSecond;
        break;
      case 'texture':
        this.#addTexture(data.path, data.bytes);
        break;
      case 'picture':
        this.#draw(data);
        break;
      case 'waiting':
        this.#interrupted = true;
        figures.status = data.text;
        break;
      case 'done':
        this.#done(data.complete);
        break;
      case 'complete':
        if (figures.state === 'idle') figures.state = 'complete';
        figures.status = '';
        break;
      case 'error':
        if (data.changed) this.#renew(data.message, data.changed === 'gone');
        else this.#fail(data.message, data.retryable);
        break;
    }
    this.#changed();
  }

  /** @param {Extract<Message, { type: 'picture' }>} message */
  #draw({ batches, received, drawn }) {
    this.figures.batches = batches;
    this.figures.faces = drawn.indices.length / 3;
    this.pictures++;
    if (this.figures.state === 'loading') this.figures.state = 'refining';
    if (this.figures.firstPicture === null) this.figures.firstPicture = { bytes: received, millis: performance.now() };
    this.#stage?.update(drawn);
    this.#send({ type: 'drawn' });
  }

  /**
   * @param {string} path
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  async #addTexture(path, bytes) {
    this.texturesLoading++;
    try {
      await this.#stage?.addTexture(path, bytes);
    } catch {
      this.figures.notice = `The texture ${path} is not an image that this browser can show.`;
      this.#changed();
    }
    this.texturesLoading--;
  }

  /** @param {boolean} complete */
  #done(complete) {
    const answered = this.#pending.shift();
    if (answered === undefined) return;
    const { wish, resolve } = answered;
    if (wish !== 'open') {
      if (complete) this.figures.state = 'complete';
      else if (this.figures.batches > 0) this.figures.state = 'idle';
      else this.#fail('Loading ended before there was anything to show.', true);
      this.figures.status = '';
      this.#interrupted = false;
    }
    resolve();
  }

  /**
   * The archive is another one by now, or gone: shows the new one from the start, if there is one.
   *
   * @param {string} message
   * @param {boolean} isGone
   */
  async #renew(message, isGone) {
    if (this.#opened === null) return;
    const { manifest, decoder, serverPlan, renew } = this.#opened;
    let now = null;
    if (this.#renewals++ < MOST_RENEWALS) now = await renew().catch(() => null);
    const isNew = now?.archiveSha256 === undefined ? !isGone : now.archiveSha256 !== manifest.archiveSha256;
    if (now === null || !isNew) {
      this.#fail(message, false);
      return;
    }
    const waiting = this.#pending.splice(0);
    this.#worker.terminate();
    this.figures = new Figures();
    this.#interrupted = false;
    this.#worker = this.#startWorker();
    this.#stage?.clear();
    this.renewed = 'The model was changed on the server while it was loading. This is the new one, from its beginning.';
    this.open(now, decoder, serverPlan, renew);
    await (this.#lastWish === 'complete' ? this.complete() : this.refine());
    waiting.forEach(({ resolve }) => resolve());
  }

  /**
   * @param {string} message
   * @param {boolean} retryable
   */
  #fail(message, retryable) {
    this.figures.state = 'error';
    this.figures.status = '';
    this.#interrupted = false;
    this.figures.error = message;
    this.figures.retryable = retryable;
    this.figures.identical = false;
    this.#changed();
    this.#pending.splice(0).forEach(({ resolve }) => resolve());
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}
