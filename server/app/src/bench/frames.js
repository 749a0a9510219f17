// @ts-check
// Runs in the page: streams one model to its end, as the viewer does, and others beside it that are not drawn, and says
// when all are there.

import { Session } from '/modules/session/session.js';
import { ModelView } from '/modules/viewer/model-view.js';

const options = new URLSearchParams(location.search);
if (options.has('undrawn')) WebGL2RenderingContext.prototype.drawElements = () => {};
const view = new ModelView(/** @type {HTMLElement} */ (document.getElementById('host')), 'smooth');
const session = new Session();
const start = performance.now();
/** Of each step: when it came, in seconds, and its faces. @type {[number, number][]} */
const pictures = [];
session.addEventListener('change', () => {
  if (session.pictures > pictures.length) pictures.push([(performance.now() - start) / 1000, session.figures.faces]);
});
session.stage = view;
const others = Array.from({ length: Number(options.get('models')) - 1 }, () => new Session());
const all = [session, ...others].map((one) => {
  one.open({ archiveUrl: new URL('model.jsm', location.href).href }, { decoder: 'auto', serverPlan: false, renew: async () => ({ archiveUrl: '' }) });
  return one.complete();
});
Promise.all(all).then(() => {
  const { faces, error, state } = session.figures;
  const millis = performance.now() - start;
  Object.assign(globalThis, { result: JSON.stringify({ faces, error, state, steps: session.pictures, pictures, millis, decoder: session.decoder }) });
});
