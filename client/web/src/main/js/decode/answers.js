// @ts-check
// What Java answers: JSON with a value or an error, which becomes an exception here.

/** @typedef {{ kind: 'damaged' | 'memory' | 'call', message: string }} Failure */

/** The bytes are no archive, or not the one that was expected. */
export class DamagedArchive extends Error {}

/** The model needs more memory than the browser gives, in words. */
export class OutOfMemory extends Error {
  /** @param {string} reason */
  constructor(reason) {
    super(`The decoder ran out of memory (${reason}). Close other pages, or stop before the original has arrived.`);
  }
}

/** The decoder cannot be loaded, in words. */
export class DecoderMissing extends Error {
  /**
   * @param {unknown} reason
   * @param {string} remedy
   */
  constructor(reason, remedy) {
    super(`The decoder could not be loaded (${reason instanceof Error ? reason.message : reason}). ${remedy}.`);
  }
}

/**
 * The value of an answer. Java answers errors, too; where it does not look, it traps.
 *
 * @param {() => string} ask
 * @returns {any}
 */
export function valueOf(ask) {
  /** @type {{ value?: any, error?: Failure }} */
  let answer;
  try {
    answer = JSON.parse(ask());
  } catch (trap) {
    throw stopped(trap);
  }
  if (answer.error !== undefined) throw failed(answer.error);
  return answer.value;
}

/** @param {Failure} failure */
function failed({ kind, message }) {
  if (kind === 'damaged') return new DamagedArchive(message);
  return kind === 'memory' ? new OutOfMemory(message) : new Error(message);
}

/** @param {unknown} trap */
function stopped(trap) {
  const reason = trap instanceof Error ? trap.message : 'for an unknown reason';
  // Words of Chromium, Firefox and Safari for an array for which there is no room.
  if (/allocat|too large|out of memory/i.test(reason)) return new OutOfMemory(reason);
  return new DamagedArchive(`the decoder stopped (${reason})`);
}
