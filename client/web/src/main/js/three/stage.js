// @ts-check
// The three.js scene: one mesh that is refined, in the light of a studio, seen by a camera that others move.

import * as THREE from 'three';
import { Ground } from './ground.js';
import { Lights } from './lights.js';
import { Materials } from './materials.js';
import { RefinedMesh } from './refined-mesh.js';
import { reserveBuffers } from './reserved-buffers.js';

/** @import { Header } from '../session/header.js' */
/** @import { MeshArrays } from '../session/mesh-arrays.js' */
/** @import { Shading } from '../session/shading.js' */
/** @import { Orbit } from '../viewer/orbit.js' */

/**
 * A mesh that is shown in the place of the model's; in the colours of its vertices and in flat shading where it is painted.
 *
 * @typedef {{ mesh: RefinedMesh, isPainted: boolean }} Guest
 */
/**
 * Draws the picture of parts.
 *
 * @callback Painter
 * @param {THREE.WebGLRenderer} renderer
 * @param {(guest: Guest | null) => void} draw draws a guest, or the model itself
 */

/**
 * Planes beyond which nothing of the model is drawn, and what is done with its materials before.
 *
 * @typedef {{ planes: { normal: { x: number, y: number, z: number }, constant: number }[], dress: (scene: THREE.Scene) => void }} Cutting
 */

/** Of textures seen from the side. */
const ANISOTROPY = 8;

export class Stage {
  #renderer;
  #scene = new THREE.Scene();
  #camera = new THREE.PerspectiveCamera();
  #orbit;
  #rig = new THREE.Group();
  #mesh;
  #lights;
  #materials;
  #changed;
  #size = { width: 1, height: 1 };
  /** Other meshes in the place of the model's. @type {Set<Guest>} */
  #guests = new Set();
  /** Draws the picture instead of the stage. @type {Painter | null} */
  painter = null;
  /** @type {Cutting | null} */
  cut = null;
  /** How dark the shadow on the ground is, 0 to 1. */
  shadow = 0;
  /** @type {Ground | null} */
  #ground = null;
  /** @type {Header | null} */
  #header = null;
  /** @type {MeshArrays | null} */
  #arrays = null;
  #shading;

  /**
   * Draws into a canvas.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {Orbit} orbit
   * @param {() => void} changed called when the picture is another, but for the camera
   * @param {Shading} shading
   * @param {() => void} lacksMemory called when the graphics card has none for the mesh
   */
  constructor(canvas, orbit, changed, shading = 'smooth', lacksMemory = () => {}) {
    this.canvas = canvas;
    this.#orbit = orbit;
    this.#changed = changed;
    this.#shading = shading;
    this.#mesh = new RefinedMesh(this.#rig, true, lacksMemory);
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setClearAlpha(0);
    reserveBuffers(this.#renderer.getContext());
    canvas.addEventListener('webglcontextrestored', () => this.#restore());
    this.#renderer.toneMapping = THREE.NeutralToneMapping;
    this.#renderer.toneMappingExposure = 0.92;
    this.#materials = new Materials(Math.min(ANISOTROPY, this.#renderer.capabilities.getMaxAnisotropy()), () => this.#dress());
    this.#materials.shading = shading;
    this.#scene.add(this.#rig);
    this.#lights = new Lights(this.#scene, this.#renderer);
    this.#lights.shading = shading;
  }

  /**
   * Makes the materials of a model; resolves when they are as they will be.
   *
   * @param {Header} header
   */
  open(header) {
    this.#header = header;
    // The header comes in two parts, and the first one has coarser bounds.
    this.#ground?.dispose();
    this.#ground = null;
    return this.#materials.open(header);
  }

  /**
   * Shows a finer mesh.
   *
   * @param {MeshArrays} arrays
   */
  update(arrays) {
    this.#arrays = arrays;
    this.#materials.tangents = arrays.tangentSlots;
    this.#mesh.update(arrays);
    if (arrays.isWhole) this.#changed();
    else if (!this.#renderer.getContext().isContextLost()) this.#mesh.upload(this.#renderer);
  }

  /**
   * A texture has arrived whole, or a preview of it; rejects when the browser cannot read it.
   *
   * @param {string[]} paths of its textures
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  addTexture(paths, bytes) {
    return this.#materials.addTexture(paths, bytes);
  }

  /** @param {Shading} value */
  set shading(value) {
    this.#shading = value;
    this.#lights.shading = value;
    this.#materials.shading = value;
    this.#materials.make();
  }

  /** @param {boolean} on */
  set wireframe(on) {
    this.#materials.wireframe = on;
    this.#materials.make();
  }

  /**
   * @param {number} width pixels of the drawing buffer
   * @param {number} height
   */
  resize(width, height) {
    this.#size = { width, height };
    this.#renderer.setPixelRatio(1);
    this.#renderer.setSize(width, height, false);
  }

  /** Draws now. */
  render() {
    if (this.#renderer.getContext().isContextLost()) return;
    this.#look();
    this.#lights.follow(this.#camera, this.#orbit.sphere);
    this.#mesh.upload(this.#renderer);
    const { center, radius } = this.#orbit.sphere;
    this.#materials.seenFrom(this.cut === null && this.#camera.position.distanceTo(new THREE.Vector3(...center)) > radius);
    this.#castShadow();
    if (this.painter === null) this.#draw(null);
    else this.painter(this.#renderer, (guest) => this.#draw(guest));
  }

  /** The ground lies beneath what there is of the model, and again when there is much more of it. */
  #castShadow() {
    const isLit = this.#shading === 'smooth' || this.#shading === 'flat';
    // A plane that cuts the model would cut the ground, too.
    const intensity = isLit && this.cut === null ? this.shadow : 0;
    if (intensity > 0 && this.#arrays !== null && this.#header !== null && this.#ground?.fits(this.#arrays, this.#orbit.upright.axis) !== true) {
      this.#ground?.dispose();
      this.#ground = new Ground(this.#rig, this.#arrays, this.#header.bounds, this.#orbit.upright.axis);
    }
    this.#ground?.show(intensity);
  }

  /** @param {Guest | null} guest */
  #draw(guest) {
    const shown = guest?.mesh ?? this.#mesh;
    for (const { object } of [this.#mesh, ...[...this.#guests].map(({ mesh }) => mesh)]) {
      if (object !== null) object.visible = object === shown.object;
    }
    shown.orderFor(this.#camera);
    // The studio's picture and what goes to the graphics card beforehand are never cut.
    this.cut?.dress(this.#scene);
    this.#renderer.clippingPlanes = /** @type {THREE.Plane[]} */ (this.cut?.planes ?? []);
    this.#renderer.render(this.#scene, this.#camera);
    this.#renderer.clippingPlanes = [];
  }

  /**
   * Makes room for another mesh in the place of the model's.
   *
   * @param {boolean} isPainted
   * @returns {Guest}
   */
  addGuest(isPainted) {
    const guest = { mesh: new RefinedMesh(this.#rig), isPainted };
    this.#guests.add(guest);
    this.#dress();
    return guest;
  }

  /** @param {Guest} guest */
  removeGuest(guest) {
    guest.mesh.dispose();
    this.#guests.delete(guest);
  }

  /** Takes the camera's place; the model turns about its middle. */
  #look() {
    const { eye, target, near, far, fieldOfView, aspect, shift } = this.#orbit.camera;
    const { width, height } = this.#size;
    this.#camera.position.set(...eye);
    this.#camera.up.set(0, 1, 0);
    this.#camera.lookAt(...target);
    Object.assign(this.#camera, { near, far, aspect, fov: fieldOfView });
    if (shift === 0) this.#camera.clearViewOffset();
    else this.#camera.setViewOffset(width, height, 0, (shift * height) / 2, width, height);
    this.#camera.updateProjectionMatrix();
    const center = new THREE.Vector3(...this.#orbit.sphere.center);
    this.#rig.rotation.x = this.#orbit.upright.axis === 'z' ? -Math.PI / 2 : 0;
    this.#rig.position.copy(center).sub(center.clone().applyEuler(this.#rig.rotation));
    this.#rig.updateMatrixWorld();
  }

  /** What the graphics card holds now. */
  get memory() {
    return { ...this.#renderer.info.memory };
  }

  /** Takes the model off the stage and frees what it held. */
  clear() {
    this.#ground?.dispose();
    this.#ground = null;
    this.#arrays = null;
    this.#mesh.clear();
    this.#materials.clear();
  }

  dispose() {
    this.clear();
    this.#mesh.dispose();
    this.#lights.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  /** The browser has given back the graphics card: three.js makes its buffers anew, but not what was drawn into textures. */
  #restore() {
    this.#lights.restore();
    this.#materials.make();
  }

  #dress() {
    this.#mesh.materials = this.#materials.all;
    for (const { mesh, isPainted } of this.#guests) mesh.materials = isPainted ? this.#materials.painted : this.#materials.all;
    this.#changed();
  }
}
