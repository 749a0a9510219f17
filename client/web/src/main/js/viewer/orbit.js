// @ts-check
// A camera that turns around a model. What draws the model asks it where the eye is; it knows no renderer.

import { wantsMotion } from '../session/motion.js';
import { Upright } from '../session/up.js';
import { cross, difference, dot, projectionMatrix, scaled, sum, unit, viewMatrix } from './vectors.js';

/** @import { Vector } from './vectors.js' */
/** @typedef {{ top: number, bottom: number }} Inset pixels of the canvas that lie below other things */
/** @typedef {{ target: Vector, theta: number, phi: number, radius: number }} Pose angles in radians: about the upward axis, and down from it */

/** @type {Vector} */
const START_DIRECTION = [0.55, 0.32, 1];
/** Degrees. */
const FIELD_OF_VIEW = 35;
/** Panels of the same window are not always as high. @type {Inset} */
export const UNCOVERED = { top: 0, bottom: 0 };
/** Share of the free part of the picture that the bounding box fills at first. */
const FILLED = 0.96;
/** Nothing that is drawn is farther from the model's middle, in halves of its diagonal. */
const NEAREST = 2;
/** No nearer to the poles. */
const POLE = 0.02;
/** A movement comes this much nearer to its end in each of these milliseconds. */
const SETTLING = 1 - Math.exp(-1 / 55);

const START_THETA = Math.atan2(START_DIRECTION[0], START_DIRECTION[2]);
const START_PHI = Math.acos(unit(START_DIRECTION)[1]);

/** Tells of a `change` whenever the picture is another. */
export class Orbit extends EventTarget {
  upright = new Upright(() => this.#stand());
  /** Of the model as it stands in its file. @type {Vector[]} */
  #corners = [];
  /** @type {Vector} */
  #center = [0, 0, 0];
  #stands = this.upright.axis;
  #extent = 1;
  /** @type {Pose} */
  #pose = { target: [0, 0, 0], theta: START_THETA, phi: START_PHI, radius: 4 };
  /** Where a movement ends. @type {Pose} */
  #goal = { ...this.#pose };
  #size = { width: 1, height: 1 };
  /** @type {Inset} */
  #inset = { top: 0, bottom: 0 };
  /** How the model is framed: parts of the pose, and the share of the distance from which all of it is seen. @type {Partial<Pose> & { share: number }} */
  #start = { share: 1 };
  /** Whether somebody has moved the camera; until then the model stays framed. */
  isTouched = false;
  /** How often somebody has. */
  moves = 0;

  constructor() {
    super();
    this.bounds = [-1, -1, -1, 1, 1, 1];
  }

  /** @param {number[]} bounds smallest x, y, z, then largest */
  set bounds([x, y, z, toX, toY, toZ]) {
    this.#corners = [x, toX].flatMap((a) => [y, toY].flatMap((b) => [z, toZ].map((c) => /** @type {Vector} */ ([a, b, c]))));
    this.#center = [(x + toX) / 2, (y + toY) / 2, (z + toZ) / 2];
    this.#extent = Math.hypot(toX - x, toY - y, toZ - z) / 2 || 1;
    if (!this.isTouched) this.frame();
  }

  /** Half of the diagonal, and the middle of the model. */
  get sphere() {
    return { center: this.#center, radius: this.#extent };
  }

  /** Puts the whole model into the part of the picture that nothing covers, seen from the front and slightly above. */
  frame() {
    this.isTouched = false;
    const { share, ...start } = this.#start;
    this.#goal = { target: this.#center, theta: START_THETA, phi: START_PHI, radius: 1, ...start };
    this.#goal.radius = start.radius ?? share * this.framingRadius();
    this.jump();
  }

  /** Where it is to be at first; it goes there from where it is. @param {Partial<Pose> & { share: number }} value */
  set start(value) {
    const pose = this.#pose;
    this.#start = value;
    this.frame();
    this.#pose = pose;
    this.#changed();
  }

  /** From where on all corners of the box are in the part of the picture that nothing covers, at the angles of the camera. */
  framingRadius(inset = this.#inset) {
    const { width, height } = this.#size;
    const slope = FILLED * Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    const free = Math.max(height - inset.top - inset.bottom, height / 3);
    const { right, up, back } = axesOf(this.#goal);
    const radii = this.#corners.map((corner) => {
      const at = this.#stood(difference(corner, this.#center));
      return dot(at, back) + Math.max((Math.abs(dot(at, right)) * height) / width, (Math.abs(dot(at, up)) * height) / free) / slope;
    });
    return Math.max(0, ...radii) || 1;
  }

  /** A direction of the model's file as it stands in the picture. @param {Vector} direction @returns {Vector} */
  #stood([x, y, z]) {
    return this.upright.axis === 'z' ? [x, z, -y] : [x, y, z];
  }

  #stand() {
    if (this.#stands === this.upright.axis) return;
    this.#stands = this.upright.axis;
    this.frame();
  }

  /**
   * Fits the camera to the canvas.
   *
   * @param {number} width
   * @param {number} height
   */
  resize(width, height, inset = this.#inset) {
    this.#size = { width, height };
    this.#inset = inset;
    if (this.isTouched) this.#changed();
    else this.frame();
  }

  /**
   * Fits the camera to a window of another shape, which shows as much of the model as the one before.
   *
   * @param {number} width
   * @param {number} height
   */
  refit(width, height, inset = this.#inset) {
    const before = this.framingRadius(UNCOVERED);
    this.resize(width, height, inset);
    if (!this.isTouched) return;
    const factor = this.framingRadius(UNCOVERED) / before;
    this.#goal = { ...this.#goal, radius: factor * this.#goal.radius };
    this.#pose = { ...this.#pose, radius: factor * this.#pose.radius };
    this.#changed();
  }

  /**
   * Turns the camera around the target.
   *
   * @param {number} right radians
   * @param {number} up radians
   */
  turn(right, up) {
    this.#touch();
    this.#goal = { ...this.#goal, theta: this.#goal.theta + right, phi: clamp(this.#goal.phi + up, POLE, Math.PI - POLE) };
    this.#changed();
  }

  /**
   * Moves the camera nearer or away. What lies beneath a place of the picture stays there.
   *
   * @param {number} factor of the distance
   * @param {number} across of the place, from −1 to 1 at the right edge
   * @param {number} along of the place, from −1 to 1 at the upper edge
   */
  zoom(factor, across = 0, along = 0) {
    this.#touch();
    const before = this.#goal.radius;
    const radius = clamp(before * factor, this.#extent / 50, 20 * this.#extent);
    const { right, up } = axesOf(this.#goal);
    const slope = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * (before - radius);
    const moved = sum(scaled(right, across * slope * this.#aspect), scaled(up, (along - this.#shift) * slope));
    this.#goal = { ...this.#goal, radius, target: sum(this.#goal.target, moved) };
    this.#changed();
  }

  /**
   * Moves what is seen along the picture.
   *
   * @param {number} right in heights of the picture
   * @param {number} up in heights of the picture
   */
  pan(right, up) {
    this.#touch();
    const axes = axesOf(this.#goal);
    const height = 2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * this.#goal.radius;
    const moved = sum(scaled(axes.right, -right * height), scaled(axes.up, -up * height));
    this.#goal = { ...this.#goal, target: sum(this.#goal.target, moved) };
    this.#changed();
  }

  get inset() {
    return this.#inset;
  }

  /** Where the camera goes, or is at rest. */
  get pose() {
    return { ...this.#goal };
  }

  /** @param {Partial<Pose>} pose what is to be another */
  moveTo(pose) {
    this.#touch();
    this.#goal = { ...this.#goal, ...pose };
    this.#goal.phi = clamp(this.#goal.phi, POLE, Math.PI - POLE);
    this.#changed();
  }

  /** Ends the movement at once. */
  jump() {
    this.#pose = { ...this.#goal };
    this.#changed();
  }

  /**
   * Goes on with a movement, or ends it where visitors want no motion. Says whether it goes on after that.
   *
   * @param {number} millis since the step before
   */
  step(millis) {
    const share = 1 - (1 - SETTLING) ** millis;
    const { target, theta, phi, radius } = this.#pose;
    const goal = this.#goal;
    const far = Math.max(Math.abs(goal.theta - theta), Math.abs(goal.phi - phi), Math.abs(goal.radius / radius - 1), Math.hypot(...difference(goal.target, target)) / radius);
    if (far < 1e-4 || !wantsMotion()) {
      if (far > 0) this.jump();
      return false;
    }
    this.#pose = {
      target: sum(target, scaled(difference(goal.target, target), share)),
      theta: theta + (goal.theta - theta) * share,
      phi: phi + (goal.phi - phi) * share,
      radius: radius * (goal.radius / radius) ** share,
    };
    return true;
  }

  get #aspect() {
    return this.#size.width / this.#size.height;
  }

  /** How far the middle is moved up for what covers the picture, in half heights. */
  get #shift() {
    return (this.#inset.bottom - this.#inset.top) / this.#size.height;
  }

  /** What a renderer needs to know. Lengths are those of the model. */
  get camera() {
    const { target, radius } = this.#pose;
    const axes = axesOf(this.#pose);
    const eye = sum(target, scaled(axes.back, radius));
    // The less lies before the model, the better depths within it are told apart.
    const near = Math.max(this.#extent / 200, Math.hypot(...difference(eye, this.#center)) - NEAREST * this.#extent);
    const far = radius + 40 * this.#extent;
    return { eye, target, axes, near, far, fieldOfView: FIELD_OF_VIEW, aspect: this.#aspect, shift: this.#shift };
  }

  /** From the world to the eye and from there to the picture, for WebGL. */
  get matrices() {
    const { eye, axes, fieldOfView, ...lens } = this.camera;
    return { view: viewMatrix(eye, axes), projection: projectionMatrix({ ...lens, fieldOfView: (fieldOfView * Math.PI) / 180 }) };
  }

  #touch() {
    this.isTouched = true;
    this.moves++;
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}

/** @param {Pose} pose */
function axesOf({ theta, phi }) {
  /** @type {Vector} */
  const back = [Math.sin(phi) * Math.sin(theta), Math.cos(phi), Math.sin(phi) * Math.cos(theta)];
  /** @type {Vector} */
  const right = [Math.cos(theta), 0, -Math.sin(theta)];
  return { right, up: cross(back, right), back };
}

/** @param {number} value @param {number} least @param {number} most */
function clamp(value, least, most) {
  return Math.min(Math.max(value, least), most);
}
