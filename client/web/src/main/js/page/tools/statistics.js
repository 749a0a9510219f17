// @ts-check
// Figures and a chart of how a model is loaded, with what changes that: the wait of a round, and a slower link.

import { Chart } from './chart.js';
import { rows } from './facts.js';
import { labelled, make } from './make.js';
import { Record } from './record.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Use } from './list.js' */

const SAMPLE_MILLIS = 200;
const LONGEST_WAIT = 10;
/** Names by bytes per second. @type {[number, string][]} */
const LIMITS = [[0, 'No limit'], [8_000, '64 kbit/s'], [32_000, '256 kbit/s'], [125_000, '1 Mbit/s'], [1_250_000, '10 Mbit/s']];

const record = new Record();
let limit = 0;
let isRecording = false;

/** @type {Use} */
export function use(viewer, session, place) {
  startRecording(session);
  const chart = new Chart();
  const words = make('p', 'fine');
  const table = make('dl', 'facts');
  place.element.append(chart.element, words, waitOf(viewer), limitOf(session), againOf(viewer, session), table);
  const show = () => {
    const { figures } = session;
    words.textContent = chart.draw(record.points(session.rounds, figures.keptBytes), figures.header, figures.totalFaces);
    fill(table, rows(session, memoryOf(viewer, session)));
  };
  show();
  const timer = setInterval(show, SAMPLE_MILLIS);
  return () => clearInterval(timer);
}

/** Goes on when the controls are closed, so that the chart has no gaps. @param {Session} session */
function startRecording(session) {
  if (isRecording) return;
  isRecording = true;
  const sample = () => record.sample(session.rounds, session.figures.bytes, performance.now());
  session.addEventListener('change', sample);
}

/** @param {JsmViewerElement} viewer */
function waitOf(viewer) {
  const slider = make('input');
  Object.assign(slider, { type: 'range', min: '1', max: String(LONGEST_WAIT), step: '1', value: String(viewer.waitMillis / 1000) });
  const label = labelled('', slider);
  const show = () => {
    /** @type {HTMLElement} */ (label.firstElementChild).textContent = `Wait: ${slider.value} s`;
    slider.setAttribute('aria-valuetext', `${slider.value} seconds`);
  };
  slider.addEventListener('input', () => {
    viewer.setAttribute('wait-seconds', slider.value);
    show();
  });
  show();
  return label;
}

/** @param {Session} session */
function limitOf(session) {
  const choice = make('select');
  for (const [rate, name] of LIMITS) choice.append(new Option(name, String(rate), false, rate === limit));
  choice.addEventListener('change', () => {
    limit = Number(choice.value);
    session.limit = limit;
  });
  return labelled('Bandwidth', choice);
}

/** @param {JsmViewerElement} viewer @param {Session} session */
function againOf(viewer, session) {
  const again = make('button', '', 'Load it once more');
  again.type = 'button';
  again.addEventListener('click', () => {
    keepCamera(viewer);
    session.again(viewer.waitMillis);
  });
  return again;
}

/** The model is seen from the same place when it comes once more. @param {JsmViewerElement} viewer */
function keepCamera(viewer) {
  const orbit = viewer.view?.orbit;
  if (!orbit?.isTouched) return;
  const { pose } = orbit;
  const back = () => {
    orbit.moveTo(pose);
    orbit.jump();
  };
  viewer.addEventListener('load', back, { once: true });
}

/**
 * Bytes of the arrays that are there to be drawn: buffers have the same.
 *
 * @param {JsmViewerElement} viewer
 * @param {Session} session
 */
function memoryOf({ view }, { arrays }) {
  const { positions, normals, tangents, colours, uvs, indices, starts } = arrays;
  const bytes = [positions, normals, tangents, colours, indices, starts, ...uvs].reduce((sum, { byteLength }) => sum + byteLength, 0);
  return { bytes, textures: view?.memory.textures ?? 0 };
}

/** @param {HTMLElement} table @param {[string, string][]} facts */
function fill(table, facts) {
  const made = facts.map(([name, value]) => {
    const row = make('div');
    row.append(make('dt', '', name), make('dd', '', value));
    return row;
  });
  table.replaceChildren(...made);
}
