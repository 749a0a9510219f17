// @ts-check
// A chart of throughput (filled) and detail (a line) over the time of loading.

import * as numbers from '../../session/numbers.js';
import { facesOf, parts } from './record.js';

/** @import { Header } from '../../session/header.js' */
/** @import { Point } from './record.js' */

const SVG = 'http://www.w3.org/2000/svg';
const WIDTH = 240;
const HEIGHT = 90;
const PARTS = 48;

export class Chart {
  element = shape('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', class: 'chart' });
  #rate = shape('path', { class: 'rate' });
  #detail = shape('path', { class: 'detail' });

  constructor() {
    this.element.append(this.#rate, this.#detail);
  }

  /**
   * Draws; gives the words below.
   *
   * @param {Point[]} points
   * @param {Header | null} header
   * @param {number} totalFaces
   */
  draw(points, header, totalFaces) {
    const { seconds, rates, bytes } = parts(points, PARTS);
    const most = Math.max(...rates);
    const faces = bytes.map((there) => (header === null ? 0 : facesOf(header.ends, header.batchFaces, there)));
    this.#rate.setAttribute('d', area(rates.map((rate) => rate / (most || 1))));
    this.#detail.setAttribute('d', line(faces.map((shown) => shown / (totalFaces || 1))));
    this.element.setAttribute('aria-label', `Throughput and faces over ${seconds.toFixed(1)} seconds of loading, up to ${numbers.faces(faces[PARTS - 1])}.`);
    return `Filled: throughput, up to ${numbers.rate(most)}. Line: faces. Over ${seconds.toFixed(1)} s of loading.`;
  }
}

/** @param {number[]} shares */
function area(shares) {
  return `M0 ${HEIGHT}${steps(shares)}V${HEIGHT}Z`;
}

/** @param {number[]} shares */
function line(shares) {
  return `M0 ${HEIGHT - 1}${steps(shares)}`;
}

/** @param {number[]} shares from 0 to 1 */
function steps(shares) {
  return shares.map((share, i) => `V${round(1 + (HEIGHT - 2) * (1 - share))}H${round(((i + 1) * WIDTH) / shares.length)}`).join('');
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 10) / 10;
}

/** @param {string} tag @param {Record<string, string>} attributes */
function shape(tag, attributes) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}
