// @ts-check
// Measures distances between points that somebody clicks on the model. What was measured stays on the picture when the
// controls are closed.

import { Clicks } from '../marks/clicks.js';
import { measurements } from '../marks/measurements.js';
import { make } from './make.js';

/** @import { Vector } from '../../viewer/vectors.js' */
/** @import { Use } from './list.js' */

const FIRST = 'Click two points of the model. With the keyboard: turn the picture until a point is in its middle, and press Enter.';
const SECOND = 'Now the second point. Escape takes the first one back.';

/** @type {Use} */
export function use(viewer, session, place) {
  const { view } = viewer;
  if (view === null) return undefined;
  const all = measurements(viewer, view, session, place);
  const clicks = new Clicks(viewer, view, session);
  const hint = make('p', '', FIRST);
  const list = make('ol', 'measured');
  const clear = make('button', '', 'Remove all');
  clear.type = 'button';
  place.element.append(hint, clicks.button, list, clear);

  const tell = () => {
    hint.textContent = all.isPending ? SECOND : FIRST;
    list.replaceChildren(...all.lengths.map((length, i) => row(length, () => all.remove(i))));
    clear.hidden = all.lengths.length === 0;
  };
  const take = (/** @type {Event} */ event) => {
    const point = /** @type {CustomEvent<Vector | null>} */ (event).detail;
    if (point === null) place.say('There is nothing of the model at this place');
    else all.take(point);
  };
  const escape = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    if (all.isPending) all.giveUp();
    else place.close();
  };
  clicks.addEventListener('point', take);
  clear.addEventListener('click', () => all.clear());
  all.addEventListener('change', tell);
  document.addEventListener('keydown', escape, { capture: true });
  tell();
  return () => {
    document.removeEventListener('keydown', escape, { capture: true });
    all.removeEventListener('change', tell);
    all.giveUp();
    clicks.end();
  };
}

/** Shows what the address says, without controls. @type {Use} */
export function restore(viewer, session, place) {
  if (viewer.view !== null) measurements(viewer, viewer.view, session, place);
}

/** @param {string} length @param {() => void} remove */
function row(length, remove) {
  const item = make('li');
  const button = make('button', '', 'Remove');
  button.type = 'button';
  button.setAttribute('aria-label', `Remove ${length}`);
  button.addEventListener('click', remove);
  item.append(make('span', '', length), button);
  return item;
}
