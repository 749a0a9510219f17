// The bytes of one answer, in as large pieces as are wished: what was read too far waits for the next wish, and who stops reading holds the sender back.

export class Body {
  #reader;
  #life;
  #outlives;
  #pending = null;
  #rest = null;

  /**
   * @param response whose body is read
   * @param life gives the answer up
   * @param at offset in the file of the first byte
   * @param outlives whether the answer is to be read on after an abort
   */
  constructor(response, life, at, outlives) {
    this.#reader = response.body.getReader();
    this.#life = life;
    this.#outlives = outlives;
    this.status = response.status;
    this.at = at;
  }

  /**
   * At most so many bytes; null at the end, or when aborted.
   *
   * @param guard wraps waiting for the network
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
    const chunk = this.#rest.length > most ? this.#rest.subarray(0, most) : this.#rest;
    this.#rest = chunk.length < this.#rest.length ? this.#rest.subarray(chunk.length) : null;
    this.at += chunk.length;
    return chunk;
  }

  cancel() {
    this.#life.abort();
  }
}

/** What a promise brings, or null when the signal comes before. */
function orAborted(promise, signal) {
  if (signal.aborted) return null;
  return new Promise((resolve, reject) => {
    const abort = () => resolve(null);
    signal.addEventListener('abort', abort, { once: true });
    promise.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
  });
}
