// @ts-check
// How a model looks: a material for each of its display slots, and their images.

import * as THREE from 'three';
import { modern } from './gltf-json.js';
import { maskOf, mayHaveOpacity, opacityOf, pixelsOf } from './opacity.js';
import { plainMaterial } from './plain-materials.js';
import { adaptShaders } from './shaders.js';
import { Textures } from './textures.js';

/** @import { Json } from './gltf-json.js' */
/** @import { GltfMaterials } from './gltf-materials.js' */
/** @import { GltfSlot, Header, Slot, TextureUse } from '../session/header.js' */
/** @import { Meaning, Reading } from './plain-materials.js' */
/** @import { Shading } from '../session/shading.js' */
/** @typedef {{ shading: Shading, wireframe: boolean, colours: boolean, tangents: boolean }} Look the last two: of the vertices of the faces */

/** Pixels a side that tell what the opacity of an image means. */
const OPACITY_SAMPLES = 512;
const CLAMPED = { wrapS: 33071, wrapT: 33071 };
/** Of colours that mean something, because a matte surface sends out less light than it gets. */
const PAINT_BRIGHTNESS = 1.2;

/** One material per display slot. Made anew whenever something about them changes; `all` are those of now. */
export class Materials {
  /** @type {Slot[]} */
  #slots = [];
  /** Materials of slots from glTF, empty objects for others. @type {Json[]} */
  #definitions = [];
  /** @type {GltfMaterials | null} */
  #gltf = null;
  #hasColours = false;
  #isClosed = false;
  /** Those that need not be seen from behind, though they could be. @type {THREE.Material[]} */
  #solid = [];
  /** @type {Set<number>} */
  #tangents = new Set();
  #textures;
  /** Textures of plain slots by their use. @type {Map<string, THREE.Texture>} */
  #used = new Map();
  /** @type {Map<string, Meaning>} */
  #meanings = new Map();
  /** @type {THREE.Material[]} */
  #all = [];
  /** @type {THREE.Material | null} */
  #painted = null;
  #changed;

  /** @type {Shading} */
  shading = 'smooth';
  wireframe = false;

  /**
   * @param {number} anisotropy of textures
   * @param {() => void} changed called when `all` are others
   */
  constructor(anisotropy, changed) {
    this.#textures = new Textures(anisotropy);
    this.#changed = changed;
  }

  get all() {
    return this.#all;
  }

  /** For meshes whose vertices have colours that mean something: no other ones are seen. */
  get painted() {
    this.#painted ??= paintedMaterial(this.wireframe);
    return [this.#painted];
  }

  /**
   * Resolves when the materials are there; until then, some are simpler. Rejects when the page's own files cannot be
   * loaded.
   *
   * @param {Header} header
   */
  async open({ slots, channels, isClosed }) {
    this.#isClosed = isClosed;
    this.#hasColours = channels.some((c) => c.semantic === 'COLOUR');
    // The header comes in two parts, and says the same of materials in both.
    if (JSON.stringify(slots) === JSON.stringify(this.#slots)) return;
    this.#slots = slots;
    this.#definitions = slots.map((slot) => ('gltf' in slot ? definition(slot) : {}));
    this.#gltf?.dispose();
    this.#gltf = null;
    this.make();
    if (!slots.some((slot) => 'gltf' in slot)) return;
    const { GltfMaterials: Loaded } = await import('./gltf-materials.js');
    const kept = slots.map((slot, i) => ({ gltf: this.#definitions[i], images: 'gltf' in slot ? slot.images : [] }));
    const loaded = await Loaded.load(kept, this.#textures);
    if (slots !== this.#slots) return;
    this.#gltf = loaded;
    this.make();
  }

  /** @param {Set<number>} slots whose faces have tangents */
  set tangents(slots) {
    if (slots.size === this.#tangents.size && [...slots].every((slot) => this.#tangents.has(slot))) return;
    this.#tangents = slots;
    this.make();
  }

  make() {
    const before = [...this.#all, this.#painted];
    this.#painted = null;
    this.#all = this.#slots.map((slot, i) => this.#material(slot, i));
    this.#solid = this.#isClosed && this.#all.every(hidesWhatIsBehind) ? this.#all.filter(({ side }) => side === THREE.DoubleSide) : [];
    this.#changed();
    before.forEach((material) => material?.dispose());
  }

  /**
   * From outside, no face of a whole solid is seen from behind, but where a rounding error turns it.
   *
   * @param {boolean} isOutside
   */
  seenFrom(isOutside) {
    for (const material of this.#solid) material.side = isOutside ? THREE.FrontSide : THREE.DoubleSide;
  }

  /**
   * A texture has arrived whole, or a preview of it; rejects when the browser cannot read it. All paths of an image come together.
   *
   * @param {string[]} paths of its textures
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  async addTexture(paths, bytes) {
    const image = await this.#textures.add(paths, bytes);
    if (image === null) return;
    const uses = this.#slots.flatMap((slot) => ('gltf' in slot ? [] : Object.entries(slot.textures)));
    const found = uses.filter(([, { path }]) => paths.includes(path));
    if (found.length === 0) {
      this.#changed();
      return;
    }
    const opacity = mayHaveOpacity(bytes) ? opacityOf(pixelsOf(image, OPACITY_SAMPLES).data) : 'opaque';
    const mask = found.find(([use]) => use === 'OPACITY')?.[1];
    const meaning = { opacity, mask: mask === undefined ? null : maskTexture(image, mask) };
    this.#meanings.get(paths[0])?.mask?.texture.dispose();
    paths.forEach((path) => this.#meanings.set(path, meaning));
    this.make();
  }

  clear() {
    this.#textures.clear();
    this.#meanings.forEach(({ mask }) => mask?.texture.dispose());
    this.#meanings.clear();
    this.#used.clear();
    this.#all.forEach((material) => material.dispose());
    this.#all = [];
    this.#painted?.dispose();
    this.#painted = null;
    this.#gltf?.dispose();
    this.#gltf = null;
    this.#slots = [];
  }

  /**
   * @param {Slot} slot
   * @param {number} index
   */
  #material(slot, index) {
    const { shading, wireframe } = this;
    const gltf = this.#definitions[index];
    if (shading === 'normals') {
      const side = 'gltf' in slot && gltf.doubleSided !== true ? THREE.FrontSide : THREE.DoubleSide;
      return new THREE.MeshNormalMaterial({ flatShading: true, side, wireframe });
    }
    const look = { shading, wireframe, colours: this.#hasColours, tangents: this.#tangents.has(index) };
    if ('gltf' in slot) return this.#gltf?.dressed(index, look) ?? factorsAlone(gltf, look);
    return plainMaterial(slot, { textureOf: (use, reading) => this.#textureOf(use, reading), meaningOf: (path) => this.#meanings.get(path) }, look);
  }

  /**
   * @param {TextureUse} use
   * @param {Reading} reading
   */
  #textureOf(use, reading) {
    if (reading === 'mask') return this.#meanings.get(use.path)?.mask?.texture ?? null;
    if (!this.#textures.has(use.path)) return null;
    const key = JSON.stringify([use, reading]);
    const texture = this.#used.get(key) ?? placed(this.#textures.of({ path: use.path, sampler: use.clamped ? CLAMPED : {}, kind: reading }), use);
    if (reading === 'colour') texture.colorSpace = THREE.SRGBColorSpace;
    this.#used.set(key, texture);
    return texture;
  }
}

/** @param {THREE.Material} material */
function hidesWhatIsBehind(material) {
  return !material.transparent && material.alphaTest === 0 && !(material instanceof THREE.MeshPhysicalMaterial && material.transmission > 0);
}

/** Lines have no side that light could fall on. @param {boolean} wireframe */
function paintedMaterial(wireframe) {
  const common = { side: THREE.DoubleSide, toneMapped: false };
  const material = wireframe ? new THREE.MeshBasicMaterial({ ...common, wireframe }) : new THREE.MeshLambertMaterial({ ...common, flatShading: true });
  // Where the light falls straight on it, a colour is as on its scale.
  if (!wireframe) material.color.setScalar(PAINT_BRIGHTNESS);
  adaptShaders(material, { colours: true, tangents: false });
  return material;
}

/**
 * @param {GltfSlot} slot
 * @returns {Json}
 */
function definition({ gltf }) {
  try {
    const read = JSON.parse(gltf);
    return typeof read === 'object' && read !== null ? modern(read) : {};
  } catch {
    return {};
  }
}

/**
 * What is drawn of a glTF material until three's loader is there.
 *
 * @param {Json} gltf
 * @param {Look} look
 */
function factorsAlone({ pbrMetallicRoughness: surface, alphaMode, doubleSided }, { shading, wireframe, colours }) {
  // What an archive says may be anything.
  const { baseColorFactor, metallicFactor = 1, roughnessFactor = 1 } = surface ?? {};
  const [r, g, b, alpha] = Array.isArray(baseColorFactor) ? baseColorFactor : [1, 1, 1, 1];
  const side = doubleSided === true ? THREE.DoubleSide : THREE.FrontSide;
  const common = { side, wireframe, flatShading: shading === 'flat' };
  const material =
    shading === 'matte'
      ? new THREE.MeshLambertMaterial({ ...common, toneMapped: false })
      : new THREE.MeshStandardMaterial({ ...common, metalness: metallicFactor, roughness: roughnessFactor });
  material.color.setRGB(r, g, b, THREE.LinearSRGBColorSpace);
  if (alphaMode === 'BLEND') {
    material.transparent = true;
    material.opacity = alpha;
    material.depthWrite = false;
  }
  adaptShaders(material, { colours, tangents: false });
  return material;
}

/**
 * @param {ImageBitmap} image
 * @param {TextureUse} use
 */
function maskTexture(image, use) {
  const { data, width, height } = pixelsOf(image);
  const mask = maskOf(data);
  const texture = new THREE.DataTexture(mask, width, height);
  texture.wrapS = texture.wrapT = use.clamped ? THREE.ClampToEdgeWrapping : THREE.RepeatWrapping;
  texture.generateMipmaps = true;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  placed(texture, use);
  return { texture, opacity: opacityOf(mask) };
}

/**
 * @template {THREE.Texture} T
 * @param {T} texture
 * @param {TextureUse} use
 */
function placed(texture, { transform: [a, b, c, d, e, f] }) {
  texture.matrixAutoUpdate = false;
  texture.matrix.set(a, b, c, d, e, f, 0, 0, 1);
  return texture;
}
