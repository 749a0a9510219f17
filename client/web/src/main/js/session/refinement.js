// @ts-check
// Brings the steps of a model to the screen: in slices, so that no frame of the page has to wait, and then lets new
// vertices glide to their places.

import { MeshArrays } from './mesh-arrays.js';
import { wantsMotion } from './motion.js';

/** @import { Changes } from '../decode/decoder.js' */
/** @typedef {{ changes: Changes, applied: () => void }} Step */

const GLIDE_MILLIS = 200;
/** Elements that are copied in a frame: 512 kB, here and once more to the graphics card. */
const ELEMENTS = 1 << 17;
/** A page that is not seen has no frames. */
const HIDDEN_MILLIS = 250;
/** Where frames take longer, because the processor draws, each brings so many times as much, and nothing glides. */
const SLOW_MILLIS = 50;
const SLOW_SHARE = 3;

export class Refinement {
  arrays = new MeshArrays();
  #shown;
  #glideMillis;
  #frame;
  #lacksRoom;
  /** @type {Step[]} */
  #steps = [];
  #isApplying = false;
  /** When the vertices of the step that is applied began to glide, or null. @type {number | null} */
  #since = null;
  #isScheduled = false;
  /** When the frame before was, and how long it took. */
  #frameAt = 0;
  #frameMillis = 0;
  /** @type {(() => void)[]} */
  #waiting = [];

  /**
   * @param {(arrays: MeshArrays) => void} shown called when they are others, or their vertices have glided on
   * @param {number} glideMillis 0 for none
   * @param {(work: (now: number) => void) => void} frame
   * @param {() => void} lacksRoom called when the browser has no memory for a step; none can follow
   */
  constructor(shown, glideMillis = wantsMotion() ? GLIDE_MILLIS : 0, frame = nextFrame, lacksRoom = () => {}) {
    this.#shown = shown;
    this.#glideMillis = glideMillis;
    this.#frame = frame;
    this.#lacksRoom = lacksRoom;
  }

  /** One for another model, shown in the same place. The steps that are left are given up. */
  another() {
    this.#giveUp();
    return new Refinement(this.#shown, this.#glideMillis, this.#frame, this.#lacksRoom);
  }

  #giveUp() {
    this.#steps = [];
    this.#since = null;
    this.#waiting.splice(0).forEach((resolve) => resolve());
  }

  /**
   * Takes the next step.
   *
   * @param {Changes} changes
   * @param {() => void} applied called when the next one may come
   */
  take(changes, applied) {
    // How long a frame takes shows while one follows the other.
    if (this.isResting) this.#frameAt = Infinity;
    this.#steps.push({ changes, applied });
    // The first picture waits for nothing.
    if (changes.step === 1) this.#work(0);
    else this.#schedule();
  }

  /** Resolves when it rests. */
  settled() {
    /** @type {Promise<void>} */
    const settled = new Promise((resolve) => this.#waiting.push(resolve));
    return settled;
  }

  /** Whether all steps are shown, and nothing moves any more. */
  get isResting() {
    return this.#steps.length === 0 && this.#since === null;
  }

  #schedule() {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    this.#frame((now) => {
      this.#isScheduled = false;
      this.#frameMillis = now - this.#frameAt;
      this.#frameAt = now;
      if (!this.isResting) this.#work(now);
    });
  }

  /** @param {number} now */
  #work(now) {
    const [step] = this.#steps;
    if (this.#since !== null && (step === undefined || !step.changes.jump)) this.#glide(now);
    if (this.#since === null || step?.changes.jump) this.#apply(now);
    this.#shown(this.arrays);
    if (!this.isResting) {
      this.#schedule();
      return;
    }
    this.#waiting.splice(0).forEach((resolve) => resolve());
  }

  /** @param {number} now */
  #glide(now) {
    if (this.#since === null) return;
    this.arrays.glided = Math.min(1, (now - this.#since) / this.#glideMillis);
    if (this.arrays.glided === 1) this.#since = null;
  }

  /** Says whether there is room. @param {Step} step */
  #begin({ changes }) {
    try {
      this.arrays.begin(changes);
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      this.#giveUp();
      this.#lacksRoom();
      return false;
    }
    return true;
  }

  /** @param {number} now */
  #apply(now) {
    const [step] = this.#steps;
    if (step === undefined) return;
    if (!this.#isApplying && !this.#begin(step)) return;
    this.#isApplying = true;
    const isSlow = this.#frameMillis > SLOW_MILLIS;
    const isAtOnce = step.changes.jump || step.changes.step === 1 || isHidden();
    if (!this.arrays.apply(isAtOnce ? Infinity : isSlow ? SLOW_SHARE * ELEMENTS : ELEMENTS)) return;
    this.#isApplying = false;
    this.#steps.shift();
    const glides = this.#glideMillis > 0 && !isAtOnce && !isSlow;
    this.#since = glides ? now : null;
    if (!glides) this.arrays.glided = 1;
    step.applied();
  }
}

/** Nobody waits for a frame of a page that is not seen. */
function isHidden() {
  return globalThis.document?.hidden === true;
}

/** @param {(now: number) => void} work */
function nextFrame(work) {
  let isDone = false;
  const once = () => {
    if (isDone) return;
    isDone = true;
    clearTimeout(timer);
    work(performance.now());
  };
  const timer = setTimeout(once, HIDDEN_MILLIS);
  globalThis.requestAnimationFrame?.(once);
}
