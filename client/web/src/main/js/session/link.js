// @ts-check
// What the page's own files tell of a link before anything of an archive has come.

/**
 * When files of a host came over the network and how many bytes each had, in pairs of milliseconds and bytes. The clock runs while one is under way and begins with the
 * first request.
 *
 * @param {string} address of something on that host
 * @param {PerformanceResourceTiming[]} [files]
 * @returns {number[]}
 */
export function linkTo(address, files = /** @type {PerformanceResourceTiming[]} */ (performance.getEntriesByType('resource'))) {
  const { origin } = new URL(address, location.href);
  // Of a file that a cache has, no more than a head comes.
  const come = files.filter(({ name, transferSize, encodedBodySize }) => encodedBodySize > 0 && transferSize > encodedBodySize && new URL(name).origin === origin).sort((a, b) => a.responseEnd - b.responseEnd);
  const spans = spansOf(come);
  const clock = (/** @type {number} */ time) => spans.reduce((sum, [from, to]) => sum + Math.max(0, Math.min(to, time) - from), 0);
  return come.flatMap(({ responseEnd, transferSize }) => [clock(responseEnd), transferSize]);
}

/** Times in which something was under way. @param {PerformanceResourceTiming[]} files */
function spansOf(files) {
  /** @type {[number, number][]} */
  const spans = [];
  for (const { requestStart, responseEnd } of [...files].sort((a, b) => a.requestStart - b.requestStart)) {
    const last = spans.at(-1);
    if (last !== undefined && requestStart <= last[1]) last[1] = Math.max(last[1], responseEnd);
    else spans.push([requestStart, responseEnd]);
  }
  return spans;
}
