// @ts-check
// The page's way to the workshop, a worker that writes model files and encodes them. It lives for one piece of work.

/** @import { Made, Progress, Work } from './workshop-worker.js' */

/**
 * @param {Work} work
 * @param {AbortSignal} [signal] gives it up
 * @param {(progress: Progress) => void} [tell] hears how far an encoding is
 * @returns {Promise<Made>}
 */
export function workshop(work, signal, tell) {
  const worker = new Worker(new URL('./workshop-worker.js', import.meta.url), { type: 'module' });
  return /** @type {Promise<Made>} */ (
    new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => {
        if ('stage' in data) tell?.(data);
        else if ('error' in data) reject(new Error(data.error));
        else resolve(data);
      };
      worker.onerror = ({ message }) => reject(new Error(message || 'the worker did not load'));
      signal?.addEventListener('abort', () => reject(signal.reason));
      worker.postMessage(work);
    })
  ).finally(() => worker.terminate());
}
