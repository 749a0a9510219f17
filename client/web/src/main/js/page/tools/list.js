// @ts-check
// The tools of the page of a model, in the order of their buttons.
//
// A tool is a small file that exports `use`. It is imported when somebody presses the button for the first time, so that
// visitors who never do so do not load it. To add one, write the file and put a line into `TOOLS`.

import { State } from './state.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Place } from './place.js' */

/**
 * Begins to work. A tool with controls puts them into `place.element`, which is empty then, and is seen until somebody
 * closes it. One without is called at each press.
 *
 * @callback Use
 * @param {JsmViewerElement} viewer
 * @param {Session} session which is the same as long as the page stands; its figures are not
 * @param {Place} place for controls and messages
 * @returns {void | (() => void) | Promise<void | (() => void)>} called when the controls are closed, where there is something to end
 */
/**
 * @typedef {object} Tool
 * @property {string} name of the button, and title of the controls
 * @property {string} icon lines of a picture of 24 units, as the data of an SVG path
 * @property {boolean} [isSwitch] the button shows whether it is on: see `place.pressed`
 * @property {boolean} [hasControls] it stays open until it is closed
 * @property {string} [part] where the address has this part, the tool shows it by itself: by what it exports as `restore`, else by opening. See state.js
 * @property {(session: Session) => boolean} [isWanted] whether a model has something that the tool shows by itself
 * @property {() => boolean} [isAvailable] false where the browser lacks what it needs
 * @property {() => Promise<{ use: Use, restore?: Use }>} load
 */

/** @type {Tool[]} */
export const TOOLS = [
  {
    name: 'Levels of detail',
    icon: 'M4 18h16M7 14h10M10 10h4M11 6h2',
    hasControls: true,
    part: 'lod',
    load: () => import('../../levels/levels.js'),
  },
  {
    name: 'Measure',
    icon: 'M3 15l12-12 6 6-12 12zM7 11l2 2M10 8l3 3M13 5l2 2',
    hasControls: true,
    part: 'measure',
    load: () => import('./measure.js'),
  },
  {
    name: 'Cut open',
    icon: 'M4 7l8-4 8 4v10l-8 4-8-4zM2 14l20-5',
    hasControls: true,
    part: 'cut',
    load: () => import('./section.js'),
  },
  {
    name: 'Annotations',
    icon: 'M4 5h16v11h-9l-4 4v-4h-3zM8 9h8M8 12h5',
    hasControls: true,
    part: 'notes',
    isWanted: ({ opened }) => opened?.manifest.annotationsUrl !== undefined,
    load: () => import('./annotations.js'),
  },
  {
    name: 'Copy a link to this view',
    icon: 'M10 14a4 4 0 0 0 6 .4l3-3a4 4 0 0 0-5.7-5.7l-1.4 1.4M14 10a4 4 0 0 0-6-.4l-3 3a4 4 0 0 0 5.7 5.7l1.4-1.4',
    load: () => import('./share.js'),
  },
  {
    name: 'Save the picture',
    icon: 'M4 8h3.5l1.5-2.5h6l1.5 2.5h3.5v11h-16zM12 10a3.2 3.2 0 1 0 .01 0',
    load: () => import('./screenshot.js'),
  },
  {
    name: 'Turn by itself',
    icon: 'M19.5 9a8 8 0 1 0 .5 4M20 4v5h-5',
    isSwitch: true,
    load: () => import('./rotate.js'),
  },
  {
    name: 'Full screen',
    icon: 'M4 9v-5h5M15 4h5v5M20 15v5h-5M9 20h-5v-5',
    isSwitch: true,
    isAvailable: () => document.fullscreenEnabled,
    load: () => import('./full-screen.js'),
  },
  {
    name: 'Download',
    icon: 'M12 4v11M7 11l5 5 5-5M4 20h16',
    hasControls: true,
    load: () => import('./downloads.js'),
  },
  {
    name: 'Open in the desktop viewer',
    icon: 'M3 4h18v12H3zM12 16v4M8 20h8',
    hasControls: true,
    // It runs on no telephone.
    isAvailable: () => !/Android|iPhone|iPad/.test(navigator.userAgent),
    load: () => import('./desktop.js'),
  },
  {
    name: 'Statistics',
    icon: 'M4 20h16M6 16v-4M11 16v-9M16 16v-6',
    hasControls: true,
    load: () => import('./statistics.js'),
  },
];

export const state = new State();
