// @ts-check
// Which axis of a model points up on the page: what the address says (`&up=z`), else what the visitor chose last time, else what the archive says.

/** @typedef {'y' | 'z'} Axis */

const KEPT = 'jsm-up-';

/**
 * @param {unknown} value
 * @returns {Axis | null}
 */
export function axis(value) {
  return value === 'y' || value === 'z' ? value : null;
}

/** A visitor's choice for one model. */
export class UpChoice {
  #key;
  #store;

  /**
   * @param {string} model its id, or the address of its archive
   * @param {Pick<Storage, 'getItem' | 'setItem'> | null} store null where the browser keeps nothing
   */
  constructor(model, store = browserStore()) {
    this.#key = KEPT + model;
    this.#store = store;
  }

  /** @returns {Axis | null} what was chosen last time */
  get kept() {
    try {
      return axis(this.#store?.getItem(this.#key));
    } catch {
      return null;
    }
  }

  /** @param {Axis} value */
  keep(value) {
    try {
      this.#store?.setItem(this.#key, value);
    } catch {
      // The browser's store is full or closed: the choice counts for this visit.
    }
  }
}

function browserStore() {
  try {
    return localStorage;
  } catch {
    return null;
  }
}

/** The axis of one model that points up; tells of a `change` whenever the model is opened or the axis chosen. */
export class Upright extends EventTarget {
  /** @type {Axis} */
  #model = 'y';
  /** @type {Axis | null} */
  #chosen = null;

  /** @param {() => void} listener hears of each change first */
  constructor(listener = () => {}) {
    super();
    this.addEventListener('change', listener);
  }

  /** The axis that points up. */
  get axis() {
    return this.#chosen ?? this.#model;
  }

  /** @param {string} value what the archive says: an axis, or that it is unknown */
  set model(value) {
    this.#model = axis(value) ?? 'y';
    this.dispatchEvent(new Event('change'));
  }

  /** @param {Axis | null} value null for what the archive says */
  set chosen(value) {
    this.#chosen = value;
    this.dispatchEvent(new Event('change'));
  }
}

/**
 * Shows the axis in a control. A choice there counts at once, is kept for the next visit and put into the address.
 *
 * @param {HTMLSelectElement} control
 * @param {Upright} upright
 * @param {string} model its id, or the address of its archive
 */
export function bindUp(control, upright, model) {
  const choice = new UpChoice(model);
  upright.addEventListener('change', () => (control.value = upright.axis));
  upright.chosen = axis(new URLSearchParams(location.search).get('up')) ?? choice.kept;
  control.addEventListener('change', () => {
    const value = axis(control.value) ?? 'y';
    upright.chosen = value;
    choice.keep(value);
    history.replaceState(null, '', withUp(location.href, value));
  });
}

/**
 * The address of the page with an axis in it.
 *
 * @param {string} address
 * @param {Axis} value
 */
export function withUp(address, value) {
  const url = new URL(address);
  url.searchParams.set('up', value);
  return url.href;
}
