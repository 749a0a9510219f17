// @ts-check
// Asks for an annotation: for its place first where it is a new one, then for what it says.

import { MOST_TEXT, MOST_TITLE } from '../marks/annotation-format.js';
import { cameraOf } from '../marks/camera.js';
import { Clicks } from '../marks/clicks.js';
import { labelled, make } from './make.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../../viewer/model-view.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Annotation } from '../marks/annotation-format.js' */
/** @import { Place } from './place.js' */

/** Tells of an `end` when nothing is asked any more. */
export class AnnotationForm extends EventTarget {
  #viewer;
  #view;
  #session;
  #place;
  /** @type {Clicks | null} */
  #clicks = null;
  element = make('div', 'form');

  /** @param {JsmViewerElement} viewer @param {ModelView} view @param {Session} session @param {Place} place */
  constructor(viewer, view, session, place) {
    super();
    this.#viewer = viewer;
    this.#view = view;
    this.#session = session;
    this.#place = place;
    this.element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.end();
    });
  }

  /** A new one. @param {(annotation: Annotation) => void} done */
  begin(done) {
    this.#pick((point) => this.#ask({ title: '', text: '', point, camera: cameraOf(this.#view.orbit) }, 'Add', done), () => this.end());
  }

  /** @param {Annotation} annotation @param {(annotation: Annotation) => void} done hears the changed one */
  edit(annotation, done) {
    this.#ask(annotation, 'Save', done);
  }

  end() {
    if (this.element.childElementCount === 0) return;
    this.#rest();
    this.element.replaceChildren();
    this.dispatchEvent(new Event('end'));
  }

  /** Listens for no clicks. */
  #rest() {
    this.#clicks?.end();
    this.#clicks = null;
  }

  /** @param {(point: Vector) => void} take @param {() => void} back */
  #pick(take, back) {
    this.#rest();
    const clicks = new Clicks(this.#viewer, this.#view, this.#session);
    this.#clicks = clicks;
    const cancel = button('Cancel', back);
    this.element.replaceChildren(make('p', '', 'Click a point of the model. With the keyboard: press Enter on the picture.'), clicks.button, cancel);
    clicks.button.focus();
    clicks.addEventListener('point', (event) => {
      const point = /** @type {CustomEvent<Vector | null>} */ (event).detail;
      if (point === null) this.#place.say('There is nothing of the model at this place');
      else take(point);
    });
  }

  /** @param {Annotation} asked @param {string} name of the button @param {(annotation: Annotation) => void} done */
  #ask(asked, name, done) {
    this.#rest();
    let { camera } = asked;
    const title = make('input');
    Object.assign(title, { maxLength: MOST_TITLE, autocomplete: 'off', value: asked.title });
    const text = make('textarea');
    Object.assign(text, { maxLength: MOST_TEXT, rows: 3, value: asked.text });
    const written = () => ({ ...asked, title: title.value.trim(), text: text.value, camera });
    const move = button('Move it', () => {
      const draft = written();
      this.#pick((point) => this.#ask({ ...draft, point }, name, done), () => this.#ask(draft, name, done));
    });
    const look = button('See it from here', () => {
      camera = cameraOf(this.#view.orbit);
      this.#place.say('Its camera is where you are now');
    });
    const save = button(name, () => {
      if (title.value.trim() === '') {
        title.focus();
        this.#place.say('Give it a title');
        return;
      }
      const annotation = written();
      this.end();
      done(annotation);
    });
    save.classList.add('primary');
    const [changes, ends] = [make('div', 'pair'), make('div', 'pair')];
    changes.append(move, look);
    ends.append(save, button('Cancel', () => this.end()));
    this.element.replaceChildren(labelled('Title', title), labelled('Text', text), changes, ends);
    title.focus();
  }
}

/** @param {string} text @param {() => void} act */
export function button(text, act) {
  const made = make('button', '', text);
  made.type = 'button';
  made.addEventListener('click', act);
  return made;
}
