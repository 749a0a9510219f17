// @ts-check
// What files of a model are called.

/** Characters that no system has in the names of files. */
// eslint-disable-next-line no-control-regex
const FORBIDDEN = /[\u0000-\u001f"*/:<>?\\|]+/g;

/** The name that the page shows, fit for a file. */
export function nameOfModel() {
  return fileName(document.getElementById('title')?.textContent ?? '');
}

/** @param {string} name */
export function fileName(name) {
  const fit = name.replace(FORBIDDEN, '-').replace(/^[\s.-]+|[\s.-]+$/g, '');
  return fit === '' ? 'model' : fit;
}
