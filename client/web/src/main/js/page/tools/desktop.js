// @ts-check
// Ways to open the model in the desktop viewer, with what each of them needs.

import * as numbers from '../../session/numbers.js';
import { manifestOfPage } from '../elements.js';
import { copy } from './copy.js';
import { addressOf, jarIn, launchUrl, lines, systemOf } from './desktop-ways.js';
import { dressing, make } from './make.js';

/** @import { Session } from '../../session/session.js' */
/** @import { JsmViewerElement } from '../../viewer/jsm-viewer.js' */
/** @import { Jar, System } from './desktop-ways.js' */
/** @import { Place } from './place.js' */

const dress = dressing(`
.tool .ways { display: grid; gap: 14px; }
.tool .ways section { display: grid; gap: 6px; }
.tool .ways h3 { margin: 0; font-size: .88rem; font-weight: 600; }
.tool .ways a { color: var(--accent); text-decoration: underline; }
.tool .ways pre { margin: 0; padding: 8px; overflow: auto; border: 1px solid var(--edge); border-radius: 8px; font-size: .76rem; }
`);

/** Programs that start what a server describes. @type {Record<System, string>} */
const STARTERS = {
  Linux: 'icedtea-netx with Java 17, or OpenWebStart',
  Windows: 'OpenWebStart',
  macOS: 'OpenWebStart',
  other: 'OpenWebStart',
};

/** What makes a system know the links. @type {Record<System, string>} */
const HANDLERS = {
  Linux: 'a viewer that was started once with --register',
  Windows: 'a viewer that was started once with --register',
  macOS: 'the viewer as an application, which its build makes',
  other: 'a viewer that was started once with --register',
};

/** @param {JsmViewerElement} _ @param {Session} session @param {Place} place */
export async function use(_, session, place) {
  dress();
  const archiveUrl = session.opened?.manifest.archiveUrl ?? '';
  const address = addressOf(archiveUrl, location.search, document.baseURI, manifestOfPage()?.manifestUrl);
  if (address === null) {
    const why = archiveUrl === '' ? 'No model is open yet.' : 'This model is on your device alone. Give the viewer its file: java -jar jsm-viewer.jar FILE';
    place.element.append(make('p', '', why));
    return;
  }
  const ways = make('div', 'ways');
  place.element.append(make('p', '', 'A window of its own, drawn with OpenGL. It needs Java 17 or newer.'), ways);
  const { platform } = /** @type {{ userAgentData?: { platform: string } } & Navigator} */ (navigator).userAgentData ?? navigator;
  const system = systemOf(platform);
  const launch = launchUrl(address);
  const jar = launch === null ? null : await ask(launch, address);
  if (launch !== null && jar !== null) ways.append(way('Start it', link('Start the viewer', launch), `Needs ${STARTERS[system]}, which opens the small file that your browser saves.`));
  ways.append(way('By a link', link('Open the jsm: link', `jsm:${address}`), `Needs ${HANDLERS[system]}.`), terminal(system, address, jar, place));
}

/** Whether the server has the viewer, and where. @param {string} launch @param {string} address */
async function ask(launch, address) {
  try {
    const response = await fetch(launch);
    const isLaunch = response.ok && (response.headers.get('Content-Type') ?? '').includes('jnlp');
    return isLaunch ? jarIn(await response.text(), address) : null;
  } catch {
    return null;
  }
}

/**
 * @param {string} name
 * @param {HTMLElement} control
 * @param {string} needs
 */
function way(name, control, needs) {
  const section = make('section');
  section.append(make('h3', '', name), control, make('p', 'fine', needs));
  return section;
}

/** @param {string} text @param {string} href */
function link(text, href) {
  const made = make('a', '', text);
  made.href = href;
  return made;
}

/**
 * @param {System} system
 * @param {string} address
 * @param {Jar | null} jar
 * @param {Place} place
 */
function terminal(system, address, jar, place) {
  const text = lines(system, address, jar);
  const field = make('pre', '', text);
  // Whoever has no mouse can scroll it.
  field.tabIndex = 0;
  const button = make('button', '', 'Copy');
  button.type = 'button';
  button.setAttribute('aria-label', 'Copy the lines for a terminal');
  button.addEventListener('click', async () => place.say((await copy(text)) ? 'Lines copied' : 'Select the lines and copy them'));
  const made = way('In a terminal', field, jar === null ? 'Needs jsm-viewer.jar, which this server does not have.' : '');
  const fine = made.querySelector('.fine');
  if (jar !== null) fine?.append('Downloads ', link('jsm-viewer.jar', jar.url), ` (${numbers.bytes(jar.bytes)}).`);
  fine?.before(button);
  return made;
}
