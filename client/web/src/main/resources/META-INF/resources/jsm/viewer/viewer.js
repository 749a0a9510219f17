// One model: figures, buttons and keys around a session and its stage. `window.jsm` is the same for scripts.

import { fetchManifest } from './manifest.js';
import * as numbers from './numbers.js';
import { Session } from './session.js';
import { Stage } from './stage.js';

const element = (id) => document.getElementById(id);
const TURN = Math.PI / 24;

/** Opens the model of a manifest or an archive; an archive's address may be relative to the page. */
export async function openViewer({ manifestUrl, archive, decoder, shading }) {
  document.body.classList.add('viewing');
  element('viewer').hidden = false;
  const session = new Session();
  const page = new Page(session);
  page.render();
  try {
    const renew = async () => (manifestUrl === undefined ? describe(archive) : fetchManifest(manifestUrl, 'reload'));
    const manifest = manifestUrl === undefined ? await renew() : await openManifest(manifestUrl, page);
    element('title').textContent = manifest.name ?? manifest.id;
    document.title = `${manifest.name ?? manifest.id} · jSM`;
    session.open(manifest, decoder, element('server-plan').checked, renew);
    session.refine();
  } catch (error) {
    window.jsm = scripting(session, null);
    session.fail(error.message);
    return;
  }
  // The worker loads the base while the stage is set up.
  const stage = makeStage(session, shading);
  if (stage === null) return;
  session.stage = stage;
  bindActions(session, stage);
  bindKeys(stage);
  window.jsm = scripting(session, stage);
}

/** A model that nobody has asked for before is encoded first, which takes a while. */
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

/** What is known of an archive without a manifest. */
function describe(archive) {
  let url;
  try {
    url = new URL(archive, document.baseURI);
  } catch {
    throw new Error(`"${archive}" is not the address of an archive. Correct it behind ?archive= in the page's address.`);
  }
  const file = url.pathname.split('/').pop().replace(/\.jsm$/, '');
  const archiveSha256 = /^[0-9a-f]{64}$/.test(file) ? file : undefined;
  try {
    return { archiveUrl: url.href, archiveSha256, name: decodeURIComponent(file) };
  } catch {
    return { archiveUrl: url.href, archiveSha256, name: file };
  }
}

function makeStage(session, shading) {
  try {
    const canvas = element('canvas');
    const stage = new Stage(canvas, true, shading);
    element('shading').value = shading;
    const panel = document.querySelector('.panel');
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
  #waitText = null;

  constructor(session) {
    this.#session = session;
    session.addEventListener('change', () => this.#schedule());
  }

  say(text) {
    this.#waitText = text;
    this.#schedule();
  }

  render() {
    this.#scheduled = false;
    const s = this.#session;
    const share = s.totalBytes > 0 ? s.bytes / s.totalBytes : 0;
    element('fill').style.width = `${100 * share}%`;
    element('track').setAttribute('aria-valuenow', Math.floor(100 * share));
    element('track').classList.toggle('busy', s.state === 'loading' || s.state === 'refining');
    element('faces').textContent = s.totalFaces > 0 ? `${numbers.count(s.faces)} of ${numbers.count(s.totalFaces)}` : '–';
    element('bytes').textContent = s.totalBytes > 0 ? `${numbers.bytes(s.bytes)} of ${numbers.bytes(s.totalBytes)}` : numbers.bytes(s.bytes);
    element('rate').textContent = numbers.rate(s.bytesPerSecond);
    element('level').textContent = s.header === null ? '–' : `${s.level} of ${Math.max(s.header.levels, s.level)}`;
    element('error').textContent = s.errorMean === null ? '–' : numbers.distance(s.errorMean);
    this.#buttons(s);
    this.#messages(s);
    element('proof').hidden = !s.identical;
    element('proof').title = s.identical ? `SHA-256 of the decoded mesh: ${s.sha256}` : '';
    const running = s.decoder === null ? '' : `Decoder: ${s.decoder === 'wasm' ? 'WebAssembly' : 'JavaScript'}`;
    const proof = s.identical ? `SHA-256 of the decoded mesh: ${s.sha256}` : null;
    const kept = s.keptBytes > 0 ? `${numbers.bytes(s.keptBytes)} of it were kept by this browser` : null;
    element('fine').textContent = [running, proof, kept, s.notice].filter((text) => text).join('. ');
    this.#announce(s);
  }

  #buttons(s) {
    const busy = s.state === 'loading' || s.state === 'refining';
    const over = s.state === 'complete' || (s.state === 'error' && !s.retryable);
    element('more').disabled = busy || over;
    element('original').disabled = busy || over;
    element('stop').hidden = !busy || s.batches === 0;
    element('more').hidden = !element('stop').hidden;
  }

  #messages(s) {
    const waiting = s.batches === 0 && s.error === null;
    element('wait').hidden = !waiting && s.status === '';
    element('wait').classList.toggle('small', s.batches > 0);
    const opening = s.bytes > 0 ? `Opening: ${numbers.bytes(s.bytes)} received` : 'Opening';
    const status = s.status === '' || s.status === 'Opening' ? opening : s.status;
    element('wait-text').textContent = (waiting && this.#waitText) || status;
    element('alert').hidden = s.error === null;
    element('alert-text').textContent = s.error ?? '';
    element('retry').hidden = !s.retryable;
    element('notice').hidden = s.renewed === null;
    element('notice').textContent = s.renewed ?? '';
  }

  /** For those who hear the page: a sentence whenever it comes to rest. */
  #announce(s) {
    if (s.state !== 'idle' && s.state !== 'complete') return;
    const shown = `${numbers.count(s.faces)} of ${numbers.faces(s.totalFaces)}, ${numbers.percent(s.bytes / s.totalBytes)} of the bytes`;
    const sentence = s.identical ? `Showing the original: ${numbers.faces(s.faces)}, identical to the original.` : `Showing ${shown}.`;
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

function bindActions(session, stage) {
  element('more').addEventListener('click', () => session.refine());
  element('original').addEventListener('click', () => session.complete());
  element('stop').addEventListener('click', () => session.stop());
  element('retry').addEventListener('click', () => session.retry());
  element('reset').addEventListener('click', () => stage.frame());
  element('shading').addEventListener('change', ({ target }) => (stage.shading = target.value));
  element('up').addEventListener('change', ({ target }) => (stage.up = target.value));
  element('wireframe').addEventListener('change', ({ target }) => (stage.wireframe = target.checked));
  element('server-plan').addEventListener('change', ({ target }) => (session.serverPlan = target.checked));
}

function bindKeys(stage) {
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

/** The page for scripts and tests. */
function scripting(session, stage) {
  const facts = ['state', 'faces', 'totalFaces', 'bytes', 'totalBytes', 'bytesPerSecond', 'identical', 'sha256', 'error', 'decoder', 'level', 'batches', 'header'];
  const more = ['errorMean', 'firstPicture', 'rounds', 'requests', 'pictures', 'texturesLoading', 'keptBytes', 'renewed'];
  const jsm = {
    refine: () => session.refine(),
    complete: () => session.complete(),
    retry: () => session.retry(),
    stop: () => session.stop(),
    snapshot: (width, height) => stage.picture('image/png', width, height),
    frame: () => stage.frame(),
    setShading: (value) => (stage.shading = value),
  };
  for (const name of [...facts, ...more]) Object.defineProperty(jsm, name, { get: () => session[name], enumerable: true });
  Object.defineProperty(jsm, 'camera', { get: () => stage.camera });
  Object.defineProperty(jsm, 'memory', { get: () => stage.memory });
  return jsm;
}
