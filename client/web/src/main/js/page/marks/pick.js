// @ts-check
// The point of a mesh that a ray meets first. All triangles are looked at, in slices, so that the page goes on meanwhile:
// that takes no memory, and no time before somebody asks.

/** @import { Group, MeshArrays } from '../../session/mesh-arrays.js' */
/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Ray } from './space.js' */
/** @typedef {Pick<MeshArrays, 'positions' | 'indices' | 'groups'>} Drawn */

/** Triangles between two looks at the clock, and how long a slice may take. */
const STRIDE = 1 << 14;
const SLICE_MILLIS = 6;

/**
 * The nearest point of a mesh on a ray.
 *
 * @param {Drawn} mesh
 * @param {Ray} ray
 * @param {(point: Vector) => boolean} isSeen whether a point is not cut away
 * @param {() => Promise<void>} rest called between two slices
 * @returns {Promise<Vector | null>}
 */
export async function pick(mesh, ray, isSeen = () => true, rest = pause) {
  let nearest = Infinity;
  await look(mesh, ray, rest, (t) => {
    if (t < nearest && isSeen(pointAt(ray, t))) nearest = t;
    return false;
  });
  return nearest === Infinity ? null : pointAt(ray, nearest);
}

/**
 * Whether a ray meets the mesh sooner than a distance.
 *
 * @param {Drawn} mesh
 * @param {Ray} ray
 * @param {number} far
 * @param {(point: Vector) => boolean} isSeen
 * @returns {Promise<boolean>}
 */
export function meets(mesh, ray, far, isSeen = () => true, rest = pause) {
  return look(mesh, ray, rest, (t) => t < far && isSeen(pointAt(ray, t)));
}

/** @param {Ray} ray @param {number} t */
function pointAt({ from, along }, t) {
  return /** @type {Vector} */ (from.map((at, axis) => at + t * along[axis]));
}

/**
 * @param {Drawn} mesh
 * @param {Ray} ray
 * @param {() => Promise<void>} rest
 * @param {(t: number) => boolean} isEnough is told how far along the ray each triangle is
 */
async function look({ positions, indices, groups }, { from, along }, rest, isEnough) {
  let began = performance.now();
  for (const { start, count } of groups) {
    for (let first = start; first < start + count; first += 3 * STRIDE) {
      const end = Math.min(start + count, first + 3 * STRIDE);
      for (let i = first; i < end; i += 3) {
        const t = meet(positions, 3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2], from, along);
        if (t < Infinity && isEnough(t)) return true;
      }
      if (performance.now() - began < SLICE_MILLIS) continue;
      await rest();
      began = performance.now();
    }
  }
  return false;
}

/**
 * How far along a ray a triangle is, or infinite (Möller and Trumbore 1997).
 *
 * @param {Float32Array} p
 * @param {number} a where the first corner's coordinates begin
 * @param {number} b
 * @param {number} c
 * @param {Vector} from
 * @param {Vector} along
 */
export function meet(p, a, b, c, from, along) {
  // Arrays taken apart in the head of a function would take as long as all that follows.
  const dx = along[0];
  const dy = along[1];
  const dz = along[2];
  const ax = p[a];
  const ay = p[a + 1];
  const az = p[a + 2];
  const ux = p[b] - ax;
  const uy = p[b + 1] - ay;
  const uz = p[b + 2] - az;
  const vx = p[c] - ax;
  const vy = p[c + 1] - ay;
  const vz = p[c + 2] - az;
  const hx = dy * vz - dz * vy;
  const hy = dz * vx - dx * vz;
  const hz = dx * vy - dy * vx;
  const size = ux * hx + uy * hy + uz * hz;
  if (size === 0) return Infinity;
  const sx = from[0] - ax;
  const sy = from[1] - ay;
  const sz = from[2] - az;
  const s = (sx * hx + sy * hy + sz * hz) / size;
  if (!(s >= 0 && s <= 1)) return Infinity;
  const qx = sy * uz - sz * uy;
  const qy = sz * ux - sx * uz;
  const qz = sx * uy - sy * ux;
  const t = (dx * qx + dy * qy + dz * qz) / size;
  if (!(t >= 0 && s + t <= 1)) return Infinity;
  const far = (vx * qx + vy * qy + vz * qz) / size;
  return far > 0 ? far : Infinity;
}

function pause() {
  return new Promise((resolve) => setTimeout(resolve));
}
