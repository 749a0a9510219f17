// @ts-check
// The one mesh on the stage: arrays of finer and finer meshes go into buffers of the graphics card that are made once.

import * as THREE from './three/three.module.min.js';

/** @import { Drawn, Header } from './decoder.js' */

/** Room for render vertices that creases add to the wedges. */
const CREASE_ROOM = 1.3;

export class RefinedMesh {
  #parent;
  #capacity = { vertices: 0, indices: 0, creases: false };
  #sphere = new THREE.Sphere();
  /** @type {THREE.Mesh<THREE.BufferGeometry, THREE.Material[]> | null} */
  #mesh = null;
  /** @type {THREE.Material[]} */
  #materials = [];

  /** @param {THREE.Object3D} parent of what is drawn */
  constructor(parent) {
    this.#parent = parent;
  }

  /**
   * Takes the totals of the model, for which room is made when the first arrays come. Without them, room is made for
   * what comes.
   *
   * @param {Header} header
   * @param {THREE.Sphere} sphere around the model
   */
  open({ wedges, faces, channels }, sphere) {
    this.#capacity = { vertices: wedges ?? 0, indices: 3 * (faces ?? 0), creases: !channels.some((c) => c.semantic === 'NORMAL') };
    this.#sphere = sphere;
  }

  /** @param {THREE.Material[]} all one per display slot */
  set materials(all) {
    this.#materials = all;
    if (this.#mesh !== null) this.#mesh.material = all;
  }

  /**
   * Shows the arrays of a finer mesh.
   *
   * @param {Drawn} drawn
   */
  update(drawn) {
    const { normals, positions, uvs, colours, indices, groups } = drawn;
    const geometry = this.#geometryFor(drawn);
    fill(geometry.getAttribute('position'), positions);
    fill(geometry.getAttribute('normal'), normals);
    if (uvs.length > 0) fill(geometry.getAttribute('uv'), uvs);
    if (colours.length > 0) fill(geometry.getAttribute('color'), new Uint8Array(colours.buffer));
    if (geometry.index !== null) fill(geometry.index, indices);
    geometry.clearGroups();
    for (let i = 0; i < groups.length; i += 3) {
      if (groups[i + 2] > 0) geometry.addGroup(groups[i + 1], groups[i + 2], groups[i]);
    }
    geometry.setDrawRange(0, indices.length);
  }

  /** What was filled in is on the graphics card now. */
  rendered() {
    if (this.#mesh === null) return;
    const { attributes, index } = this.#mesh.geometry;
    for (const attribute of [...Object.values(attributes), index]) {
      if (attribute instanceof THREE.BufferAttribute) attribute.clearUpdateRanges();
    }
  }

  clear() {
    if (this.#mesh === null) return;
    this.#parent.remove(this.#mesh);
    this.#mesh.geometry.dispose();
    this.#mesh = null;
  }

  /** @param {Drawn} drawn */
  #geometryFor({ vertices, uvs, colours, indices }) {
    const before = this.#mesh?.geometry;
    if (before && vertices <= before.getAttribute('position').count && indices.length <= (before.index?.count ?? 0)) return before;
    const { vertices: total, indices: corners, creases } = this.#capacity;
    const room = Math.max(Math.ceil(total * (creases && before ? CREASE_ROOM : 1)), vertices);
    // Buffers of the graphics card cannot grow, so they are made for the whole model at once.
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', dynamic(new Float32Array(3 * room), 3));
    geometry.setAttribute('normal', dynamic(new Float32Array(3 * room), 3));
    if (uvs.length > 0) geometry.setAttribute('uv', dynamic(new Float32Array(2 * room), 2));
    if (colours.length > 0) geometry.setAttribute('color', dynamic(new Uint8Array(4 * room), 4, true));
    geometry.setIndex(dynamic(new Uint32Array(Math.max(corners, indices.length)), 1));
    geometry.boundingSphere = this.#sphere.clone();
    this.#show(geometry);
    return geometry;
  }

  /** @param {THREE.BufferGeometry} geometry */
  #show(geometry) {
    if (this.#mesh === null) {
      this.#mesh = new THREE.Mesh(geometry, this.#materials);
      this.#mesh.frustumCulled = false;
      this.#parent.add(this.#mesh);
    } else {
      this.#mesh.geometry.dispose();
      this.#mesh.geometry = geometry;
    }
  }
}

/**
 * @param {THREE.TypedArray} array
 * @param {number} itemSize
 */
function dynamic(array, itemSize, normalized = false) {
  return new THREE.BufferAttribute(array, itemSize, normalized).setUsage(THREE.DynamicDrawUsage);
}

/**
 * @param {THREE.BufferAttribute | THREE.InterleavedBufferAttribute} attribute
 * @param {ArrayLike<number>} values
 */
function fill(attribute, values) {
  if (!(attribute instanceof THREE.BufferAttribute)) return;
  attribute.array.set(values);
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, values.length);
  attribute.needsUpdate = true;
}
