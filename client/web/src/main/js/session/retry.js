// @ts-check
// When to ask again a server that did not answer as wished.

/** Pauses before further attempts: there are no more than these. */
export const BACKOFF_MILLIS = [250, 500, 1000, 2000, 4000];
/** Nobody in front of a picture waits longer for one answer. */
const MOST_SECONDS = 30;

/**
 * What a server that is busy, or prepares the answer, says of how long it wants to be left alone; 0 when it says nothing, or a date.
 *
 * @param {Pick<Response, 'status' | 'headers'>} response
 */
export function retryAfterMillis(response) {
  const text = response.headers.get('Retry-After') ?? '';
  const isBusy = [202, 429, 503].includes(response.status);
  return isBusy && /^\d+$/.test(text) ? 1000 * Math.min(Number(text), MOST_SECONDS) : 0;
}

/**
 * Ends early when aborted.
 *
 * @param {number} millis
 * @param {AbortSignal} [signal]
 * @returns {Promise<void>}
 */
export function pause(millis, signal) {
  if (signal?.aborted) return Promise.resolve();
  return new Promise((resolve) => {
    const end = () => {
      clearTimeout(timer);
      signal?.removeEventListener('abort', end);
      resolve();
    };
    const timer = setTimeout(end, millis);
    signal?.addEventListener('abort', end);
  });
}

/**
 * What whoever waits is told.
 *
 * @param {number} millis for which the server wants to be left alone
 * @param {number} attempt from 1 on
 */
export function inWords(millis, attempt) {
  const count = `(${attempt} of ${BACKOFF_MILLIS.length})`;
  return millis > 0 ? `The server is busy; trying again in ${millis / 1000} s ${count}` : `Connection lost; trying again ${count}`;
}
