// @ts-check
// Two decoders in a row: a small one, which comes soon and knows the base and the first splits, and the whole one, which takes over when it has come. It is fed all
// bytes from the start, and hears again what the planner was told, so that the estimate goes on.

import { valueOf } from './answers.js';

/** @import { Java, Method } from './decoder.js' */
/** @import { Whole } from './load-decoder.js' */

/** What the planner learns from. */
const PLANNING = /** @type {const} */ (['beginRound', 'nextRequest', 'beginResponse', 'arrived', 'endResponse']);
/** No request: the planner has no time left, and does not count it. */
const NOTHING = JSON.stringify({ value: null });
/** What the first decoder lacks, with its answers. */
const LACKING = /** @type {const} */ ({ isComplete: false, images: [] });

export class Relay {
  /** @type {Java} */
  #java;
  #load;
  /** @type {Promise<Whole> | null} */
  #whole = null;
  /** @type {Whole | null} */
  #next = null;
  /** @type {Uint8Array[]} */
  #fed = [];
  #batches = 0;
  /** @type {[Method, unknown[]][]} */
  #heard = [];
  #isWaiting = false;
  /** Has the first decoder stopped amid a batch, so that it cannot draw? */
  isBroken = false;

  /**
   * @param {Java} first what FirstDecoderMain exports
   * @param {() => Promise<Whole>} load loads the whole decoder
   */
  constructor(first, load) {
    this.#java = first;
    this.#load = load;
    this.isFirst = true;
    /** @type {Java} the methods of whichever decodes now */
    this.java = this.#methods();
  }

  /** The whole decoder, which comes from now on at the latest. */
  whole() {
    if (this.#whole === null) {
      this.#whole = this.#load();
      this.#whole.then((come) => (this.#next = come)).catch(() => {}); // whoever waits is told
    }
    return this.#whole;
  }

  /** Are there bytes that only the whole decoder can decode? */
  get isWaiting() {
    return this.#isWaiting;
  }

  /** Has the whole decoder come, and is the first one still at work? */
  get isDue() {
    return this.isFirst && this.#next !== null;
  }

  /**
   * The whole decoder takes over, which has come.
   *
   * @returns {'wasm' | 'js'} its kind
   * @throws {DamagedArchive} when it finds damage in the bytes so far
   */
  takeOver() {
    if (this.#next === null) throw new Error('the whole decoder has not come');
    const { kind, java } = this.#next;
    this.#java = java;
    this.isFirst = false;
    this.isBroken = false;
    this.#isWaiting = false;
    valueOf(() => java.open());
    for (const [method, args] of this.#heard) valueOf(() => Reflect.apply(java[method], undefined, args));
    for (const bytes of this.#fed) this.#batches = this.#stage(bytes);
    this.#fed = [];
    this.#heard = [];
    return kind;
  }

  /**
   * @param {Uint8Array} bytes
   * @returns {number} batches
   */
  #stage(bytes) {
    let batches = this.#batches;
    for (let from = 0; from < bytes.length; ) {
      const staging = this.#java.staging();
      const part = bytes.subarray(from, from + staging.length);
      staging.set(part);
      batches = valueOf(() => this.#java.feed(part.length));
      from += part.length;
    }
    return batches;
  }

  /** @returns {Java} */
  #methods() {
    /** @type {any} */
    const methods = new Proxy({}, { get: (_, method) => this.#method(/** @type {Method} */ (method)) });
    return methods;
  }

  /**
   * @param {Method | 'staging'} method
   * @returns {Function}
   */
  #method(method) {
    if (!this.isFirst || method === 'staging') return this.#java[method];
    if (method === 'open') return () => this.#open();
    if (method === 'feed') return (/** @type {number} */ length) => this.#feed(length);
    if (method in LACKING) return () => JSON.stringify({ value: LACKING[/** @type {keyof typeof LACKING} */ (method)] });
    if (!PLANNING.some((name) => name === method)) return this.#java[method];
    return (/** @type {unknown[]} */ ...args) => {
      /** @type {string} */
      const answer = Reflect.apply(this.#java[method], undefined, args);
      if (method !== 'nextRequest' || answer !== NOTHING) this.#heard.push([method, args]);
      return answer;
    };
  }

  #open() {
    this.#fed = [];
    this.#batches = 0;
    this.isBroken = false;
    this.#isWaiting = false;
    return this.#java.open();
  }

  /**
   * Whatever stops the first decoder, the whole one tells the reason, if there is one.
   *
   * @param {number} length
   */
  #feed(length) {
    this.#fed.push(new Uint8Array(this.#java.staging().slice(0, length).buffer));
    if (!this.#isWaiting) {
      try {
        /** @type {number} */
        const batches = valueOf(() => this.#java.feed(length));
        this.#isWaiting = batches < 0;
        this.#batches = batches < 0 ? -1 - batches : batches;
      } catch {
        this.#isWaiting = true;
        this.isBroken = true;
      }
    }
    return JSON.stringify({ value: this.#batches });
  }
}
