// @ts-check
// From points of a model to places of its picture, and back along rays.

import { difference, dot, scaled, sum, unit } from '../../viewer/vectors.js';

/** @import { Orbit } from '../../viewer/orbit.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @typedef {Pick<Orbit, 'camera' | 'sphere' | 'upright'>} Eye */
/** @typedef {{ width: number, height: number }} Size of a picture, in pixels of the page */
/** @typedef {{ x: number, y: number, depth: number }} Place in pixels from the upper left corner, and how far before the eye */
/** @typedef {{ from: Vector, along: Vector }} Ray in the coordinates of the model */

const DEGREES = Math.PI / 180;

/** Where a point of the model stands. @param {Eye} eye @param {Vector} point @returns {Vector} */
export function stood({ sphere, upright }, point) {
  if (upright.axis !== 'z') return point;
  const [x, y, z] = difference(point, sphere.center);
  return sum(sphere.center, [x, z, -y]);
}

/** A direction of the picture's space in the model's. @param {Eye} eye @param {Vector} direction @returns {Vector} */
export function lain({ upright }, [x, y, z]) {
  return upright.axis === 'z' ? [x, -z, y] : [x, y, z];
}

/**
 * Where a point of the model is seen; null where it is not before the eye.
 *
 * @param {Eye} eye
 * @param {Size} size
 * @param {Vector} point
 * @returns {Place | null}
 */
export function project(eye, { width, height }, point) {
  const { eye: from, axes, near, fieldOfView, aspect, shift } = eye.camera;
  const away = difference(stood(eye, point), from);
  const depth = -dot(away, axes.back);
  if (depth < near) return null;
  const slope = 1 / Math.tan((fieldOfView * DEGREES) / 2) / depth;
  const across = (slope * dot(away, axes.right)) / aspect;
  const along = slope * dot(away, axes.up) + shift;
  return { x: ((1 + across) * width) / 2, y: ((1 - along) * height) / 2, depth };
}

/**
 * What lies beneath a place of the picture.
 *
 * @param {Eye} eye
 * @param {Size} size
 * @param {{ x: number, y: number }} place in pixels from the upper left corner
 * @returns {Ray}
 */
export function rayThrough(eye, { width, height }, { x, y }) {
  const { eye: from, axes, fieldOfView, aspect, shift } = eye.camera;
  const slope = Math.tan((fieldOfView * DEGREES) / 2);
  const across = ((2 * x) / width - 1) * slope * aspect;
  const along = (1 - (2 * y) / height - shift) * slope;
  const direction = unit(sum(sum(scaled(axes.right, across), scaled(axes.up, along)), scaled(axes.back, -1)));
  const { center } = eye.sphere;
  return { from: sum(center, lain(eye, difference(from, center))), along: lain(eye, direction) };
}

/**
 * The place of the picture that the camera turns about: the middle of what nothing covers.
 *
 * @param {Eye} eye
 * @param {Size} size
 */
export function middle({ camera }, { width, height }) {
  return { x: width / 2, y: ((1 - camera.shift) * height) / 2 };
}

/** @param {Vector} a @param {Vector} b */
export function distance(a, b) {
  return Math.hypot(...difference(a, b));
}
