// @ts-check
// Large buffers of the graphics card that begin with zeros: their size is enough to make them, so that nothing is copied.

/** Smaller ones are copied soon enough. */
const LEAST_BYTES = 1 << 18;

/** @type {WeakSet<object>} */
const reserved = new WeakSet();

/**
 * Lets a context make buffers of the arrays that are reserved by their size.
 *
 * @param {Pick<WebGL2RenderingContext, 'bufferData'>} gl
 */
export function reserveBuffers(gl) {
  const make = /** @type {Function} */ (gl.bufferData).bind(gl);
  gl.bufferData = (/** @type {number} */ target, /** @type {any} */ data, /** @type {unknown[]} */ ...rest) => {
    const isReserved = typeof data === 'object' && data !== null && reserved.delete(data);
    make(target, isReserved ? data.byteLength : data, ...rest);
  };
}

/**
 * Whether there was no memory for something. The processor waits for the graphics card to know: to be asked when buffers were made, not in each frame.
 *
 * @param {{ getContext: () => Pick<WebGL2RenderingContext, 'getError' | 'NO_ERROR' | 'OUT_OF_MEMORY' | 'CONTEXT_LOST_WEBGL'> }} renderer
 */
export function isOutOfMemory(renderer) {
  const gl = renderer.getContext();
  // There may be older errors of other kinds.
  for (let error = gl.getError(); error !== gl.NO_ERROR && error !== gl.CONTEXT_LOST_WEBGL; error = gl.getError()) {
    if (error === gl.OUT_OF_MEMORY) return true;
  }
  return false;
}

/**
 * The buffer that is made of an array next has its size, but not what is in it.
 *
 * @param {ArrayBufferView} array
 */
export function reserve(array) {
  if (array.byteLength >= LEAST_BYTES) reserved.add(array);
}
