// @ts-check
// The model's shadow on the ground in the first pictures. It comes after the first one, as it costs bytes.

import { contactShadow, DARKEST, SIDE } from './contact-shadow.js';
import { linked } from './first-view.js';

/** @import { MeshArrays } from '../session/mesh-arrays.js' */
/** @import { Orbit } from '../viewer/orbit.js' */

const VERTEX = `#version 300 es
uniform mat4 view, projection;
uniform mat3 rig;
uniform vec3 center;
uniform vec4 place;
out vec2 at;
void main(){
  at=vec2(gl_VertexID&1,gl_VertexID>>1);
  vec3 p=vec3(place.xy+place.w*at,place.z);
  if(rig[1].y>0.)p=p.yzx;
  gl_Position=projection*(view*vec4(rig*(p-center)+center,1));
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec2 at;
uniform sampler2D shadow;
uniform float dark;
out vec4 pixel;
void main(){
  pixel=vec4(0,0,0,dark*texture(shadow,at).r);
}`;

export class FirstGround {
  #gl;
  #orbit;
  #program;
  /** What the shadow is of. */
  #cast = '';

  /**
   * @param {WebGL2RenderingContext} gl
   * @param {Orbit} orbit
   */
  constructor(gl, orbit) {
    this.#gl = gl;
    this.#orbit = orbit;
    this.#program = linked(gl, VERTEX, FRAGMENT);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
  }

  /**
   * Darkens the ground where it is seen from above. All of the model is above it, and hides it when it is drawn after that.
   *
   * @param {MeshArrays} arrays
   * @param {number[]} bounds smallest x, y, z, then largest
   * @param {number[]} rig how the model stands
   * @param {number} intensity 0 to 1
   */
  draw(arrays, bounds, rig, intensity) {
    const gl = this.#gl;
    const at = (/** @type {string} */ name) => gl.getUniformLocation(this.#program, name);
    const { view, projection } = this.#orbit.matrices;
    const { axis } = this.#orbit.upright;
    gl.useProgram(this.#program);
    // The header comes in two parts, and the first one has coarser bounds.
    const cast = [axis, arrays.corners, ...bounds].join();
    if (this.#cast !== cast) {
      this.#cast = cast;
      const { cells, place } = contactShadow(arrays, bounds, axis);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, SIDE, SIDE, 0, gl.RED, gl.UNSIGNED_BYTE, cells);
      gl.uniform4fv(at('place'), place);
    }
    gl.uniformMatrix4fv(at('view'), false, view);
    gl.uniformMatrix4fv(at('projection'), false, projection);
    gl.uniformMatrix3fv(at('rig'), false, rig);
    gl.uniform3fv(at('center'), this.#orbit.sphere.center);
    gl.uniform1f(at('dark'), DARKEST * intensity);
    gl.enable(gl.BLEND);
    gl.enable(gl.CULL_FACE);
    gl.depthMask(false);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.depthMask(true);
  }
}
