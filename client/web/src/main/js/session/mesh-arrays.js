// @ts-check
// The arrays of one model as it is refined. Whatever draws it shares them: they are made once, with room for the whole
// model. A step changes ranges of them, and may be applied in slices.

/** @import { Changes } from '../decode/decoder.js' */
/** @import { Header } from './header.js' */
/** @typedef {{ slot: number, start: number, count: number }} Group indices that are drawn with one material; a slot may have several groups */
/** @typedef {'positions' | 'normals' | 'colours' | 'indices' | 'tangents' | 'starts' | 'uv0' | 'uv1' | 'uv2' | 'uv3'} Name */
/** @typedef {{ name: Name, first: number, count: number }} Range elements of an array that are others; of colours, vertices */

/** What the decoder numbers. @type {(Name | null)[]} */
const NAMES = ['positions', 'normals', 'colours', 'indices', null, 'tangents', 'uv0', 'uv1', 'uv2', 'uv3', 'starts'];
/** Elements per vertex. */
const SIZES = { positions: 3, normals: 3, tangents: 4, colours: 1, starts: 4, uv0: 2, uv1: 2, uv2: 2, uv3: 2 };
/** @type {Name[]} */
const ALWAYS = ['positions', 'normals', 'starts', 'indices'];
/** Room for render vertices that creases add to the wedges. */
const CREASE_ROOM = 1.3;
/** Room for faces whose slot may still get others. */
const SLOT_ROOM = 1.5;

export class MeshArrays {
  positions = new Float32Array();
  normals = new Float32Array();
  /** x, y, z and sign; empty when there are none. */
  tangents = new Float32Array();
  /** sRGB bytes red, green, blue, opacity; empty when there are none. */
  colours = new Uint8Array();
  /** Sets of texture coordinates, each empty when there is none. @type {Float32Array<ArrayBuffer>[]} */
  uvs = [];
  indices = new Uint32Array();
  /** x, y, z from which a vertex glides to its position, and the step in which it does. */
  starts = new Float32Array();
  /** Vertices and corners in use. */
  vertices = 0;
  corners = 0;
  /** @type {Group[]} */
  groups = [];
  /** Slots whose vertices all have tangents. @type {Set<number>} */
  tangentSlots = new Set();
  /** Goes up when the arrays are others. */
  generation = 0;
  /** The step that is applied, and how far its vertices have glided: 0 where they start, 1 in their places. */
  step = 0;
  glided = 1;

  /** Whether the arrays are to be made anew when the step that is applied is whole. */
  #isLoose = false;
  #total = { vertices: 0, corners: 0 };
  #room = { vertices: 0, corners: 0 };
  /** All arrays as bits. @type {Map<Name, Uint32Array<ArrayBuffer>>} */
  #bits = new Map();
  /** @type {Changes | null} */
  #changes = null;
  /** Of the changes: range, elements of it that are applied, elements that are read. */
  #at = { range: 0, applied: 0, read: 0 };
  /** @type {Range[]} */
  #fresh = [];

  /**
   * Takes the totals of the model.
   *
   * @param {Pick<Header, 'wedges' | 'faces'> & Partial<Pick<Header, 'channels' | 'slots'>>} header
   */
  expect({ wedges, faces, channels = [], slots = [] }) {
    const creases = channels.some(({ semantic }) => semantic === 'NORMAL') ? 1 : CREASE_ROOM;
    // The first slot is that of faces without a material; most models use one.
    this.#total = { vertices: Math.ceil((wedges ?? 0) * creases), corners: 3 * Math.ceil((faces ?? 0) * (slots.length > 2 ? SLOT_ROOM : 1)) };
  }

  /**
   * Takes the changes to a finer mesh at once.
   *
   * @param {Changes} changes
   */
  take(changes) {
    this.begin(changes);
    this.apply(Infinity);
    this.glided = 1;
  }

  /**
   * Begins to apply changes; those before are applied whole.
   *
   * @param {Changes} changes
   * @throws {RangeError} when there is no memory for them; all stays as it is
   */
  begin(changes) {
    this.#makeRoom(changes, changes.step <= this.step);
    this.step = changes.step;
    this.glided = 0;
    this.#changes = changes;
    this.#at = { range: 0, applied: 0, read: 0 };
  }

  /**
   * Applies the next changes. True when all are.
   *
   * @param {number} most elements
   */
  apply(most) {
    if (this.#changes === null) return true;
    const { ranges, data } = this.#changes;
    const at = this.#at;
    for (let left = most; 3 * at.range < ranges.length; ) {
      if (left <= 0) return false;
      const [array, first, all] = ranges.subarray(3 * at.range, 3 * at.range + 3);
      const count = Math.min(left, all - at.applied);
      const name = NAMES[array];
      if (name) {
        this.#bits.get(name)?.set(data.subarray(at.read, at.read + count), first + at.applied);
        this.#fresh.push({ name, first: first + at.applied, count });
      }
      left -= count;
      at.read += count;
      at.applied += count;
      if (at.applied < all) return false;
      at.range++;
      at.applied = 0;
    }
    this.#finish(this.#changes);
    return true;
  }

  /** Whether all of the step is applied. While it is not, the picture is that of the step before. */
  get isWhole() {
    return this.#changes === null;
  }

  /** Ranges that were applied since this was asked the last time. */
  takeFresh() {
    const fresh = this.#fresh;
    this.#fresh = [];
    return fresh;
  }

  /**
   * Takes smaller totals, and lets go of room beyond them as soon as no step is being applied.
   *
   * @param {Parameters<MeshArrays['expect']>[0]} header
   */
  fit(header) {
    this.expect(header);
    this.#isLoose = true;
    if (this.isWhole) this.#fit();
  }

  #fit() {
    this.#isLoose = false;
    this.#make(this.#bits.keys(), { vertices: Math.max(this.#total.vertices, this.vertices), corners: Math.max(this.#total.corners, this.corners) }, false);
  }

  /** @param {Changes} changes */
  #finish({ vertices, places, groups, tangents }) {
    this.vertices = vertices;
    this.corners = 3 * places;
    this.groups = groupsOf(groups);
    this.tangentSlots = new Set(tangents);
    this.#changes = null;
    if (this.#isLoose) this.#fit();
  }

  /**
   * @param {Changes} changes
   * @param {boolean} isAnother whether it is another mesh, of which nothing is here yet
   */
  #makeRoom({ vertices, places, ranges }, isAnother) {
    const names = new Set([...ALWAYS, ...this.#bits.keys()]);
    for (let i = 0; i < ranges.length; i += 3) {
      const name = NAMES[ranges[i]];
      if (name) names.add(name);
    }
    const room = this.#room;
    const fits = vertices <= room.vertices && 3 * places <= room.corners && names.size === this.#bits.size;
    if (fits && !isAnother) return;
    const more = (/** @type {number} */ total, /** @type {number} */ needed) => (needed <= total ? total : Math.ceil(needed * (total === 0 ? 1 : CREASE_ROOM)));
    this.#make(names, { vertices: more(this.#total.vertices, vertices), corners: more(this.#total.corners, 3 * places) }, isAnother);
  }

  /**
   * @param {Iterable<Name>} names
   * @param {{ vertices: number, corners: number }} room
   * @param {boolean} isAnother
   */
  #make(names, room, isAnother) {
    /** @type {Map<Name, Uint32Array<ArrayBuffer>>} */
    const all = new Map();
    for (const name of names) {
      const bits = new Uint32Array(name === 'indices' ? room.corners : SIZES[name] * room.vertices);
      const kept = this.#bits.get(name);
      if (!isAnother && kept) bits.set(kept.subarray(0, Math.min(bits.length, name === 'indices' ? this.corners : SIZES[name] * this.vertices)));
      all.set(name, bits);
    }
    this.#room = room;
    this.#bits = all;
    this.generation++;
    this.#fresh = [];
    this.#expose();
  }

  #expose() {
    const floats = (/** @type {Name} */ name) => new Float32Array(this.#bits.get(name)?.buffer ?? new ArrayBuffer(0));
    this.positions = floats('positions');
    this.normals = floats('normals');
    this.tangents = floats('tangents');
    this.starts = floats('starts');
    this.uvs = [floats('uv0'), floats('uv1'), floats('uv2'), floats('uv3')];
    this.colours = new Uint8Array(this.#bits.get('colours')?.buffer ?? new ArrayBuffer(0));
    this.indices = /** @type {Uint32Array<ArrayBuffer>} */ (this.#bits.get('indices'));
  }
}

/** @param {ArrayLike<number>} numbers three per group */
function groupsOf(numbers) {
  /** @type {Group[]} */
  const groups = [];
  for (let i = 0; i < numbers.length; i += 3) {
    if (numbers[i + 2] > 0) groups.push({ slot: numbers[i], start: numbers[i + 1], count: numbers[i + 2] });
  }
  return groups;
}
