// @ts-check
// One archive's place in the worker: takes wishes one after the other through a port, and posts what comes of them.

import { ArchiveStream } from './archive-stream.js';
import { loadDecoder, prepare } from './load-decoder.js';
import { inWords } from './messages.js';

/** @import { Java } from './decoder.js' */
/** @import { Message, Opening, Wish } from './messages.js' */

export class Connection {
  #port;
  #first;
  /** @type {ArchiveStream | null} */
  #stream = null;
  /** @type {unknown} */
  #openError = null;
  #queue = Promise.resolve();
  /** As it was wished last, maybe while the decoder was loading. */
  #serverPlan = false;
  /** @type {import('./limiter.js').Limiter | null} */
  #limiter = null;
  #limiting = Promise.resolve();

  /**
   * @param {MessagePort} port
   * @param {() => Java} first makes a first decoder
   */
  constructor(port, first) {
    this.#port = port;
    this.#first = first;
    port.onmessage = (/** @type {MessageEvent<Wish>} */ { data }) => this.#hear(data);
  }

  /** @param {Wish} wish */
  #hear(wish) {
    if (wish.type === 'drawn') {
      this.#stream?.drawn();
    } else if (wish.type === 'serverPlan') {
      this.#serverPlan = wish.on;
      if (this.#stream !== null) this.#stream.serverPlan = wish.on;
    } else if (wish.type === 'limit') {
      this.#limiting = this.#limit(wish.bytesPerSecond);
    } else if (wish.type === 'mostFaces') {
      if (this.#stream !== null) this.#stream.mostFaces = wish.faces;
    } else if (wish.type === 'stop') {
      this.#stream?.stop();
    } else if (wish.type === 'close') {
      this.#stream?.stop();
      this.#port.close();
    } else {
      if (wish.type === 'open') this.#serverPlan = wish.serverPlan;
      this.#queue = this.#queue.then(() => this.#handle(wish));
    }
  }

  /** @param {Extract<Wish, { id?: number }>} wish */
  async #handle(wish) {
    if (wish.type === 'prepare') {
      await prepare();
      this.#post({ type: 'done', id: wish.id, complete: false });
      return;
    }
    try {
      const stream = wish.type === 'open' ? await this.#open(wish) : this.#stream;
      if (stream === null) throw this.#openError;
      if (wish.type === 'round') await stream.round(wish.waitMillis);
      else if (wish.type === 'prefix') await stream.prefix(wish.bytes);
      else if (wish.type === 'complete') await stream.complete();
      this.#post({ type: 'done', id: wish.id, complete: stream.isComplete });
    } catch (error) {
      if (this.#stream === null) this.#post({ type: 'error', ...inWords(error) });
      else await this.#stream.fail(error);
    }
  }

  /** @param {number} bytesPerSecond 0 for no limit */
  async #limit(bytesPerSecond) {
    const { Limiter } = await import('./limiter.js');
    this.#limiter = bytesPerSecond > 0 ? new Limiter(bytesPerSecond) : null;
    if (this.#stream !== null) this.#stream.limiter = this.#limiter;
  }

  /** @param {Opening} opening */
  async #open(opening) {
    this.#stream = null;
    const post = (/** @type {Message} */ message, /** @type {ArrayBuffer[]} */ transfer = []) => this.#post(message, transfer);
    try {
      this.#stream = new ArchiveStream(await this.#load(opening.decoder), opening, post);
    } catch (error) {
      // Wishes that are queued already find no stream: they fail for the same reason.
      this.#openError = error;
      throw error;
    }
    await this.#limiting;
    this.#stream.limiter = this.#limiter;
    if (this.#limiter === null) learn(this.#stream.decoder, opening.link);
    this.#stream.serverPlan = this.#serverPlan;
    this.#post({ type: 'ready', decoder: this.#stream.decoder.kind });
    return this.#stream;
  }

  /** @param {string} wanted */
  #load(wanted) {
    return loadDecoder(wanted, this.#first, ({ kind }) => this.#post({ type: 'ready', decoder: kind }));
  }

  /**
   * @param {Message} message
   * @param {ArrayBuffer[]} [transfer]
   */
  #post(message, transfer = []) {
    this.#port.postMessage(message, { transfer });
  }
}

/**
 * Tells the planner of files that came over the link before.
 *
 * @param {import('./decoder.js').Decoder} decoder
 * @param {number[]} [link] milliseconds and bytes of each
 */
function learn(decoder, link = []) {
  const [took = 0] = link.slice(-2);
  const start = performance.now() - took;
  decoder.beginResponse(start);
  for (let i = 0; i < link.length; i += 2) decoder.arrived(start + link[i], link[i + 1]);
  decoder.endResponse(false);
}
