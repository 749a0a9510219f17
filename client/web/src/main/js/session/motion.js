// @ts-check

/** Whether the visitor likes things to move by themselves; others see them jump. */
export function wantsMotion() {
  return !globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches;
}
