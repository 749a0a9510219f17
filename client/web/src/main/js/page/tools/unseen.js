// @ts-check
// What a browser that draws nothing may still do with a model.

import { archiveOf, originals } from './downloads.js';
import { make } from './make.js';
import { dress } from './style.js';

/** @import { Session } from '../../session/session.js' */

/**
 * @param {Session} session
 * @param {HTMLElement} panel before which it is put
 */
export function offer(session, panel) {
  dress();
  const card = make('section', 'tool');
  card.style.setProperty('--columns', '0');
  const title = make('h2', '', 'Download');
  title.id = 'unseen-title';
  card.setAttribute('aria-labelledby', title.id);
  const head = make('header');
  head.append(title);
  const controls = make('div', 'controls');
  controls.append(...originals(session), archiveOf(session));
  card.append(head, controls);
  panel.before(card);
}
