// @ts-check
// The one mesh on the stage: draws the arrays of a model as it is refined.

import * as THREE from 'three';
import { orderBlended } from './blend-order.js';
import { Glide } from './glide.js';
import { isOutOfMemory, reserve } from './reserved-buffers.js';
import { Uploader } from './uploader.js';

/** @import { Group, MeshArrays, Name, Range } from '../session/mesh-arrays.js' */

/** What three.js calls the arrays. @type {Record<Exclude<Name, 'indices'>, string>} */
const ATTRIBUTES = { positions: 'position', normals: 'normal', tangents: 'tangent', colours: 'color', starts: 'start', uv0: 'uv', uv1: 'uv1', uv2: 'uv2', uv3: 'uv3' };
const COLOUR_BYTES = 4;

export class RefinedMesh {
  #parent;
  #uploads;
  #lacksMemory;
  #glide = new Glide();
  #uploader = new Uploader();
  /** @type {THREE.Mesh<THREE.BufferGeometry, THREE.Material[]> | null} */
  #mesh = null;
  /** @type {THREE.Material[]} */
  #materials = [];
  /** @type {MeshArrays | null} */
  #arrays = null;
  /** Of the arrays that the geometry has. */
  #generation = 0;
  /** Whether the geometry's buffers are still to be made. */
  #isNew = false;
  /** Whether there was memory for them. */
  #isProved = true;
  /** @type {Group[]} */
  #groups = [];
  /** Changed indices that a wireframe waits for: three.js makes all its lines anew whenever one changes. @type {Range[]} */
  #held = [];
  /** What has changed while the buffers were still to be made. @type {Range[]} */
  #early = [];
  /** Direction of sight for which blended faces are in order. @type {THREE.Vector3 | null} */
  #orderedFor = null;

  /**
   * @param {THREE.Object3D} parent of what is drawn
   * @param {boolean} uploads whether its buffers are made, and filled, by {@link upload} alone; else three.js does so when it draws
   * @param {() => void} lacksMemory called when the graphics card had none for its buffers
   */
  constructor(parent, uploads = false, lacksMemory = () => {}) {
    this.#parent = parent;
    this.#uploads = uploads;
    this.#lacksMemory = lacksMemory;
  }

  /** @param {THREE.Material[]} all one per display slot */
  set materials(all) {
    this.#materials = all;
    this.#orderedFor = null;
    all.forEach((material) => this.#glide.adapt(material));
    if (this.#mesh !== null) this.#mesh.material = all;
    if (this.#arrays !== null) this.update(this.#arrays);
  }

  /**
   * Shows what has changed.
   *
   * @param {MeshArrays} arrays
   */
  update(arrays) {
    this.#arrays = arrays;
    const fresh = arrays.takeFresh();
    this.#glide.set(arrays.step, arrays.glided);
    if (arrays.groups.length === 0) return;
    const geometry = this.#geometryFor(arrays);
    if (this.#isNew) {
      this.#early.push(...fresh);
      return;
    }
    for (const range of fresh) this.#change(geometry, range);
    if (this.#groups !== arrays.groups) this.#regroup(geometry, arrays.groups);
  }

  /**
   * @param {THREE.BufferGeometry} geometry
   * @param {Range} range
   */
  #change(geometry, range) {
    const { name, first, count } = range;
    if (name === 'indices') {
      if (this.#isWireframe) this.#held.push(range);
      else this.#changeIndices(geometry, range);
      return;
    }
    const attribute = geometry.getAttribute(ATTRIBUTES[name]);
    if (!(attribute instanceof THREE.BufferAttribute)) return;
    const bytes = name === 'colours' ? COLOUR_BYTES : 1;
    attribute.addUpdateRange(bytes * first, bytes * count);
    attribute.needsUpdate = true;
  }

  /**
   * @param {THREE.BufferGeometry} geometry
   * @param {Range} range
   */
  #changeIndices({ index }, { first, count }) {
    if (index === null || this.#arrays === null) return;
    const { indices } = this.#arrays;
    if (index.array !== indices) /** @type {Uint32Array} */ (index.array).set(indices.subarray(first, first + count), first);
    index.addUpdateRange(first, count);
    index.needsUpdate = true;
  }

  /**
   * @param {THREE.BufferGeometry} geometry
   * @param {Group[]} groups
   */
  #regroup(geometry, groups) {
    this.#held.splice(0).forEach((range) => this.#changeIndices(geometry, range));
    this.#groups = groups;
    setGroups(geometry, groups);
    this.#orderedFor = null;
  }

  /**
   * Brings what has changed to the graphics card. A new mesh is not seen before.
   *
   * @param {THREE.WebGLRenderer} renderer
   */
  upload(renderer) {
    const geometry = this.#mesh?.geometry;
    if (!geometry) return;
    if (this.#isNew) {
      this.#uploader.upload(renderer, geometry);
      this.#fill(geometry);
    }
    this.#uploader.upload(renderer, geometry);
  }

  /** @param {THREE.WebGLRenderer} renderer that has drawn it */
  #prove(renderer) {
    if (this.#isProved) return;
    this.#isProved = true;
    // three.js still goes through what it draws.
    if (isOutOfMemory(renderer)) queueMicrotask(this.#lacksMemory);
  }

  /** The buffers are made, and empty. @param {THREE.BufferGeometry} geometry */
  #fill(geometry) {
    const arrays = this.#arrays;
    this.#isNew = false;
    if (arrays === null) return;
    for (const attribute of Object.values(geometry.attributes)) {
      if (attribute instanceof THREE.BufferAttribute) changed(attribute, arrays.vertices * attribute.itemSize);
    }
    if (geometry.index !== null) changed(geometry.index, arrays.corners);
    this.#early.splice(0).forEach((range) => this.#change(geometry, range));
    this.#regroup(geometry, arrays.groups);
  }

  /** What three.js draws; null before there is anything. */
  get object() {
    return this.#mesh;
  }

  /**
   * Puts blended faces into the order in which they are to be drawn. Says whether that is another one.
   *
   * @param {THREE.Camera} camera
   */
  orderFor(camera) {
    const geometry = this.#mesh?.geometry;
    if (!geometry?.index || this.#arrays === null || !this.#hasBlended) return false;
    const away = camera.getWorldDirection(new THREE.Vector3()).applyQuaternion(this.#parent.quaternion.clone().invert());
    if (this.#orderedFor?.equals(away)) return false;
    this.#orderedFor = away;
    const { index } = geometry;
    const { positions, indices } = this.#arrays;
    const mesh = { positions, indices, sorted: /** @type {Uint32Array} */ (index.array), groups: this.#groups };
    setGroups(geometry, orderBlended(mesh, (slot) => this.#isBlended(slot), away.toArray()));
    for (const { slot, start, count } of this.#groups) if (this.#isBlended(slot)) index.addUpdateRange(start, count);
    index.needsUpdate = true;
    return true;
  }

  /** @param {number} slot */
  #isBlended(slot) {
    return this.#materials[slot]?.transparent === true;
  }

  get #hasBlended() {
    return this.#groups.some(({ slot }) => this.#isBlended(slot));
  }

  get #isWireframe() {
    return this.#materials.some((material) => 'wireframe' in material && material.wireframe);
  }

  clear() {
    this.#arrays = null;
    if (this.#mesh === null) return;
    this.#parent.remove(this.#mesh);
    this.#mesh.geometry.dispose();
    this.#mesh = null;
  }

  dispose() {
    this.clear();
    this.#uploader.dispose();
  }

  /** @param {MeshArrays} arrays */
  #geometryFor(arrays) {
    const { generation, positions, normals, tangents, colours, starts, uvs, indices, groups } = arrays;
    const before = this.#mesh?.geometry;
    const isSorted = groups.some(({ slot }) => this.#isBlended(slot));
    if (before && generation === this.#generation && (before.index?.array !== indices) === isSorted) return before;
    this.#generation = generation;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', dynamic(positions, 3));
    // A mesh that is not refined may lack these.
    if (normals.length > 0) geometry.setAttribute('normal', dynamic(normals, 3));
    if (starts.length > 0) geometry.setAttribute('start', dynamic(starts, 4));
    uvs.forEach((set, i) => {
      if (set.length > 0) geometry.setAttribute(i === 0 ? 'uv' : `uv${i}`, dynamic(set, 2));
    });
    if (tangents.length > 0) geometry.setAttribute('tangent', dynamic(tangents, 4));
    if (colours.length > 0) geometry.setAttribute('color', dynamic(colours, 4, true));
    // The order in which blended faces are drawn is another one than that of their places.
    geometry.setIndex(dynamic(isSorted ? indices.slice() : indices, 1));
    this.#held = [];
    this.#early = [];
    this.#groups = [];
    this.#isNew = this.#uploads;
    this.#isProved = false;
    if (this.#uploads) for (const attribute of [...Object.values(geometry.attributes), geometry.index]) reserve(/** @type {THREE.BufferAttribute} */ (attribute).array);
    this.#show(geometry);
    return geometry;
  }

  /** @param {THREE.BufferGeometry} geometry */
  #show(geometry) {
    if (this.#mesh === null) {
      this.#mesh = new THREE.Mesh(geometry, this.#materials);
      this.#mesh.frustumCulled = false;
      this.#mesh.onAfterRender = (renderer) => this.#prove(renderer);
      this.#parent.add(this.#mesh);
    } else {
      this.#mesh.geometry.dispose();
      this.#mesh.geometry = geometry;
    }
  }
}

/**
 * @param {THREE.BufferGeometry} geometry
 * @param {Group[]} groups
 */
function setGroups(geometry, groups) {
  geometry.clearGroups();
  for (const { slot, start, count } of groups) geometry.addGroup(start, count, slot);
}

/**
 * @param {THREE.TypedArray} array
 * @param {number} itemSize
 */
function dynamic(array, itemSize, normalized = false) {
  return new THREE.BufferAttribute(array, itemSize, normalized).setUsage(THREE.DynamicDrawUsage);
}

/**
 * @param {THREE.BufferAttribute} attribute
 * @param {number} count of its numbers that are in use
 */
function changed(attribute, count) {
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, count);
  attribute.needsUpdate = true;
}
