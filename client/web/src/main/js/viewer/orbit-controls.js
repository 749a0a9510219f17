// @ts-check
// Pointers, wheel and keys that move the camera around a model.

/** @import { Orbit } from './orbit.js' */
/** @typedef {{ zoom: boolean, pan: boolean }} Allowed */
/** @typedef {{ x: number, y: number }} Place */

/** A turn by one key, in radians. */
const KEY_TURN = Math.PI / 24;
const KEY_ZOOM = 1.15;
const KEY_PAN = 0.05;
/** Of the distance, per pixel that the wheel is turned. */
const WHEEL_ZOOM = 0.0012;
/** Pixels in the units of a wheel: pixels, lines, pages. */
const WHEEL_UNITS = [1, 18, 300];
/** No more by one event, however far the wheel was turned. */
const MOST_WHEEL = 240;

export class OrbitControls {
  #canvas;
  #orbit;
  /** Where each pointer was last. @type {Map<number, Place>} */
  #pointers = new Map();
  #pans = false;
  #listening = new AbortController();
  /** @type {Allowed} */
  allowed = { zoom: true, pan: true };
  /** Somebody takes the camera, and lets it go. */
  isHeld = false;

  /**
   * @param {HTMLElement} canvas
   * @param {Orbit} orbit
   */
  constructor(canvas, orbit) {
    this.#canvas = canvas;
    this.#orbit = orbit;
    const { signal } = this.#listening;
    canvas.style.touchAction = 'none';
    canvas.addEventListener('pointerdown', (event) => this.#take(event), { signal });
    canvas.addEventListener('pointermove', (event) => this.#move(event), { signal });
    for (const end of /** @type {const} */ (['pointerup', 'pointercancel', 'lostpointercapture'])) {
      canvas.addEventListener(end, (event) => this.#leave(event), { signal });
    }
    canvas.addEventListener('wheel', (event) => this.#wheel(event), { signal, passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    canvas.addEventListener('keydown', (event) => this.#key(event), { signal });
  }

  dispose() {
    this.#listening.abort();
    this.#canvas.style.touchAction = '';
  }

  /** @param {PointerEvent} event */
  #take(event) {
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.#pans = event.button !== 0 || event.shiftKey || event.ctrlKey || event.metaKey;
    this.isHeld = true;
  }

  /** @param {PointerEvent} event */
  #leave(event) {
    this.#pointers.delete(event.pointerId);
    this.isHeld = this.#pointers.size > 0;
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) return;
    const now = { x: event.clientX, y: event.clientY };
    const height = this.#canvas.clientHeight || 1;
    if (this.#pointers.size === 1) {
      const [right, down] = [(now.x - before.x) / height, (now.y - before.y) / height];
      if (!this.#pans) this.#orbit.turn(-2 * Math.PI * right, -2 * Math.PI * down);
      else if (this.allowed.pan) this.#orbit.pan(right, -down);
    } else if (this.#pointers.size === 2) {
      this.#pinch(event.pointerId, before, now);
    }
    this.#pointers.set(event.pointerId, now);
  }

  /**
   * Two fingers: their distance is that to the model, their middle moves it.
   *
   * @param {number} id of the finger that moves
   * @param {Place} before
   * @param {Place} now
   */
  #pinch(id, before, now) {
    const [, other] = /** @type {[number, Place]} */ ([...this.#pointers].find(([key]) => key !== id));
    const height = this.#canvas.clientHeight || 1;
    const apart = (/** @type {Place} */ place) => Math.hypot(place.x - other.x, place.y - other.y) || 1;
    const middle = this.#place({ clientX: (now.x + other.x) / 2, clientY: (now.y + other.y) / 2 });
    if (this.allowed.zoom) this.#orbit.zoom(apart(before) / apart(now), ...middle);
    if (this.allowed.pan) this.#orbit.pan((now.x - before.x) / 2 / height, -(now.y - before.y) / 2 / height);
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    if (!this.allowed.zoom) return;
    event.preventDefault();
    const turned = event.deltaY * WHEEL_UNITS[event.deltaMode] * (event.ctrlKey ? 5 : 1);
    this.#orbit.zoom(Math.exp(WHEEL_ZOOM * Math.min(Math.max(turned, -MOST_WHEEL), MOST_WHEEL)), ...this.#place(event));
  }

  /**
   * A place of the picture, from −1 to 1, to the right and up.
   *
   * @param {{ clientX: number, clientY: number }} event
   * @returns {[number, number]}
   */
  #place({ clientX, clientY }) {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    return [(2 * (clientX - left)) / (width || 1) - 1, 1 - (2 * (clientY - top)) / (height || 1)];
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const action = this.#actions[`${event.shiftKey && event.key.startsWith('Arrow') ? 'Shift+' : ''}${event.key}`];
    if (action === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  /** @type {Record<string, () => void>} */
  #actions = {
    ArrowLeft: () => this.#orbit.turn(-KEY_TURN, 0),
    ArrowRight: () => this.#orbit.turn(KEY_TURN, 0),
    ArrowUp: () => this.#orbit.turn(0, -KEY_TURN),
    ArrowDown: () => this.#orbit.turn(0, KEY_TURN),
    'Shift+ArrowLeft': () => this.#orbit.pan(-KEY_PAN, 0),
    'Shift+ArrowRight': () => this.#orbit.pan(KEY_PAN, 0),
    'Shift+ArrowUp': () => this.#orbit.pan(0, KEY_PAN),
    'Shift+ArrowDown': () => this.#orbit.pan(0, -KEY_PAN),
    '+': () => this.#orbit.zoom(1 / KEY_ZOOM),
    '=': () => this.#orbit.zoom(1 / KEY_ZOOM),
    '-': () => this.#orbit.zoom(KEY_ZOOM),
    0: () => this.#orbit.frame(),
    Home: () => this.#orbit.frame(),
  };
}
