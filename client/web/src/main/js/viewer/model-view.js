// @ts-check
// The picture of a model. A small renderer draws it first; three.js takes over when it has come.

import { FirstView } from '../first/first-view.js';
import { messageOf } from '../session/errors.js';
import { isTextured } from '../session/weight.js';
import { Orbit } from './orbit.js';
import { Pictures } from './pictures.js';
import { isLargeMesh } from './three-pays.js';

/** @import { Header } from '../session/header.js' */
/** @import { MeshArrays } from '../session/mesh-arrays.js' */
/** @import { Shading } from '../session/shading.js' */
/** @import { Stage } from '../three/stage.js' */
/** @import { Inset } from './orbit.js' */
/** @typedef {{ paths: string[], bytes: Uint8Array<ArrayBuffer>, resolve: (shown: Promise<void>) => void }} Image that waits for three.js */

const MOST_PIXEL_RATIO = 2;

/** Tells of `picture` when there is the first one, of `takeover` when three.js draws, and of `trouble` when it cannot. */
export class ModelView extends EventTarget {
  orbit = new Orbit();
  #host;
  /** @type {FirstView | null} */
  #first = null;
  /** @type {Stage | null} */
  #stage = null;
  #isLoading = false;
  /** Whether three.js could not be loaded. A browser may remember that for as long as the page stands, so it is asked for once. */
  #hasFailed = false;
  /** @type {Header | null} */
  #header = null;
  /** @type {MeshArrays | null} */
  #arrays = null;
  /** @type {Image[]} */
  #images = [];
  /** @type {Shading} */
  #shading = 'smooth';
  #wireframe = false;
  #shadow = 0;
  /** Those who wait for three.js. @type {{ resolve: () => void, reject: (reason: unknown) => void }[]} */
  #waiting = [];
  #dirty = false;
  #steppedAt = 0;
  #isDisposed = false;
  /** Moves the camera by itself: called before each picture with the milliseconds since the last one; says whether to go on. @type {(millis: number) => boolean} */
  turns = () => false;
  size = { width: 1, height: 1, pixelRatio: 1 };
  /** Called when the graphics card has no memory for a model of this size. */
  lacksMemory = () => {};

  /**
   * @param {HTMLElement} host that holds the canvas
   * @param {Shading} shading
   * @throws {Error} where there is no WebGL 2
   */
  constructor(host, shading) {
    super();
    this.#host = host;
    this.#shading = shading;
    this.#begin();
    this.orbit.addEventListener('change', () => this.invalidate());
  }

  /**
   * Resolves when three.js draws, with materials as they will be.
   *
   * @param {Header} header
   * @returns {Promise<void>}
   */
  open(header) {
    this.#header = header;
    this.orbit.bounds = header.bounds;
    this.orbit.upright.model = header.up;
    if (this.#stage === null) this.#begin();
    this.#first?.open(header);
    if (this.#stage !== null) return this.#stage.open(header);
    return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject }));
  }

  /** @param {MeshArrays} arrays of a finer mesh */
  update(arrays) {
    const isFirst = this.#arrays === null;
    this.#arrays = arrays;
    const isLarge = isLargeMesh(this.#header, arrays);
    if (!isLarge || isFirst || this.#hasFailed) this.#first?.update(arrays);
    this.#stage?.update(arrays);
    if (arrays.isWhole) this.invalidate();
    if (isFirst) this.dispatchEvent(new Event('picture'));
    if (isFirst && this.#shadow > 0) this.#layGround();
    if (isLarge || isTextured(this.#header)) this.takeOver();
  }

  /**
   * A texture, or a preview of one. Resolves when it is shown.
   *
   * @param {string[]} paths
   * @param {Uint8Array<ArrayBuffer>} bytes
   * @returns {Promise<void>}
   */
  addTexture(paths, bytes) {
    if (this.#stage !== null) return this.#stage.addTexture(paths, bytes);
    return new Promise((resolve) => this.#images.push({ paths, bytes, resolve }));
  }

  /** Takes the model away. */
  clear() {
    this.#images = [];
    this.#waiting.splice(0).forEach(({ resolve }) => resolve());
    this.#arrays = null;
    this.#header = null;
    this.orbit.isTouched = false;
    this.#stage?.clear();
    this.#first?.dispose();
    this.#first?.canvas.remove();
    this.#first = null;
    this.invalidate();
  }

  #begin() {
    if (this.#first !== null) return;
    this.#first = new FirstView(hiddenCanvas(), this.orbit, this.#shading);
    this.#first.shadow = this.#shadow;
    this.#host.append(this.#first.canvas);
    this.resize();
  }

  /** Lets three.js draw, once there is something to draw. */
  async takeOver() {
    if (this.#arrays === null || this.#stage !== null || this.#isLoading || this.#hasFailed) return;
    this.#isLoading = true;
    try {
      await this.#loadStage();
    } catch (error) {
      this.#hasFailed = true;
      this.#waiting.splice(0).forEach(({ reject }) => reject(error));
      if (!this.#isDisposed) this.dispatchEvent(new CustomEvent('trouble', { detail: messageOf(error) }));
    }
    this.#isLoading = false;
  }

  async #loadStage() {
    const { Stage: Loaded } = await loadStage();
    if (this.#isDisposed || this.#arrays === null || this.#header === null) return;
    const stage = new Loaded(hiddenCanvas(), this.orbit, () => this.invalidate(), this.#shading, () => this.lacksMemory());
    stage.wireframe = this.#wireframe;
    stage.shadow = this.#shadow;
    const materials = stage.open(this.#header);
    stage.update(this.#arrays);
    this.#stage = stage;
    this.resize();
    const shown = this.#images.splice(0).map(({ paths, bytes, resolve }) => {
      const image = stage.addTexture(paths, bytes);
      resolve(image);
      return image;
    });
    // What stands for a material until three's loader has come looks no better than the first pictures.
    await Promise.allSettled([materials, ...shown]);
    if (this.#isDisposed) return;
    stage.render();
    this.#host.append(stage.canvas);
    this.#first?.canvas.remove();
    this.#first?.dispose();
    this.#first = null;
    this.#waiting.splice(0).forEach(({ resolve }) => resolve());
    this.dispatchEvent(new Event('takeover'));
  }

  /** What draws now: until three.js has all that it needs for its first picture, the small renderer goes on. */
  get #renderer() {
    return this.#first ?? this.#stage;
  }

  /** Whether three.js draws. */
  get isWhole() {
    return this.#first === null && this.#stage !== null;
  }

  /** The first pictures get a shadow: where it does not come, three.js brings it. */
  async #layGround() {
    const loaded = await import('../first/first-ground.js').catch(() => null);
    const gl = this.#first?.canvas.getContext('webgl2');
    if (loaded === null || !gl || this.#first === null) return;
    this.#first.ground = new loaded.FirstGround(gl, this.orbit);
    this.invalidate();
  }

  /** @param {Shading} value */
  set shading(value) {
    this.#shading = value;
    if (this.#first !== null) this.#first.shading = value;
    if (this.#stage !== null) this.#stage.shading = value;
    this.invalidate();
  }

  get shading() {
    return this.#shading;
  }

  /** @param {boolean} on */
  set wireframe(on) {
    this.#wireframe = on;
    if (this.#stage !== null) this.#stage.wireframe = on;
  }

  /** How dark the model's shadow on the ground is, 0 to 1. @param {number} value */
  set shadow(value) {
    this.#shadow = value;
    if (this.#first !== null) this.#first.shadow = value;
    if (this.#stage !== null) this.#stage.shadow = value;
  }

  /**
   * Fits the picture to its place on the page, which has an inset of things that cover it.
   *
   * @param {Inset} [inset]
   */
  resize(inset) {
    const { clientWidth: width, clientHeight: height } = this.#host;
    if (width === 0 || height === 0) return;
    const pixelRatio = Math.min(devicePixelRatio, MOST_PIXEL_RATIO);
    this.size = { width, height, pixelRatio };
    this.orbit.refit(width, height, inset);
    const [across, along] = [Math.round(width * pixelRatio), Math.round(height * pixelRatio)];
    this.#first?.resize(across, along);
    this.#stage?.resize(across, along);
    // A canvas of another size is empty.
    if (this.#arrays !== null) this.render();
  }

  /** Draws at the next frame. */
  invalidate() {
    if (this.#dirty || this.#isDisposed) return;
    this.#dirty = true;
    requestAnimationFrame((now) => this.#frame(now));
  }

  /** @param {number} now */
  #frame(now) {
    this.#dirty = false;
    const millis = Math.min(now - this.#steppedAt, 100);
    const turns = this.turns(millis);
    const moves = this.orbit.step(millis);
    this.#steppedAt = now;
    this.render();
    if (moves || turns) this.invalidate();
  }

  /** Draws now. */
  render() {
    if (this.#arrays !== null) this.#renderer?.render();
  }

  /**
   * The picture on a transparent background as a data URL, at a size in pixels or that of the page.
   *
   * @param {string} type
   * @param {{ width: number, height: number } | null} size
   */
  picture(type, size = null) {
    const renderer = this.#renderer;
    if (renderer === null) return '';
    const shadow = this.#shadow;
    this.shadow = 0;
    const picture = new Pictures(this.orbit, renderer).take(type, size, this.size);
    this.shadow = shadow;
    this.invalidate();
    return picture;
  }

  /** What draws with three.js, for tools; null until `takeover`. */
  get stage() {
    return this.#stage;
  }

  /** What the graphics card holds now, as far as three.js counts it. */
  get memory() {
    return this.#stage?.memory ?? { geometries: this.#arrays === null ? 0 : 1, textures: 0 };
  }

  dispose() {
    this.#isDisposed = true;
    this.clear();
    this.#stage?.dispose();
    this.#stage?.canvas.remove();
    this.#stage = null;
  }
}

/** Loads what three.js needs; the second time at once. */
export function loadStage() {
  return import('../three/stage.js');
}

/** Its host says what is to be seen. */
function hiddenCanvas() {
  const canvas = document.createElement('canvas');
  canvas.setAttribute('aria-hidden', 'true');
  return canvas;
}
