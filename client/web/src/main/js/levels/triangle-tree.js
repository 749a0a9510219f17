// @ts-check
// Boxes around boxes around triangles, so that few triangles are looked at for the one that is nearest to a point.

const LEAF = 4;
/** Numbers of a node: its box, and where its triangles lie. */
const BOX = 6;

export class TriangleTree {
  /** Nine coordinates per triangle, in the order of the leaves. */
  #corners;
  #boxes;
  /** First triangle and number of triangles of each node. A node's children follow it: the left one at once, the right one at `#right`. */
  #first;
  #count;
  #right;
  #nodes = 0;
  #nearest = 0;
  #stack = new Int32Array(128);
  #distances = new Float64Array(128);

  /** @param {Float32Array<ArrayBuffer>} corners nine coordinates per triangle, of which there is one at least; they are put into another order */
  constructor(corners) {
    const size = corners.length / 9;
    const most = Math.max(1, 2 * Math.ceil(size / (LEAF / 2)));
    this.#boxes = new Float32Array(BOX * most);
    this.#first = new Int32Array(most);
    this.#count = new Int32Array(most);
    this.#right = new Int32Array(most).fill(-1);
    const middles = new Float32Array(3 * size);
    for (let t = 0; t < size; t++) {
      for (let axis = 0; axis < 3; axis++) middles[3 * t + axis] = corners[9 * t + axis] + corners[9 * t + 3 + axis] + corners[9 * t + 6 + axis];
    }
    const order = Uint32Array.from({ length: size }, (_, t) => t);
    this.#corners = new Float32Array(corners.length);
    this.#split(order, middles, 0, size);
    for (let i = 0; i < size; i++) this.#corners.set(corners.subarray(9 * order[i], 9 * order[i] + 9), 9 * i);
    for (let node = this.#nodes - 1; node >= 0; node--) this.#fit(node);
  }

  /**
   * @param {Uint32Array} order
   * @param {Float32Array} middles
   * @param {number} from
   * @param {number} count
   */
  #split(order, middles, from, count) {
    const node = this.#nodes++;
    this.#first[node] = from;
    this.#count[node] = count;
    if (count <= LEAF) return node;
    const axis = longestAxis(order, middles, from, count);
    const half = from + (count >> 1);
    select(order, middles, axis, from, from + count - 1, half);
    this.#split(order, middles, from, half - from);
    this.#right[node] = this.#split(order, middles, half, from + count - half);
    return node;
  }

  /** Children come behind their parents, so they are fitted before them. @param {number} node */
  #fit(node) {
    const box = this.#boxes;
    const at = BOX * node;
    const right = this.#right[node];
    for (let axis = 0; axis < 3; axis++) {
      let low = Infinity;
      let high = -Infinity;
      if (right < 0) {
        const end = 9 * (this.#first[node] + this.#count[node]);
        for (let i = 9 * this.#first[node] + axis; i < end; i += 3) {
          low = Math.min(low, this.#corners[i]);
          high = Math.max(high, this.#corners[i]);
        }
      } else {
        low = Math.min(box[BOX * (node + 1) + axis], box[BOX * right + axis]);
        high = Math.max(box[BOX * (node + 1) + 3 + axis], box[BOX * right + 3 + axis]);
      }
      box[at + axis] = low;
      box[at + 3 + axis] = high;
    }
  }

  /**
   * The distance from a point to the nearest triangle. This is fastest when the point is near the one before.
   *
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  distance(x, y, z) {
    const stack = this.#stack;
    const distances = this.#distances;
    let best = squaredDistance(this.#corners, 9 * this.#nearest, x, y, z);
    let depth = 0;
    stack[depth] = 0;
    distances[depth++] = this.#boxDistance(0, x, y, z);
    while (depth > 0) {
      if (distances[--depth] >= best) continue;
      let node = stack[depth];
      while (this.#right[node] >= 0) {
        let near = node + 1;
        let far = this.#right[node];
        let toNear = this.#boxDistance(near, x, y, z);
        let toFar = this.#boxDistance(far, x, y, z);
        if (toFar < toNear) {
          [near, far] = [far, near];
          [toNear, toFar] = [toFar, toNear];
        }
        if (toFar < best) {
          stack[depth] = far;
          distances[depth++] = toFar;
        }
        node = near;
        if (toNear >= best) break;
      }
      if (this.#right[node] >= 0) continue;
      const end = this.#first[node] + this.#count[node];
      for (let t = this.#first[node]; t < end; t++) {
        const square = squaredDistance(this.#corners, 9 * t, x, y, z);
        if (square >= best) continue;
        best = square;
        this.#nearest = t;
      }
    }
    return Math.sqrt(best);
  }

  /**
   * @param {number} node
   * @param {number} x
   * @param {number} y
   * @param {number} z
   */
  #boxDistance(node, x, y, z) {
    const b = this.#boxes;
    const at = BOX * node;
    const dx = Math.max(b[at] - x, x - b[at + 3], 0);
    const dy = Math.max(b[at + 1] - y, y - b[at + 4], 0);
    const dz = Math.max(b[at + 2] - z, z - b[at + 5], 0);
    return dx * dx + dy * dy + dz * dz;
  }
}

/**
 * @param {Uint32Array} order
 * @param {Float32Array} middles
 * @param {number} from
 * @param {number} count
 */
function longestAxis(order, middles, from, count) {
  let longest = 0;
  let length = -1;
  for (let axis = 0; axis < 3; axis++) {
    let low = Infinity;
    let high = -Infinity;
    for (let i = from; i < from + count; i++) {
      const at = middles[3 * order[i] + axis];
      if (at < low) low = at;
      if (at > high) high = at;
    }
    if (high - low > length) {
      length = high - low;
      longest = axis;
    }
  }
  return longest;
}

/**
 * Brings those that lie lowest along an axis before place `k` (Hoare 1961).
 *
 * @param {Uint32Array} order
 * @param {Float32Array} middles
 * @param {number} axis
 * @param {number} from
 * @param {number} to
 * @param {number} k
 */
function select(order, middles, axis, from, to, k) {
  let low = from;
  let high = to;
  while (low < high) {
    const pivot = middles[3 * order[(low + high) >> 1] + axis];
    let i = low;
    let j = high;
    while (i <= j) {
      while (middles[3 * order[i] + axis] < pivot) i++;
      while (middles[3 * order[j] + axis] > pivot) j--;
      if (i > j) break;
      const swapped = order[i];
      order[i++] = order[j];
      order[j--] = swapped;
    }
    if (k <= j) high = j;
    else if (k >= i) low = i;
    else return;
  }
}

/**
 * From a point to a triangle, which may be a line or a point: its plane where the point lies above it, else the nearest of its edges.
 *
 * @param {Float32Array} p
 * @param {number} at where the nine coordinates begin
 * @param {number} x
 * @param {number} y
 * @param {number} z
 */
export function squaredDistance(p, at, x, y, z) {
  const ax = p[at];
  const ay = p[at + 1];
  const az = p[at + 2];
  const [ux, uy, uz] = [p[at + 3] - ax, p[at + 4] - ay, p[at + 5] - az];
  const [vx, vy, vz] = [p[at + 6] - ax, p[at + 7] - ay, p[at + 8] - az];
  const [wx, wy, wz] = [x - ax, y - ay, z - az];
  const uu = ux * ux + uy * uy + uz * uz;
  const uv = ux * vx + uy * vy + uz * vz;
  const vv = vx * vx + vy * vy + vz * vz;
  const wu = wx * ux + wy * uy + wz * uz;
  const wv = wx * vx + wy * vy + wz * vz;
  const area = uu * vv - uv * uv;
  if (area > 1e-14 * uu * vv) {
    const s = (vv * wu - uv * wv) / area;
    const t = (uu * wv - uv * wu) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) return squared(wx - s * ux - t * vx, wy - s * uy - t * vy, wz - s * uz - t * vz);
  }
  const s = uu > 0 ? clamp(wu / uu) : 0;
  const t = vv > 0 ? clamp(wv / vv) : 0;
  const [ex, ey, ez] = [vx - ux, vy - uy, vz - uz];
  const ee = ex * ex + ey * ey + ez * ez;
  const r = ee > 0 ? clamp(((wx - ux) * ex + (wy - uy) * ey + (wz - uz) * ez) / ee) : 0;
  return Math.min(
    squared(wx - s * ux, wy - s * uy, wz - s * uz),
    squared(wx - t * vx, wy - t * vy, wz - t * vz),
    squared(wx - ux - r * ex, wy - uy - r * ey, wz - uz - r * ez),
  );
}

/** @param {number} x @param {number} y @param {number} z */
function squared(x, y, z) {
  return x * x + y * y + z * z;
}

/** @param {number} value */
function clamp(value) {
  return value < 0 ? 0 : value > 1 ? 1 : value;
}
