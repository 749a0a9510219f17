// @ts-check
// How a model looks: the materials of its display slots, their textures, and the light that falls on them.

import * as THREE from './three/three.module.min.js';
import { RoomEnvironment } from './three/RoomEnvironment.js';

/** @import { Header, Slot } from './decoder.js' */
/** @import { Shading } from './shading.js' */

/** Models without colours: warm in the studio's light, neutral in the matte one. */
const CLAY = [0.74, 0.71, 0.66];
const GREY = [0.8, 0.8, 0.8];
/**
 * Light of the matte shading, in linear values: from above, from below, and from over the viewer's left shoulder.
 *
 * @type {Record<'sky' | 'ground' | 'key', [number, number, number]>}
 */
const MATTE = { sky: [0.62, 0.64, 0.66], ground: [0.2, 0.19, 0.18], key: [0.5, 0.49, 0.46] };
/** @type {[number, number, number]} */
const KEY_DIRECTION = [-0.6, 0.9, 0.7];

/** One material per display slot. Made anew whenever something about them changes; `all` are those of now. */
export class Materials {
  /** @type {Slot[]} */
  #slots = [];
  #hasColours = false;
  /** @type {Map<string, THREE.Texture>} */
  #textures = new Map();
  /** Number of the latest image per path, and of the one that is shown. */
  /** @type {Map<string, number>} */
  #turns = new Map();
  /** @type {Map<string, number>} */
  #shownTurns = new Map();
  /** @type {THREE.Material[]} */
  #all = [];
  #anisotropy;
  #changed;

  /** @type {Shading} */
  shading = 'smooth';
  wireframe = false;

  /**
   * @param {number} anisotropy of textures
   * @param {() => void} changed called when `all` are others
   */
  constructor(anisotropy, changed) {
    this.#anisotropy = anisotropy;
    this.#changed = changed;
  }

  get all() {
    return this.#all;
  }

  /** @param {Header} header */
  open({ slots, channels }) {
    this.#slots = slots;
    this.#hasColours = channels.some((c) => c.semantic === 'COLOUR');
    this.make();
  }

  make() {
    const before = this.#all;
    this.#all = this.#slots.map((slot) => this.#material(slot));
    this.#changed();
    before.forEach((material) => material.dispose());
  }

  /**
   * A texture has arrived whole, or a preview of it; rejects when the browser cannot read it.
   *
   * @param {string} path
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  async addTexture(path, bytes) {
    const turn = (this.#turns.get(path) ?? 0) + 1;
    this.#turns.set(path, turn);
    const gltf = this.#slots.some((slot) => slot.texture === path && slot.gltf);
    const image = await createImageBitmap(new Blob([bytes]), { imageOrientation: gltf ? 'none' : 'flipY', premultiplyAlpha: 'none' });
    // A better image may have been ready sooner.
    if (turn < (this.#shownTurns.get(path) ?? 0)) return;
    this.#shownTurns.set(path, turn);
    const texture = new THREE.Texture(image);
    texture.flipY = false;
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.anisotropy = this.#anisotropy;
    texture.needsUpdate = true;
    const before = this.#textures.get(path);
    this.#textures.set(path, texture);
    this.make();
    before?.dispose();
  }

  clear() {
    this.#textures.forEach((texture) => texture.dispose());
    this.#textures.clear();
    this.#turns.clear();
    this.#shownTurns.clear();
    this.#all.forEach((material) => material.dispose());
    this.#all = [];
  }

  /** @param {Slot} slot */
  #material(slot) {
    const { shading, wireframe } = this;
    const side = THREE.DoubleSide;
    if (shading === 'normals') return new THREE.MeshNormalMaterial({ flatShading: true, side, wireframe });
    const map = (slot.texture === null ? undefined : this.#textures.get(slot.texture)) ?? null;
    const common = { map, side, wireframe, flatShading: shading === 'flat', vertexColors: this.#hasColours };
    const roughness = slot.roughness >= 0 ? slot.roughness : 0.62;
    const metalness = slot.metallic >= 0 ? slot.metallic : 0;
    const material =
      shading === 'matte'
        ? new THREE.MeshLambertMaterial({ ...common, toneMapped: false })
        : new THREE.MeshStandardMaterial({ ...common, roughness, metalness });
    const [r, g, b, alpha] = slot.colour ?? [...(shading === 'matte' ? GREY : CLAY), 1];
    material.color.setRGB(r, g, b, slot.gltf ? THREE.LinearSRGBColorSpace : THREE.SRGBColorSpace);
    // Many MTL files give a textured material a black or grey Kd that no viewer applies.
    if (map !== null && !slot.gltf) material.color.setRGB(1, 1, 1);
    if (alpha < 1) {
      material.transparent = true;
      material.opacity = alpha;
      material.depthWrite = false;
    }
    if (this.#hasColours) material.onBeforeCompile = decodeColours;
    return material;
  }
}

/** A sky, a key light over the viewer's shoulder and, but for the matte shading, a studio. */
export class Lights {
  #scene;
  #renderer;
  #sky = new THREE.HemisphereLight();
  #key = new THREE.DirectionalLight();

  /**
   * @param {THREE.Scene} scene
   * @param {THREE.WebGLRenderer} renderer
   */
  constructor(scene, renderer) {
    this.#scene = scene;
    this.#renderer = renderer;
    scene.add(this.#sky, this.#key, this.#key.target);
  }

  /** @param {Shading} value */
  set shading(value) {
    const matte = value === 'matte';
    if (matte) {
      // Linear values times π, because a matte surface sends out a πth of what it receives.
      this.#sky.color.setRGB(...MATTE.sky);
      this.#sky.groundColor.setRGB(...MATTE.ground);
      this.#key.color.setRGB(...MATTE.key);
    } else {
      this.#sky.color.set(0xffffff);
      this.#sky.groundColor.set(0x8d8478);
      this.#key.color.set(0xfff4e6);
      this.#scene.environment ??= this.#studio();
      this.#scene.environmentIntensity = 0.45;
    }
    this.#sky.intensity = matte ? Math.PI : 0.55;
    this.#key.intensity = matte ? Math.PI : 2.1;
  }

  /**
   * The light comes over the viewer's left shoulder, wherever the camera is.
   *
   * @param {THREE.Camera} camera
   * @param {THREE.Sphere} sphere around the model
   */
  follow(camera, { center, radius }) {
    this.#key.position.set(...KEY_DIRECTION).applyQuaternion(camera.quaternion).multiplyScalar(3 * radius).add(center);
    this.#key.target.position.copy(center);
  }

  dispose() {
    this.#scene.environment?.dispose();
  }

  /** Soft light from all sides, as in a photographer's room; small, because it is blurred anyway. */
  #studio() {
    const generator = new THREE.PMREMGenerator(this.#renderer);
    const room = new RoomEnvironment();
    const { texture } = generator.fromScene(room, 0.04, 0.1, 100, { size: 128 });
    room.dispose();
    generator.dispose();
    return texture;
  }
}

/**
 * Vertex colours come in sRGB bytes; light is reckoned in linear values.
 *
 * @param {{ vertexShader: string }} shader
 */
function decodeColours(shader) {
  shader.vertexShader = shader.vertexShader.replace(
    '#include <color_vertex>',
    `#include <color_vertex>
    vColor.rgb = mix(pow((vColor.rgb + 0.055) / 1.055, vec3(2.4)), vColor.rgb / 12.92, vec3(lessThanEqual(vColor.rgb, vec3(0.04045))));`,
  );
}
