// @ts-check
// Fetches and decodes one archive off the main thread: takes wishes one after the other, and posts what comes of them.

import { ArchiveStream } from './archive-stream.js';
import { loadDecoder } from './decoder.js';
import { inWords } from './messages.js';

/** @import { Message, Opening, Wish } from './messages.js' */

/** @type {ArchiveStream | null} */
let stream = null;
/** @type {unknown} */
let openError = null;
let queue = Promise.resolve();

addEventListener('message', (/** @type {MessageEvent<Wish>} */ { data }) => {
  if (data.type === 'drawn') {
    stream?.drawn();
  } else if (data.type === 'serverPlan') {
    if (stream !== null) stream.serverPlan = data.on;
  } else if (data.type === 'stop') {
    stream?.stop();
  } else {
    queue = queue.then(() => handle(data));
  }
});

/** @param {Wish} wish */
async function handle(wish) {
  try {
    const opened = wish.type === 'open' ? await open(wish) : stream;
    if (opened === null) throw openError;
    if (wish.type === 'round') await opened.round(wish.waitMillis);
    else if (wish.type === 'prefix') await opened.prefix(wish.bytes);
    else if (wish.type === 'complete') await opened.complete();
    post({ type: 'done', complete: opened.isComplete });
  } catch (error) {
    if (stream === null) post({ type: 'error', ...inWords(error) });
    else await stream.fail(error);
  }
}

/** @param {Opening} opening */
async function open(opening) {
  stream = null;
  try {
    stream = new ArchiveStream(await loadDecoder(opening.decoder), opening, post);
  } catch (error) {
    // Wishes that are queued already find no stream: they fail for the same reason.
    openError = error;
    throw error;
  }
  post({ type: 'ready', decoder: stream.decoder.kind });
  return stream;
}

/**
 * @param {Message} message
 * @param {ArrayBuffer[]} [transfer]
 */
function post(message, transfer = []) {
  postMessage(message, { transfer });
}
