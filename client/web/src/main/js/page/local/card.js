// @ts-check
// A card above the page, with words, controls and how far something is. Escape closes it and gives up what goes on.

import { make } from '../tools/make.js';
import { dress } from './style.js';

export class Card {
  #dialog = make('dialog', 'local');
  #text = make('p');
  #fields = make('div', 'fields');
  #progress = make('progress');
  #line = make('p', 'soft');
  #actions = make('div', 'actions');
  #close = make('button', '', 'Close');
  #abort = new AbortController();

  /** @param {string} title */
  constructor(title) {
    dress();
    const head = make('h2', '', title);
    head.id = 'local-title';
    this.#dialog.setAttribute('aria-labelledby', head.id);
    this.#line.setAttribute('role', 'status');
    this.#progress.hidden = true;
    this.#progress.setAttribute('aria-label', 'How far it is');
    this.#close.type = 'button';
    this.#close.addEventListener('click', () => this.close());
    this.#actions.append(this.#close);
    this.#dialog.append(head, this.#text, this.#fields, this.#progress, this.#line, this.#actions);
    this.#dialog.addEventListener('close', () => {
      this.#abort.abort();
      this.#dialog.remove();
    });
    document.querySelector('dialog.local')?.remove();
    document.body.append(this.#dialog);
    this.#dialog.showModal();
  }

  /** Aborted when somebody closes the card. */
  get signal() {
    return this.#abort.signal;
  }

  /** @param {string} text */
  say(text) {
    this.#text.textContent = text;
  }

  /** @param {...HTMLElement} fields */
  add(...fields) {
    this.#fields.append(...fields);
  }

  /**
   * Adds a button that does something which takes a while.
   *
   * @param {string} name
   * @param {() => Promise<void>} act
   * @param {string} className
   */
  addAction(name, act, className = 'primary') {
    const button = make('button', `act ${className}`, name);
    button.type = 'button';
    const begin = async () => {
      const buttons = [...this.#actions.querySelectorAll('button.act')].filter((one) => one instanceof HTMLButtonElement);
      for (const one of buttons) one.disabled = true;
      await act();
      for (const one of buttons) one.disabled = false;
    };
    button.addEventListener('click', begin);
    this.#fields.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && !button.disabled && this.#actions.querySelector('.primary') === button) begin();
    });
    this.#actions.append(button);
  }

  /** How far it is. @param {string} text @param {number | null} fraction */
  tell = (text, fraction) => {
    this.#progress.hidden = false;
    this.#close.textContent = 'Cancel';
    if (fraction === null) this.#progress.removeAttribute('value');
    else this.#progress.value = fraction;
    this.#line.classList.remove('bad');
    this.#line.textContent = fraction === null ? text : `${text}, ${Math.round(100 * fraction)}%`;
  };

  /** @param {string} reason */
  fail(reason) {
    this.#progress.hidden = true;
    this.#close.textContent = 'Close';
    this.#line.classList.add('bad');
    this.#line.textContent = reason;
  }

  close() {
    this.#dialog.close();
  }
}
