// @ts-check
// What people wrote about places of a model: as a file, which may have anything in it, and as a part of an address.

/** @import { Vector } from '../../viewer/vectors.js' */
/**
 * @typedef {object} Annotation
 * @property {string} title
 * @property {string} text
 * @property {Vector} point in the coordinates of the mesh
 * @property {{ eye: Vector, target: Vector } | null} camera likewise
 */
/** @typedef {{ annotations: Annotation[], problems: string[] }} Read */

export const MOST_BYTES = 1 << 20;
export const MOST = 500;
export const MOST_TITLE = 200;
export const MOST_TEXT = 5000;
/** Characters of a link that mail and chat programs still take. */
export const MOST_LINK = 6000;
/** Coordinates of models are of single precision. */
const DIGITS = 7;

/**
 * Leaves out what is wrong, and says so.
 *
 * @param {unknown} file
 * @param {number[]} origin what coordinates of the mesh count from
 * @returns {Read}
 */
export function readFile(file, origin) {
  const list = /** @type {any} */ (file)?.annotations;
  if (!Array.isArray(list)) return { annotations: [], problems: ['The file has no list “annotations”.'] };
  const problems = list.length > MOST ? [`Only the first ${MOST} of ${list.length} annotations are shown.`] : [];
  const annotations = list.slice(0, MOST).flatMap((entry, i) => {
    const read = annotation(entry, origin);
    if (typeof read !== 'string') return [read];
    problems.push(`Annotation ${i + 1} is left out: ${read}.`);
    return [];
  });
  return { annotations, problems };
}

/**
 * @param {any} entry
 * @param {number[]} origin
 * @returns {Annotation | string} or what is wrong
 */
function annotation(entry, origin) {
  const { title, text = '', point, camera = null } = entry ?? {};
  if (typeof title !== 'string' || title.trim() === '') return 'it has no “title”';
  if (title.length > MOST_TITLE) return `its “title” is longer than ${MOST_TITLE} characters`;
  if (typeof text !== 'string') return 'its “text” is no text';
  if (text.length > MOST_TEXT) return `its “text” is longer than ${MOST_TEXT} characters`;
  const at = vector(point, origin);
  if (at === null) return 'its “point” is not a list of three numbers';
  if (camera === null) return { title: title.trim(), text, point: at, camera };
  const eye = vector(camera.eye, origin);
  const target = vector(camera.target, origin);
  if (eye === null || target === null || eye.every((value, i) => value === target[i])) return 'its “camera” has no “eye” and “target” of three numbers each, at two places';
  return { title: title.trim(), text, point: at, camera: { eye, target } };
}

/** @param {unknown} value @param {number[]} origin @returns {Vector | null} */
function vector(value, origin) {
  const isVector = Array.isArray(value) && value.length === 3 && value.every((each) => typeof each === 'number' && Number.isFinite(each));
  return isVector ? /** @type {Vector} */ (value.map((each, i) => each - origin[i])) : null;
}

/**
 * As a file that can be read again.
 *
 * @param {Annotation[]} annotations
 * @param {number[]} origin
 */
export function writeFile(annotations, origin) {
  const placed = (/** @type {Vector} */ at) => at.map((value, i) => (origin[i] === 0 ? rounded(value) : origin[i] + value));
  const written = annotations.map(({ title, text, point, camera }) => ({
    title,
    text,
    point: placed(point),
    ...(camera !== null && { camera: { eye: placed(camera.eye), target: placed(camera.target) } }),
  }));
  return `${JSON.stringify({ annotations: written }, null, 2)}\n`;
}

/**
 * As a part of an address; null when it would be too long.
 *
 * @param {Annotation[]} annotations
 */
export function textOf(annotations) {
  const rows = annotations.map(({ title, text, point, camera }) => [title, text, ...point.map(rounded), ...(camera === null ? [] : [...camera.eye, ...camera.target].map(rounded))]);
  const bytes = new TextEncoder().encode(JSON.stringify(rows));
  const written = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  return written.length > MOST_LINK ? null : written;
}

/**
 * What an address says; nothing where it says anything else.
 *
 * @param {string} written
 * @returns {Annotation[]}
 */
export function annotationsOf(written) {
  try {
    const bytes = Uint8Array.from(atob(written.replaceAll('-', '+').replaceAll('_', '/')), (character) => character.charCodeAt(0));
    const rows = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
    const annotations = rows.map((/** @type {any[]} */ [title, text, ...n]) => ({ title, text, point: n.slice(0, 3), ...(n.length > 3 && { camera: { eye: n.slice(3, 6), target: n.slice(6) } }) }));
    return readFile({ annotations }, [0, 0, 0]).annotations;
  } catch {
    return [];
  }
}

/** @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(DIGITS));
}
