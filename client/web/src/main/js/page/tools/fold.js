// @ts-check
// Folds the panel away when the model is complete, so that the picture has the room. A button unfolds it, and folds it at
// any time.

import { wantsMotion } from '../../session/motion.js';
import { button } from './make.js';

/** @import { Session } from '../../session/session.js' */

const MILLIS = 200;

export class Fold {
  #panel;
  #button = button('Fold the panel', 'M6 9l6 6 6-6');
  /** Whether the model was complete when somebody looked last: it folds by itself once. */
  #wasComplete = false;

  /** @param {HTMLElement} panel */
  constructor(panel) {
    this.#panel = panel;
    this.#button.classList.add('fold');
    this.#button.setAttribute('aria-controls', panel.id);
    this.#button.addEventListener('click', () => this.#set(!this.#isFolded));
    panel.querySelector('.actions')?.append(this.#button);
    this.#name();
  }

  get #isFolded() {
    return this.#panel.classList.contains('folded');
  }

  /** @param {Session} session */
  follow({ figures }) {
    const isComplete = figures.state === 'complete';
    if (isComplete !== this.#wasComplete) this.#set(isComplete);
    this.#wasComplete = isComplete;
  }

  /** @param {boolean} folded */
  #set(folded) {
    if (folded === this.#isFolded) return;
    const before = this.#panel.getBoundingClientRect();
    const hadFocus = this.#panel.contains(document.activeElement);
    this.#panel.classList.toggle('folded', folded);
    this.#name();
    const { activeElement } = document;
    if (hadFocus && activeElement instanceof HTMLElement && activeElement.offsetParent === null) this.#button.focus({ preventScroll: true });
    const after = this.#panel.getBoundingClientRect();
    if (!wantsMotion()) return;
    // The picture follows the panel's height in each frame.
    this.#panel.animate([sizeOf(before), sizeOf(after)], { duration: MILLIS, easing: 'ease-out' });
  }

  #name() {
    const name = this.#isFolded ? 'Unfold the panel' : 'Fold the panel';
    this.#button.title = name;
    this.#button.setAttribute('aria-label', name);
    this.#button.setAttribute('aria-expanded', String(!this.#isFolded));
  }
}

/** @param {DOMRect} rectangle */
function sizeOf({ width, height }) {
  return { width: `${width}px`, height: `${height}px` };
}
