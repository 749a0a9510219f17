// When to ask again a server that did not answer as wished.

/** Pauses before further attempts: there are no more than these. */
export const BACKOFF_MILLIS = [250, 500, 1000, 2000, 4000];
/** Nobody in front of a picture waits longer for one answer. */
const MOST_SECONDS = 30;

/** What a busy server says of how long it wants to be left alone; 0 when it says nothing, or a date. */
export function retryAfterMillis(response) {
  const text = response.headers.get('Retry-After') ?? '';
  const isBusy = response.status === 429 || response.status === 503;
  return isBusy && /^\d+$/.test(text) ? 1000 * Math.min(Number(text), MOST_SECONDS) : 0;
}

/** Ends early when aborted. */
export function pause(millis, signal) {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, millis);
    signal?.addEventListener('abort', () => (clearTimeout(timer), resolve()), { once: true });
  });
}

/** What whoever waits is told. */
export function inWords(millis, attempt) {
  const count = `(${attempt} of ${BACKOFF_MILLIS.length})`;
  return millis > 0 ? `The server is busy; trying again in ${millis / 1000} s ${count}` : `Connection lost; trying again ${count}`;
}
