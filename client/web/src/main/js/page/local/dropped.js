// @ts-check
// The files that somebody drops or picks, each with its path; those of folders, too.

/** @typedef {{ path: string, file: File }} Given a path has `/` between its parts */

/** More files than these are no model with its pictures. */
const MOST_FILES = 1000;

/**
 * @param {(FileSystemEntry | File | null)[]} dropped
 * @returns {Promise<Given[]>}
 */
export async function filesOf(dropped) {
  /** @type {Given[]} */
  const given = [];
  for (const one of dropped) await add(one, given);
  return withoutTop(given);
}

/**
 * @param {FileSystemEntry | File | null} one
 * @param {Given[]} given
 */
async function add(one, given) {
  if (one === null || given.length >= MOST_FILES) return;
  if (one instanceof File) {
    given.push({ path: one.webkitRelativePath || one.name, file: one });
  } else if (one.isDirectory) {
    for (const entry of await entriesOf(/** @type {FileSystemDirectoryEntry} */ (one))) await add(entry, given);
  } else {
    const file = await new Promise((resolve, reject) => /** @type {FileSystemFileEntry} */ (one).file(resolve, reject));
    given.push({ path: one.fullPath.replace(/^\//, ''), file });
  }
}

/** A reader gives some entries at a time, and none at the end. @param {FileSystemDirectoryEntry} folder @returns {Promise<FileSystemEntry[]>} */
async function entriesOf(folder) {
  const reader = folder.createReader();
  const all = [];
  for (;;) {
    /** @type {FileSystemEntry[]} */
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return all;
    all.push(...some);
  }
}

/** Paths without the folder in which all of them lie. @param {Given[]} given @returns {Given[]} */
function withoutTop(given) {
  const top = given[0]?.path.match(/^[^/]+\//)?.[0];
  if (top === undefined || !given.every(({ path }) => path.startsWith(top))) return given;
  return withoutTop(given.map(({ path, file }) => ({ path: path.slice(top.length), file })));
}

/** Formats of model files, the best first. */
const FORMATS = ['glb', 'gltf', 'obj', 'ply', '3mf', 'off', 'm', 'stl'];
const PACKED = /\.zip$|\.gz$/i;

/** @param {Given[]} given @returns {Given | null} the archive to open */
export function archiveAmong(given) {
  return given.find(({ path }) => /\.jsm$/i.test(path)) ?? null;
}

/** @param {Given[]} given @returns {Given | null} the model file; the others are its companions */
export function modelAmong(given) {
  for (const format of FORMATS) {
    const found = given.find(({ path }) => path.toLowerCase().endsWith(`.${format}`));
    if (found !== undefined) return found;
  }
  return given.find(({ path }) => PACKED.test(path)) ?? null;
}
