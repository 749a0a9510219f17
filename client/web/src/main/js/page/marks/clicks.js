// @ts-check
// Points of the model that somebody clicks, or takes with the keyboard from the middle of the picture.

import { make } from '../tools/make.js';
import { isSeen } from './cut.js';
import { Overlay } from './overlay.js';
import { pick } from './pick.js';
import { middle, rayThrough } from './space.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../../viewer/model-view.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Mark } from './overlay.js' */

/** Pixels that a pointer may move between press and release: beyond these somebody turns the model. */
const STILL = 5;

/** Shows on the picture what the keyboard takes. @param {ModelView} view @returns {Mark} */
function cross(view) {
  const element = make('div', 'aim');
  element.hidden = true;
  const place = () => {
    const { x, y } = middle(view.orbit, view.size);
    element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  };
  return { element, place };
}

/** Tells of a `point` with the point as its detail, or null where nothing of the model was met. */
export class Clicks extends EventTarget {
  #viewer;
  #view;
  #session;
  #listening = new AbortController();
  #pressedAt = { x: 0, y: 0 };
  #count = 0;
  #overlay;
  #aim;
  /** Takes the point in the middle of the picture. */
  button = make('button', '', 'Take the middle of the picture');

  /** @param {JsmViewerElement} viewer @param {ModelView} view @param {Session} session */
  constructor(viewer, view, session) {
    super();
    this.#viewer = viewer;
    this.#view = view;
    this.#session = session;
    const { signal } = this.#listening;
    this.#overlay = new Overlay(viewer, view);
    this.#aim = cross(view);
    this.#overlay.add(this.#aim);
    const aim = (/** @type {boolean} */ on) => this.#aim.element.toggleAttribute('hidden', !on);
    viewer.classList.add('picking');
    viewer.addEventListener('pointerdown', ({ clientX, clientY }) => {
      this.#pressedAt = { x: clientX, y: clientY };
      aim(false);
    }, { signal, capture: true });
    this.button.type = 'button';
    this.button.addEventListener('click', () => this.takeMiddle());
    for (const shown of ['focus', 'pointerenter']) this.button.addEventListener(shown, () => aim(true));
    this.button.addEventListener('pointerleave', () => aim(false));
    viewer.addEventListener('keydown', () => aim(true), { signal });
    viewer.addEventListener('click', (event) => this.#click(event), { signal });
    viewer.addEventListener('keydown', (event) => this.#key(event), { signal });
  }

  /** @param {MouseEvent} event */
  #click(event) {
    const { x, y } = this.#pressedAt;
    if (!isPicture(event) || Math.hypot(event.clientX - x, event.clientY - y) > STILL) return;
    const { left, top } = this.#viewer.getBoundingClientRect();
    this.#take({ x: event.clientX - left, y: event.clientY - top });
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.key !== 'Enter' || !isPicture(event)) return;
    event.preventDefault();
    this.takeMiddle();
  }

  takeMiddle() {
    return this.#take(middle(this.#view.orbit, this.#view.size));
  }

  /** @param {{ x: number, y: number }} place */
  async #take(place) {
    const number = ++this.#count;
    /** @type {Vector | null} */
    const point = await pick(this.#session.arrays, rayThrough(this.#view.orbit, this.#view.size, place), isSeen);
    if (number === this.#count && !this.#listening.signal.aborted) this.dispatchEvent(new CustomEvent('point', { detail: point }));
  }

  end() {
    this.#viewer.classList.remove('picking');
    this.#overlay.remove(this.#aim);
    this.#listening.abort();
  }
}

/** Whether the picture itself is meant, not what lies on it. @param {Event} event */
function isPicture(event) {
  return event.composedPath().some((part) => part instanceof Element && part.part.contains('stage'));
}
