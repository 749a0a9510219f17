// @ts-check
// One side of the picture, or all of it: the model as it streams, or a level that was decoded once more.

import { MeshArrays } from '../session/mesh-arrays.js';
import { shaded } from './palette.js';

/** @import { Guest, Stage } from '../three/stage.js' */
/** @import { Level, Wish } from './service.js' */

/** Each mesh is another one. */
let generation = 0;

export class Side {
  #stage;
  /** @type {{ plain: Guest | null, painted: Guest | null }} */
  #guests = { plain: null, painted: null };
  /** Which batch is wished; null for the newest. @type {number | null} */
  batches = null;
  /** The level that is shown; null for the model as it streams. @type {Level | null} */
  level = null;
  /** Whether an answer is on its way. */
  isWaiting = false;
  /** How many batches had arrived when it was asked for. */
  newest = 0;

  /**
   * @param {Pick<Stage, 'addGuest' | 'removeGuest'>} stage
   * @param {Wish['side']} name
   */
  constructor(stage, name) {
    this.#stage = stage;
    this.name = name;
  }

  /** What draws it; null for the model itself. */
  get guest() {
    if (this.level === null) return null;
    return this.level.paint === 'file' ? this.#guests.plain : this.#guests.painted;
  }

  /** The largest distance, where distances are shown. */
  get farthest() {
    return this.level?.measured?.farthest ?? null;
  }

  /**
   * @param {Level} level
   * @param {number} scale the distance at the bright end of the scale
   */
  show(level, scale) {
    this.level = level;
    this.isWaiting = false;
    const kind = level.paint === 'file' ? 'plain' : 'painted';
    const guest = (this.#guests[kind] ??= this.#stage.addGuest(kind === 'painted'));
    guest.mesh.update(arraysOf(level, scale));
  }

  /** Shows the model as it streams. */
  showModel() {
    this.level = null;
    this.isWaiting = false;
  }

  dispose() {
    for (const guest of [this.#guests.plain, this.#guests.painted]) if (guest !== null) this.#stage.removeGuest(guest);
    this.#guests = { plain: null, painted: null };
    this.level = null;
  }
}

/**
 * @param {Level} level
 * @param {number} scale
 */
function arraysOf({ mesh, painted, measured }, scale) {
  const arrays = new MeshArrays();
  generation++;
  if (mesh !== undefined) {
    const { positions, normals, tangents, colours, uvs, indices, groups, vertices } = mesh;
    return Object.assign(arrays, { positions, normals, tangents, colours, uvs, indices, groups, vertices, corners: indices.length, generation });
  }
  const positions = (measured ?? painted)?.positions ?? new Float32Array();
  const colours = measured === undefined ? painted?.colours : shaded(measured.distances, scale);
  const corners = positions.length / 3;
  const indices = Uint32Array.from({ length: corners }, (_, i) => i);
  return Object.assign(arrays, { positions, colours, indices, groups: [{ slot: 0, start: 0, count: corners }], vertices: corners, corners, generation });
}
