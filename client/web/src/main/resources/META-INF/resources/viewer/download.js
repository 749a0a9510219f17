// Ranges of one immutable file, read as they arrive and resumed at the byte where a connection broke.

const BACKOFF_MILLIS = [250, 500, 1000, 2000, 4000];
/** A connection over which nothing comes for so long counts as broken. */
const STALL_MILLIS = 10000;

/** What went wrong, in words; `retryable` says whether trying again can help. */
export class DownloadError extends Error {
  constructor(message, retryable) {
    super(message);
    this.retryable = retryable;
  }
}

class StalledError extends DownloadError {
  constructor() {
    super(`nothing came for ${STALL_MILLIS / 1000} s`, true);
  }
}

export class Download {
  #etag = null;
  #interrupted = false;

  /**
   * @param url of the file
   * @param listener `begin()`, `bytes(chunk)` (which may take its time), `end(entry)` for every request, and `waiting(message)` before another try
   */
  constructor(url, listener) {
    this.url = url;
    this.listener = listener;
    this.totalBytes = null;
  }

  /** True from a break until bytes come again, or it is given up. */
  get isInterrupted() {
    return this.#interrupted;
  }

  /**
   * Reads bytes `from` to before `end` (null: to the end of the file), trying again after breaks. Resolves early when aborted.
   *
   * @param options `plannedUrl`: a resource that holds the bytes from `from` on, as many as it likes, asked first; what it leaves out when it breaks is read as a
   *     range. `endsAtStall`: a silent connection is not tried again
   */
  async read(from, end, signal, options = {}) {
    try {
      await this.#persist(from, end, signal, options);
    } finally {
      this.#interrupted = false;
    }
  }

  async #persist(from, end, signal, { plannedUrl = null, endsAtStall = false }) {
    let at = from;
    const count = (chunk) => {
      at += chunk.length;
      this.#interrupted = false;
    };
    for (let failures = 0; failures === 0 || end === null || at < end; ) {
      const before = at;
      try {
        if (plannedUrl !== null && failures === 0) return await this.#request(plannedUrl, null, null, signal, count);
        await this.#request(this.url, at, end, signal, count);
        const want = end === null ? this.totalBytes : Math.min(end, this.totalBytes ?? end);
        if (want === null || at >= want) return;
        throw new DownloadError('the connection was closed early', true);
      } catch (error) {
        if (signal.aborted) return;
        if (!(error instanceof DownloadError && error.retryable)) throw error;
        if (error instanceof StalledError && endsAtStall) {
          throw new DownloadError(`The server is silent: ${error.message}. What has arrived is kept.`, true);
        }
        failures = at > before ? 1 : failures + 1;
        if (failures > BACKOFF_MILLIS.length) throw this.#givenUp(at, error);
        this.#interrupted = true;
        this.listener.waiting(`Connection lost; trying again (${failures} of ${BACKOFF_MILLIS.length})`);
        await pause(BACKOFF_MILLIS[failures - 1], signal);
        if (signal.aborted) return;
      }
    }
  }

  #givenUp(at, error) {
    const reason = error.message.replace(/\.$/, '');
    if (at === 0) return new DownloadError(`${this.url} cannot be fetched (${reason}). Check the address and the connection.`, true);
    return new DownloadError(`The connection to the server broke at byte ${at} and did not come back (${reason}).`, true);
  }

  async #request(url, from, end, signal, count) {
    const headers = {};
    if (from !== null) {
      headers.Range = `bytes=${from}-${end === null ? '' : end - 1}`;
      if (this.#etag !== null) headers['If-Range'] = this.#etag;
    }
    this.listener.begin(from, end);
    const entry = { url: String(url), from, end, status: 0, bytes: 0 };
    const request = new AbortController();
    const abort = () => request.abort();
    signal.addEventListener('abort', abort);
    try {
      const response = await overNetwork(fetch(url, { headers, signal: request.signal }));
      entry.status = response.status;
      let skip = this.#check(response, from);
      const etag = response.headers.get('ETag');
      if (from !== null && etag !== null && !etag.startsWith('W/')) this.#etag = etag;
      const reader = response.body.getReader();
      const most = from === null || end === null ? Infinity : end - from;
      // A 206 ends by itself; only a whole file is cut short.
      while (entry.bytes < most || response.status === 206) {
        const { done, value } = await overNetwork(reader.read());
        if (done) break;
        const chunk = value.subarray(Math.min(skip, value.length), Math.min(value.length, skip + most - entry.bytes));
        skip -= Math.min(skip, value.length);
        if (chunk.length === 0) continue;
        entry.bytes += chunk.length;
        count(chunk);
        await this.listener.bytes(chunk);
      }
      if (response.status === 200 && entry.bytes >= most) reader.cancel().catch(() => {});
    } catch (error) {
      request.abort();
      throw error;
    } finally {
      signal.removeEventListener('abort', abort);
      this.listener.end(entry);
    }
  }

  /** Bytes to skip at the beginning of a response: none, unless the server answered a range with the whole file. */
  #check(response, from) {
    if (response.status === 206) {
      const range = /^bytes (\d+)-(\d+)\/(\d+|\*)$/.exec(response.headers.get('Content-Range') ?? '');
      if (range === null || Number(range[1]) !== from) throw new DownloadError('The server answered with another range than it was asked for.', false);
      if (range[3] !== '*') this.#setTotal(Number(range[3]));
      return 0;
    }
    if (response.status === 200) {
      if (from === null) return 0;
      if (this.#etag !== null && response.headers.get('ETag') !== this.#etag) {
        throw new DownloadError('The file on the server has changed since it was opened. Reload the page.', false);
      }
      const length = response.headers.get('Content-Length');
      if (length !== null) this.#setTotal(Number(length));
      return from;
    }
    const words = response.status === 416 ? 'The file on the server is shorter than its index says' : 'The server refused the file';
    throw new DownloadError(`${words} (HTTP status ${response.status}).`, response.status >= 500 || response.status === 429);
  }

  #setTotal(bytes) {
    if (this.totalBytes !== null && this.totalBytes !== bytes) {
      throw new DownloadError(`The file on the server has ${bytes} bytes instead of ${this.totalBytes}. Reload the page.`, false);
    }
    this.totalBytes = bytes;
  }
}

/** A failure of the network, told apart from one of whoever takes the bytes; silence is one, too. */
function overNetwork(promise) {
  let timer;
  const silence = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new StalledError()), STALL_MILLIS);
  });
  const answer = promise.catch((error) => {
    throw new DownloadError(error.message, true);
  });
  return Promise.race([answer, silence]).finally(() => clearTimeout(timer));
}

function pause(millis, signal) {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, millis);
    signal.addEventListener('abort', () => (clearTimeout(timer), resolve()), { once: true });
  });
}
