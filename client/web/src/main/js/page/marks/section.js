// @ts-check
// The plane that cuts the model of this page open: three.js leaves out what lies beyond it, and faces seen from behind have
// a flat tone, so that a closed model looks filled.

import { state } from '../tools/list.js';
import { setCut } from './cut.js';
import { CutMaterials } from './cut-materials.js';
import { planeOf, START, textOf, wishOf } from './planes.js';
import { lain, stood } from './space.js';
import { dress } from './style.js';

/** @import { Session } from '../../session/session.js' */
/** @import { Stage } from '../../three/stage.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../../viewer/model-view.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Cut } from './cut.js' */
/** @import { Wish } from './planes.js' */
/** @import { Place } from '../tools/place.js' */

/** @type {Promise<Section | null> | null} */
let only = null;

/**
 * That of the page, as soon as three.js draws; null where nothing is drawn.
 *
 * @param {JsmViewerElement} viewer @param {Session} session @param {Place} place
 */
export function section(viewer, session, place) {
  only ??= begin(viewer, session, place);
  return only;
}

/** @param {JsmViewerElement} viewer @param {Session} session @param {Place} place */
async function begin({ view }, session, place) {
  if (view === null) return null;
  dress();
  const made = new Section(view, await stageOf(view), session, place);
  state.add('cut', { write: () => made.write(), read: (text) => made.read(text) });
  return made;
}

/** @param {ModelView} view @returns {Promise<Stage>} */
async function stageOf(view) {
  if (!view.isWhole) {
    const taken = new Promise((resolve) => view.addEventListener('takeover', resolve, { once: true }));
    view.takeOver();
    await taken;
  }
  return /** @type {Stage} */ (view.stage);
}

/** Tells of a `change` whenever the plane is another. */
class Section extends EventTarget {
  #view;
  #stage;
  #session;
  #place;
  #materials = new CutMaterials();
  #follow = () => this.#apply();
  wish = START;
  isOn = false;

  /** @param {ModelView} view @param {Stage} stage @param {Session} session @param {Place} place */
  constructor(view, stage, session, place) {
    super();
    this.#view = view;
    this.#stage = stage;
    this.#session = session;
    this.#place = place;
  }

  /** Cuts. @param {Partial<Wish>} wish what is to be another */
  change(wish) {
    if (!this.isOn) this.#begin();
    this.wish = { ...this.wish, ...wish, ...(wish.axis === 'view' && wish.direction === undefined && { direction: this.#sight }) };
    this.#apply();
  }

  /** From the model to whoever looks at it. */
  get #sight() {
    const { orbit } = this.#view;
    return lain(orbit, orbit.camera.axes.back);
  }

  #begin() {
    this.isOn = true;
    this.#place.pressed = true;
    // What is known of the model's size gets better.
    this.#session.addEventListener('change', this.#follow);
    this.#view.orbit.upright.addEventListener('change', this.#follow);
    this.#stage.cut = { dress: (scene) => this.#materials.dress(scene), planes: [] };
  }

  /** The model is whole again. */
  end() {
    if (!this.isOn) return;
    this.isOn = false;
    this.#place.pressed = false;
    this.#session.removeEventListener('change', this.#follow);
    this.#view.orbit.upright.removeEventListener('change', this.#follow);
    this.#stage.cut = null;
    setCut(null);
    // Materials are made anew, as they were.
    const { shading } = this.#view;
    this.#view.shading = shading;
    this.dispatchEvent(new Event('change'));
  }

  #apply() {
    const bounds = this.#session.figures.header?.bounds;
    const { cut } = this.#stage;
    if (bounds === undefined || cut === null) return;
    const plane = planeOf(this.wish, bounds);
    setCut(plane);
    cut.planes = [this.#standing(plane)];
    this.#view.invalidate();
    this.dispatchEvent(new Event('change'));
  }

  /** The plane where the model stands: as three.js has it, what lies before it is drawn. @param {Cut} cut */
  #standing({ normal, at }) {
    const { orbit } = this.#view;
    const [x, y, z] = stood({ ...pivot(orbit), camera: orbit.camera }, /** @type {Vector} */ (normal.map((n) => -n)));
    const on = stood(orbit, /** @type {Vector} */ (normal.map((n) => n * at)));
    return { normal: { x, y, z }, constant: -(x * on[0] + y * on[1] + z * on[2]) };
  }

  write() {
    return this.isOn ? textOf(this.wish) : null;
  }

  /** @param {string} text */
  read(text) {
    const wish = wishOf(text);
    if (wish !== null) this.change(wish);
  }
}

/** Turns directions, not points. @param {ModelView['orbit']} orbit */
function pivot({ upright }) {
  return { upright, sphere: { center: /** @type {Vector} */ ([0, 0, 0]), radius: 1 } };
}
