// @ts-check
// The models of the server, each with a picture of its first bytes.

import { element, messageOf } from './elements.js';
import { fetchJson } from './manifest.js';
import * as numbers from './numbers.js';
import { Thumbnails } from './thumbnails.js';

/**
 * What the list says of a model.
 *
 * @typedef {object} Model
 * @property {string} id
 * @property {string} [name]
 * @property {string} [state] `ready`, `failed`, or it is being encoded
 * @property {string} [error]
 * @property {number} [faces]
 * @property {number} [bytes]
 * @property {string} [manifestUrl]
 */

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
    /** @type {{ models: Model[] }} */
    const { models } = await fetchJson(modelsUrl);
    if (models.length === 0) note.textContent = 'There is no model here yet. Put a model or a .jsm archive into the folder that the server serves, and reload the page.';
    const thumbnails = new Thumbnails(decoder);
    for (const model of models) cards.append(card(model, modelsUrl, decoder, thumbnails));
  } catch (error) {
    note.textContent = messageOf(error);
    note.setAttribute('role', 'alert');
  }
}

/**
 * @param {Model} model
 * @param {URL} modelsUrl
 * @param {string} decoder
 * @param {Thumbnails} thumbnails
 */
function card(model, modelsUrl, decoder, thumbnails) {
  const link = document.createElement('a');
  link.href = `?m=${encodeURIComponent(model.id)}${decoder === 'auto' ? '' : `&decoder=${decoder}`}`;
  link.className = 'card';
  const picture = document.createElement('img');
  picture.alt = '';
  picture.width = 320;
  picture.height = 240;
  picture.className = 'empty';
  picture.src = new URL('icon.svg', import.meta.url).href;
  const name = document.createElement('strong');
  name.textContent = model.name ?? model.id;
  const facts = document.createElement('span');
  facts.textContent = describe(model);
  link.append(picture, name, facts);
  if (model.state !== 'failed') {
    const manifestUrl = new URL(model.manifestUrl ?? `${encodeURIComponent(model.id)}/manifest.json`, modelsUrl);
    // The server encodes a model when its manifest is asked for: those that are ready come first.
    thumbnails.show(picture, manifestUrl, model.state === 'ready').then(
      (manifest) => (facts.textContent = describe({ ...model, ...manifest, state: 'ready' })),
      (error) => (facts.textContent = messageOf(error)),
    );
  }
  const item = document.createElement('li');
  item.append(link);
  return item;
}

/** @param {Pick<Model, 'state' | 'error' | 'faces' | 'bytes'>} model */
function describe(model) {
  if (model.state === 'failed') return model.error ?? 'cannot be encoded';
  const facts = [];
  if (model.faces) facts.push(numbers.faces(model.faces));
  if (model.bytes) facts.push(numbers.bytes(model.bytes));
  if (facts.length === 0) facts.push('being encoded');
  return facts.join(' · ');
}
