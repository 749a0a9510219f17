// @ts-check
// The buttons of the tools, and the card with the controls of the one that is open.

import { messageOf } from '../../session/errors.js';
import { button, make } from './make.js';
import { Place } from './place.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Tool } from './list.js' */

/** Pixels: of a button with the gap below it, and what bar and panel keep free around the buttons. */
const BUTTON = 44;
const GAP = 8;
/** Below this height controls lie above the panel. */
const LOW = 190;

export class Toolbar {
  #viewer;
  #session;
  #bar = make('div', 'tools');
  #card = make('section', 'tool');
  #line = make('p', 'said');
  /** @type {{ button: HTMLButtonElement, end: () => void } | null} */
  #opened = null;
  /** Goes up with each press, so that a tool that loads slowly does not open after another one. */
  #presses = 0;

  /**
   * @param {JsmViewerElement} viewer
   * @param {Session} session
   */
  constructor(viewer, session) {
    this.#viewer = viewer;
    this.#session = session;
    this.#bar.setAttribute('role', 'group');
    this.#bar.setAttribute('aria-label', 'Tools');
    this.#line.setAttribute('role', 'status');
    this.#card.id = 'tool';
    this.#card.tabIndex = -1;
    this.#card.hidden = true;
    for (const part of [this.#bar, this.#card]) {
      part.addEventListener('keydown', (event) => {
        if (event.key === 'Escape') this.close();
      });
    }
  }

  /** @param {HTMLElement} panel below the toolbar, before which it is put */
  attach(panel) {
    panel.before(this.#bar, this.#card, this.#line);
    const observer = new ResizeObserver(() => this.#fit(panel));
    observer.observe(this.#viewer);
    observer.observe(panel);
  }

  /** Bar and panel cover nothing of it. @param {HTMLElement} panel */
  #fit(panel) {
    const free = panel.offsetTop - this.#bar.offsetTop - GAP;
    const { style } = this.#bar;
    const rows = Math.max(1, Math.min(this.#bar.children.length, Math.floor((free + GAP) / BUTTON)));
    style.setProperty('--rows', String(rows));
    this.#card.style.setProperty('--columns', String(Math.ceil(this.#bar.children.length / rows)));
    this.#card.classList.toggle('over', free < LOW);
    this.#card.style.maxHeight = free < LOW ? '' : `${free}px`;
  }

  /**
   * Adds the button of a tool; gives what shows what the address says of it.
   *
   * @param {Tool} tool
   */
  add(tool) {
    const made = button(tool.name, tool.icon);
    if (tool.hasControls) {
      made.setAttribute('aria-expanded', 'false');
      made.setAttribute('aria-controls', this.#card.id);
    }
    if (tool.isSwitch) made.setAttribute('aria-pressed', 'false');
    made.addEventListener('click', () => this.#press(tool, made));
    this.#bar.append(made);
    return () => this.#restore(tool, made);
  }

  /** @param {Tool} tool @param {HTMLButtonElement} pressed */
  async #restore(tool, pressed) {
    const place = new Place(make('div'), pressed, this.#line, () => {});
    try {
      const { restore } = await tool.load();
      if (restore === undefined) this.#press(tool, pressed);
      else await restore(this.#viewer, this.#session, place);
    } catch (error) {
      place.say(inWords(tool, error));
    }
  }

  /**
   * @param {Tool} tool
   * @param {HTMLButtonElement} pressed
   */
  async #press(tool, pressed) {
    const number = ++this.#presses;
    const wasOpen = this.#opened?.button === pressed;
    if (tool.hasControls) this.close();
    if (wasOpen) return;
    const element = make('div', 'controls');
    const place = new Place(element, pressed, this.#line, () => this.close());
    try {
      const { use } = await tool.load();
      if (number !== this.#presses) return;
      if (tool.hasControls) this.#open(tool.name, pressed, element);
      const end = await use(this.#viewer, this.#session, place);
      if (this.#opened?.button === pressed && typeof end === 'function') this.#opened.end = end;
    } catch (error) {
      place.say(inWords(tool, error));
    }
  }

  /**
   * @param {string} name
   * @param {HTMLButtonElement} pressed
   * @param {HTMLElement} controls
   */
  #open(name, pressed, controls) {
    const close = button('Close', 'M6 6l12 12M18 6L6 18');
    close.addEventListener('click', () => this.close());
    const head = make('header');
    head.append(make('h2', '', name), close);
    this.#card.replaceChildren(head, controls);
    this.#card.setAttribute('aria-label', name);
    this.#card.hidden = false;
    this.#card.focus({ preventScroll: true });
    pressed.setAttribute('aria-expanded', 'true');
    this.#opened = { button: pressed, end: () => {} };
  }

  /** Closes the controls that are open. Whoever is in them is on their button then. */
  close() {
    const opened = this.#opened;
    if (opened === null) return;
    this.#opened = null;
    opened.end();
    const isInside = this.#card.contains(document.activeElement);
    this.#card.hidden = true;
    this.#card.replaceChildren();
    opened.button.setAttribute('aria-expanded', 'false');
    if (isInside) opened.button.focus();
  }
}

/** @param {Tool} tool @param {unknown} error */
function inWords({ name }, error) {
  return `${name}: this is not possible now (${messageOf(error)}).`;
}
