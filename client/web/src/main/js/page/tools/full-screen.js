// @ts-check
// Gives the page the whole screen, and back.

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Place } from './place.js' */

let isHeard = false;

/** @param {JsmViewerElement} _viewer @param {Session} _session @param {Place} place */
export async function use(_viewer, _session, place) {
  if (!isHeard) {
    // Escape ends it, too.
    document.addEventListener('fullscreenchange', () => (place.pressed = document.fullscreenElement !== null));
    isHeard = true;
  }
  if (document.fullscreenElement === null) await document.documentElement.requestFullscreen();
  else await document.exitFullscreen();
}
