// @ts-check
// The three.js scene: one mesh that is refined, and the camera that looks at it.

import * as THREE from './three/three.module.min.js';
import { OrbitControls } from './three/OrbitControls.js';
import { Lights, Materials } from './materials.js';
import { RefinedMesh } from './refined-mesh.js';

/** @import { Drawn, Header } from './decoder.js' */
/** @import { Shading } from './shading.js' */
/** @typedef {{ top: number, bottom: number }} Inset pixels of the canvas that lie below other things */

const FIELD_OF_VIEW = 35;
/** @type {[number, number, number]} */
const START_DIRECTION = [0.55, 0.32, 1];
/** Share of the free part of the picture that the bounding box fills at first. */
const FILLED = 0.96;

export class Stage {
  #renderer;
  #scene = new THREE.Scene();
  #camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  /** @type {OrbitControls | null} */
  #controls = null;
  #rig = new THREE.Group();
  #mesh = new RefinedMesh(this.#rig);
  #lights;
  #materials;
  /** @type {Inset} */
  #inset = { top: 0, bottom: 0 };
  #size = { width: 1, height: 1, pixelRatio: 1 };
  #dirty = false;
  #touched = false;
  #box = new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
  #sphere = new THREE.Sphere(new THREE.Vector3(), 1);

  /**
   * Draws into a canvas.
   *
   * @param {HTMLCanvasElement} canvas
   * @param {boolean} interactive adds orbit controls
   * @param {Shading} shading
   */
  constructor(canvas, interactive, shading = 'smooth') {
    this.canvas = canvas;
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: !interactive });
    this.#renderer.setClearAlpha(0);
    this.#renderer.toneMapping = THREE.NeutralToneMapping;
    this.#renderer.toneMappingExposure = 0.92;
    this.#materials = new Materials(Math.min(8, this.#renderer.capabilities.getMaxAnisotropy()), () => this.#dress());
    this.#materials.shading = shading;
    this.#scene.add(this.#rig);
    this.#lights = new Lights(this.#scene, this.#renderer);
    this.#lights.shading = shading;
    if (interactive) this.#controls = this.#addControls();
  }

  /**
   * Frames the model and makes its materials.
   *
   * @param {Header} header
   */
  open(header) {
    const [x, y, z, toX, toY, toZ] = header.bounds;
    this.#box.min.set(x, y, z);
    this.#box.max.set(toX, toY, toZ);
    this.#box.getBoundingSphere(this.#sphere);
    if (this.#sphere.radius === 0) this.#sphere.radius = 1;
    this.#mesh.open(header, this.#sphere);
    this.#materials.open(header);
    this.frame();
  }

  /** Puts the whole model into the part of the picture that nothing covers, seen from the front and slightly above. */
  frame() {
    const { center, radius } = this.#sphere;
    this.#camera.position.set(...START_DIRECTION).add(center);
    this.#camera.up.set(0, 1, 0);
    this.#camera.lookAt(center);
    const distance = this.#framingDistance();
    this.#camera.near = radius / 200;
    this.#camera.far = distance + 40 * radius;
    this.#camera.position.sub(center).setLength(distance).add(center);
    this.#camera.updateProjectionMatrix();
    if (this.#controls) {
      this.#controls.target.copy(center);
      this.#controls.minDistance = radius / 50;
      this.#controls.maxDistance = 20 * radius;
      this.#controls.update();
    }
    this.invalidate();
  }

  /** From where on all corners of the box are in the picture. */
  #framingDistance() {
    const { width, height } = this.#size;
    const slope = FILLED * Math.tan(THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2));
    const free = Math.max(height - this.#inset.top - this.#inset.bottom, height / 3);
    const toEye = this.#camera.quaternion.clone().invert();
    let distance = 0;
    for (let i = 0; i < 8; i++) {
      const pick = (/** @type {number} */ axis) => (i & (1 << axis) ? this.#box.max : this.#box.min).getComponent(axis);
      const corner = new THREE.Vector3(pick(0), pick(1), pick(2)).sub(this.#sphere.center);
      corner.applyEuler(this.#rig.rotation).applyQuaternion(toEye);
      const across = (Math.abs(corner.x) * height) / width;
      const along = (Math.abs(corner.y) * height) / free;
      distance = Math.max(distance, corner.z + Math.max(across, along) / slope);
    }
    return distance;
  }

  /**
   * Shows the arrays of a finer mesh.
   *
   * @param {Drawn} drawn
   */
  update(drawn) {
    this.#mesh.update(drawn);
    this.invalidate();
  }

  /**
   * A texture has arrived whole, or a preview of it; rejects when the browser cannot read it.
   *
   * @param {string} path
   * @param {Uint8Array<ArrayBuffer>} bytes
   */
  addTexture(path, bytes) {
    return this.#materials.addTexture(path, bytes);
  }

  /** @param {Shading} value */
  set shading(value) {
    this.#lights.shading = value;
    this.#materials.shading = value;
    this.#materials.make();
  }

  /** @param {boolean} on */
  set wireframe(on) {
    this.#materials.wireframe = on;
    this.#materials.make();
  }

  /** @param {'y' | 'z'} axis */
  set up(axis) {
    this.#rig.rotation.x = axis === 'z' ? -Math.PI / 2 : 0;
    this.#placeRig();
    this.frame();
  }

  /**
   * Turns the camera around the model of an interactive stage.
   *
   * @param {number} right radians
   * @param {number} up radians
   */
  turn(right, up) {
    if (this.#controls === null) return;
    this.#touched = true;
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    const spherical = new THREE.Spherical().setFromVector3(offset);
    spherical.theta += right;
    spherical.phi = THREE.MathUtils.clamp(spherical.phi + up, 0.02, Math.PI - 0.02);
    this.#camera.position.setFromSpherical(spherical).add(this.#controls.target);
    this.#controls.update();
  }

  /**
   * Moves the camera of an interactive stage.
   *
   * @param {number} factor of the distance
   */
  zoom(factor) {
    if (this.#controls === null) return;
    this.#touched = true;
    const { target, minDistance, maxDistance } = this.#controls;
    const offset = this.#camera.position.clone().sub(target);
    offset.setLength(THREE.MathUtils.clamp(offset.length() * factor, minDistance, maxDistance));
    this.#camera.position.copy(target).add(offset);
    this.#controls.update();
  }

  /**
   * Fits the drawing buffer to the canvas on the page.
   *
   * @param {number} width
   * @param {number} height
   * @param {number} pixelRatio
   */
  resize(width, height, pixelRatio, inset = this.#inset) {
    if (width === 0 || height === 0) return;
    this.#size = { width, height, pixelRatio };
    this.#inset = inset;
    this.#renderer.setPixelRatio(pixelRatio);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    const shift = (inset.bottom - inset.top) / 2;
    if (shift === 0) this.#camera.clearViewOffset();
    else this.#camera.setViewOffset(width, height, 0, shift, width, height);
    this.#camera.updateProjectionMatrix();
    // Until somebody has turned the model it stays framed.
    if (!this.#touched) this.frame();
    this.invalidate();
  }

  /** Draws at the next frame. */
  invalidate() {
    if (this.#dirty) return;
    this.#dirty = true;
    requestAnimationFrame(() => this.render());
  }

  /** Draws now. */
  render() {
    this.#dirty = false;
    this.#lights.follow(this.#camera, this.#sphere);
    this.#renderer.render(this.#scene, this.#camera);
    this.#mesh.rendered();
  }

  /**
   * The picture on a transparent background as a data URL, at a size in pixels or that of the page.
   *
   * @param {string} type
   * @param {{ width: number, height: number } | null} size
   */
  picture(type, size = null) {
    const { width, height, pixelRatio } = this.#size;
    const inset = this.#inset;
    const touched = this.#touched;
    this.#touched = true;
    if (size !== null) this.resize(size.width, size.height, 1, { top: 0, bottom: 0 });
    this.render();
    const url = this.canvas.toDataURL(type);
    if (size !== null) this.resize(width, height, pixelRatio, inset);
    this.#touched = touched;
    return url;
  }

  /** The camera in the model's space, for checks against other renderers. */
  get camera() {
    const target = this.#controls ? this.#controls.target : this.#sphere.center;
    return { eye: this.#camera.position.toArray(), target: target.toArray(), up: this.#camera.up.toArray(), fieldOfView: FIELD_OF_VIEW };
  }

  /** What the graphics card holds now. */
  get memory() {
    return { ...this.#renderer.info.memory };
  }

  /** Takes the model off the stage and frees what it held. */
  clear() {
    this.#mesh.clear();
    this.#materials.clear();
  }

  dispose() {
    this.clear();
    this.#controls?.dispose();
    this.#lights.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #addControls() {
    const controls = new OrbitControls(this.#camera, this.canvas);
    controls.enableDamping = true;
    controls.dampingFactor = 0.12;
    let until = 0;
    this.canvas.addEventListener('pointerdown', () => (this.#touched = true));
    this.canvas.addEventListener('wheel', () => (this.#touched = true), { passive: true });
    const follow = () => {
      controls.update();
      if (performance.now() < until) requestAnimationFrame(follow);
    };
    controls.addEventListener('start', () => {
      until = Infinity;
      requestAnimationFrame(follow);
    });
    controls.addEventListener('end', () => (until = performance.now() + 700));
    controls.addEventListener('change', () => this.invalidate());
    return controls;
  }

  #dress() {
    this.#mesh.materials = this.#materials.all;
    this.invalidate();
  }

  /** Turns the model about its middle, so that the framing stays. */
  #placeRig() {
    const { center } = this.#sphere;
    this.#rig.position.set(0, 0, 0);
    this.#rig.updateMatrixWorld();
    this.#rig.position.copy(center).sub(center.clone().applyEuler(this.#rig.rotation));
  }
}
