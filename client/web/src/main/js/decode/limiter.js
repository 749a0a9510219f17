// @ts-check
// Holds reading back to a rate, as a slow link would. It imports nothing, so that the worker stays one file without it.

/** How much time's worth of bytes is read at once, and may be caught up on when a timer was late. */
const PORTION_MILLIS = 50;

export class Limiter {
  #bytesPerMilli;
  /** When the bytes that were read would have come over such a link. */
  #clearAt = 0;
  #now;

  /**
   * @param {number} bytesPerSecond
   * @param {() => number} now
   */
  constructor(bytesPerSecond, now = () => performance.now()) {
    this.#bytesPerMilli = bytesPerSecond / 1000;
    this.#now = now;
    /** Bytes that are read at once. */
    this.portion = Math.max(1, Math.round(this.#bytesPerMilli * PORTION_MILLIS));
  }

  /**
   * Resolves when so many bytes would have come, or when aborted.
   *
   * @param {number} bytes
   * @param {AbortSignal} signal
   * @returns {Promise<void>}
   */
  spend(bytes, signal) {
    const now = this.#now();
    this.#clearAt = Math.max(this.#clearAt, now - PORTION_MILLIS) + bytes / this.#bytesPerMilli;
    const millis = this.#clearAt - now;
    if (millis <= 0 || signal.aborted) return Promise.resolve();
    return new Promise((resolve) => {
      const end = () => {
        clearTimeout(timer);
        signal.removeEventListener('abort', end);
        resolve();
      };
      const timer = setTimeout(end, millis);
      signal.addEventListener('abort', end);
    });
  }
}
