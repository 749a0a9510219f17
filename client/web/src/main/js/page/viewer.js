// @ts-check
// One model: its element, and figures, buttons and messages around it. `window.jsm` is the same for scripts.

import { whenDrawn } from '../session/drawn.js';
import { messageOf } from '../session/errors.js';
import { absolute, fetchManifest } from '../session/manifest.js';
import { SHADINGS } from '../session/shading.js';
import { bindUp } from '../session/up.js';
import { JsmViewerElement } from '../viewer/jsm-viewer.js';
import { archiveAt } from '../viewer/source.js';
import { element, typed } from './elements.js';
import { bindMenu } from './menu.js';
import { Panel } from './panel.js';
import { scripting } from './scripting.js';

/** @import { Manifest } from '../session/manifest.js' */
/** @import { Session } from '../session/session.js' */
/** @import { Source } from '../viewer/source.js' */

/** How long a server may take for a manifest before it is said that it encodes. */
const ENCODING_MILLIS = 1500;
/** Pixels that the bar covers. */
const BAR = 48;

/**
 * What is to be shown: the model of a manifest, or an archive, whose address may be relative to the page.
 *
 * @typedef {{ manifestUrl: URL, known?: Manifest } | { archive: string }} Wanted `known` is the manifest that the page has in it
 */

/**
 * @param {Wanted} wanted
 * @param {string} decoder
 * @param {string | null} wantedShading as the address names it
 */
export function openViewer(wanted, decoder, wantedShading) {
  const shading = SHADINGS.find((name) => name === wantedShading) ?? 'smooth';
  document.body.classList.add('viewing');
  element('viewer').hidden = false;
  const viewer = typed('model', JsmViewerElement);
  viewer.setAttribute('decoder', decoder);
  viewer.setAttribute('shading', shading);
  const poster = document.getElementById('poster');
  // The page has the picture in it: nobody need ask for it again.
  if (poster instanceof HTMLImageElement) viewer.setAttribute('poster', poster.src);
  typed('shading', HTMLSelectElement).value = shading;
  fit(viewer);
  viewer.addEventListener('session', () => {
    const { session, view } = viewer;
    if (session === null) return;
    const panel = new Panel(session, view, () => (session.figures.error === null ? location.reload() : viewer.retry()));
    panel.render();
    viewer.addEventListener('waiting', (event) => panel.say(/** @type {CustomEvent} */ (event).detail.text));
    viewer.addEventListener('trouble', (event) => panel.trouble('the model is drawn plainly', /** @type {CustomEvent} */ (event).detail.message));
    Object.assign(window, { jsm: scripting(session, view) });
    if (view === null) {
      viewer.addEventListener('manifest', () => bringDownloads(session, panel));
      return;
    }
    bringTools(viewer, session, panel);
    bindUp(typed('up', HTMLSelectElement), view.orbit.upright, 'archive' in wanted ? wanted.archive : wanted.manifestUrl.href);
  });
  viewer.addEventListener('manifest', (event) => {
    const { name, id } = /** @type {CustomEvent} */ (event).detail;
    const title = name ?? id ?? '';
    element('title').textContent = title;
    element('title').title = title;
    document.title = `${title} · jSM`;
  });
  viewer.addEventListener('poster-dismissed', () => document.getElementById('poster')?.remove());
  bindActions(viewer);
  bindMenu(typed('options', HTMLDetailsElement));
  viewer.source = 'archive' in wanted ? archive(wanted.archive) : served(wanted, viewer);
}

/**
 * The tools come when the first picture is on the screen; before it where the address says what they are to show.
 *
 * @param {JsmViewerElement} viewer
 * @param {Session} session
 * @param {Panel} panel
 */
function bringTools(viewer, session, panel) {
  const bring = async () => {
    try {
      const { openTools } = await import('./tools/tools.js');
      openTools(viewer, session);
    } catch (error) {
      panel.trouble('its tools are missing', messageOf(error));
    }
  };
  if (location.hash.length > 1) bring();
  else viewer.addEventListener('load', () => whenDrawn(bring), { once: true });
}

/**
 * Whoever sees no picture may still take the model.
 *
 * @param {Session} session
 * @param {Panel} panel
 */
async function bringDownloads(session, panel) {
  try {
    const { offer } = await import('./tools/unseen.js');
    offer(session, element('panel'));
  } catch (error) {
    panel.trouble('its downloads are missing', messageOf(error));
  }
}

/** @param {JsmViewerElement} viewer whose picture goes on beneath bar and panel */
function fit(viewer) {
  const panel = element('panel');
  const observer = new ResizeObserver(() => (viewer.inset = { top: BAR, bottom: Math.max(0, viewer.clientHeight - panel.offsetTop) }));
  observer.observe(viewer);
  observer.observe(panel);
}

/**
 * @param {string} address
 * @returns {Source}
 */
function archive(address) {
  try {
    return archiveAt(new URL(address, document.baseURI));
  } catch {
    const wrong = new Error(`"${address}" is not the address of an archive. Correct it behind ?archive= in the page's address.`);
    return { manifest: () => Promise.reject(wrong), renew: () => Promise.reject(wrong) };
  }
}

/**
 * A model that nobody has asked for before is encoded first, which takes a while.
 *
 * @param {{ manifestUrl: URL, known?: Manifest }} wanted
 * @param {JsmViewerElement} viewer
 * @returns {Source}
 */
function served({ manifestUrl: url, known }, viewer) {
  const say = (/** @type {string | null} */ text) => viewer.dispatchEvent(new CustomEvent('waiting', { detail: { text } }));
  const manifest = async () => {
    // That of a model without an archive says its name alone.
    if (known?.archiveUrl !== undefined) return absolute(known, url);
    const timer = setTimeout(() => say('The server is encoding this model for its first visitor'), ENCODING_MILLIS);
    try {
      return await fetchManifest(url, 'default', (text) => {
        clearTimeout(timer);
        say(text);
      });
    } finally {
      clearTimeout(timer);
      say(null);
    }
  };
  return { manifest, renew: () => fetchManifest(url, 'reload') };
}

/** @param {JsmViewerElement} viewer */
function bindActions(viewer) {
  element('more').addEventListener('click', () => viewer.refine());
  element('original').addEventListener('click', () => {
    if (viewer.session?.figures.isFull) viewer.setAttribute('max-faces', 'none');
    viewer.complete();
  });
  element('stop').addEventListener('click', () => viewer.stop());
  element('reset').addEventListener('click', () => viewer.frame());
  const shading = typed('shading', HTMLSelectElement);
  shading.addEventListener('change', () => viewer.setAttribute('shading', shading.value));
  const wireframe = typed('wireframe', HTMLInputElement);
  wireframe.addEventListener('change', () => viewer.toggleAttribute('wireframe', wireframe.checked));
  const serverPlan = typed('server-plan', HTMLInputElement);
  // A browser may have kept the tick of a visit before.
  viewer.toggleAttribute('server-plan', serverPlan.checked);
  serverPlan.addEventListener('change', () => {
    viewer.toggleAttribute('server-plan', serverPlan.checked);
    if (viewer.session !== null) viewer.session.serverPlan = serverPlan.checked;
  });
}
