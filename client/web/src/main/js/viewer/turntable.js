// @ts-check
// Turns a model slowly by itself, until somebody takes the camera, and again some time after that.

import { wantsMotion } from '../session/motion.js';

/** @import { Orbit } from './orbit.js' */

export class Turntable {
  #orbit;
  #stillMillis = 0;
  /** Radians per second; 0 when it does not turn. */
  speed = 0;
  /** Milliseconds that nobody has touched the model before it turns. */
  delay = 3000;

  /** @param {Orbit} orbit */
  constructor(orbit) {
    this.#orbit = orbit;
  }

  /**
   * Goes on. Says whether the next picture will be another.
   *
   * @param {number} millis since the step before
   * @param {boolean} isHeld whether somebody has the camera
   */
  step(millis, isHeld) {
    if (this.speed === 0 || !wantsMotion()) return false;
    this.#stillMillis = isHeld ? 0 : this.#stillMillis + millis;
    if (this.#stillMillis > this.delay) {
      const { isTouched } = this.#orbit;
      this.#orbit.turn((this.speed * millis) / 1000, 0);
      this.#orbit.jump();
      this.#orbit.isTouched = isTouched;
    }
    return true;
  }
}
