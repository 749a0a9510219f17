// @ts-check
// The order in which blended faces are drawn: the farthest first, so that each is blended with what lies behind it.

/** @import { Group } from '../session/mesh-arrays.js' */

/** Of a group with more triangles, the order is left as it is: to find it would hold up every picture. */
export const MOST_SORTED = 1 << 17;
/** Steps of depth that are told apart; with the number of a triangle they fit into a number without rounding. */
const STEPS = 2 ** 24;
const NUMBERS = 2 ** 28;

/**
 * Sorts the triangles of blended slots, and gives all groups in the order in which they are to be drawn. The groups of a
 * slot are sorted as one.
 *
 * @param {{ positions: ArrayLike<number>, indices: Uint32Array, sorted: Uint32Array, groups: Group[] }} mesh `sorted` takes the indices of the blended groups
 * @param {(slot: number) => boolean} isBlended
 * @param {[number, number, number]} away the direction of sight
 */
export function orderBlended({ positions, indices, sorted, groups }, isBlended, away) {
  /** @type {Map<number, number>} */
  const depths = new Map();
  for (const { slot } of groups) {
    if (!isBlended(slot) || depths.has(slot)) continue;
    const runs = groups.filter((group) => group.slot === slot);
    depths.set(slot, sortRuns(positions, indices, sorted, runs, away));
  }
  const depth = (/** @type {Group} */ { slot }) => depths.get(slot) ?? Infinity;
  return groups.toSorted((a, b) => (depth(a) === depth(b) ? 0 : depth(b) - depth(a)));
}

/**
 * Sorts triangles by the depths of their centres; gives the mean of these.
 *
 * @param {ArrayLike<number>} positions
 * @param {Uint32Array} indices
 * @param {Uint32Array} sorted
 * @param {Group[]} runs
 * @param {[number, number, number]} away
 */
function sortRuns(positions, indices, sorted, runs, [x, y, z]) {
  const triangles = runs.reduce((all, { count }) => all + count / 3, 0);
  const depths = new Float64Array(triangles);
  const places = new Uint32Array(triangles);
  let sum = 0;
  let nearest = Infinity;
  let farthest = -Infinity;
  let t = 0;
  for (const { start, count } of runs) {
    for (let first = start; first < start + count; first += 3) {
      let depth = 0;
      for (let i = first; i < first + 3; i++) {
        const at = 3 * indices[i];
        depth += (x * positions[at] + y * positions[at + 1] + z * positions[at + 2]) / 3;
      }
      places[t] = first;
      depths[t++] = depth;
      sum += depth;
      nearest = Math.min(nearest, depth);
      farthest = Math.max(farthest, depth);
    }
  }
  const isSorted = triangles <= MOST_SORTED && farthest > nearest;
  const scale = isSorted ? (STEPS - 1) / (farthest - nearest) : 0;
  const keys = isSorted ? depths.map((depth, i) => Math.round((farthest - depth) * scale) * NUMBERS + i).sort() : depths.map((_, i) => i);
  keys.forEach((key, i) => {
    const from = places[key % NUMBERS];
    sorted.set(indices.subarray(from, from + 3), places[i]);
  });
  return sum / Math.max(1, triangles);
}
