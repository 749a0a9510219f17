// @ts-check
// Copies a link that shows the same view.

import { copy } from './copy.js';
import { state } from './list.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Place } from './place.js' */

/** @param {JsmViewerElement} viewer @param {Session} _ @param {Place} place */
export async function use(viewer, _, place) {
  if (history.state?.isLocal) {
    place.say('This file is on your device alone: no link leads to it');
    return;
  }
  const link = linkTo(location.href, viewer.view?.orbit.upright.axis, state.write());
  history.replaceState(history.state, '', link);
  if (await copy(link)) place.say('Link copied');
  else place.say('Copy the link from the address of the page');
}

/**
 * The address of the page with a view in it.
 *
 * @param {string} address
 * @param {string | undefined} axis that points up: visitors may have chosen another one
 * @param {string} view
 */
export function linkTo(address, axis, view) {
  const url = new URL(address);
  url.searchParams.delete('shading');
  if (axis !== undefined) url.searchParams.set('up', axis);
  url.hash = view;
  return url.href;
}
