// @ts-check
// When a step is on the screen.

/** A frame that takes longer is followed by a pause of its length: where the processor draws, it has to decode as well. */
const SLOW_MILLIS = 50;
/** No longer than this: the first frame of a renderer may take seconds. */
const MOST_MILLIS = 1000;

/**
 * Calls when what is drawn in the next frame is on the screen. A page that is not seen draws nothing.
 *
 * @param {() => void} then
 */
export function whenDrawn(then) {
  const { requestAnimationFrame: frame, document } = globalThis;
  if (frame === undefined || document?.hidden) {
    then();
    return;
  }
  const start = performance.now();
  // The frame after the next one begins when that is drawn.
  frame(() => frame(() => {
    const millis = performance.now() - start;
    if (millis > SLOW_MILLIS) setTimeout(then, Math.min(millis, MOST_MILLIS));
    else then();
  }));
}
