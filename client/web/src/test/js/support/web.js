// What browsers have and Node lacks, and a server that answers from memory.

/** @typedef {{ url: string, range: string | null, ifRange: string | null }} Asked */

/** @param {string} href the address of the page */
export function standOn(href) {
  const { origin } = new URL(href);
  Object.assign(globalThis, { location: { href, origin } });
}

/** @param {number} length */
export function bytesUpTo(length) {
  return Uint8Array.from({ length }, (_, i) => (i * 37 + (i >> 8)) & 255);
}

/**
 * Makes fetch() answer by a function of the request; gives the list of what was asked.
 *
 * @param {import('node:test').TestContext} t
 * @param {(asked: Asked, number: number) => Response | Promise<Response>} answer
 */
export function serve(t, answer) {
  /** @type {Asked[]} */
  const asked = [];
  t.mock.method(globalThis, 'fetch', async (/** @type {string | URL} */ url, /** @type {RequestInit} */ init = {}) => {
    const headers = new Headers(init.headers);
    asked.push({ url: String(url), range: headers.get('Range'), ifRange: headers.get('If-Range') });
    init.signal?.throwIfAborted();
    return answer(asked[asked.length - 1], asked.length - 1);
  });
  return asked;
}

/**
 * The answer of a host that knows ranges.
 *
 * @param {Asked} asked
 * @param {Uint8Array<ArrayBuffer>} file
 * @param {{ etag?: string, breaksAt?: number }} [how] the connection breaks at this byte of the file
 */
export function partOf({ range }, file, { etag = '"a"', breaksAt = Infinity } = {}) {
  const [, first, last] = /^bytes=(\d+)-(\d*)$/.exec(range ?? '') ?? [];
  const from = Number(first);
  const end = last === '' ? file.length : Math.min(Number(last) + 1, file.length);
  const headers = { 'Content-Range': `bytes ${from}-${end - 1}/${file.length}`, ETag: etag };
  return new Response(streamOf(file.subarray(from, Math.min(end, breaksAt)), breaksAt < end), { status: 206, headers });
}

/**
 * A body that comes in pieces of 100 bytes and may break at its end.
 *
 * @param {Uint8Array<ArrayBuffer>} bytes
 */
export function streamOf(bytes, breaks = false) {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at < bytes.length) controller.enqueue(bytes.slice(at, (at += 100)));
      else if (breaks) controller.error(new TypeError('network error'));
      else controller.close();
    },
  });
}

/**
 * Pauses pass at once; gives the list of how long they were to take.
 *
 * @param {import('node:test').TestContext} t
 * @param {(millis: number) => boolean} which
 */
export function skipPauses(t, which = () => true) {
  /** @type {number[]} */
  const skipped = [];
  const wait = globalThis.setTimeout;
  t.mock.method(globalThis, 'setTimeout', (/** @type {() => void} */ work, millis = 0) => {
    if (!which(millis)) return wait(work, millis);
    skipped.push(millis);
    return wait(work, 0);
  });
  return skipped;
}
