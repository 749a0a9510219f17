// @ts-check
// The ground beneath a model, which is seen by the model's shadow alone, and from above.

import * as THREE from 'three';
import { contactShadow, DARKEST, SIDE } from '../first/contact-shadow.js';

/** @import { MeshArrays } from '../session/mesh-arrays.js' */

/** Times as many faces, with which a model may have another shadow. */
const MUCH_MORE = 4;

export class Ground {
  #parent;
  #mesh;
  #axis;
  #corners;

  /**
   * @param {THREE.Object3D} parent in the coordinates of the model
   * @param {MeshArrays} arrays
   * @param {ArrayLike<number>} bounds smallest x, y, z, then largest
   * @param {'y' | 'z'} axis that points up
   */
  constructor(parent, arrays, bounds, axis) {
    this.#parent = parent;
    this.#axis = axis;
    this.#corners = arrays.corners;
    const { cells, place } = contactShadow(arrays, bounds, axis);
    // alphaMap looks at green.
    const pixels = new Uint8Array(4 * SIDE * SIDE);
    cells.forEach((dark, i) => (pixels[4 * i + 1] = dark));
    const alphaMap = new THREE.DataTexture(pixels, SIDE, SIDE);
    alphaMap.magFilter = THREE.LinearFilter;
    alphaMap.minFilter = THREE.LinearFilter;
    alphaMap.needsUpdate = true;
    const [across, along, height, side] = place;
    const geometry = new THREE.PlaneGeometry(side, side);
    geometry.translate(across + side / 2, along + side / 2, height);
    if (axis === 'y') geometry.applyMatrix4(new THREE.Matrix4().set(0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1));
    const material = new THREE.MeshBasicMaterial({ color: 0, alphaMap, transparent: true, depthWrite: false });
    this.#mesh = new THREE.Mesh(geometry, material);
    this.#mesh.renderOrder = -1;
    parent.add(this.#mesh);
  }

  /**
   * Whether it still is as it should be.
   *
   * @param {MeshArrays} arrays
   * @param {'y' | 'z'} axis
   */
  fits(arrays, axis) {
    return axis === this.#axis && arrays.corners < MUCH_MORE * this.#corners;
  }

  /** @param {number} intensity 0 to 1 */
  show(intensity) {
    this.#mesh.material.opacity = DARKEST * intensity;
    this.#mesh.visible = intensity > 0;
  }

  dispose() {
    this.#parent.remove(this.#mesh);
    this.#mesh.geometry.dispose();
    this.#mesh.material.alphaMap?.dispose();
    this.#mesh.material.dispose();
  }
}
