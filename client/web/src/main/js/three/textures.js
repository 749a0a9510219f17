// @ts-check
// Images as textures: what stands in for an image until it arrives, and how each use reads it.

import * as THREE from 'three';
import { pixelsOf } from './opacity.js';

/** @import { Kind, TextureUse } from './gltf-json.js' */
/** @typedef {{ path: string, glossiness: number | undefined, source: THREE.Source<unknown> }} Shown */

/**
 * What a surface shows before its image arrives: factors alone, no light of its own, no bumps.
 *
 * @type {Record<Kind, [number, number, number]>}
 */
const NEUTRAL = {
  colour: [255, 255, 255],
  emission: [0, 0, 0],
  normal: [128, 128, 255],
  direction: [255, 128, 255],
  data: [255, 255, 255],
};
/** Filters and wrapping as glTF numbers them. @type {Record<number, THREE.MagnificationTextureFilter>} */
const MAGNIFIED = { 9728: THREE.NearestFilter, 9729: THREE.LinearFilter };
/** @type {Record<number, THREE.MinificationTextureFilter>} */
const MINIFIED = {
  9728: THREE.NearestFilter,
  9729: THREE.LinearFilter,
  9984: THREE.NearestMipmapNearestFilter,
  9985: THREE.LinearMipmapNearestFilter,
  9986: THREE.NearestMipmapLinearFilter,
  9987: THREE.LinearMipmapLinearFilter,
};
/** @type {Record<number, THREE.Wrapping>} */
const WRAPPING = { 33071: THREE.ClampToEdgeWrapping, 33648: THREE.MirroredRepeatWrapping, 10497: THREE.RepeatWrapping };

export class Textures {
  #anisotropy;
  /** @type {Map<string, ImageBitmap>} */
  #images = new Map();
  /** What is shown of an image, by path and kind. @type {Map<string, Shown>} */
  #sources = new Map();
  /** @type {Set<THREE.Texture>} */
  #textures = new Set();
  /** Number of the latest image per path, and of the one that is shown. @type {Map<string, number>} */
  #turns = new Map();
  /** @type {Map<string, number>} */
  #shownTurns = new Map();

  /** @param {number} anisotropy of textures */
  constructor(anisotropy) {
    this.#anisotropy = anisotropy;
  }

  /**
   * An image has arrived whole, or a preview of it; rejects when the browser cannot read it. Gives null for one that a
   * better one has overtaken.
   *
   * @param {string[]} paths of the image, which come together
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  async add(paths, bytes) {
    const [first] = paths;
    const turn = (this.#turns.get(first) ?? 0) + 1;
    this.#turns.set(first, turn);
    const image = await createImageBitmap(new Blob([bytes]), { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
    if (turn < (this.#shownTurns.get(first) ?? 0) || !this.#turns.has(first)) {
      image.close();
      return null;
    }
    this.#shownTurns.set(first, turn);
    const before = this.#images.get(first);
    paths.forEach((path) => this.#images.set(path, image));
    this.#show(paths, image);
    before?.close();
    return image;
  }

  /** @param {string} path */
  has(path) {
    return this.#images.has(path);
  }

  /**
   * A texture that shows an image from when it arrives on.
   *
   * @param {TextureUse} use
   */
  of({ path, sampler, kind, glossiness }) {
    const texture = new THREE.Texture();
    texture.source = this.#source(path, kind, glossiness);
    texture.flipY = false;
    texture.magFilter = MAGNIFIED[sampler.magFilter] ?? THREE.LinearFilter;
    texture.minFilter = MINIFIED[sampler.minFilter] ?? THREE.LinearMipmapLinearFilter;
    texture.wrapS = WRAPPING[sampler.wrapS] ?? THREE.RepeatWrapping;
    texture.wrapT = WRAPPING[sampler.wrapT] ?? THREE.RepeatWrapping;
    texture.generateMipmaps = texture.minFilter !== THREE.NearestFilter && texture.minFilter !== THREE.LinearFilter;
    texture.anisotropy = this.#anisotropy;
    texture.needsUpdate = true;
    return this.follow(texture);
  }

  /**
   * Keeps a copy of a texture up to date, too.
   *
   * @param {THREE.Texture} texture
   */
  follow(texture) {
    this.#textures.add(texture);
    return texture;
  }

  clear() {
    this.#textures.forEach((texture) => texture.dispose());
    this.#images.forEach((image) => image.close());
    for (const kept of [this.#textures, this.#images, this.#sources, this.#turns, this.#shownTurns]) kept.clear();
  }

  /**
   * @param {string} path
   * @param {Kind} kind
   * @param {number} [glossiness]
   */
  #source(path, kind, glossiness) {
    const key = JSON.stringify([path, kind, glossiness]);
    const known = this.#sources.get(key);
    if (known !== undefined) return known.source;
    const image = this.#images.get(path);
    const same = [...this.#sources.values()].find((shown) => image !== undefined && this.#images.get(shown.path) === image && shown.glossiness === glossiness);
    const source = same?.source ?? new THREE.Source(image === undefined ? onePixel(NEUTRAL[kind]) : readAs(image, glossiness));
    this.#sources.set(key, { path, glossiness, source });
    return source;
  }

  /**
   * Textures of one image share its place on the graphics card, whatever they are for.
   *
   * @param {string[]} paths
   * @param {ImageBitmap} image
   */
  #show(paths, image) {
    /** @type {Map<number | undefined, THREE.Source<unknown>>} */
    const common = new Map();
    for (const shown of this.#sources.values()) {
      if (!paths.includes(shown.path)) continue;
      const source = common.get(shown.glossiness) ?? shown.source;
      if (!common.has(shown.glossiness)) source.data = readAs(image, shown.glossiness);
      common.set(shown.glossiness, source);
      for (const texture of this.#textures) if (texture.source === shown.source) renew(texture, source);
      shown.source = source;
    }
  }
}

/**
 * @param {THREE.Texture} texture
 * @param {THREE.Source<unknown>} source
 */
function renew(texture, source) {
  // The place on the graphics card has the size of the image before.
  texture.dispose();
  texture.source = source;
  texture.needsUpdate = true;
}

/** @param {[number, number, number]} rgb */
function onePixel(rgb) {
  return new ImageData(Uint8ClampedArray.of(...rgb, 255), 1, 1);
}

/**
 * Roughness is green for three.js.
 *
 * @param {ImageBitmap} image
 * @param {number} [glossiness] factor of the alpha of an image that says the contrary of roughness
 */
function readAs(image, glossiness) {
  if (glossiness === undefined) return image;
  const pixels = pixelsOf(image);
  for (let i = 0; i < pixels.data.length; i += 4) pixels.data.set([255, 255 - glossiness * pixels.data[i + 3], 0, 255], i);
  return pixels;
}
