// @ts-check
// Pictures of a model as files.

/** @import { Inset, Orbit } from './orbit.js' */
/** @typedef {{ canvas: HTMLCanvasElement, resize: (width: number, height: number) => void, render: () => void }} Renderer */

export class Pictures {
  #orbit;
  #renderer;

  /**
   * @param {Orbit} orbit
   * @param {Renderer} renderer
   */
  constructor(orbit, renderer) {
    this.#orbit = orbit;
    this.#renderer = renderer;
  }

  /**
   * A picture as a data URL, at a size in pixels or that of the page, which stays as it is.
   *
   * @param {string} type
   * @param {{ width: number, height: number } | null} size
   * @param {{ width: number, height: number, pixelRatio: number }} page
   */
  take(type, size, page) {
    const renderer = this.#renderer;
    if (size === null) {
      renderer.render();
      return renderer.canvas.toDataURL(type);
    }
    const { isTouched, inset } = this.#orbit;
    this.#orbit.isTouched = true;
    this.#orbit.resize(size.width, size.height, { top: 0, bottom: 0 });
    renderer.resize(size.width, size.height);
    renderer.render();
    const url = renderer.canvas.toDataURL(type);
    this.#orbit.resize(page.width, page.height, inset);
    renderer.resize(Math.round(page.width * page.pixelRatio), Math.round(page.height * page.pixelRatio));
    renderer.render();
    this.#orbit.isTouched = isTouched;
    return url;
  }
}
