// @ts-check
// What was wished of the worker and is not answered yet. It answers one wish after the other.

/** @import { Wish } from '../decode/messages.js' */
/** @typedef {{ id: number, wish: Wish['type'], resolve: () => void }} Pending */

export class Wishes {
  #count = 0;
  /** @type {Pending[]} */
  #pending = [];

  /**
   * Sends a wish; resolves when it is answered.
   *
   * @param {Extract<Wish, { id?: number }>} wish
   * @param {(wish: Wish) => void} send
   * @returns {Promise<void>}
   */
  send(wish, send) {
    return new Promise((resolve) => {
      const id = ++this.#count;
      this.#pending.push({ id, wish: wish.type, resolve });
      send({ ...wish, id });
    });
  }

  /**
   * The wish of an answer; nobody waits for one that comes after an error.
   *
   * @param {number | undefined} id
   */
  answered(id) {
    return this.#pending[0]?.id === id ? this.#pending.shift() : undefined;
  }

  /** Gives up all; gives what resolves them. */
  clear() {
    const pending = this.#pending.splice(0);
    return () => pending.forEach(({ resolve }) => resolve());
  }
}
