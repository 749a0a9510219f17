// @ts-check
// The picture that stands for a model until there is something to see of it.

/** Tells that it was `dismissed`. */
export class Poster extends EventTarget {
  element = document.createElement('div');
  #image = document.createElement('img');

  constructor() {
    super();
    this.element.className = 'poster';
    this.element.part.add('poster');
    this.#image.hidden = true;
    const slot = document.createElement('slot');
    slot.name = 'poster';
    slot.append(this.#image);
    this.element.append(slot);
  }

  /** @param {string | null} address */
  set src(address) {
    this.#image.hidden = address === null;
    if (address !== null) this.#image.src = address;
  }

  /** @param {string} text */
  set alt(text) {
    this.#image.alt = text;
  }

  /** @param {boolean} is */
  set isShown(is) {
    const isGone = this.element.classList.toggle('gone', !is);
    if (isGone) this.dispatchEvent(new Event('dismissed'));
  }
}
