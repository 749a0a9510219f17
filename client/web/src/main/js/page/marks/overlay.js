// @ts-check
// What tools draw over the picture: it follows the camera, and lets the pointer through.

import { make } from '../tools/make.js';
import { project } from './space.js';

/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../../viewer/model-view.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Place } from './space.js' */
/** @typedef {(point: Vector) => Place | null} Project */
/** @typedef {{ element: Element, place: (project: Project) => void }} Mark `place` puts it where it is seen now */

const SVG = 'http://www.w3.org/2000/svg';
/** Pictures in which nothing moves, after which nobody looks again. */
const STILL = 3;

/** @param {string} tag @param {Record<string, string>} [attributes] */
export function shape(tag, attributes = {}) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

export class Overlay {
  #viewer;
  #view;
  #element = make('div', 'marks');
  #lines = shape('svg', { 'aria-hidden': 'true' });
  /** @type {Set<Mark>} */
  #marks = new Set();
  #seen = '';
  #still = 0;
  #isRunning = false;
  /** At once: a slow machine shows the picture of another window for a while before its next one. */
  #hear = () => {
    this.#place();
    this.follow();
  };
  #resizing = new ResizeObserver(this.#hear);

  /** @param {JsmViewerElement} viewer @param {ModelView} view */
  constructor(viewer, view) {
    this.#viewer = viewer;
    this.#view = view;
    this.#element.append(this.#lines);
  }

  /** @param {Mark} mark */
  add(mark) {
    if (this.#marks.size === 0) this.#begin();
    this.#marks.add(mark);
    (mark.element instanceof SVGElement ? this.#lines : this.#element).append(mark.element);
    this.#place();
  }

  /** @param {Mark} mark */
  remove(mark) {
    mark.element.remove();
    this.#marks.delete(mark);
    if (this.#marks.size > 0) return;
    this.#element.remove();
    this.#resizing.disconnect();
    this.#view.orbit.removeEventListener('change', this.#hear);
  }

  #begin() {
    this.#viewer.append(this.#element);
    this.#resizing.observe(this.#viewer);
    this.#view.orbit.addEventListener('change', this.#hear);
  }

  /** Looks where all marks are until nothing moves any more. */
  follow() {
    this.#still = 0;
    if (this.#isRunning) return;
    this.#isRunning = true;
    requestAnimationFrame(() => this.#frame());
  }

  #frame() {
    this.#place();
    this.#isRunning = ++this.#still < STILL && this.#marks.size > 0;
    if (this.#isRunning) requestAnimationFrame(() => this.#frame());
  }

  #place() {
    const { orbit, size } = this.#view;
    const { eye, target, shift } = orbit.camera;
    const now = JSON.stringify([eye, target, shift, size, orbit.upright.axis]);
    if (now !== this.#seen) this.#still = 0;
    this.#seen = now;
    for (const mark of this.#marks) mark.place((point) => project(orbit, size, point));
  }
}
