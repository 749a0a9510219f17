// @ts-check
// Meshes whose colours mean something: each triangle has three corners that it shares with no other.

import { colourOf, shareOfLevel } from './palette.js';

/** @import { Snapshot } from './snapshots.js' */
/** @import { TriangleTree } from './triangle-tree.js' */
/** @typedef {{ positions: Float32Array<ArrayBuffer>, colours: Uint8Array<ArrayBuffer> }} Painted nine coordinates and three colours, sRGB and opacity, per triangle */
/** @typedef {{ positions: Float32Array<ArrayBuffer>, distances: Float32Array<ArrayBuffer>, farthest: Farthest }} Measured nine coordinates and three distances per triangle */
/** @typedef {Pick<Snapshot, 'positions' | 'indices' | 'groups'>} Drawn */
/** @typedef {{ distance: number, at: [number, number, number] }} Farthest */

/** Triangles that a mesh of few faces is cut into, so that distances inside its faces show. */
const PIECES = 120_000;
/** More pieces of one side of a face show nothing more. */
const MOST_CUTS = 48;
/** No longer than this without a look at newer wishes. */
const YIELD_MILLIS = 40;
const OPAQUE = 255;

/**
 * Each triangle in the colour of the level in which it came.
 *
 * @param {Snapshot} snapshot
 * @param {number} most the last level that there is
 * @returns {Painted}
 */
export function paintedByLevel({ levels, ...drawn }, most) {
  const corners = cornersOf(drawn);
  const colours = new Uint8Array((4 * corners.length) / 3);
  let at = 0;
  for (const { start, count } of drawn.groups) {
    for (let place = start / 3; place < (start + count) / 3; place++) {
      const colour = colourOf(shareOfLevel(levels[place], most));
      for (let corner = 0; corner < 3; corner++, at += 4) colours.set([...colour, OPAQUE], at);
    }
  }
  return { positions: corners, colours };
}

/**
 * Into how many parts the sides of faces are cut.
 *
 * @param {number} faces
 */
export function cutsOf(faces) {
  return Math.max(1, Math.min(MOST_CUTS, Math.floor(Math.sqrt(PIECES / Math.max(1, faces)))));
}

/**
 * Distances of points of a mesh from another one. Faces are cut into smaller triangles; distances are measured at their corners, and where a face is not
 * cut in its middle, because the corners of a coarse mesh may all lie on the finer one. Null when it is no longer wished.
 *
 * @param {Drawn & { faces: number }} drawn
 * @param {Pick<TriangleTree, 'distance'>} other
 * @param {{ isWhole?: boolean, isStale: () => boolean }} how `isWhole` leaves faces uncut; `isStale` is asked now and then
 * @returns {Promise<Measured | null>}
 */
export async function measured(drawn, other, { isWhole = false, isStale }) {
  const faces = cornersOf(drawn);
  const cuts = isWhole ? 1 : cutsOf(faces.length / 9);
  const positions = new Float32Array(faces.length * cuts * cuts);
  const distances = new Float32Array(positions.length / 3);
  /** @type {Farthest} */
  const farthest = { distance: 0, at: [0, 0, 0] };
  const measure = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => {
    const distance = other.distance(x, y, z);
    if (distance > farthest.distance) Object.assign(farthest, { distance, at: [x, y, z] });
    return distance;
  };
  const grid = new Grid(cuts);
  let yieldedAt = performance.now();
  for (let face = 0, to = 0; face < faces.length; face += 9) {
    to = cuts > 1 ? grid.cut(faces, face, measure, positions, distances, to) : middle(faces, face, measure, positions, distances, to);
    if (face % (9 * 64) !== 0 || performance.now() - yieldedAt < YIELD_MILLIS) continue;
    await new Promise((resolve) => setTimeout(resolve));
    yieldedAt = performance.now();
    if (isStale()) return null;
  }
  return { positions, distances, farthest };
}

/** @typedef {(x: number, y: number, z: number) => number} Measure */

/**
 * @param {Float32Array} faces
 * @param {number} from
 * @param {Measure} measure
 * @param {Float32Array} positions
 * @param {Float32Array} distances
 * @param {number} to corner
 */
function middle(faces, from, measure, positions, distances, to) {
  const mean = (/** @type {number} */ axis) => (faces[from + axis] + faces[from + 3 + axis] + faces[from + 6 + axis]) / 3;
  positions.set(faces.subarray(from, from + 9), 3 * to);
  distances.fill(measure(mean(0), mean(1), mean(2)), to, to + 3);
  return to + 3;
}

/** Points of a face whose sides are cut into equal parts. */
class Grid {
  #cuts;
  #points;
  #distances;

  /** @param {number} cuts */
  constructor(cuts) {
    this.#cuts = cuts;
    const count = ((cuts + 1) * (cuts + 2)) / 2;
    this.#points = new Float64Array(3 * count);
    this.#distances = new Float64Array(count);
  }

  /**
   * Cuts a face; gives the corner behind the last one that it has written.
   *
   * @param {Float32Array} faces
   * @param {number} from
   * @param {Measure} measure
   * @param {Float32Array} positions
   * @param {Float32Array} distances
   * @param {number} to corner
   */
  cut(faces, from, measure, positions, distances, to) {
    const n = this.#cuts;
    const points = this.#points;
    let count = 0;
    for (let row = 0; row <= n; row++) {
      for (let column = 0; column <= n - row; column++, count++) {
        const u = column / n;
        const v = row / n;
        for (let axis = 0; axis < 3; axis++) {
          points[3 * count + axis] = faces[from + axis] * (1 - u - v) + faces[from + 3 + axis] * u + faces[from + 6 + axis] * v;
        }
        this.#distances[count] = measure(points[3 * count], points[3 * count + 1], points[3 * count + 2]);
      }
    }
    let at = to;
    const write = (/** @type {number} */ point) => {
      positions.set(points.subarray(3 * point, 3 * point + 3), 3 * at);
      distances[at++] = this.#distances[point];
    };
    for (let row = 0, first = 0; row < n; row++) {
      const above = first + n - row + 1;
      for (let column = 0; column < n - row; column++) {
        [first + column, first + column + 1, above + column].forEach(write);
        if (column < n - row - 1) [first + column + 1, above + column + 1, above + column].forEach(write);
      }
      first = above;
    }
    return at;
  }
}

/** Nine coordinates per triangle. @param {Drawn} drawn */
export function cornersOf({ positions, indices, groups }) {
  const corners = new Float32Array(groups.reduce((sum, { count }) => sum + 3 * count, 0));
  let at = 0;
  for (const { start, count } of groups) {
    for (let i = start; i < start + count; i++, at += 3) {
      const from = 3 * indices[i];
      corners[at] = positions[from];
      corners[at + 1] = positions[from + 1];
      corners[at + 2] = positions[from + 2];
    }
  }
  return corners;
}
