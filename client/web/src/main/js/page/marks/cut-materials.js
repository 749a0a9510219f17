// @ts-check
// What three.js draws of a model that is cut open: both sides of its faces, the inner one in a flat tone.

/** @import * as THREE from 'three' */

/** Of three.js, which this file need not load. @type {THREE.Side} */
const DOUBLE_SIDED = 2;
/** In sRGB: that of the page's controls, which is unlike the ground, and unlike clay, stone and bronze. */
const TONE = 'vec3(0.059, 0.463, 0.431)';
const INSIDE = `  if (!gl_FrontFacing) gl_FragColor = vec4(${TONE}, 1.0);\n}`;

export class CutMaterials {
  /** @type {WeakSet<THREE.Material>} */
  #dressed = new WeakSet();

  /** Dresses the materials of all meshes that have some for display slots. @param {THREE.Object3D} scene */
  dress(scene) {
    scene.traverse((object) => {
      const { material } = /** @type {Partial<THREE.Mesh>} */ (object);
      if (Array.isArray(material)) material.forEach((each) => this.#dress(each));
    });
  }

  /** @param {THREE.Material} material */
  #dress(material) {
    if (this.#dressed.has(material) || material.transparent) return;
    this.#dressed.add(material);
    const { onBeforeCompile, customProgramCacheKey } = material;
    material.onBeforeCompile = (shader, renderer) => {
      onBeforeCompile.call(material, shader, renderer);
      shader.fragmentShader = shader.fragmentShader.replace(/\}\s*$/, INSIDE);
    };
    material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} cut`;
    material.side = DOUBLE_SIDED;
    material.needsUpdate = true;
  }
}
