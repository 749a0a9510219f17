// @ts-check
// The tools around a model. They come after the first picture; what each of them does comes when it is used.

import { element } from '../elements.js';
import { Fold } from './fold.js';
import { state, TOOLS } from './list.js';
import { dress } from './style.js';
import { Toolbar } from './toolbar.js';
import { addView } from './view.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */

/**
 * Makes the buttons of the tools, and shows what the address says of the view.
 *
 * @param {JsmViewerElement} viewer
 * @param {Session} session
 */
export function openTools(viewer, session) {
  dress();
  const toolbar = new Toolbar(viewer, session);
  const tools = TOOLS.filter((tool) => tool.isAvailable?.() !== false).map((tool) => ({ ...tool, open: toolbar.add(tool) }));
  toolbar.attach(element('panel'));
  const fold = new Fold(element('panel'));
  session.addEventListener('change', () => fold.follow(session));
  fold.follow(session);
  addView(state, viewer, session);
  const read = () => {
    state.read(location.hash);
    for (const { part, isWanted, open } of tools) if ((part !== undefined && state.isWanted(part)) || isWanted?.(session)) open();
  };
  addEventListener('hashchange', read);
  if (viewer.loaded) read();
  else viewer.addEventListener('load', read, { once: true });
}
