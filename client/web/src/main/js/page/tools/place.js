// @ts-check
// What a tool has of the page: a place for its controls, its button, and a line for messages.

/** How long a message stays. */
const MESSAGE_MILLIS = 4000;

/** @typedef {{ button: HTMLButtonElement, card: HTMLElement, line: HTMLElement }} Parts */

/** The timer of the message that is seen now. @type {ReturnType<typeof setTimeout> | undefined} */
let timer;

export class Place {
  #button;
  #line;

  /**
   * @param {HTMLElement} element for the tool's controls
   * @param {HTMLButtonElement} button
   * @param {HTMLElement} line where messages stand
   * @param {() => void} close
   */
  constructor(element, button, line, close) {
    this.element = element;
    this.#button = button;
    this.#line = line;
    /** Closes the controls. */
    this.close = close;
  }

  /** Opens the controls. */
  open() {
    if (this.#button.getAttribute('aria-expanded') === 'false') this.#button.click();
  }

  /** Says something for a few seconds, also to those who hear the page. @param {string} text */
  say(text) {
    clearTimeout(timer);
    this.#line.textContent = text;
    timer = setTimeout(() => (this.#line.textContent = ''), MESSAGE_MILLIS);
  }

  /** Shows on the button whether what it switches is on. @param {boolean} on */
  set pressed(on) {
    this.#button.setAttribute('aria-pressed', String(on));
  }
}
