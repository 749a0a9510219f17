// @ts-check
// Materials of glTF, made by three's own loader. Loaded only with models that have such materials.

import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { gltfOf } from './gltf-json.js';
import { adaptShaders } from './shaders.js';

/** @import { Kept } from './gltf-json.js' */
/** @import { Look } from './materials.js' */
/** @import { Textures } from './textures.js' */

export class GltfMaterials {
  #made;

  /** @param {(THREE.Material | null)[]} made one per material; null for one that three.js cannot make */
  constructor(made) {
    this.#made = made;
  }

  /**
   * @param {Kept[]} kept
   * @param {Textures} textures
   */
  static async load(kept, textures) {
    const { json, uses } = gltfOf(kept);
    const loader = new GLTFLoader();
    loader.register(() => ({ name: 'jsm_textures', loadTexture: async (i) => textures.of(uses[i]) }));
    const { parser } = await loader.parseAsync(JSON.stringify(json), '');
    // The loader throws at once, or later, where a definition is none.
    const made = await Promise.allSettled(kept.map(async (_, i) => parser.getDependency('material', i)));
    const materials = made.map((result) => (result.status === 'fulfilled' ? result.value : null));
    // The loader copies a texture for other coordinates or another transform.
    for (const material of materials) {
      for (const value of Object.values(material ?? {})) if (value instanceof THREE.Texture) textures.follow(value);
    }
    return new GltfMaterials(materials);
  }

  /**
   * The material as it is to be drawn now, or null when there is none.
   *
   * @param {number} index
   * @param {Look} look
   */
  dressed(index, { shading, wireframe, colours, tangents }) {
    const made = this.#made[index];
    if (made === null) return null;
    const material = shading === 'matte' ? matte(made) : made.clone();
    if ('wireframe' in material) material.wireframe = wireframe;
    if (shading === 'flat' && 'flatShading' in material) material.flatShading = true;
    if (!tangents) turnBumps(material);
    adaptShaders(material, { colours, tangents });
    return material;
  }

  dispose() {
    this.#made.forEach((material) => material?.dispose());
  }
}

/**
 * The same colours, opacity and light of its own on a surface that mirrors nothing.
 *
 * @param {THREE.Material} made
 */
function matte(made) {
  if (!(made instanceof THREE.MeshStandardMaterial)) {
    const material = made.clone();
    material.toneMapped = false;
    return material;
  }
  const { color, map, emissive, emissiveIntensity, emissiveMap, normalMap, normalScale } = made;
  const { side, transparent, opacity, depthWrite, alphaTest } = made;
  const material = new THREE.MeshLambertMaterial({ map, emissiveIntensity, emissiveMap, normalMap, side, transparent, opacity, depthWrite, alphaTest });
  material.color.copy(color);
  material.emissive.copy(emissive);
  material.normalScale.copy(normalScale);
  material.toneMapped = false;
  return material;
}

/**
 * Without tangents, three.js takes the direction of v for up; v of glTF grows downwards.
 *
 * @param {THREE.Material} material
 */
function turnBumps(material) {
  if (material instanceof THREE.MeshStandardMaterial || material instanceof THREE.MeshLambertMaterial) material.normalScale.y *= -1;
  if (material instanceof THREE.MeshPhysicalMaterial) material.clearcoatNormalScale.y *= -1;
}
