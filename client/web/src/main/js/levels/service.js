// @ts-check
// Answers wishes for levels. Each side of the picture has one wish at most: a newer one takes the place of that before.

import { inWords } from '../decode/messages.js';
import { cornersOf, measured, paintedByLevel } from './painting.js';
import { TriangleTree } from './triangle-tree.js';

/** @import { Measured, Painted } from './painting.js' */
/** @import { Index, LevelDecoder } from './level-decoder.js' */
/** @import { Snapshot } from './snapshots.js' */
/** @typedef {'file' | 'levels' | 'distance'} Paint what the colours show */
/**
 * @typedef {object} Wish
 * @property {'left' | 'right'} side
 * @property {number} id
 * @property {number} batches that the mesh is made of
 * @property {number} lastLevel that the archive has, as far as that is known
 * @property {number} newest batches that have arrived, from which distances are measured
 * @property {Paint} paint
 * @property {boolean} isWireframe whether edges are all that is seen
 * @property {Index} index
 */
/**
 * @typedef {{ side: Wish['side'], id: number, batches: number, faces: number, paint: Paint }} Head of an answer
 * @typedef {Head & { mesh?: Snapshot, painted?: Painted, measured?: Measured }} Level one of the three
 * @typedef {{ side: Wish['side'], id: number, error: string }} Refusal
 */

export class Service {
  #decoder;
  #post;
  /** @type {Map<Wish['side'], Wish>} */
  #wishes = new Map();
  #isBusy = false;
  /** Of the newest mesh that distances were measured from. @type {{ batches: number, tree: TriangleTree } | null} */
  #newest = null;

  /**
   * @param {Promise<Pick<LevelDecoder, 'level'>>} decoder
   * @param {(answer: Level | Refusal, transfer: ArrayBuffer[]) => void} post
   */
  constructor(decoder, post) {
    this.#decoder = decoder;
    this.#post = post;
    decoder.catch(() => {}); // whoever wishes is told
  }

  /** @param {Wish} wish */
  async hear(wish) {
    this.#wishes.set(wish.side, wish);
    if (this.#isBusy) return;
    this.#isBusy = true;
    for (let next = this.#next(); next !== null; next = this.#next()) await this.#answer(next);
    this.#isBusy = false;
  }

  /** @returns {Wish | null} */
  #next() {
    const [first = null] = this.#wishes.values();
    return first;
  }

  /** @param {Wish} wish */
  async #answer(wish) {
    const { side, id } = wish;
    const isStale = () => this.#wishes.get(side) !== wish;
    try {
      const level = await this.#level(wish, isStale);
      if (level !== null && !isStale()) this.#post(level, transferred(level));
    } catch (error) {
      if (!isStale()) this.#post({ side, id, error: inWords(error).message }, []);
    }
    if (!isStale()) this.#wishes.delete(side);
  }

  /**
   * @param {Wish} wish
   * @param {() => boolean} isStale
   * @returns {Promise<Level | null>}
   */
  async #level({ side, id, batches, newest, lastLevel, paint, isWireframe, index }, isStale) {
    const decoder = await this.#decoder;
    const mesh = await decoder.level(batches, index, isStale);
    if (mesh === null) return null;
    const head = { side, id, batches, faces: mesh.faces, paint };
    if (paint === 'file') return { ...head, mesh };
    if (paint === 'levels') return { ...head, painted: paintedByLevel(mesh, lastLevel) };
    const tree = await this.#treeOf(newest, index, isStale);
    const distances = tree && (await measured(mesh, tree, { isWhole: isWireframe, isStale }));
    return distances && { ...head, measured: distances };
  }

  /**
   * @param {number} batches
   * @param {Index} index
   * @param {() => boolean} isStale
   */
  async #treeOf(batches, index, isStale) {
    if (this.#newest?.batches !== batches) {
      const mesh = await (await this.#decoder).level(batches, index, isStale);
      if (mesh === null) return null;
      this.#newest = { batches, tree: new TriangleTree(cornersOf(mesh)) };
    }
    return this.#newest.tree;
  }
}

/** What is made for an answer alone goes with it; meshes stay. @param {Level} level */
function transferred({ painted, measured: distances }) {
  if (painted !== undefined) return [painted.positions.buffer, painted.colours.buffer];
  return distances === undefined ? [] : [distances.positions.buffer, distances.distances.buffer];
}
