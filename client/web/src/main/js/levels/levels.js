// @ts-check
// The tool for what only a model has that is refined: any level that has arrived, two of them side by side, and colours that show when a face came or how far it is
// from the newest level. Streaming goes on beside it.

import { state } from '../page/tools/list.js';
import * as numbers from '../session/numbers.js';
import { Client } from './client.js';
import { Controls } from './controls.js';
import { Divider } from './divider.js';
import { sidesOf, textOf } from './link.js';
import { Side } from './side.js';
import { dress } from './style.js';

/** @import { Place } from '../page/tools/place.js' */
/** @import { Header } from '../session/header.js' */
/** @import { Session } from '../session/session.js' */
/** @import { Painter, Stage } from '../three/stage.js' */
/** @import { JsmViewerElement } from '../viewer/jsm-viewer.js' */
/** @import { ModelView } from '../viewer/model-view.js' */
/** @import { Level } from './service.js' */

/** While the model is refined, no colours of the newest level sooner than this after those before. */
const PAUSE_MILLIS = 700;

/** The tool while it is open. @type {Levels | null} */
let shown = null;

/**
 * @param {JsmViewerElement} viewer
 * @param {Session} session
 * @param {Place} place
 */
export async function use(viewer, session, place) {
  const { view } = viewer;
  if (view === null) return () => {};
  const stage = await stageOf(view);
  if (!place.element.isConnected) return () => {};
  const levels = new Levels({ viewer, view, stage, session, place });
  shown = levels;
  state.add('lod', { write: () => shown?.lod ?? null, read: (text) => shown?.await(text) });
  return () => {
    levels.end();
    shown = null;
  };
}

/**
 * @param {ModelView} view
 * @returns {Promise<Stage>}
 */
async function stageOf(view) {
  if (view.stage === null) await new Promise((resolve) => view.addEventListener('takeover', resolve, { once: true }));
  return /** @type {Stage} */ (view.stage);
}

class Levels {
  #viewer;
  #view;
  #stage;
  #session;
  #place;
  #controls = new Controls();
  #divider = new Divider(() => this.#view.invalidate());
  #sides;
  /** @type {Client | null} */
  #client = null;
  /** Of which model the client's levels are. @type {Session['opened']} */
  #model = null;
  #answeredAt = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #hear = () => this.#update();
  /** The levels that a link wishes and that have not arrived yet, by their numbers of batches. @type {Partial<Record<Side['name'], number>>} */
  #awaited = {};
  #dressing = new MutationObserver(() => this.#choose());

  /** @param {{ viewer: JsmViewerElement, view: ModelView, stage: Stage, session: Session, place: Place }} page */
  constructor({ viewer, view, stage, session, place }) {
    this.#viewer = viewer;
    this.#view = view;
    this.#stage = stage;
    this.#session = session;
    this.#place = place;
    this.#sides = { left: new Side(stage, 'left'), right: new Side(stage, 'right') };
    dress();
    place.element.append(this.#controls.element);
    viewer.append(this.#divider.element);
    this.#controls.addEventListener('change', () => {
      this.#awaited = {};
      this.#choose();
    });
    session.addEventListener('change', this.#hear);
    this.#dressing.observe(viewer, { attributeFilter: ['wireframe'] });
    stage.painter = this.#paint;
    this.#update();
    this.#choose();
  }

  /** The levels that are seen, as a part of an address. */
  get lod() {
    const batches = (/** @type {Side['name']} */ side) => this.#awaited[side] ?? this.#controls.batches(side);
    return textOf(this.#controls.isComparing ? [batches('left'), batches('right')] : [batches('left')]);
  }

  /** Shows the levels of a link as soon as they have arrived. @param {string} text */
  await(text) {
    const wished = sidesOf(text);
    if (wished === null) return;
    const [left, right] = wished;
    this.#awaited = { ...(left !== null && { left }), ...(right && { right }) };
    this.#controls.isComparing = right !== undefined;
    if (Object.values(this.#awaited).some((batches) => batches > this.#session.figures.batches)) this.#place.say('The level of the link is shown as soon as it has arrived');
    this.#update();
    this.#choose();
  }

  #showAwaited() {
    const { batches } = this.#session.figures;
    // A slider at the newest level follows it, so it is moved when there is a newer one.
    const due = /** @type {[Side['name'], number][]} */ (Object.entries(this.#awaited)).filter(([, wished]) => wished < batches);
    if (due.length === 0) return;
    for (const [side, wished] of due) {
      this.#controls.sliders[side].value = String(wished);
      delete this.#awaited[side];
    }
    this.#choose();
  }

  end() {
    clearTimeout(this.#timer);
    this.#dressing.disconnect();
    this.#session.removeEventListener('change', this.#hear);
    this.#stage.painter = null;
    this.#sides.left.dispose();
    this.#sides.right.dispose();
    this.#divider.element.remove();
    this.#client?.close();
    this.#view.invalidate();
  }

  /** @type {Painter} */
  #paint = (renderer, draw) => {
    const { left, right } = this.#sides;
    if (!this.#controls.isComparing) {
      draw(left.guest);
      return;
    }
    const { width, height } = renderer.domElement;
    const at = Math.round(this.#divider.share * width);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, at, height);
    draw(left.guest);
    renderer.setScissor(at, 0, width - at, height);
    draw(right.guest);
    renderer.setScissorTest(false);
  };

  get #shownSides() {
    const { left, right } = this.#sides;
    return this.#controls.isComparing ? [left, right] : [left];
  }

  /** Somebody wishes something else. */
  #choose() {
    const { isComparing, sliders } = this.#controls;
    this.#divider.element.hidden = !isComparing;
    // Two sides that show the same show nothing.
    if (isComparing && this.#controls.batches('left') === null && this.#controls.batches('right') === null) sliders.left.value = sliders.left.min;
    this.#controls.expect(this.#session.figures);
    for (const side of this.#shownSides) {
      side.batches = this.#controls.batches(side.name);
      this.#ask(side);
    }
    this.#describe();
    this.#view.invalidate();
  }

  /** The model is another, or more of it has arrived. */
  #update() {
    const { opened, figures } = this.#session;
    if (opened?.manifest !== this.#model?.manifest) this.#reach();
    if (figures.batches === 0) return;
    this.#controls.expect(figures);
    this.#showAwaited();
    this.#refresh();
    this.#describe();
  }

  /** Takes another worker, for another model. */
  #reach() {
    const { opened } = this.#session;
    this.#client?.close();
    this.#client = null;
    this.#model = opened;
    for (const side of Object.values(this.#sides)) side.showModel();
    if (opened === null) return;
    const { archiveUrl, archiveSha256 } = opened.manifest;
    const opening = { place: { archiveUrl, archiveSha256, access: opened.access }, decoder: opened.decoder };
    this.#client = new Client(opening, { level: (level) => this.#take(level), refused: (name, reason) => this.#refuse(name, reason) });
  }

  /** Asks for sides that depend on the newest level anew when that is another: not while they wait for an answer, and not too often. */
  #refresh() {
    clearTimeout(this.#timer);
    const { batches } = this.#session.figures;
    const isColoured = this.#controls.paint !== 'file';
    const due = this.#shownSides.filter((side) => !side.isWaiting && side.newest !== batches && isColoured && (side.batches === null || this.#controls.paint === 'distance'));
    if (due.length === 0) return;
    const wait = this.#answeredAt + PAUSE_MILLIS - performance.now();
    if (wait > 0) this.#timer = setTimeout(() => this.#refresh(), wait);
    else due.forEach((side) => this.#ask(side));
  }

  /** @param {Side} side */
  #ask(side) {
    const { batches: newest, header } = this.#session.figures;
    const { paint } = this.#controls;
    if (header === null || newest === 0) return;
    side.newest = newest;
    if (side.batches === null && paint === 'file') {
      this.#client?.forget(side.name);
      side.showModel();
      return;
    }
    const { ends, batchLevels } = header;
    side.isWaiting = true;
    const index = { ends: ends.slice(0, newest), levels: batchLevels.slice(0, newest) };
    const isWireframe = this.#viewer.hasAttribute('wireframe');
    this.#client?.ask({ side: side.name, batches: side.batches ?? newest, newest, lastLevel: this.#lastLevel, paint, isWireframe, index });
  }

  /** @param {Level} level */
  #take(level) {
    this.#answeredAt = performance.now();
    const side = this.#sides[level.side];
    const before = this.#scale;
    side.level = level;
    const scale = this.#scale;
    side.show(level, scale);
    // The scale is that of both sides.
    for (const other of this.#shownSides) if (other !== side && other.level?.measured !== undefined && scale !== before) other.show(other.level, scale);
    this.#describe();
    this.#refresh();
    this.#view.invalidate();
  }

  /**
   * @param {Side['name']} name
   * @param {string} reason
   */
  #refuse(name, reason) {
    this.#sides[name].isWaiting = false;
    this.#place.say(reason);
  }

  /** Where the largest distance is that is shown. */
  get #farthest() {
    return this.#shownSides.map((side) => side.farthest).reduce((a, b) => ((b?.distance ?? 0) > (a?.distance ?? -1) ? b : a));
  }

  get #scale() {
    return this.#farthest?.distance ?? 0;
  }

  get #lastLevel() {
    const { header, level } = this.#session.figures;
    return Math.max(header?.levels ?? 0, level);
  }

  #describe() {
    const { figures } = this.#session;
    const { header } = figures;
    if (header === null || figures.batches === 0) return;
    for (const side of Object.values(this.#sides)) {
      const [level, size] = this.#words(side, header);
      this.#controls.describe(side.name, `${level}: ${size}`);
      this.#divider.labels[side.name].textContent = `${level}\n${size}`;
    }
    if (this.#controls.paint === 'levels') this.#controls.levelsUpTo(this.#lastLevel);
    if (this.#controls.paint !== 'distance') return;
    const [x, y, z, toX, toY, toZ] = header.bounds;
    const isKnown = this.#shownSides.every((side) => side.farthest !== null);
    this.#controls.scaleOf(isKnown ? this.#farthest : null, Math.hypot(toX - x, toY - y, toZ - z), figures.batches === header.ends.length && header.whole);
  }

  /**
   * What a side shows, in words.
   *
   * @param {Side} side
   * @param {Header} header
   */
  #words(side, { batchLevels, ends }) {
    const { figures } = this.#session;
    const batches = side.level?.batches ?? figures.batches;
    const faces = side.level?.faces ?? figures.faces;
    return [`Level ${batchLevels[batches - 1]} of ${this.#lastLevel}`, `${numbers.faces(faces)}, ${numbers.bytes(ends[batches - 1])}`];
  }
}
