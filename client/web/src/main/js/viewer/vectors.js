// @ts-check
// Vectors of three numbers, and matrices of sixteen, column by column.

/** @typedef {[number, number, number]} Vector */

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const sum = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @param {Vector} a @param {number} factor @returns {Vector} */
export const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {Vector} a @returns {Vector} */
export const unit = (a) => scaled(a, 1 / Math.hypot(...a));

/**
 * From the world to the eye, which looks along its negative third axis.
 *
 * @param {Vector} eye
 * @param {{ right: Vector, up: Vector, back: Vector }} axes
 */
export function viewMatrix(eye, { right, up, back }) {
  return new Float32Array([
    right[0], up[0], back[0], 0, //
    right[1], up[1], back[1], 0, //
    right[2], up[2], back[2], 0, //
    -dot(right, eye), -dot(up, eye), -dot(back, eye), 1,
  ]);
}

/**
 * From the eye to the picture, whose middle is moved up by a share of its half height.
 *
 * @param {{ fieldOfView: number, aspect: number, near: number, far: number, shift: number }} lens field of view in radians
 */
export function projectionMatrix({ fieldOfView, aspect, near, far, shift }) {
  const slope = 1 / Math.tan(fieldOfView / 2);
  const depth = 1 / (near - far);
  return new Float32Array([slope / aspect, 0, 0, 0, 0, slope, 0, 0, 0, -shift, (near + far) * depth, -1, 0, 0, 2 * near * far * depth, 0]);
}
