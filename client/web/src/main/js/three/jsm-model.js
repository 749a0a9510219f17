// @ts-check
// A streamed model as a group of a three.js scene, which refines itself.

import * as THREE from 'three';
import { Progress } from '../viewer/progress.js';
import { Materials } from './materials.js';
import { RefinedMesh } from './refined-mesh.js';

/** @import { Header } from '../session/header.js' */
/** @import { MeshArrays } from '../session/mesh-arrays.js' */
/** @import { Session } from '../session/session.js' */
/** @import { Shading } from '../session/shading.js' */
/** @typedef {{ width: number, height: number }} Size */
/**
 * @typedef {object} Events three's own and these
 * @property {{ totalProgress: number }} progress bytes of the archive, 0 to 1
 * @property {{ level: number, faces: number }} level
 * @property {{ faces: number }} budget
 * @property {{}} complete
 * @property {{ message: string }} error
 * @property {{ meshSha256: string, modelSha256: string }} identical
 * @property {{}} change
 */
/** @typedef {{ width: number, height: number, camera: THREE.Camera }} Seen how a picture was taken */

/** Of textures seen from the side. */
const ANISOTROPY = 8;

export class JsmModel extends THREE.Group {
  #session;
  #rig = new THREE.Group();
  #mesh;
  #materials = new Materials(ANISOTROPY, () => this.#dress());
  #screen = {
    open: (/** @type {Header} */ header) => this.#open(header),
    update: (/** @type {MeshArrays} */ arrays) => this.#update(arrays),
    addTexture: (/** @type {string[]} */ paths, /** @type {Uint8Array<ArrayBuffer>} */ bytes) => this.#materials.addTexture(paths, bytes),
    clear: () => this.#clear(),
    lacksMemory: () => {},
  };
  #waitMillis;
  /** @type {{ pixels: number, camera: THREE.Camera | null } | null} */
  #target = null;
  /** The bounds of the model as it stands here. */
  bounds = new THREE.Box3();

  /**
   * @param {Session} session whose pictures go here
   * @param {number} waitMillis of a round
   */
  constructor(session, waitMillis) {
    super();
    this.#session = session;
    this.#waitMillis = waitMillis;
    this.add(this.#rig);
    this.#mesh = new RefinedMesh(this.#rig, false, () => this.#screen.lacksMemory());
    const progress = new Progress((name, detail) => this.#tell(name, detail));
    session.addEventListener('change', () => progress.hear(session));
    session.stage = this.#screen;
  }

  /** One more round of so many seconds; resolves when it is over. @param {number} [seconds] */
  async refine(seconds) {
    await this.#session.refine(seconds === undefined ? this.#waitMillis : 1000 * seconds);
  }

  /** The original; resolves when it is there. */
  complete() {
    return this.#session.complete();
  }

  /** Gives up what is being loaded; what has arrived stays. */
  stop() {
    this.#session.stop();
  }

  /** What is known of the model and of what has arrived of it. */
  get figures() {
    return this.#session.figures;
  }

  /** Estimate of the throughput. */
  get bytesPerSecond() {
    return this.#session.bytesPerSecond;
  }

  /** After so many it stops refining. @param {number} faces */
  set maxFaces(faces) {
    this.#session.mostFaces = faces;
  }

  /** @param {Shading} value */
  set shading(value) {
    this.#materials.shading = value;
    this.#materials.make();
  }

  /** @param {boolean} on */
  set wireframe(on) {
    this.#materials.wireframe = on;
    this.#materials.make();
  }

  /**
   * Refines by itself until 99.9% of the surface is off by no more pixels in the pictures that are drawn of it.
   *
   * @param {number | null} pixels null to refine no more by itself
   * @param {THREE.Camera | null} camera whose pictures count; null for all
   */
  setTargetError(pixels, camera = null) {
    this.#target = pixels === null ? null : { pixels, camera };
  }

  /**
   * How far 99.9% of the surface is off at most in a picture, in pixels; infinite before there is a mesh.
   *
   * @param {Seen} seen
   */
  pixelError({ height, camera }) {
    const { errorQuantile } = this.#session.figures;
    if (errorQuantile === null) return Infinity;
    const sphere = this.bounds.getBoundingSphere(new THREE.Sphere());
    const scale = this.matrixWorld.getMaxScaleOnAxis();
    const error = (errorQuantile * 2 * sphere.radius * scale) / 100;
    const slope = camera.projectionMatrix.elements[5];
    if (camera instanceof THREE.OrthographicCamera) return (error * slope * height) / 2;
    const eye = new THREE.Vector3().setFromMatrixPosition(camera.matrixWorld);
    const distance = Math.max(eye.distanceTo(sphere.center.applyMatrix4(this.matrixWorld)) - sphere.radius * scale, sphere.radius * scale * 1e-3);
    return (error * slope * height) / (2 * distance);
  }

  /** Frees what it holds. */
  dispose() {
    this.#session.dispose();
    this.#clear();
    this.removeFromParent();
  }

  /** @param {Header} header */
  #open(header) {
    const [x, y, z, toX, toY, toZ] = header.bounds;
    this.#rig.rotation.x = header.up === 'z' ? -Math.PI / 2 : 0;
    this.#rig.updateMatrix();
    this.bounds.set(new THREE.Vector3(x, y, z), new THREE.Vector3(toX, toY, toZ)).applyMatrix4(this.#rig.matrix);
    return this.#materials.open(header);
  }

  /** @param {MeshArrays} arrays */
  #update(arrays) {
    this.#materials.tangents = arrays.tangentSlots;
    this.#mesh.update(arrays);
    const mesh = this.#mesh.object;
    if (mesh !== null) mesh.onBeforeRender = (renderer, _, camera) => this.#beforeRender(renderer, camera);
    if (arrays.isWhole) this.#tell('change');
  }

  /**
   * @param {THREE.WebGLRenderer} renderer
   * @param {THREE.Camera} camera
   */
  #beforeRender(renderer, camera) {
    // Its order counts from the next picture on: that of this one is on the graphics card already.
    if (this.#mesh.orderFor(camera)) this.#tell('change');
    const target = this.#target;
    const { figures } = this.#session;
    if (target === null || figures.isBusy || figures.isOver || figures.isFull || figures.state === 'error' || (target.camera !== null && target.camera !== camera)) return;
    const { width, height } = renderer.getDrawingBufferSize(new THREE.Vector2());
    if (this.pixelError({ width, height, camera }) > target.pixels) this.refine();
  }

  #dress() {
    this.#mesh.materials = this.#materials.all;
    this.#tell('change');
  }

  #clear() {
    this.#mesh.clear();
    this.#materials.clear();
  }

  /**
   * @param {string} type
   * @param {unknown} [detail]
   */
  #tell(type, detail) {
    const event = { type, .../** @type {object} */ (detail) };
    this.dispatchEvent(/** @type {any} */ (event));
  }
}
