// @ts-check
// What people wrote about places of the model of this page: its publisher's annotations, and the visitor's own.

import { state } from '../tools/list.js';
import { make } from '../tools/make.js';
import { annotationsOf, MOST_BYTES, readFile, textOf, writeFile } from './annotation-format.js';
import { cameraOf, flyTo } from './camera.js';
import { isSeen } from './cut.js';
import { Overlay } from './overlay.js';
import { meets } from './pick.js';
import { distance } from './space.js';
import { dress } from './style.js';
import { difference, unit } from '../../viewer/vectors.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../../viewer/model-view.js' */
/** @import { Place } from '../tools/place.js' */
/** @import { Annotation } from './annotation-format.js' */
/** @import { Mark } from './overlay.js' */
/** @typedef {{ annotation: Annotation, isOwn: boolean, mark: Mark & { element: HTMLButtonElement } }} Entry */

/** How long the camera rests before it is found out what is hidden, and how deep a point may lie in the mesh, as a share of the model. */
const REST_MILLIS = 350;
const DEPTH = 0.01;

/** @type {Annotations | null} */
let only = null;

/** Those of the page. @param {JsmViewerElement} viewer @param {ModelView} view @param {Session} session @param {Place} place */
export function annotations(viewer, view, session, place) {
  if (only === null) {
    dress();
    const made = new Annotations(viewer, view, session, place);
    only = made;
    state.add('notes', { write: () => (made.own.length === 0 ? null : textOf(made.own)), read: (text) => made.readLink(text) });
    made.load();
  }
  return only;
}

/** Tells of a `change` whenever they are others, or another one is chosen. */
class Annotations extends EventTarget {
  #view;
  #session;
  #place;
  #overlay;
  /** @type {Entry[]} */
  entries = [];
  /** @type {Entry | null} */
  chosen = null;
  /** What is wrong with the publisher's file. @type {string[]} */
  problems = [];
  #isShown = true;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #looks = 0;

  /** @param {JsmViewerElement} viewer @param {ModelView} view @param {Session} session @param {Place} place */
  constructor(viewer, view, session, place) {
    super();
    this.#view = view;
    this.#session = session;
    this.#place = place;
    this.#overlay = new Overlay(viewer, view);
    const look = () => this.#lookSoon();
    view.orbit.addEventListener('change', look);
    session.addEventListener('change', look);
  }

  get own() {
    return this.entries.filter(({ isOwn }) => isOwn).map(({ annotation }) => annotation);
  }

  get #origin() {
    return this.#session.figures.header?.origin ?? [0, 0, 0];
  }

  /** Asks for the publisher's. */
  async load() {
    const { manifest, access } = this.#session.opened ?? {};
    if (manifest?.annotationsUrl === undefined) return;
    try {
      const response = await fetch(new URL(manifest.annotationsUrl, manifest.archiveUrl), { ...access, headers: { ...access?.headers, Accept: 'application/json' } });
      const text = await response.text();
      if (!response.ok) throw new Error(`The server answered with status ${response.status}.`);
      if (text.length > MOST_BYTES) throw new Error(`Their file is larger than ${MOST_BYTES} bytes.`);
      const { annotations: read, problems } = readFile(JSON.parse(text), this.#origin);
      this.problems = problems;
      read.forEach((annotation, i) => this.#insert(annotation, false, i));
    } catch (error) {
      this.problems = [`The annotations of this model cannot be shown. ${error instanceof SyntaxError ? 'Their file is not JSON.' : error instanceof Error ? error.message : error}`];
    }
    this.#changed();
  }

  /** @param {string} text of a link */
  readLink(text) {
    for (const entry of this.entries.filter(({ isOwn }) => isOwn)) this.remove(entry);
    for (const annotation of annotationsOf(text)) this.#insert(annotation, true);
    this.#changed();
  }

  /** The visitor's. @param {Annotation} annotation */
  add(annotation) {
    this.chosen = this.#insert(annotation, true);
    this.#changed();
  }

  /** One of the visitor's says something else, or stands elsewhere. @param {Entry} entry @param {Annotation} annotation */
  change(entry, annotation) {
    entry.annotation = annotation;
    this.#overlay.follow();
    this.#changed();
  }

  /** @param {Entry} entry */
  remove(entry) {
    this.#overlay.remove(entry.mark);
    this.entries = this.entries.filter((other) => other !== entry);
    if (this.chosen === entry) this.chosen = null;
    this.#changed();
  }

  /** @param {Entry} entry */
  choose(entry) {
    this.chosen = entry;
    flyTo(this.#view.orbit, entry.annotation);
    this.#changed();
  }

  /** @param {boolean} on whether the marks are seen */
  set isShown(on) {
    this.#isShown = on;
    this.#changed();
  }

  get isShown() {
    return this.#isShown;
  }

  /** All of them as a file. */
  file() {
    return writeFile(this.entries.map(({ annotation }) => annotation), this.#origin);
  }

  /** @param {Annotation} annotation @param {boolean} isOwn */
  #insert(annotation, isOwn, at = this.entries.length) {
    const element = make('button', 'note');
    element.type = 'button';
    const mark = { element, place: (/** @type {import('./overlay.js').Project} */ project) => move(element, project(entry.annotation.point)) };
    const entry = { annotation, isOwn, mark };
    element.addEventListener('click', () => {
      this.choose(entry);
      this.#place.open();
    });
    this.entries.splice(at, 0, entry);
    this.#overlay.add(mark);
    // Tab goes through them by their numbers.
    for (const after of this.entries.slice(at + 1)) element.parentElement?.append(after.mark.element);
    return entry;
  }

  #changed() {
    this.entries.forEach((entry, i) => {
      const { element } = entry.mark;
      element.textContent = String(i + 1);
      element.title = entry.annotation.title;
      element.setAttribute('aria-label', `Annotation ${i + 1}: ${entry.annotation.title}`);
      element.classList.toggle('chosen', entry === this.chosen);
      element.hidden = !this.#isShown;
    });
    this.#place.pressed = this.entries.length > 0 && this.#isShown;
    this.#lookSoon();
    this.dispatchEvent(new Event('change'));
  }

  #lookSoon() {
    clearTimeout(this.#timer);
    if (this.entries.length > 0 && this.#isShown) this.#timer = setTimeout(() => this.#look(), REST_MILLIS);
  }

  /** Finds out which points the model hides. */
  async #look() {
    const number = ++this.#looks;
    const { orbit } = this.#view;
    const { arrays } = this.#session;
    for (const { annotation, mark } of this.entries) {
      const { eye } = cameraOf(orbit);
      const away = distance(annotation.point, eye) - DEPTH * orbit.sphere.radius;
      const isHidden = await meets(arrays, { from: eye, along: unit(difference(annotation.point, eye)) }, away, isSeen);
      if (number !== this.#looks) return;
      mark.element.classList.toggle('hidden', isHidden);
    }
  }
}

/** @param {HTMLElement} element @param {ReturnType<import('./overlay.js').Project>} to */
function move(element, to) {
  element.style.visibility = to === null ? 'hidden' : '';
  if (to !== null) element.style.transform = `translate(${to.x.toFixed(1)}px, ${to.y.toFixed(1)}px)`;
}
