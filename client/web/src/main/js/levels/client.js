// @ts-check
// The page's way to the worker that decodes levels.

/** @import { Opening } from './levels-worker.js' */
/** @import { Level, Refusal, Wish } from './service.js' */
/** @typedef {{ level: (level: Level) => void, refused: (side: Wish['side'], reason: string) => void }} Listener */

export class Client {
  #worker = new Worker(new URL('./levels-worker.js', import.meta.url), { type: 'module' });
  #count = 0;
  /** The wish of each side that was sent last. @type {Partial<Record<Wish['side'], number>>} */
  #last = {};

  /**
   * @param {Opening} opening
   * @param {Listener} listener hears of the last wish of each side alone
   */
  constructor(opening, { level, refused }) {
    this.#worker.onmessage = (/** @type {MessageEvent<Level | Refusal>} */ { data }) => {
      if (this.#last[data.side] !== data.id) return;
      if ('error' in data) refused(data.side, data.error);
      else level(data);
    };
    this.#worker.onerror = (event) => {
      for (const side of /** @type {const} */ (['left', 'right'])) refused(side, event.message || 'the worker did not load');
    };
    this.#worker.postMessage(opening);
  }

  /** @param {Omit<Wish, 'id'>} wish */
  ask(wish) {
    const id = ++this.#count;
    this.#last[wish.side] = id;
    this.#worker.postMessage({ ...wish, id });
  }

  /** No answer to the last wish is heard. @param {Wish['side']} side */
  forget(side) {
    delete this.#last[side];
  }

  close() {
    this.#worker.terminate();
  }
}
