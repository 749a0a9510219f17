// @ts-check
// What the browser tells of requests that are over.

/**
 * Did what came last from an address come out of the browser's cache?
 *
 * @param {string} url
 */
export function cameFromCache(url) {
  const timing = /** @type {PerformanceResourceTiming | undefined} */ (performance.getEntriesByName(url).at(-1));
  performance.clearResourceTimings();
  return timing !== undefined && timing.transferSize === 0 && timing.decodedBodySize > 0;
}
