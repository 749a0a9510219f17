// The models of the server, each with a picture of its first bytes.

import { fetchJson } from './manifest.js';
import * as numbers from './numbers.js';
import { Thumbnails } from './thumbnails.js';

export async function openGallery(modelsUrl, decoder) {
  document.getElementById('gallery').hidden = false;
  document.title = 'Models · jSM';
  const note = document.getElementById('gallery-note');
  const cards = document.getElementById('cards');
  try {
    const { models } = await fetchJson(modelsUrl);
    if (models.length === 0) note.textContent = 'There is no model here yet. Put a model or a .jsm archive into the folder that the server serves, and reload the page.';
    const thumbnails = new Thumbnails(decoder);
    for (const model of models) cards.append(card(model, modelsUrl, decoder, thumbnails));
  } catch (error) {
    note.textContent = error.message;
    note.setAttribute('role', 'alert');
  }
}

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
      (error) => (facts.textContent = error.message),
    );
  }
  const item = document.createElement('li');
  item.append(link);
  return item;
}

function describe(model) {
  if (model.state === 'failed') return model.error;
  const facts = [];
  if (model.faces) facts.push(numbers.faces(model.faces));
  if (model.bytes) facts.push(numbers.bytes(model.bytes));
  if (facts.length === 0) facts.push('being encoded');
  return facts.join(' · ');
}
