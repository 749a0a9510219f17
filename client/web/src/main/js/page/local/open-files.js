// @ts-check
// What becomes of files that somebody drops on the page or picks: an archive is shown, a model is sent to the server or encoded here.

import { messageOf } from '../../session/errors.js';
import { Card } from './card.js';
import { archiveAmong, filesOf, modelAmong } from './dropped.js';
import { encodeHere } from './encode-here.js';
import { sendModel } from './send-model.js';
import { showArchive } from './show-archive.js';
import { takesModels } from './upload.js';

const GIVE = 'Give a .jsm archive, or a PLY, OBJ, STL, OFF, Hoppe .m, GLB, glTF or 3MF file with its materials and pictures.';

/**
 * @param {(FileSystemEntry | File | null)[]} dropped
 * @param {string} decoder
 */
export async function openFiles(dropped, decoder) {
  try {
    const given = await filesOf(dropped);
    if (given.length === 0) return;
    const archive = archiveAmong(given);
    const model = modelAmong(given);
    if (archive !== null) await showArchive(archive.file, archive.path, decoder);
    else if (model === null) new Card('This is no model').say(`${given[0].path} is no file that can be shown here. ${GIVE}`);
    else if (await takesModels(new URL('m/', document.baseURI))) sendModel(model, given, decoder);
    else await encodeHere(model, given, decoder);
  } catch (error) {
    new Card('The file could not be opened').say(`The browser cannot read it (${messageOf(error)}).`);
  }
}
