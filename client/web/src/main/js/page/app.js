// @ts-check
// Shows the gallery, or a model: the one that the page was made for (`m/ID/`), or that the address names, `?m=ID` or `?archive=URL` for an archive on any server.

import { messageOf } from '../session/errors.js';
import { element, manifestOfPage, typed } from './elements.js';

const query = new URLSearchParams(location.search);
const models = new URL('m/', document.baseURI);
const id = query.get('m');
const archive = query.get('archive');
const decoder = query.get('decoder') ?? 'auto';
/** What opens models whose addresses must be signed, if the page was opened with it. */
const signature = query.has('signature') ? `?${new URLSearchParams({ expires: query.get('expires') ?? '', signature: query.get('signature') ?? '' })}` : '';
typed('home', HTMLAnchorElement).search = query.has('decoder') ? `decoder=${decoder}` : '';

/** What the address asks for, or the page was made for; null for the gallery. */
function model() {
  if (id !== null) return { manifestUrl: new URL(`${encodeURIComponent(id)}/manifest.json${signature}`, models) };
  if (archive !== null) return { archive };
  const made = manifestOfPage();
  return made === null ? null : { manifestUrl: new URL(made.manifestUrl, document.baseURI), known: made };
}

async function open() {
  const wanted = model();
  if (wanted === null) {
    const { openGallery } = await import('./gallery.js');
    openGallery(new URL(`index.json${signature}`, models), decoder);
    const { offerFiles } = await import('./local/picker.js');
    return offerFiles(take);
  }
  const { openViewer } = await import('./viewer.js');
  return openViewer(wanted, decoder, query.get('shading'));
}

/** Opens files of this device. @param {(FileSystemEntry | File | null)[]} files */
async function take(files) {
  const { openFiles } = await import('./local/open-files.js').catch(lack);
  return openFiles(files, decoder);
}

/** @param {DragEvent} event */
function drop(event) {
  if (!event.dataTransfer?.types.includes('Files')) return;
  event.preventDefault();
  // What is dropped can be read only now.
  if (event.type === 'drop') take([...event.dataTransfer.items].map((item) => item.webkitGetAsEntry() ?? item.getAsFile()));
}

/** @param {unknown} error @returns {never} */
function lack(error) {
  element('missing-text').textContent = `Part of the page could not be loaded (${messageOf(error)}).`;
  element('missing').hidden = false;
  element('reload').addEventListener('click', () => location.reload());
  throw error;
}

addEventListener('dragover', drop);
addEventListener('drop', drop);
open().catch(lack);
