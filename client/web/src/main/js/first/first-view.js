// @ts-check
// Draws the first pictures of a model, before three.js has come: base mesh and first splits in their plain colours, with
// the camera and light that three.js takes over.

import { unit } from '../viewer/vectors.js';
import { KEY_DIRECTION } from './light.js';
import { plainLook } from './looks.js';
import { FRAGMENT, VERTEX } from './shaders.js';

/** @import { FirstGround } from './first-ground.js' */
/** @import { Look } from './looks.js' */
/** @import { Header, Slot } from '../session/header.js' */
/** @import { Group, MeshArrays } from '../session/mesh-arrays.js' */
/** @import { Shading } from '../session/shading.js' */
/** @import { Orbit } from '../viewer/orbit.js' */

export class FirstView {
  #gl;
  #program;
  #orbit;
  /** @type {Map<string, WebGLUniformLocation | null>} */
  #places = new Map();
  /** @type {WebGLBuffer[]} */
  #buffers = [];
  /** @type {MeshArrays | null} */
  #arrays = null;
  /** @type {Group[]} */
  #groups = [];
  /** @type {Look[]} */
  #looks = [];
  /** @type {Slot[]} */
  #slots = [];
  #coloured = false;
  #isClosed = false;
  /** @type {number[]} */
  #bounds = [];
  /** @type {Shading} */
  #shading;
  /** @type {FirstGround | null} */
  ground = null;
  /** How dark the shadow on the ground is, 0 to 1. */
  shadow = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Orbit} orbit
   * @param {Shading} shading
   * @throws {Error} where there is no WebGL 2
   */
  constructor(canvas, orbit, shading) {
    const gl = canvas.getContext('webgl2', { antialias: true });
    if (gl === null) throw new Error('WebGL 2 is missing');
    this.canvas = canvas;
    this.#gl = gl;
    this.#orbit = orbit;
    this.#shading = shading;
    this.#program = linked(gl, VERTEX, FRAGMENT);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** @param {Header} header */
  open({ slots, channels, isClosed, bounds }) {
    this.#bounds = bounds;
    this.#isClosed = isClosed;
    this.#slots = slots;
    this.#coloured = channels.some(({ semantic }) => semantic === 'COLOUR');
    this.#dressSlots();
  }

  #dressSlots() {
    const looks = this.#slots.map((slot) => plainLook(slot, this.#shading));
    // Along silhouettes, rounding errors turn faces around.
    const isSolid = this.#isClosed && !looks.some(({ blended }) => blended);
    this.#looks = looks.map((look) => ({ ...look, oneSided: isSolid || look.oneSided, coloured: this.#coloured }));
  }

  /** @param {MeshArrays} arrays */
  update(arrays) {
    const gl = this.#gl;
    this.#arrays = arrays;
    // While a step is on its way, or its vertices glide, the picture before stays.
    if (this.#groups === arrays.groups) return;
    this.#groups = arrays.groups;
    const { vertices, corners, positions, normals, colours, indices } = arrays;
    this.#buffers.forEach((buffer) => gl.deleteBuffer(buffer));
    this.#buffers = [];
    this.#fill(gl.ELEMENT_ARRAY_BUFFER, indices.subarray(0, corners));
    this.#attribute(0, positions.subarray(0, 3 * vertices), 3, gl.FLOAT);
    this.#attribute(1, normals.subarray(0, 3 * vertices), 3, gl.FLOAT);
    gl.disableVertexAttribArray(2);
    if (colours.length > 0) this.#attribute(2, colours.subarray(0, 4 * vertices), 4, gl.UNSIGNED_BYTE);
  }

  /** @param {Shading} value */
  set shading(value) {
    this.#shading = value;
    this.#dressSlots();
  }

  /**
   * @param {number} width
   * @param {number} height
   */
  resize(width, height) {
    this.canvas.width = width;
    this.canvas.height = height;
    this.#gl.viewport(0, 0, width, height);
  }

  render() {
    const gl = this.#gl;
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    if (this.#arrays === null) return;
    const { view, projection } = this.#orbit.matrices;
    const { center } = this.#orbit.sphere;
    const rig = this.#orbit.upright.axis === 'z' ? [1, 0, 0, 0, 0, -1, 0, 1, 0] : [1, 0, 0, 0, 1, 0, 0, 0, 1];
    if (this.shadow > 0 && (this.#shading === 'smooth' || this.#shading === 'flat')) this.ground?.draw(this.#arrays, this.#bounds, rig, this.shadow);
    gl.useProgram(this.#program);
    gl.uniformMatrix4fv(this.#at('view'), false, view);
    gl.uniformMatrix4fv(this.#at('projection'), false, projection);
    gl.uniformMatrix3fv(this.#at('rig'), false, rig);
    gl.uniform3fv(this.#at('center'), center);
    gl.uniform3fv(this.#at('key'), unit(KEY_DIRECTION));
    gl.uniform1i(this.#at('isFlat'), Number(this.#shading === 'flat' || this.#shading === 'normals'));
    gl.uniform1i(this.#at('isMatte'), Number(this.#shading === 'matte'));
    gl.uniform1i(this.#at('showsNormals'), Number(this.#shading === 'normals'));
    const groups = [...this.#groups].sort((a, b) => Number(this.#looks[a.slot]?.blended) - Number(this.#looks[b.slot]?.blended));
    for (const { slot, start, count } of groups) {
      this.#dress(this.#looks[slot]);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 4 * start);
    }
    gl.depthMask(true);
  }

  /** @param {Look} look */
  #dress({ base, emission, metal, rough, blended, oneSided, coloured }) {
    const gl = this.#gl;
    gl.uniform4fv(this.#at('base'), base);
    gl.uniform3fv(this.#at('emission'), emission);
    gl.uniform1f(this.#at('metal'), metal);
    gl.uniform1f(this.#at('rough'), rough);
    gl.uniform1i(this.#at('coloured'), Number(coloured));
    for (const [is, capability] of /** @type {const} */ ([[blended, gl.BLEND], [oneSided, gl.CULL_FACE]])) {
      if (is) gl.enable(capability);
      else gl.disable(capability);
    }
    gl.depthMask(!blended);
  }

  dispose() {
    this.#gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  /** @param {string} name of a uniform */
  #at(name) {
    const known = this.#places.get(name);
    if (known !== undefined) return known;
    const place = this.#gl.getUniformLocation(this.#program, name);
    this.#places.set(name, place);
    return place;
  }

  /**
   * @param {number} target
   * @param {Float32Array | Uint32Array | Uint8Array} values
   */
  #fill(target, values) {
    const gl = this.#gl;
    const buffer = gl.createBuffer();
    if (buffer === null) return;
    this.#buffers.push(buffer);
    gl.bindBuffer(target, buffer);
    gl.bufferData(target, values, gl.STATIC_DRAW);
  }

  /**
   * @param {number} location
   * @param {Float32Array | Uint8Array} values
   * @param {number} size
   * @param {number} type
   */
  #attribute(location, values, size, type) {
    this.#fill(this.#gl.ARRAY_BUFFER, values);
    this.#gl.vertexAttribPointer(location, size, type, type === this.#gl.UNSIGNED_BYTE, 0, 0);
    this.#gl.enableVertexAttribArray(location);
  }
}

/** @param {WebGL2RenderingContext} gl @param {string} vertex @param {string} fragment */
export function linked(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, text] of /** @type {const} */ ([[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]])) {
    const shader = gl.createShader(type);
    if (shader === null) continue;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    throw new Error(`the first renderer's shaders do not compile: ${gl.getProgramInfoLog(program)}`);
  }
  return program;
}
