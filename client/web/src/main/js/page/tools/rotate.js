// @ts-check
// Turns the model slowly until the button is pressed again.

import { wantsMotion } from '../../session/motion.js';

/** @import { Use } from './list.js' */

/** Milliseconds until a model turns that nobody holds: whoever presses the button waits for it. */
const DELAY = '300';

/** @type {Use} */
export function use(viewer, _, place) {
  const on = !viewer.hasAttribute('auto-rotate');
  if (on && !wantsMotion()) {
    place.say('This system asks for less motion, so the model stands still');
    return;
  }
  viewer.setAttribute('auto-rotate-delay', DELAY);
  viewer.toggleAttribute('auto-rotate', on);
  place.pressed = on;
}
