// @ts-check
// Decodes levels of one archive that were shown before, off the main thread and beside what is streamed.

import { loadDecoder } from '../decode/load-decoder.js';
import { ArchiveBytes } from './archive-bytes.js';
import { LevelDecoder } from './level-decoder.js';
import { Service } from './service.js';
import { Snapshots } from './snapshots.js';

/** @import { Place } from './archive-bytes.js' */
/** @import { Wish } from './service.js' */
/** @typedef {{ place: Place, decoder: string }} Opening `decoder` as `loadDecoder` takes it */

/** @type {Service | null} */
let service = null;

addEventListener('message', (/** @type {MessageEvent<Opening | Wish>} */ { data }) => {
  if ('place' in data) {
    const decoder = loadDecoder(data.decoder).then((loaded) => new LevelDecoder(loaded, new ArchiveBytes(data.place), new Snapshots()));
    service = new Service(decoder, (answer, transfer) => postMessage(answer, { transfer }));
  } else {
    service?.hear(data);
  }
});
