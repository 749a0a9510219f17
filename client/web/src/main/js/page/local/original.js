// @ts-check
// Saves the original of an archive as a model file: one file as it is, several as a ZIP archive.

import { save } from '../tools/save.js';
import { workshop } from './workshop.js';
import { zipOf } from './zip.js';

/** @import { Session } from '../../session/session.js' */

/**
 * What is not here yet is fetched. Resolves to what the file does not hold, in words.
 *
 * @param {Session} session
 * @param {string} fileName whose extension tells the format
 */
export async function saveOriginal({ opened, figures }, fileName) {
  if (opened === null) return 'There is no model yet.';
  const { archiveUrl, archiveSha256 } = opened.manifest;
  const { files, notes } = await workshop({ place: { archiveUrl, archiveSha256, access: opened.access }, bytes: figures.header?.archiveBytes ?? figures.totalBytes, fileName });
  const name = files.length === 1 ? fileName : `${fileName.replace(/\.[^.]*$/, '')}.zip`;
  save(files.length === 1 ? new Blob([files[0].bytes]) : zipOf(files), name);
  return [`${name} saved.`, ...notes].join(' ');
}
