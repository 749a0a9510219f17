// @ts-check
// Ranges of one immutable file, read as they arrive and resumed where a connection broke. A host that answers with the whole file is read on and on.

import { Body } from './body.js';
import { BACKOFF_MILLIS, inWords, pause, retryAfterMillis } from '../session/retry.js';

/** @import { Access } from './messages.js' */
/** @typedef {{ url: string, from: number | null, end: number | null, status: number, bytes: number }} Entry what became of a request */
/**
 * @typedef {object} Listener
 * @property {(from: number | null, end: number | null) => void} begin of every request
 * @property {(chunk: Uint8Array<ArrayBuffer>) => void | Promise<void>} bytes which may take its time
 * @property {(entry: Entry) => void} end of every request
 * @property {(text: string) => void} waiting before another try
 */
/**
 * @typedef {object} ReadOptions
 * @property {string | null} [plannedUrl] with the bytes from the first one on, as many as it likes; what is missing is read as a range
 * @property {boolean} [endsAtStall] a silent connection is not tried again
 */

/** A silent connection counts as broken. */
const STALL_MILLIS = 10000;
/** Answers of a host that does not plan. */
const PLANS_NOT = [400, 403, 404, 405, 501];

/**
 * What went wrong, in words; `retryable` says whether trying again can help, `changed` whether the file is 'another' or 'gone', `waitMillis` how long the server
 * wants to be left alone.
 */
export class DownloadError extends Error {
  /**
   * @param {string} message
   * @param {boolean} retryable
   * @param {'another' | 'gone' | null} changed
   */
  constructor(message, retryable, changed = null, waitMillis = 0) {
    super(message);
    this.retryable = retryable;
    this.changed = changed;
    this.waitMillis = waitMillis;
  }
}

class StalledError extends DownloadError {
  constructor() {
    super(`nothing came for ${STALL_MILLIS / 1000} s`, true);
  }
}

class PlansNot extends DownloadError {
  constructor() {
    super('the host does not plan', true);
  }
}

export class Download {
  /** @type {string | null} */
  #etag = null;
  #interrupted = false;
  /** @type {Body | null} */
  #whole = null;

  /**
   * @param {string} url of the file
   * @param {Listener} listener
   * @param {Access} access
   */
  constructor(url, listener, access = {}) {
    this.url = url;
    this.access = access;
    this.listener = listener;
    /** @type {number | null} */
    this.totalBytes = null;
    this.isPlanned = true;
    /** @type {import('./limiter.js').Limiter | null} */
    this.limiter = null;
    // Asking with If-Range is left out where the browser would first ask whether it may: the tag of the answer is compared anyway.
    this.sameOrigin = new URL(url, location.href).origin === location.origin;
  }

  /** True from a break until bytes come again, or it is given up. */
  get isInterrupted() {
    return this.#interrupted;
  }

  /**
   * Reads bytes `from` to before `end` (null: to the end of the file), trying again after breaks. Resolves early when aborted.
   *
   * @param {number} from
   * @param {number | null} end
   * @param {AbortSignal} signal
   * @param {ReadOptions} options
   */
  async read(from, end, signal, options = {}) {
    try {
      await this.#persist(from, end, signal, options);
    } finally {
      this.#interrupted = false;
    }
  }

  /**
   * @param {number} from
   * @param {number | null} end
   * @param {AbortSignal} signal
   * @param {ReadOptions} options
   */
  async #persist(from, end, signal, { plannedUrl = null, endsAtStall = false }) {
    let at = from;
    const count = (/** @type {Uint8Array} */ chunk) => {
      at += chunk.length;
      this.#interrupted = false;
    };
    for (let failures = 0; failures === 0 || end === null || at < end; ) {
      const before = at;
      try {
        if (plannedUrl !== null && this.isPlanned && failures === 0) return await this.#request(plannedUrl, null, null, signal, count);
        await this.#request(this.url, at, end, signal, count);
        const want = end === null ? this.totalBytes : Math.min(end, this.totalBytes ?? end);
        if (want === null || at >= want || signal.aborted) return;
        throw new DownloadError('the connection was closed early', true);
      } catch (error) {
        if (signal.aborted) return;
        if (error instanceof PlansNot) {
          this.isPlanned = false;
          continue;
        }
        if (!(error instanceof DownloadError && error.retryable)) throw error;
        if (error instanceof StalledError && endsAtStall) {
          throw new DownloadError(`The server is silent: ${error.message}. What has arrived is kept.`, true);
        }
        failures = at > before ? 1 : failures + 1;
        if (failures > BACKOFF_MILLIS.length) throw this.#givenUp(at, error);
        this.#interrupted = true;
        this.listener.waiting(inWords(error.waitMillis, failures));
        await pause(Math.max(error.waitMillis, BACKOFF_MILLIS[failures - 1]), signal);
        if (signal.aborted) return;
      }
    }
  }

  /** @param {number} at @param {DownloadError} error */
  #givenUp(at, error) {
    const reason = error.message.replace(/\.$/, '');
    if (at === 0) return new DownloadError(`${this.url} cannot be fetched (${reason}). Check the address and the connection.`, true);
    return new DownloadError(`The connection to the server broke at byte ${at} and did not come back (${reason}).`, true);
  }

  /**
   * @param {string} url
   * @param {number | null} from null: as many bytes as the answer has
   * @param {number | null} end
   * @param {AbortSignal} signal
   * @param {(chunk: Uint8Array) => void} count
   */
  async #request(url, from, end, signal, count) {
    this.listener.begin(from, end);
    /** @type {Entry} */
    const entry = { url, from, end, status: 0, bytes: 0 };
    const request = new AbortController();
    const abort = () => request.abort();
    signal.addEventListener('abort', abort);
    try {
      const body = from !== null && this.#whole?.at === from ? this.#whole : await this.#open(url, from, end, request.signal);
      entry.status = body.status;
      // An answer to a range ends by itself; a whole file is read no further than is wished now.
      const most = from === null || end === null ? Infinity : end - from;
      while (entry.bytes < most || body.status === 206) {
        const skip = from === null ? 0 : Math.max(0, from - body.at);
        const wanted = Math.min(skip > 0 ? skip : most - entry.bytes, this.limiter?.portion ?? Infinity);
        const chunk = await body.next(wanted, request.signal, overNetwork);
        if (chunk === null) {
          if (body === this.#whole && !signal.aborted) this.#setTotal(body.at);
          break;
        }
        await this.limiter?.spend(chunk.length, request.signal);
        if (skip > 0) continue;
        entry.bytes += chunk.length;
        count(chunk);
        await this.listener.bytes(chunk);
      }
    } catch (error) {
      this.#whole = null;
      request.abort();
      throw error;
    } finally {
      signal.removeEventListener('abort', abort);
      this.listener.end(entry);
    }
  }

  /**
   * The body of a new answer, whose head has been checked.
   *
   * @param {string} url
   * @param {number | null} from
   * @param {number | null} end
   * @param {AbortSignal} signal
   */
  async #open(url, from, end, signal) {
    this.#whole?.cancel();
    this.#whole = null;
    const headers = { ...this.access.headers };
    if (from !== null) {
      headers.Range = `bytes=${from}-${end === null ? '' : end - 1}`;
      if (this.#etag !== null && this.sameOrigin) headers['If-Range'] = this.#etag;
    }
    // A whole file is read on when this request is over: it has a life of its own.
    const life = new AbortController();
    const abort = () => life.abort();
    signal.addEventListener('abort', abort);
    try {
      const response = await overNetwork(fetch(url, { headers, credentials: this.access.credentials, signal: life.signal }));
      if (from === null) return planned(response, life);
      this.sameOrigin &&= !response.redirected; // another server may have answered
      this.#check(response, from);
      const etag = response.headers.get('ETag');
      if (etag !== null && !etag.startsWith('W/')) this.#etag = etag;
      const body = new Body(response, life, response.status === 200 ? 0 : from, response.status === 200);
      if (response.status === 200) this.#whole = body;
      return body;
    } catch (error) {
      life.abort(); // a silent request would hold up the next one of the same file
      throw error;
    } finally {
      signal.removeEventListener('abort', abort);
    }
  }

  /** @param {Response} response @param {number} from */
  #check(response, from) {
    const etag = response.headers.get('ETag');
    const isOther = this.#etag !== null && etag !== null && etag !== this.#etag && !etag.startsWith('W/');
    if (response.status === 206) {
      const range = /^bytes (\d+)-(\d+)\/(\d+|\*)$/.exec(response.headers.get('Content-Range') ?? `bytes ${from}-${from}/*`);
      if (range === null || Number(range[1]) !== from) throw new DownloadError('The server answered with another range than it was asked for.', false);
      if (isOther) throw changedFile('it has another tag');
      if (range[3] !== '*') this.#setTotal(Number(range[3]));
    } else if (response.status === 200) {
      if (isOther) throw changedFile('it has another tag');
      const length = response.headers.get('Content-Length');
      // The length of a compressed answer is not that of the file, and other origins do not say that they compress.
      if (length !== null && this.sameOrigin && !response.headers.has('Content-Encoding')) this.#setTotal(Number(length));
    } else {
      throw refused(response);
    }
  }

  /** @param {number} bytes */
  #setTotal(bytes) {
    if (this.totalBytes !== null && this.totalBytes !== bytes) throw changedFile(`it has ${bytes} bytes instead of ${this.totalBytes}`);
    this.totalBytes = bytes;
  }
}

/**
 * @param {Response} response
 * @param {AbortController} life
 */
function planned(response, life) {
  if (response.status === 200) return new Body(response, life, 0, false);
  life.abort();
  if (PLANS_NOT.includes(response.status)) throw new PlansNot();
  throw refused(response);
}

/** @param {Response} response */
function refused(response) {
  const { status } = response;
  if (status === 416) return changedFile('it is shorter than its index says');
  const isGone = status === 404 || status === 410;
  const isPassing = status >= 500 || status === 429 || status === 408;
  return new DownloadError(`The server refused the file (HTTP status ${status}).`, isPassing, isGone ? 'gone' : null, retryAfterMillis(response));
}

/** @param {string} how */
function changedFile(how) {
  return new DownloadError(`The file on the server has changed since it was opened: ${how}. Reload the page.`, false, 'another');
}

/**
 * A failure of the network, told apart from one of whoever takes the bytes; silence is one, too.
 *
 * @template T
 * @param {Promise<T>} promise
 * @returns {Promise<T>}
 */
function overNetwork(promise) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** @type {Promise<never>} */
  const silence = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new StalledError()), STALL_MILLIS);
  });
  const answer = promise.catch((error) => {
    throw new DownloadError(error.message, true);
  });
  return Promise.race([answer, silence]).finally(() => clearTimeout(timer));
}
