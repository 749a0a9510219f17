// @ts-check
// Brings what has changed to the graphics card without drawing it: three.js does both at once, and to draw a large mesh
// for each slice of a step would take far longer than the slice.

import * as THREE from 'three';

export class Uploader {
  #scene = new THREE.Scene();
  #camera = new THREE.Camera();
  #target = new THREE.WebGLRenderTarget(1, 1, { depthBuffer: false });
  #material = new THREE.MeshBasicMaterial();
  #mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.#material);

  constructor() {
    this.#mesh.frustumCulled = false;
    this.#scene.add(this.#mesh);
  }

  /**
   * @param {THREE.WebGLRenderer} renderer
   * @param {THREE.BufferGeometry} geometry of which no face is drawn
   */
  upload(renderer, geometry) {
    this.#mesh.geometry = geometry;
    geometry.setDrawRange(0, 0);
    renderer.setRenderTarget(this.#target);
    renderer.render(this.#scene, this.#camera);
    renderer.setRenderTarget(null);
    geometry.setDrawRange(0, Infinity);
  }

  dispose() {
    this.#target.dispose();
    this.#material.dispose();
  }
}
