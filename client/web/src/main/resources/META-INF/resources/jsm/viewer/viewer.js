// @ts-check
// One model: figures, buttons and keys around a session and its stage. `window.jsm` is the same for scripts.

import { element, messageOf, typed } from './elements.js';
import { fetchManifest } from './manifest.js';
import * as numbers from './numbers.js';
import { Session } from './session.js';
import { Stage } from './stage.js';

/** @import { Figures } from './figures.js' */
/** @import { Manifest } from './manifest.js' */
/** @import { Shading } from './shading.js' */

const TURN = Math.PI / 24;

/** @param {string} id */
const input = (id) => typed(id, HTMLInputElement);
/** @param {string} id */
const select = (id) => typed(id, HTMLSelectElement);

/**
 * What is to be shown: the model of a manifest, or an archive, whose address may be relative to the page.
 *
 * @typedef {{ manifestUrl: URL } | { archive: string }} Source
 */

/**
 * @param {Source} source
 * @param {string} decoder
 * @param {Shading} shading
 */
export async function openViewer(source, decoder, shading) {
  document.body.classList.add('viewing');
  element('viewer').hidden = false;
  const session = new Session();
  const page = new Page(session);
  page.render();
  try {
    const renew = async () => ('archive' in source ? describe(source.archive) : fetchManifest(source.manifestUrl, 'reload'));
    const manifest = 'archive' in source ? await renew() : await openManifest(source.manifestUrl, page);
    const name = manifest.name ?? manifest.id ?? '';
    element('title').textContent = name;
    document.title = `${name} · jSM`;
    session.open(manifest, decoder, input('server-plan').checked, renew);
    session.refine();
  } catch (error) {
    publish(scripting(session, null));
    session.fail(messageOf(error));
    return;
  }
  // The worker loads the base while the stage is set up.
  const stage = makeStage(session, shading);
  if (stage === null) return;
  session.stage = stage;
  bindActions(session, stage);
  bindKeys(stage);
  publish(scripting(session, stage));
}

/**
 * A model that nobody has asked for before is encoded first, which takes a while.
 *
 * @param {URL} url
 * @param {Page} page
 */
async function openManifest(url, page) {
  const timer = setTimeout(() => page.say('The server is encoding this model for its first visitor'), 1500);
  try {
    return await fetchManifest(url, 'default', (text) => {
      clearTimeout(timer);
      page.say(text);
    });
  } finally {
    clearTimeout(timer);
    page.say(null);
  }
}

/**
 * What is known of an archive without a manifest.
 *
 * @param {string} archive
 * @returns {Manifest}
 */
function describe(archive) {
  let url;
  try {
    url = new URL(archive, document.baseURI);
  } catch {
    throw new Error(`"${archive}" is not the address of an archive. Correct it behind ?archive= in the page's address.`);
  }
  const file = url.pathname.replace(/^.*\//, '').replace(/\.jsm$/, '');
  const archiveSha256 = /^[0-9a-f]{64}$/.test(file) ? file : undefined;
  try {
    return { archiveUrl: url.href, archiveSha256, name: decodeURIComponent(file) };
  } catch {
    return { archiveUrl: url.href, archiveSha256, name: file };
  }
}

/**
 * @param {Session} session
 * @param {Shading} shading
 */
function makeStage(session, shading) {
  try {
    const canvas = typed('canvas', HTMLCanvasElement);
    const stage = new Stage(canvas, true, shading);
    select('shading').value = shading;
    const panel = element('panel');
    const fit = () => {
      const inset = { top: 48, bottom: Math.max(0, canvas.clientHeight - panel.offsetTop) };
      stage.resize(canvas.clientWidth, canvas.clientHeight, Math.min(devicePixelRatio, 2), inset);
    };
    const observer = new ResizeObserver(fit);
    observer.observe(canvas);
    observer.observe(panel);
    fit();
    return stage;
  } catch {
    session.fail('This browser has no WebGL, which is needed to draw the model.');
    session.dispose();
    return null;
  }
}

/** Keeps the page's figures in step with the session. */
class Page {
  #session;
  #scheduled = false;
  #announced = '';

  /** @type {string | null} */
  #waitText = null;

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
    session.addEventListener('change', () => this.#schedule());
  }

  /** @param {string | null} text what to say instead of the session's status until there is a picture */
  say(text) {
    this.#waitText = text;
    this.#schedule();
  }

  render() {
    this.#scheduled = false;
    const { figures: f, bytesPerSecond, decoder, renewed } = this.#session;
    const share = f.totalBytes > 0 ? f.bytes / f.totalBytes : 0;
    element('fill').style.width = `${100 * share}%`;
    element('track').setAttribute('aria-valuenow', String(Math.floor(100 * share)));
    element('track').classList.toggle('busy', f.isBusy);
    element('faces').textContent = f.totalFaces > 0 ? `${numbers.count(f.faces)} of ${numbers.count(f.totalFaces)}` : '–';
    element('bytes').textContent = f.totalBytes > 0 ? `${numbers.bytes(f.bytes)} of ${numbers.bytes(f.totalBytes)}` : numbers.bytes(f.bytes);
    element('rate').textContent = numbers.rate(bytesPerSecond);
    element('level').textContent = f.header === null ? '–' : `${f.level} of ${Math.max(f.header.levels ?? 0, f.level)}`;
    element('error').textContent = f.errorMean === null ? '–' : numbers.distance(f.errorMean);
    renderButtons(f);
    this.#messages(f, renewed);
    element('proof').hidden = !f.identical;
    element('proof').title = f.identical ? `SHA-256 of the decoded mesh: ${f.sha256}` : '';
    const running = decoder === null ? '' : `Decoder: ${decoder === 'wasm' ? 'WebAssembly' : 'JavaScript'}`;
    const proof = f.identical ? `SHA-256 of the decoded mesh: ${f.sha256}` : null;
    const kept = f.keptBytes > 0 ? `${numbers.bytes(f.keptBytes)} of it were kept by this browser` : null;
    element('fine').textContent = [running, proof, kept, f.notice].filter((text) => text).join('. ');
    this.#announce(f);
  }

  /**
   * @param {Figures} f
   * @param {string | null} renewed
   */
  #messages(f, renewed) {
    const waiting = f.batches === 0 && f.error === null;
    element('wait').hidden = !waiting && f.status === '';
    element('wait').classList.toggle('small', f.batches > 0);
    const opening = f.bytes > 0 ? `Opening: ${numbers.bytes(f.bytes)} received` : 'Opening';
    const status = f.status === '' || f.status === 'Opening' ? opening : f.status;
    element('wait-text').textContent = (waiting && this.#waitText) || status;
    element('alert').hidden = f.error === null;
    element('alert-text').textContent = f.error ?? '';
    element('retry').hidden = !f.retryable;
    element('notice').hidden = renewed === null;
    element('notice').textContent = renewed ?? '';
  }

  /**
   * For those who hear the page: a sentence whenever it comes to rest.
   *
   * @param {Figures} f
   */
  #announce(f) {
    if (f.state !== 'idle' && f.state !== 'complete') return;
    const shown = `${numbers.count(f.faces)} of ${numbers.faces(f.totalFaces)}, ${numbers.percent(f.bytes / f.totalBytes)} of the bytes`;
    const sentence = f.identical ? `Showing the original: ${numbers.faces(f.faces)}, identical to the original.` : `Showing ${shown}.`;
    if (sentence === this.#announced) return;
    this.#announced = sentence;
    element('live').textContent = sentence;
  }

  #schedule() {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => this.render());
  }
}

/** @param {Figures} f */
function renderButtons(f) {
  typed('more', HTMLButtonElement).disabled = f.isBusy || f.isOver;
  typed('original', HTMLButtonElement).disabled = f.isBusy || f.isOver;
  element('stop').hidden = !f.isBusy || f.batches === 0;
  element('more').hidden = !element('stop').hidden;
}

/**
 * @param {Session} session
 * @param {Stage} stage
 */
function bindActions(session, stage) {
  element('more').addEventListener('click', () => session.refine());
  element('original').addEventListener('click', () => session.complete());
  element('stop').addEventListener('click', () => session.stop());
  element('retry').addEventListener('click', () => session.retry());
  element('reset').addEventListener('click', () => stage.frame());
  const shading = select('shading');
  shading.addEventListener('change', () => (stage.shading = /** @type {Shading} */ (shading.value)));
  const up = select('up');
  up.addEventListener('change', () => (stage.up = up.value === 'z' ? 'z' : 'y'));
  const wireframe = input('wireframe');
  wireframe.addEventListener('change', () => (stage.wireframe = wireframe.checked));
  const serverPlan = input('server-plan');
  serverPlan.addEventListener('change', () => (session.serverPlan = serverPlan.checked));
}

/** @param {Stage} stage */
function bindKeys(stage) {
  /** @type {Record<string, () => void>} */
  const actions = {
    ArrowLeft: () => stage.turn(-TURN, 0),
    ArrowRight: () => stage.turn(TURN, 0),
    ArrowUp: () => stage.turn(0, -TURN),
    ArrowDown: () => stage.turn(0, TURN),
    '+': () => stage.zoom(1 / 1.15),
    '=': () => stage.zoom(1 / 1.15),
    '-': () => stage.zoom(1.15),
    0: () => stage.frame(),
    Home: () => stage.frame(),
  };
  element('canvas').addEventListener('keydown', (event) => {
    const action = actions[event.key];
    if (action === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  });
}

/**
 * The page for scripts and tests.
 *
 * @param {Session} session
 * @param {Stage | null} stage
 */
function scripting(session, stage) {
  /** @type {(keyof Session)[]} */
  const ofSession = ['bytesPerSecond', 'decoder', 'rounds', 'pictures', 'texturesLoading', 'renewed'];
  /** @type {(keyof Figures)[]} */
  const ofArchive = ['state', 'faces', 'totalFaces', 'bytes', 'totalBytes', 'identical', 'sha256', 'error', 'level', 'batches', 'header', 'errorMean', 'firstPicture',
    'requests', 'keptBytes'];
  const jsm = {
    refine: () => session.refine(),
    complete: () => session.complete(),
    retry: () => session.retry(),
    stop: () => session.stop(),
    snapshot: (/** @type {number} */ width, /** @type {number} */ height) => stage?.picture('image/png', { width, height }),
    frame: () => stage?.frame(),
    setShading: (/** @type {Shading} */ value) => {
      if (stage !== null) stage.shading = value;
    },
  };
  for (const name of ofSession) Object.defineProperty(jsm, name, { get: () => session[name], enumerable: true });
  for (const name of ofArchive) Object.defineProperty(jsm, name, { get: () => session.figures[name], enumerable: true });
  Object.defineProperty(jsm, 'camera', { get: () => stage?.camera });
  Object.defineProperty(jsm, 'memory', { get: () => stage?.memory });
  return jsm;
}

/** @param {object} jsm */
function publish(jsm) {
  Object.assign(window, { jsm });
}
