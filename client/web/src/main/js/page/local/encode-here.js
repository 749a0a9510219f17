// @ts-check
// Encodes a model in the browser and shows it: nothing leaves the device.

import { messageOf } from '../../session/errors.js';
import { Card } from './card.js';
import { showArchive } from './show-archive.js';
import { workshop } from './workshop.js';

/** @import { Given } from './dropped.js' */

/** What a browser encodes in about a minute. */
const MOST_FACES = 200_000;

/** Whether a model file is of a format that the browser encodes. @param {string} path */
export function isEncodedHere(path) {
  return /\.(obj|ply|stl|off|m)$/i.test(path);
}

/**
 * @param {Given} model
 * @param {Given[]} given the model and the files around it
 * @param {string} decoder
 */
export async function encodeHere(model, given, decoder) {
  const card = new Card(`Open ${model.path}`);
  if (!isEncodedHere(model.path)) {
    card.say(`A browser encodes OBJ, PLY, STL, OFF and Hoppe .m files alone, and this server takes no models. Encode ${model.path} with jsm encode, and drop the .jsm file here.`);
    return;
  }
  card.say('This browser encodes the model. No file leaves your device.');
  card.tell('Loading what encodes', null);
  try {
    const { files } = await workshop({ model: model.path, given, mostFaces: MOST_FACES }, card.signal, ({ stage, fraction }) => card.tell(`Encoding: ${stage}`, fraction));
    card.close();
    await showArchive(new Blob([files[0].bytes]), `${model.path.replace(/\.[^.]*$/, '')}.jsm`, decoder);
  } catch (error) {
    if (card.signal.aborted) return;
    card.say('The model could not be opened.');
    card.fail(messageOf(error));
  }
}
