// @ts-check
// Changes of three's own shaders.

import * as THREE from 'three';
import { FACING } from '../first/light.js';

/** Vertex colours come in sRGB bytes; light is reckoned in linear values. */
const LINEAR_COLOURS = `#include <color_vertex>
vColor.rgb = mix(pow((vColor.rgb + 0.055) / 1.055, vec3(2.4)), vColor.rgb / 12.92, vec3(lessThanEqual(vColor.rgb, vec3(0.04045))));`;
/** Materials of solids show one side or both, without another program. */
const BOTH_SIDES = '#ifndef DOUBLE_SIDED\n#define DOUBLE_SIDED\n#endif\n';
/** Tangents come from the direction in which texture coordinates grow, though other vertices have their own. */
const NO_TANGENTS = '#undef USE_TANGENT\n';

/**
 * Blended faces are in order (blend-order.js), so they need not be drawn twice, first those seen from behind.
 *
 * @param {THREE.Material} material
 * @param {{ colours: boolean, tangents: boolean }} has what the vertices of its faces have
 */
export function adaptShaders(material, { colours, tangents }) {
  material.vertexColors = colours;
  material.forceSinglePass = true;
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_begin>', THREE.ShaderChunk.normal_fragment_begin.replace('normal *= faceDirection;', `{vec3 toEye=normalize(vViewPosition),n=normal;${FACING}normal=n;}`));
    shader.fragmentShader = BOTH_SIDES + shader.fragmentShader;
    if (colours) shader.vertexShader = shader.vertexShader.replace('#include <color_vertex>', LINEAR_COLOURS);
    if (tangents) return;
    shader.vertexShader = NO_TANGENTS + shader.vertexShader;
    shader.fragmentShader = NO_TANGENTS + shader.fragmentShader;
  };
  material.customProgramCacheKey = () => `${colours} ${tangents}`;
}
