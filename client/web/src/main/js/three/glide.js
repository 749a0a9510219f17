// @ts-check
// Vertices glide from where they start to their places: in the vertex shader, so that it costs the page no time.

import * as THREE from 'three';

const DECLARATION = 'attribute vec4 start;\nuniform vec2 glide;\n';
const PLACE = '#include <begin_vertex>\nif (start.w == glide.x) transformed = mix(start.xyz, transformed, glide.y);';
/** A step that no vertex has. */
const NONE = -1;

export class Glide {
  #uniform = { value: new THREE.Vector2(NONE, 1) };

  /**
   * @param {number} step of the vertices that glide
   * @param {number} share of their way
   */
  set(step, share) {
    this.#uniform.value.set(share < 1 ? step : NONE, share);
  }

  /**
   * Lets the vertices of a new material glide.
   *
   * @param {THREE.Material} material
   */
  adapt(material) {
    if (material.userData.glides) return;
    material.userData.glides = true;
    const { onBeforeCompile, customProgramCacheKey } = material;
    material.onBeforeCompile = (shader, renderer) => {
      onBeforeCompile.call(material, shader, renderer);
      shader.uniforms.glide = this.#uniform;
      shader.vertexShader = DECLARATION + shader.vertexShader.replace('#include <begin_vertex>', PLACE);
    };
    material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} glide`;
  }
}
