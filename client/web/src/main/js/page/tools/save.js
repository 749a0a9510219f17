// @ts-check
// Gives a file to whoever sees the page.

import { make } from './make.js';

/** Browsers have taken it by then. */
const TAKEN_MILLIS = 60_000;

/**
 * @param {Blob} file
 * @param {string} name
 */
export function save(file, name) {
  const url = URL.createObjectURL(file);
  const link = make('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), TAKEN_MILLIS);
}
