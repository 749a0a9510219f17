// @ts-check
// `<jsm-viewer>`: a model that appears at once and refines. Attributes and events are named as those of model-viewer
// where they mean the same.

import { SHADINGS } from '../session/shading.js';
import { messageOf } from '../session/errors.js';
import { prepareWorker } from '../session/pool.js';
import { Session, WAIT_MILLIS } from '../session/session.js';
import { angle, cameraOrbit, cameraTarget, limit, positive } from './attributes.js';
import { loadStage, ModelView } from './model-view.js';
import { OrbitControls } from './orbit-controls.js';
import { Poster } from './poster.js';
import { Progress } from './progress.js';
import { sourceOf } from './source.js';
import { dress } from './style.js';
import { Turntable } from './turntable.js';

/** @import { Shading } from '../session/shading.js' */
/** @import { Inset } from './orbit.js' */
/** @import { Source } from './source.js' */

/** How far below the fold a model begins to load. */
const NEAR = '200px';
/** How long a visitor may take to ask for more before three.js takes the link. */
const REST_MILLIS = 400;
const TURNTABLE_SPEED = Math.PI / 30;
const TURNTABLE_DELAY = 3000;

export class JsmViewerElement extends HTMLElement {
  static observedAttributes = ['src', 'poster', 'alt', 'camera-controls', 'disable-zoom', 'disable-pan', 'auto-rotate', 'auto-rotate-delay', 'rotation-per-second', 'camera-orbit',
    'camera-target', 'shadow-intensity', 'shading', 'wireframe', 'up', 'reveal', 'max-faces'];

  /** Loads decoders and three.js ahead, for pages that will show a model later. */
  static async preload() {
    await Promise.all([prepareWorker(), loadStage()]);
  }

  #stage = document.createElement('div');
  #poster;
  /** @type {ModelView | null} */
  #view = null;
  /** @type {Turntable | null} */
  #turntable = null;
  /** @type {OrbitControls | null} */
  #controls = null;
  /** @type {Session | null} */
  #session = null;
  /** @type {Source | null} */
  #source = null;
  /** @type {Inset | undefined} */
  #inset;
  #isNear = false;
  #isOpening = false;
  #resizing = new ResizeObserver(() => this.#view?.resize(this.#inset));
  #seeing = new IntersectionObserver((entries) => this.#see(entries), { rootMargin: NEAR });

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    dress(root);
    this.#stage.className = 'stage';
    this.#stage.part.add('stage');
    this.#stage.setAttribute('role', 'img');
    this.#poster = new Poster();
    root.append(this.#stage, this.#poster.element, document.createElement('slot'));
    this.#poster.addEventListener('dismissed', () => this.#tell('poster-dismissed'));
  }

  connectedCallback() {
    this.#resizing.observe(this.#stage);
    if (this.getAttribute('loading') === 'eager') this.#isNear = true;
    else this.#seeing.observe(this);
    this.#open();
  }

  disconnectedCallback() {
    this.#resizing.disconnect();
    this.#seeing.disconnect();
    this.#close();
  }

  /** @param {string} name @param {string | null} before @param {string | null} now */
  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === 'src') {
      this.#source = null;
      this.#close();
      this.#open();
    } else if (name === 'poster') {
      this.#poster.src = now;
    } else if (name === 'max-faces') {
      if (this.#session !== null) this.#session.mostFaces = limit(now);
    } else if (name === 'camera-orbit' || name === 'camera-target') {
      this.#aim();
    } else {
      this.#apply();
    }
  }

  /** @param {IntersectionObserverEntry[]} entries */
  #see(entries) {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    this.#seeing.disconnect();
    this.#isNear = true;
    this.#open();
  }

  /** What to show instead of what `src` names, for those who know the manifest. @param {Source} source */
  set source(source) {
    this.#close();
    this.#source = source;
    this.#open();
  }

  async #open() {
    const src = this.getAttribute('src');
    if (!this.isConnected || !this.#isNear || this.#isOpening || this.#session !== null || (this.#source === null && src === null)) return;
    this.#isOpening = true;
    const session = new Session();
    this.#session = session;
    const progress = new Progress((name, detail) => this.#tell(name, detail));
    session.addEventListener('change', () => {
      progress.hear(session);
      if (!session.figures.isBusy) setTimeout(() => session.figures.isBusy || this.#view?.takeOver(), REST_MILLIS);
    });
    try {
      session.stage = this.#begin();
    } catch {
      session.fail('This browser has no WebGL 2, which is needed to draw the model.');
    }
    this.#isOpening = false;
    this.#tell('session');
    const access = this.hasAttribute('with-credentials') ? { credentials: /** @type {const} */ ('include') } : undefined;
    try {
      const source = this.#source ?? sourceOf(/** @type {string} */ (src), { access, waiting: (text) => this.#tell('waiting', { text }) });
      const manifest = await source.manifest();
      if (this.#session !== session) return;
      if (manifest.posterUrl !== undefined && this.getAttribute('poster') === null) this.#poster.src = manifest.posterUrl;
      this.#tell('manifest', manifest);
      session.open(manifest, { decoder: this.getAttribute('decoder') ?? 'auto', serverPlan: this.hasAttribute('server-plan'), renew: source.renew, access, mostFaces: limit(this.getAttribute('max-faces')) });
      if (this.#view !== null) session.refine(this.waitMillis);
    } catch (error) {
      session.fail(messageOf(error));
    }
  }

  #begin() {
    const view = new ModelView(this.#stage, this.#shading);
    this.#view = view;
    this.#turntable = new Turntable(view.orbit);
    view.turns = (millis) => this.#turntable?.step(millis, this.#controls?.isHeld === true) === true;
    view.addEventListener('picture', () => this.#appear());
    view.addEventListener('trouble', (event) => this.#tell('trouble', { message: /** @type {CustomEvent} */ (event).detail }));
    view.orbit.addEventListener('change', () => this.#tell('camera-change'));
    view.resize(this.#inset);
    this.#apply();
    this.#aim();
    return view;
  }

  /** There is something to see. */
  #appear() {
    if (this.getAttribute('reveal') !== 'manual') this.dismissPoster();
    this.#tell('load', { url: this.getAttribute('src') });
    this.#tell('model-visibility', { visible: true });
  }

  #close() {
    this.#controls?.dispose();
    this.#view?.dispose();
    this.#session?.dispose();
    this.#controls = null;
    this.#view = null;
    this.#session = null;
    this.#poster.isShown = true;
  }

  /** Attributes that count at any time. */
  #apply() {
    const view = this.#view;
    const isControlled = this.hasAttribute('camera-controls');
    this.#stage.tabIndex = isControlled ? 0 : -1;
    const keys = isControlled ? ' Arrow keys turn it, plus and minus zoom, 0 shows the whole of it.' : '';
    this.#stage.setAttribute('aria-label', `${this.getAttribute('alt') ?? 'Model.'}${keys}`);
    this.#stage.classList.toggle('controlled', isControlled);
    this.#poster.alt = this.getAttribute('alt') ?? '';
    if (view === null || this.#turntable === null) return;
    if (isControlled) this.#controls ??= new OrbitControls(this.#stage, view.orbit);
    else this.#controls = this.#controls?.dispose() ?? null;
    if (this.#controls !== null) this.#controls.allowed = { zoom: !this.hasAttribute('disable-zoom'), pan: !this.hasAttribute('disable-pan') };
    const speed = angle(this.getAttribute('rotation-per-second') ?? '') ?? TURNTABLE_SPEED;
    this.#turntable.speed = this.hasAttribute('auto-rotate') ? speed : 0;
    this.#turntable.delay = positive(this.getAttribute('auto-rotate-delay'), TURNTABLE_DELAY);
    if (view.shading !== this.#shading) view.shading = this.#shading;
    view.wireframe = this.hasAttribute('wireframe');
    view.shadow = Math.min(1, positive(this.getAttribute('shadow-intensity'), 0));
    const up = this.getAttribute('up');
    if (up === 'y' || up === 'z') view.orbit.upright.chosen = up;
    view.invalidate();
  }

  /** Where the camera is to be at first. */
  #aim() {
    const orbit = this.#view?.orbit;
    if (orbit === undefined) return;
    const { share, ...pose } = cameraOrbit(this.getAttribute('camera-orbit') ?? '');
    const target = cameraTarget(this.getAttribute('camera-target') ?? '');
    orbit.start = { ...pose, ...(target === null ? {} : { target }), share: share ?? 1 };
  }

  /** @returns {Shading} */
  get #shading() {
    return SHADINGS.find((name) => name === this.getAttribute('shading')) ?? 'smooth';
  }

  /** What streams and what draws, for pages around the element; null while there is nothing. */
  get session() {
    return this.#session;
  }

  get view() {
    return this.#view;
  }

  /** The time T of a round, in milliseconds. */
  get waitMillis() {
    return 1000 * positive(this.getAttribute('wait-seconds'), WAIT_MILLIS / 1000);
  }

  /** Pixels above and below that other things cover. @param {Inset} value */
  set inset(value) {
    this.#inset = value;
    this.#view?.resize(value);
  }

  /** Whether there is something to see. */
  get loaded() {
    return (this.#session?.figures.batches ?? 0) > 0;
  }

  /** One more round of so many seconds; resolves when it is over. @param {number} [seconds] */
  async refine(seconds) {
    await this.#session?.refine(seconds === undefined ? this.waitMillis : 1000 * seconds);
  }

  /** The original; resolves when it is there. */
  async complete() {
    await this.#session?.complete();
  }

  /** Tries again what failed. */
  async retry() {
    if (this.#session?.figures.error) await this.#session.retry();
  }

  stop() {
    this.#session?.stop();
  }

  dismissPoster() {
    this.#poster.isShown = false;
  }

  showPoster() {
    this.#poster.isShown = true;
  }

  /** Shows all of the model, as at first. */
  frame() {
    this.#view?.orbit.frame();
  }

  /** @returns {{ theta: number, phi: number, radius: number }} radians, and lengths of the model */
  getCameraOrbit() {
    const { theta, phi, radius } = this.#view?.orbit.pose ?? { theta: 0, phi: 0, radius: 0 };
    return { theta, phi, radius };
  }

  /** @returns {{ x: number, y: number, z: number }} */
  getCameraTarget() {
    const [x, y, z] = this.#view?.orbit.pose.target ?? [0, 0, 0];
    return { x, y, z };
  }

  jumpCameraToGoal() {
    this.#view?.orbit.jump();
  }

  /** The picture on a transparent background. @param {string} [type] */
  toDataURL(type = 'image/png') {
    return this.#view?.picture(type) ?? '';
  }

  /** @param {string} name @param {unknown} [detail] */
  #tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}

if (customElements.get('jsm-viewer') === undefined) customElements.define('jsm-viewer', JsmViewerElement);
