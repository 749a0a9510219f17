// @ts-check
// Saves the original as a model file with all that the format holds, the shape that has arrived, and the archive.

import { messageOf } from '../../session/errors.js';
import * as numbers from '../../session/numbers.js';
import { make } from './make.js';
import { nameOfModel } from './names.js';
import { save } from './save.js';

/** @import { Session } from '../../session/session.js' */
/** @import { Use } from './list.js' */
/** @import { Place } from './place.js' */
/** @import { Format } from './writers.js' */

/** @type {[Format, string][]} */
const FORMATS = [['ply', 'PLY'], ['obj', 'OBJ'], ['stl', 'STL'], ['off', 'OFF'], ['glb', 'GLB']];

/** Formats in which the original is written, by the extension and the name in an archive. */
const ORIGINALS = [['obj', 'OBJ'], ['ply', 'PLY'], ['stl', 'STL'], ['off', 'OFF'], ['m', 'Hoppe .m']];

/** @type {Use} */
export function use(_, session, place) {
  const what = make('p');
  const tell = () => {
    const { faces, totalFaces } = session.figures;
    what.textContent = faces < totalFaces ? `The shape as far as it has arrived, with ${numbers.count(faces)} of ${numbers.faces(totalFaces)}.` : 'The shape with all its faces.';
  };
  const buttons = make('div', 'formats');
  for (const [format, name] of FORMATS) {
    const button = make('button', '', name);
    button.type = 'button';
    button.addEventListener('click', () => write(format, session, place));
    buttons.append(button);
  }
  const fine = make('p', 'fine', 'Triangles with their colours, as far as they are shown.');
  place.element.append(...originals(session), what, buttons, fine, archiveOf(session));
  tell();
  session.addEventListener('change', tell);
  return () => session.removeEventListener('change', tell);
}

/** Buttons for the original. @param {Session} session */
export function originals(session) {
  const own = session.opened?.manifest.sourceFormat ?? '';
  const from = own === '' ? '' : ` It came from a file of format ${own}.`;
  const what = make('p', '', `The original with materials, pictures and all that a format holds.${from}`);
  const buttons = make('div', 'originals');
  const notes = make('p', 'fine');
  notes.setAttribute('role', 'status');
  for (const [extension, name] of ORIGINALS) {
    const button = make('button', name === own ? 'primary' : '', name.replace('Hoppe ', ''));
    button.title = name;
    button.type = 'button';
    button.addEventListener('click', async () => {
      notes.textContent = 'Writing the file …';
      try {
        const { saveOriginal } = await import('../local/original.js');
        notes.textContent = await saveOriginal(session, `${nameOfModel()}.${extension}`);
      } catch (error) {
        notes.textContent = `The file could not be written: ${messageOf(error)}`;
      }
    });
    buttons.append(button);
  }
  return [what, buttons, notes];
}

/** A link to the archive. @param {Session} session */
export function archiveOf({ opened }) {
  const link = make('a', 'archive', 'The archive (.jsm)');
  link.href = opened?.manifest.archiveUrl ?? '';
  link.download = `${nameOfModel()}.jsm`;
  return link;
}

/**
 * @param {Format} format
 * @param {Session} session
 * @param {Place} place
 */
function write(format, { arrays, figures }, place) {
  const worker = new Worker(new URL('./export-worker.js', import.meta.url), { type: 'module' });
  worker.addEventListener('error', () => place.say('The file could not be written'));
  worker.addEventListener('message', ({ data }) => {
    worker.terminate();
    const name = `${nameOfModel()}.${format}`;
    save(data, name);
    place.say(`${name} saved`);
  });
  const { positions, colours, indices, groups, vertices } = arrays;
  const corners = groups.map(({ start, count }) => indices.subarray(start, start + count));
  const faces = new Uint32Array(corners.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const some of corners) {
    faces.set(some, at);
    at += some.length;
  }
  const shape = { positions: positions.slice(0, 3 * vertices), indices: faces, colours: colours.length > 0 ? colours.slice(0, 4 * vertices) : null };
  worker.postMessage({ format, ...shape, origin: figures.header?.origin ?? [0, 0, 0] });
}
