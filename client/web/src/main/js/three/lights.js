// @ts-check
// The light that falls on a model.

import * as THREE from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { KEY_DIRECTION } from '../first/light.js';

/** @import { Shading } from '../session/shading.js' */

/**
 * Light of the matte shading, in linear values: from above, from below, and from over the viewer's left shoulder.
 *
 * @type {Record<'sky' | 'ground' | 'key', [number, number, number]>}
 */
const MATTE = { sky: [0.62, 0.64, 0.66], ground: [0.2, 0.19, 0.18], key: [0.5, 0.49, 0.46] };

/** A sky, a key light over the viewer's shoulder and, but for the matte shading, a studio. */
export class Lights {
  #scene;
  #renderer;
  #sky = new THREE.HemisphereLight();
  #key = new THREE.DirectionalLight();
  /** All renderers of three.js 0.181 share a table of reflectances, which would keep this one for ever: it is disposed of, and others send it to the graphics card again. @type {THREE.Texture | undefined} */
  #table;

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
   * @param {{ center: [number, number, number], radius: number }} sphere around the model
   */
  follow(camera, { center, radius }) {
    this.#key.position.set(...KEY_DIRECTION).applyQuaternion(camera.quaternion).multiplyScalar(3 * radius).add(new THREE.Vector3(...center));
    this.#key.target.position.set(...center);
  }

  /** The studio is a picture that the graphics card had drawn, and has lost. */
  restore() {
    if (this.#scene.environment === null) return;
    this.#scene.environment.dispose();
    this.#scene.environment = this.#studio();
  }

  dispose() {
    this.#scene.environment?.dispose();
    this.#table?.dispose();
  }

  /** @param {THREE.Object3D} part that was drawn @returns {THREE.Texture | undefined} */
  #tableOf(part) {
    if (!(part instanceof THREE.Mesh)) return undefined;
    const { uniforms } = /** @type {{ uniforms?: Record<string, THREE.IUniform> }} */ (this.#renderer.properties.get(part.material));
    return uniforms?.dfgLUT?.value;
  }

  /** Soft light from all sides, as in a photographer's room; small, because it is blurred anyway. */
  #studio() {
    const generator = new THREE.PMREMGenerator(this.#renderer);
    const room = new RoomEnvironment();
    const { texture } = generator.fromScene(room, 0.04, 0.1, 100, { size: 128 });
    room.traverse((part) => (this.#table ??= this.#tableOf(part)));
    room.dispose();
    generator.dispose();
    return texture;
  }
}
