// @ts-check
// Shows an archive that is a file of this device. Nothing is asked of the server: the worker reads ranges of the file by an address that the browser gives it.

import { typed } from '../elements.js';
import { PARAMETER } from './style.js';

/** @import { Manifest } from '../../session/manifest.js' */
/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */

/** @type {string | null} */
let shown = null;

/**
 * @param {Blob} file
 * @param {string} name
 * @param {string} decoder
 */
export async function showArchive(file, name, decoder) {
  const url = URL.createObjectURL(file);
  /** @type {Manifest} */
  const manifest = { archiveUrl: url, name: name.replace(/^.*\//, '').replace(/\.jsm$/i, ''), bytes: file.size };
  leaveAddress(name, decoder);
  const serverPlan = typed('server-plan', HTMLInputElement);
  serverPlan.checked = false;
  serverPlan.disabled = true;
  const viewer = /** @type {JsmViewerElement} */ (document.getElementById('model'));
  const { session } = viewer;
  if (session) {
    viewer.dismissPoster();
    viewer.dispatchEvent(new CustomEvent('manifest', { detail: manifest }));
    const showing = session.show(manifest, { decoder, serverPlan: false, renew: () => Promise.reject(new Error('nobody can be asked')) });
    if (shown !== null) URL.revokeObjectURL(shown);
    await showing;
    goOn(session);
  } else {
    typed('gallery', HTMLElement).hidden = true;
    viewer.addEventListener('session', () => viewer.session !== null && goOn(viewer.session), { once: true });
    const { openViewer } = await import('../viewer.js');
    openViewer({ manifestUrl: new URL(`file:///${encodeURIComponent(name)}`), known: manifest }, decoder, null);
  }
  shown = url;
}

/** All of it is here already. @param {Session} session */
function goOn(session) {
  const look = () => {
    const { state } = session.figures;
    if (state === 'loading' || state === 'refining') return;
    session.removeEventListener('change', look);
    if (state === 'idle') session.complete();
  };
  session.addEventListener('change', look);
  look();
}

/** The way back leads to what was there before. @param {string} name @param {string} decoder */
function leaveAddress(name, decoder) {
  const address = new URL('./', document.baseURI);
  if (decoder !== 'auto') address.searchParams.set('decoder', decoder);
  address.searchParams.set(PARAMETER, name);
  if (history.state?.isLocal) {
    history.replaceState(history.state, '', address);
    return;
  }
  history.replaceState({ ...history.state, scroll: scrollY }, '');
  history.pushState({ isLocal: true }, '', address);
  addEventListener('popstate', () => {
    if (!new URLSearchParams(location.search).has(PARAMETER)) location.reload();
  });
}
