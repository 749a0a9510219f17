// @ts-check
// How much of a model a device is given, unless somebody says otherwise.

/** @import { Header } from './header.js' */

const FACES_PER_GIGABYTE = 1e6;
/** Browsers tell no more than this, however much there is. */
const MOST_GIGABYTES = 8;

/**
 * The faces that a device has room for: a face takes about 300 bytes in worker, page and graphics card together.
 *
 * @param {number | undefined} gigabytes of memory, where the browser tells
 * @returns {number} infinite where it does not, and where there is plenty
 */
export function mostFacesFor(gigabytes = /** @type {{ deviceMemory?: number }} */ (globalThis.navigator ?? {}).deviceMemory) {
  return gigabytes !== undefined && gigabytes < MOST_GIGABYTES ? gigabytes * FACES_PER_GIGABYTE : Infinity;
}

/**
 * The next smaller budget, for a device that has no memory for the one it was given.
 *
 * @param {Header | null} header
 * @param {number} mostFaces
 * @param {number} shown faces, fewer than which are no use
 * @returns {number | null} null when there is none
 */
export function smallerBudget(header, mostFaces, shown) {
  const faces = header === null ? null : withinBudget(header, mostFaces).faces;
  return faces !== null && faces > shown ? Math.max(shown, Math.floor(faces / 2)) : null;
}

/**
 * Where the last batch ends that is within a budget. The base always is.
 *
 * @param {Pick<Header, 'whole' | 'ends' | 'batchFaces'> | null} header
 * @param {number} mostFaces
 * @returns {number} byte behind the batch; infinite when all are, or the batches are not known yet
 */
export function budgetEnd(header, mostFaces) {
  if (header === null || !header.whole) return Infinity;
  const over = header.batchFaces.findIndex((faces) => faces > mostFaces);
  return over < 0 ? Infinity : header.ends[Math.max(over - 1, 0)];
}

/**
 * The totals of what is to come within a budget: nobody makes room for the rest.
 *
 * @param {Header} header
 * @param {number} mostFaces
 * @returns {Header}
 */
export function withinBudget(header, mostFaces) {
  const { faces, wedges, ends, batchFaces } = header;
  const end = budgetEnd(header, mostFaces);
  if (end === Infinity || faces === null || wedges === null) return header;
  const within = batchFaces[ends.indexOf(end)];
  return { ...header, faces: within, wedges: Math.ceil((wedges * within) / faces) };
}
