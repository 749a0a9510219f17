// @ts-check
// How dark the ground beneath a model is: the nearer the model comes to it, the darker, and soft. The class ContactShadow
// has the same for posters and the desktop's window.

/** @import { MeshArrays } from '../session/mesh-arrays.js' */
/**
 * @typedef {object} Shadow
 * @property {Uint8Array<ArrayBuffer>} cells rows of cells, 0 for light
 * @property {number[]} place where the first cell begins, across and along, the height of the ground, and the side of the square of cells. Up is y: across is z, along x. Up is z: across is x, along y
 */

/** Cells of a side. */
export const SIDE = 96;
/** How dark the ground is at most. */
export const DARKEST = 0.75;
/** Of larger models only a part is looked at: their triangles are small. */
const CORNERS = 150_000;
/** Places after which only few of each further triangle are looked at: thousands of large ones hide each other. */
const MANY_PLACES = 2 ** 24;
/** The side of the ground in lengths of the model's longer side. */
const SPACE = 1.6;
/** Height at which the shadow is less than half as dark, in lengths of the model's longest side. */
const REACH = 0.08;

const { ceil, exp, max, min } = Math;
/** Of the cells around one, in the blur: its deviation is four cells. */
const WEIGHTS = Float32Array.from({ length: 25 }, (_, i) => exp(-((i - 12) ** 2) / 32) / 10);

/**
 * @param {Pick<MeshArrays, 'positions' | 'indices' | 'corners' | 'groups'>} mesh
 * @param {ArrayLike<number>} bounds smallest x, y, z, then largest
 * @param {'y' | 'z'} up
 * @returns {Shadow}
 */
export function contactShadow({ positions, indices, corners, groups }, bounds, up) {
  const axes = up === 'z' ? [0, 1, 2] : [2, 0, 1];
  const sides = axes.map((axis) => bounds[axis + 3] - bounds[axis]);
  const side = SPACE * max(sides[0], sides[1]) || 1;
  const from = axes.map((axis, i) => bounds[axis] + (i < 2 ? (sides[i] - side) / 2 : 0));
  const units = [side / SIDE, side / SIDE, REACH * max(...sides) || 1];
  // The lowest height above each, in reaches.
  const cells = new Float32Array(SIDE * SIDE).fill(99);
  const p = new Float64Array(9);
  const stride = 3 * ceil(corners / CORNERS);
  let places = 0;
  for (const { start, count } of groups) {
    for (let i = start; i < start + count; i += stride) {
      for (let k = 0; k < 9; k++) p[k] = (positions[3 * indices[i + ((k / 3) | 0)] + axes[k % 3]] - from[k % 3]) / units[k % 3];
      // Places of the triangle, more of them than cells along its longest side.
      const most = max(p[0], p[3], p[6]) - min(p[0], p[3], p[6]) + max(p[1], p[4], p[7]) - min(p[1], p[4], p[7]);
      const steps = min(places < MANY_PLACES ? 2 * SIDE : 6, ceil(1.4 * most) || 1);
      places += ((steps + 1) * (steps + 2)) / 2;
      for (let b = 0; b <= steps; b++) {
        for (let c = 0; b + c <= steps; c++) {
          const [u, v] = [b / steps, c / steps];
          const w = 1 - u - v;
          const cell = ((w * p[1] + u * p[4] + v * p[7]) | 0) * SIDE + ((w * p[0] + u * p[3] + v * p[6]) | 0);
          cells[cell] = min(cells[cell], w * p[2] + u * p[5] + v * p[8]);
        }
      }
    }
  }
  return { cells: Uint8Array.from(blurred(blurred(cells.map((height) => exp(-max(0, height))), 1), SIDE), (dark) => 255 * dark + 0.5), place: [...from, side] };
}

/**
 * Blurs one direction. The cells of the edge are light, so a row may go on in the next one.
 *
 * @param {Float32Array} cells
 * @param {number} step from a cell to the next
 */
function blurred(cells, step) {
  return cells.map((_, cell) => {
    let sum = 0;
    for (let i = 0; i < 25; i++) sum += WEIGHTS[i] * (cells[cell + (i - 12) * step] || 0);
    return sum;
  });
}
