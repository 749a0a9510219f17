// @ts-check
// All that was measured on the model of this page.

import { state } from '../tools/list.js';
import { make } from '../tools/make.js';
import { lengthInWords, unitOf } from './lengths.js';
import { Overlay, shape } from './overlay.js';
import { distance } from './space.js';
import { dress } from './style.js';
import { pointsOf, textOf } from './text.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../../viewer/model-view.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Mark, Project } from './overlay.js' */
/** @import { Place } from '../tools/place.js' */

/** A link has no more: nobody could read them. */
const MOST = 40;

/** @type {Measurements | null} */
let all = null;

/**
 * Those of the page.
 *
 * @param {JsmViewerElement} viewer @param {ModelView} view @param {Session} session @param {Place} place
 */
export function measurements(viewer, view, session, place) {
  if (all === null) {
    dress();
    const made = new Measurements(new Overlay(viewer, view), session, place);
    all = made;
    state.add('measure', { write: () => made.write(), read: (text) => made.read(text) });
  }
  return all;
}

/** Tells of a `change` whenever they are others. */
class Measurements extends EventTarget {
  #overlay;
  #session;
  #place;
  /** @type {{ ends: [Vector, Vector], marks: Mark[] }[]} */
  #measured = [];
  /** @type {{ point: Vector, mark: Mark } | null} */
  #first = null;

  /** @param {Overlay} overlay @param {Session} session @param {Place} place */
  constructor(overlay, session, place) {
    super();
    this.#overlay = overlay;
    this.#session = session;
    this.#place = place;
  }

  get isPending() {
    return this.#first !== null;
  }

  get lengths() {
    return this.#measured.map(({ ends }) => this.#words(ends));
  }

  /** Takes the first point of a distance, or the second. @param {Vector} point */
  take(point) {
    if (this.#first === null) {
      const mark = dot(point);
      this.#overlay.add(mark);
      this.#first = { point, mark };
      this.#place.say('First point taken');
    } else {
      const { point: from, mark } = this.#first;
      this.#overlay.remove(mark);
      this.#first = null;
      this.#add([from, point]);
      this.#place.say(this.#words([from, point]));
    }
    this.#changed();
  }

  /** Takes a first point back. */
  giveUp() {
    if (this.#first === null) return;
    this.#overlay.remove(this.#first.mark);
    this.#first = null;
    this.#changed();
  }

  /** @param {number} index */
  remove(index) {
    const [{ marks }] = this.#measured.splice(index, 1);
    for (const mark of marks) this.#overlay.remove(mark);
    this.#changed();
  }

  clear() {
    while (this.#measured.length > 0) this.remove(0);
    this.giveUp();
  }

  write() {
    return this.#measured.length === 0 ? null : textOf(this.#measured.flatMap(({ ends }) => ends));
  }

  /** @param {string} text */
  read(text) {
    const points = pointsOf(text);
    if (points === null || points.length % 2 > 0 || points.length > 2 * MOST) return;
    this.clear();
    for (let i = 0; i < points.length; i += 2) this.#add([points[i], points[i + 1]]);
    this.#changed();
  }

  /** @param {[Vector, Vector]} ends */
  #add(ends) {
    const marks = [line(ends), ...ends.map(dot), label(ends, this.#words(ends))];
    for (const mark of marks) this.#overlay.add(mark);
    this.#measured.push({ ends, marks });
  }

  /** @param {[Vector, Vector]} ends */
  #words([from, to]) {
    return lengthInWords(distance(from, to), unitOf(this.#session));
  }

  #changed() {
    this.#place.pressed = this.#measured.length > 0;
    this.dispatchEvent(new Event('change'));
  }
}

/** @param {Vector} point @returns {Mark} */
function dot(point) {
  const element = shape('circle', { r: '4', class: 'end' });
  return { element, place: (project) => move(element, project(point)) };
}

/** @param {Element} element @param {ReturnType<Project>} to */
function move(element, to) {
  element.toggleAttribute('hidden', to === null);
  element.setAttribute('transform', to === null ? 'scale(0)' : `translate(${to.x.toFixed(1)} ${to.y.toFixed(1)})`);
}

/** @param {[Vector, Vector]} ends @returns {Mark} */
function line(ends) {
  const element = shape('path', { class: 'length' });
  /** @param {Project} project */
  const place = (project) => {
    const [from, to] = ends.map((end) => project(end));
    element.setAttribute('d', from && to ? `M${from.x.toFixed(1)} ${from.y.toFixed(1)}L${to.x.toFixed(1)} ${to.y.toFixed(1)}` : '');
  };
  return { element, place };
}

/** @param {[Vector, Vector]} ends @param {string} text @returns {Mark} */
function label([from, to], text) {
  const element = make('span', 'length', text);
  /** @param {Project} project */
  const place = (project) => {
    const a = project(from);
    const b = project(to);
    element.hidden = a === null || b === null;
    if (a !== null && b !== null) element.style.transform = `translate(-50%, -50%) translate(${((a.x + b.x) / 2).toFixed(1)}px, ${((a.y + b.y) / 2 - 18).toFixed(1)}px)`;
  };
  return { element, place };
}
