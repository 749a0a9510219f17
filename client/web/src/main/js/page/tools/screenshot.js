// @ts-check
// Saves the picture as a PNG on a transparent background.

import { save } from './save.js';
import { nameOfModel } from './names.js';

/** @import { Use } from './list.js' */

/** @type {Use} */
export function use(viewer, _, place) {
  const name = `${nameOfModel()}.png`;
  // A strict policy allows no fetch() of data.
  const data = atob(viewer.toDataURL('image/png').replace(/^.*,/, ''));
  save(new Blob([Uint8Array.from(data, (byte) => byte.charCodeAt(0))], { type: 'image/png' }), name);
  place.say(`${name} saved`);
}
