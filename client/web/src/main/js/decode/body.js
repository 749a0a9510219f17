// @ts-check
// The bytes of one answer, in as large pieces as are wished: what was read too far waits for the next wish, and who stops reading holds the sender back.

export class Body {
  #reader;
  #life;
  #outlives;
  /** @type {Promise<ReadableStreamReadResult<Uint8Array<ArrayBuffer>>> | null} */
  #pending = null;
  /** @type {Uint8Array<ArrayBuffer> | null} */
  #rest = null;

  /**
   * @param {Response} response whose body is read
   * @param {AbortController} life gives the answer up
   * @param {number} at offset in the file of the first byte
   * @param {boolean} outlives whether the answer is to be read on after an abort
   */
  constructor(response, life, at, outlives) {
    // Only answers that must not have a body have none.
    this.#reader = (response.body ?? new Blob().stream()).getReader();
    this.#life = life;
    this.#outlives = outlives;
    this.status = response.status;
    this.at = at;
  }

  /**
   * At most so many bytes; null at the end, or when aborted.
   *
   * @param {number} most
   * @param {AbortSignal} signal
   * @param {<T>(promise: Promise<T>) => Promise<T>} guard wraps waiting for the network
   */
  async next(most, signal, guard) {
    if (this.#rest === null) {
      this.#pending ??= this.#reader.read();
      const result = await orAborted(guard(this.#pending), signal);
      if (result === null) {
        if (!this.#outlives) this.cancel();
        return null;
      }
      this.#pending = null;
      if (result.done) return null;
      this.#rest = result.value;
    }
    const rest = this.#rest;
    const chunk = rest.length > most ? rest.subarray(0, most) : rest;
    this.#rest = chunk.length < rest.length ? rest.subarray(chunk.length) : null;
    this.at += chunk.length;
    return chunk;
  }

  cancel() {
    this.#life.abort();
  }
}

/**
 * What a promise brings, or null when the signal comes before.
 *
 * @template T
 * @param {Promise<T>} promise
 * @param {AbortSignal} signal
 * @returns {Promise<T | null>}
 */
async function orAborted(promise, signal) {
  if (signal.aborted) return null;
  return new Promise((resolve, reject) => {
    const abort = () => resolve(null);
    signal.addEventListener('abort', abort, { once: true });
    promise.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
  });
}
