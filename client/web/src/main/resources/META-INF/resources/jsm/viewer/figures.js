// @ts-check
// What is known of one archive while it is streamed.

/** @import { Header, Plan } from './decoder.js' */
/** @import { FinishedRequest, Message } from './messages.js' */

/** @typedef {'loading' | 'refining' | 'idle' | 'complete' | 'error'} State */

/**
 * What a wish asked for and what came of it.
 *
 * @typedef {object} Round
 * @property {'round' | 'complete'} kind
 * @property {number} from bytes that were there before
 * @property {number} [to] bytes that are there after
 * @property {number} at when it began
 * @property {number} [millis] how long it took
 * @property {Plan[]} plans
 */

export class Figures {
  /** @type {State} */
  state = 'loading';
  /** What is going on, in words; empty at rest. */
  status = 'Opening';
  /** Faces that are shown. */
  faces = 0;
  totalFaces = 0;
  /** Batches that are shown. */
  batches = 0;
  bytes = 0;
  totalBytes = 0;
  /** Bytes that were kept from earlier visits. */
  keptBytes = 0;
  identical = false;
  /** @type {string | null} */
  sha256 = null;
  /** @type {string | null} */
  error = null;
  /** Whether trying again can help against the error. */
  retryable = false;
  /** @type {string | null} */
  notice = null;
  /** @type {Header | null} */
  header = null;
  /** @type {{ bytes: number, millis: number } | null} */
  firstPicture = null;
  /** @type {FinishedRequest[]} */
  requests = [];

  /**
   * Learns what the worker says of the archive.
   *
   * @param {Message} message
   */
  take(message) {
    switch (message.type) {
      case 'header':
        this.header = message.header;
        if (message.header.whole) {
          this.totalBytes = message.header.archiveBytes;
          this.totalFaces = message.header.faces ?? 0;
        }
        break;
      case 'restored':
        this.keptBytes = message.bytes;
        break;
      case 'request':
        this.requests.push(message.request);
        break;
      case 'proving':
        this.status = 'Comparing with the original';
        break;
      case 'identical':
        this.identical = true;
        this.sha256 = message.sha256;
        break;
    }
  }

  /** Level that is shown, 0 for the base, of how many. */
  get level() {
    return this.header === null || this.batches === 0 ? 0 : this.header.batchLevels[this.batches - 1];
  }

  /** In percent of the diagonal; null before the first picture. */
  get errorMean() {
    return this.header === null || this.batches === 0 ? null : this.header.errorMeans[this.batches - 1];
  }

  get isBusy() {
    return this.state === 'loading' || this.state === 'refining';
  }

  /** Whether no more will come of this archive. */
  get isOver() {
    return this.state === 'complete' || (this.state === 'error' && !this.retryable);
  }
}
