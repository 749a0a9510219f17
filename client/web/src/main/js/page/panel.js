// @ts-check
// The figures, buttons and messages around a model.

import { claims } from '../session/claims.js';
import * as numbers from '../session/numbers.js';
import { isAsGood } from '../viewer/sight.js';
import { element, typed } from './elements.js';

/** @import { Figures } from '../session/figures.js' */
/** @import { Session } from '../session/session.js' */
/** @import { ModelView } from '../viewer/model-view.js' */

/** Keeps the page's figures in step with the session. */
export class Panel {
  #session;
  #view;
  #scheduled = false;
  #announced = '';

  /** @type {string | null} */
  #waitText = null;

  /** What is wrong with the page itself. @type {string | null} */
  #trouble = null;

  /**
   * @param {Session} session
   * @param {ModelView | null} view of the model
   * @param {() => void} retry loads the page again when nothing but a part of it failed
   */
  constructor(session, view, retry) {
    this.#session = session;
    this.#view = view;
    element('retry').addEventListener('click', () => {
      retry();
      this.#schedule();
    });
    session.addEventListener('change', () => this.#schedule());
    view?.orbit.addEventListener('change', () => this.#judge());
  }

  /** @param {string | null} text what to say instead of the session's status until there is a picture */
  say(text) {
    this.#waitText = text;
    this.#schedule();
  }

  /**
   * A part of the page is missing; loading the page again may help.
   *
   * @param {string} effect a clause
   * @param {string} reason
   */
  trouble(effect, reason) {
    this.#trouble = `Part of the page could not be loaded, so ${effect} (${reason}).`;
    this.#schedule();
  }

  render() {
    this.#scheduled = false;
    const { figures: f, bytesPerSecond, decoder, renewed } = this.#session;
    const share = f.totalBytes > 0 ? f.bytes / f.totalBytes : 0;
    element('fill').style.width = `${100 * share}%`;
    element('track').setAttribute('aria-valuenow', String(Math.floor(100 * share)));
    element('track').classList.toggle('busy', f.isBusy);
    element('faces').textContent = f.totalFaces > 0 ? `${numbers.count(f.faces)} of ${numbers.count(f.totalFaces)}` : '–';
    element('bytes').textContent = f.totalBytes > 0 ? `${numbers.bytes(f.bytes)} of ${numbers.bytes(f.totalBytes)}` : numbers.bytes(f.bytes);
    element('rate').textContent = numbers.rate(bytesPerSecond);
    element('level').textContent = f.header === null ? '–' : `${f.level} of ${Math.max(f.header.levels ?? 0, f.level)}`;
    element('error').textContent = errorOf(f, f.errorMean);
    element('within').textContent = errorOf(f, f.errorQuantile);
    this.#judge();
    keepingFocus(() => renderButtons(f));
    this.#messages(f, renewed);
    const { badge, isWarning, title, line } = claims(f);
    element('proof').hidden = badge === '';
    element('proof').classList.toggle('warning', isWarning);
    element('proof').title = title;
    element('proof-text').textContent = badge;
    element('losses').hidden = line === '';
    element('losses').textContent = line;
    const running = decoder === null ? '' : `Decoder: ${decoder === 'wasm' ? 'WebAssembly' : 'JavaScript'}`;
    const proof = f.proved ? `SHA-256 of the decoded mesh: ${f.sha256}; of mesh and pictures: ${f.modelSha256}` : null;
    const kept = f.keptBytes > 0 ? `${numbers.bytes(f.keptBytes)} of it were kept by this browser` : null;
    element('fine').textContent = [running, f.header?.whole && numbers.box(f.header.bounds, f.header.origin), proof, kept, f.notice].filter((text) => text).join('. ');
    this.#announce(f);
  }

  /** Says whether more would be seen. A proof says more than that. */
  #judge() {
    const { figures } = this.#session;
    element('sight').hidden = figures.batches === 0 || figures.proved || this.#view === null || !isAsGood(figures, this.#view);
  }

  /**
   * @param {Figures} f
   * @param {string | null} renewed
   */
  #messages(f, renewed) {
    const waiting = f.batches === 0 && f.error === null;
    element('wait').hidden = !waiting && f.status === '';
    element('wait').classList.toggle('small', f.batches > 0);
    const opening = f.bytes > 0 ? `Opening: ${numbers.bytes(f.bytes)} received` : 'Opening';
    const status = f.status === '' || f.status === 'Opening' ? opening : f.status;
    element('wait-text').textContent = (waiting && this.#waitText) || status;
    const trouble = this.#trouble ?? '';
    element('alert').hidden = f.error === null && trouble === '';
    element('alert-text').textContent = f.error ?? trouble;
    element('retry').hidden = f.error === null ? trouble === '' : !f.retryable;
    const why = f.isHeld ? 'because the graphics card has no memory for more.' : 'to spare the memory of this device. “Original” loads the rest.';
    const full = `Refinement stopped at ${numbers.count(f.faces)} of ${numbers.faces(f.totalFaces)} ${why}`;
    const notice = f.isFull ? full : renewed;
    element('notice').hidden = notice === null;
    element('notice').textContent = notice ?? '';
  }

  /**
   * For those who hear the page: a sentence whenever it begins something, waits, or comes to rest.
   *
   * @param {Figures} f
   */
  #announce(f) {
    const sentence = sentenceOf(f);
    if (sentence === '' || sentence === this.#announced) return;
    this.#announced = sentence;
    element('live').textContent = sentence;
  }

  #schedule() {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => this.render());
  }
}

/**
 * @param {Figures} f
 * @param {number | null} error in percent of the diagonal
 */
function errorOf({ identical }, error) {
  if (error === null) return '–';
  return identical ? 'none' : numbers.distance(error);
}

/** @param {Figures} f */
function sentenceOf(f) {
  if (f.error !== null) return ''; // an alert says it
  if (f.isBusy) return f.status === '' ? '' : `${f.status}.`;
  const shown = `${numbers.count(f.faces)} of ${numbers.faces(f.totalFaces)}, ${numbers.percent(f.bytes / f.totalBytes)} of the bytes`;
  return f.proved ? `Showing ${numbers.faces(f.faces)}, ${f.header?.words?.claim}.` : `Showing ${shown}.`;
}

/**
 * Whoever is on a button that goes away is on the one in its place, or on the panel.
 *
 * @param {() => void} change
 */
function keepingFocus(change) {
  const before = document.activeElement;
  change();
  if (!(before instanceof HTMLButtonElement) || (before.offsetParent !== null && !before.disabled)) return;
  const next = ['stop', 'more', 'original'].map((id) => typed(id, HTMLButtonElement)).find((button) => button.offsetParent !== null && !button.disabled);
  (next ?? element('panel')).focus({ preventScroll: true });
}

/** @param {Figures} f */
function renderButtons(f) {
  typed('more', HTMLButtonElement).disabled = f.isBusy || f.isOver || f.isFull;
  typed('original', HTMLButtonElement).disabled = f.isBusy || f.isOver;
  element('stop').hidden = !f.isBusy || f.batches === 0;
  element('more').hidden = !element('stop').hidden;
}
