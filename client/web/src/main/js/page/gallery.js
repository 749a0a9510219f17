// @ts-check
// The models of the server, each with its poster; where an archive has none, with a picture of its first bytes.

import { messageOf } from '../session/errors.js';
import { fetchJson } from '../session/manifest.js';
import { element } from './elements.js';
import { allModels } from './catalogue.js';
import { describe } from './card-words.js';
import { showPoster, Thumbnails } from './thumbnails.js';

/** @import { Model } from './card-words.js' */

/** From so many models on, they can be searched and sorted. */
const FEW = 8;
/** More are not loaded before somebody looks for them, where the list has an index. */
const MANY = 2000;

/**
 * @param {URL} modelsUrl
 * @param {string} decoder
 */
export async function openGallery(modelsUrl, decoder) {
  element('gallery').hidden = false;
  document.title = 'Models · jSM';
  const note = element('gallery-note');
  const cards = element('cards');
  try {
    const lead = note.textContent;
    /** @type {import('./catalogue.js').CataloguePage} */
    const first = await fetchJson(modelsUrl);
    const isLong = first.pages !== undefined && (first.total ?? 0) > MANY;
    const models = isLong ? first.models : await allModels(first, modelsUrl, (count, total) => (note.textContent = `${count} of ${total} models …`));
    note.textContent = lead;
    if (models.length === 0) note.textContent = 'There is no model here yet. Put a model or a .jsm archive into the folder that the server serves, and reload the page.';
    const thumbnails = new Thumbnails(decoder);
    const make = (/** @type {Model} */ model) => card(model, modelsUrl, decoder, thumbnails);
    const drop = (/** @type {HTMLLIElement} */ item) => item.querySelectorAll('img').forEach((picture) => thumbnails.forget(picture));
    if (isLong) {
      const { browsePages } = await import('./browse/browse-pages.js');
      await browsePages(first, modelsUrl, cards, { make, drop });
      return keepPlace();
    }
    // Whoever has few models sees them all. Without the search they are listed as they come.
    const controls = models.length < FEW ? null : await import('./browse/browse.js').catch(() => null);
    if (controls === null) cards.append(...models.map(make));
    else controls.browse(models, cards, { make, drop });
    keepPlace();
  } catch (error) {
    note.textContent = messageOf(error);
    note.setAttribute('role', 'alert');
  }
}

/** Whoever comes back is where he or she was: cards come too late for the browser to see to that. */
function keepPlace() {
  history.scrollRestoration = 'manual';
  scrollTo(0, history.state?.scroll ?? 0);
  addEventListener('pagehide', () => history.replaceState({ ...history.state, scroll: scrollY }, ''));
}

/**
 * @param {Model} model
 * @param {URL} modelsUrl
 * @param {string} decoder
 * @param {Thumbnails} thumbnails
 */
function card(model, modelsUrl, decoder, thumbnails) {
  const link = document.createElement('a');
  const at = new URL(`${encodeURIComponent(model.id)}/`, modelsUrl);
  // A list under a signed address gives each model one.
  at.search = new URL(model.manifestUrl ?? 'manifest.json', modelsUrl).search;
  if (decoder !== 'auto') at.searchParams.set('decoder', decoder);
  link.href = at.href;
  link.className = 'card';
  const picture = document.createElement('img');
  picture.alt = '';
  picture.width = 320;
  picture.height = 240;
  picture.className = 'empty';
  picture.src = new URL('./icon.svg', import.meta.url).href;
  const name = document.createElement('strong');
  name.textContent = model.name ?? model.id;
  const facts = document.createElement('span');
  facts.textContent = describe(model);
  link.append(picture, name, facts);
  if (model.posterUrl !== undefined) {
    showPoster(picture, new URL(model.posterUrl, modelsUrl));
  } else if (model.state !== 'failed') {
    const manifestUrl = new URL(model.manifestUrl ?? `${encodeURIComponent(model.id)}/manifest.json`, modelsUrl);
    // The server encodes a model when its manifest is asked for: those that are ready come first.
    const asked = () => (facts.textContent = describe(model.state === 'ready' ? model : { ...model, state: 'preparing' }));
    thumbnails.show({ picture, manifestUrl, first: model.state === 'ready', asked }).then(
      // The next card of this model need not ask.
      ({ faces, bytes, posterUrl }) => (facts.textContent = describe(Object.assign(model, { faces, bytes, ...(posterUrl && { posterUrl }), state: 'ready' }))),
      (error) => (facts.textContent = describe(Object.assign(model, { state: 'failed', error: messageOf(error) }))),
    );
  }
  const item = document.createElement('li');
  item.append(link);
  return item;
}
