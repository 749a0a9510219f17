// @ts-check
// Asks for what a server wants to know of a model, sends it with its companions, and opens its page.

import { messageOf } from '../../session/errors.js';
import { labelled, make } from '../tools/make.js';
import { Card } from './card.js';
import { encodeHere, isEncodedHere } from './encode-here.js';
import { encoded, idOf, send } from './upload.js';
import { zipOf } from './zip.js';

/** @import { Given } from './dropped.js' */

/**
 * @param {Given} model
 * @param {Given[]} given the model and the files around it
 * @param {string} decoder
 */
export function sendModel(model, given, decoder) {
  const card = new Card(`Send ${model.path} to this server`);
  const id = make('input');
  id.value = idOf(model.path);
  id.autocomplete = 'off';
  id.name = 'username';
  const token = make('input');
  token.type = 'password';
  token.autocomplete = 'current-password';
  const others = given.length > 1 ? ` ${given.length - 1} ${given.length === 2 ? 'file' : 'files'} beside it will be sent with it.` : '';
  card.say(`The server encodes the model and lists it for all visitors.${others} A model that was sent under the same name is replaced.`);
  card.add(labelled('Name in addresses', id), labelled('Token for sending', token));
  if (isEncodedHere(model.path)) card.addAction('Open it here only', () => encodeHere(model, given, decoder), '');
  card.addAction('Send', async () => {
    try {
      const { body, fileName } = await bodyOf(model, given);
      const how = { tell: card.tell, signal: card.signal };
      const url = new URL(`m/${encodeURIComponent(id.value.trim())}`, document.baseURI);
      const status = await send(url, body, { fileName, token: token.value.trim(), ...how });
      const page = await encoded(status, how);
      if (decoder !== 'auto') page.searchParams.set('decoder', decoder);
      location.assign(page);
    } catch (error) {
      if (!card.signal.aborted) card.fail(messageOf(error));
    }
  });
  token.focus();
}

/**
 * One file as it is, several as a ZIP archive.
 *
 * @param {Given} model
 * @param {Given[]} given
 */
async function bodyOf(model, given) {
  if (given.length === 1) return { body: model.file, fileName: model.path };
  const files = [];
  for (const { path, file } of given) files.push({ name: path, bytes: new Uint8Array(await file.arrayBuffer()) });
  return { body: zipOf(files), fileName: 'model.zip' };
}
