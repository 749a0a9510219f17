// @ts-check
// What is known of one archive while it is streamed.

/** @import { Plan } from '../decode/decoder.js' */
/** @import { Header } from './header.js' */
/** @import { FinishedRequest, Message } from '../decode/messages.js' */

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
  /** Whether all of the archive is there, and mesh and pictures are those that were encoded. */
  proved = false;
  /** Whether no more is loaded because the device is to be spared. */
  isFull = false;
  /** Whether more cannot be drawn, as the graphics card has no memory for it. */
  isHeld = false;
  /** @type {string | null} */
  sha256 = null;
  /** Of mesh and pictures. @type {string | null} */
  modelSha256 = null;
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
      case 'full':
        this.isFull = true;
        break;
      case 'picture':
        this.batches = message.batches;
        this.faces = message.changes.faces;
        if (this.state === 'loading') this.state = 'refining';
        this.firstPicture ??= { bytes: message.received, millis: performance.now() };
        break;
      case 'complete':
        if (this.state !== 'error') this.state = 'complete';
        this.status = '';
        break;
      case 'proving':
        this.status = 'Comparing with the original';
        break;
      case 'proved':
        this.proved = true;
        this.sha256 = message.meshSha256;
        this.modelSha256 = message.modelSha256;
        break;
    }
  }

  /** Level that is shown, 0 for the base and until the archive's index is known, of how many. */
  get level() {
    return this.header?.batchLevels[this.batches - 1] ?? 0;
  }

  /** In percent of the diagonal; null before the first picture, and until the archive's index is known. */
  get errorMean() {
    return this.header?.errorMeans[this.batches - 1] ?? null;
  }

  /** Distance to the original that 99.9% of the surface does not exceed, in the same unit; likewise null. */
  get errorQuantile() {
    return this.header?.errorQuantiles[this.batches - 1] ?? null;
  }

  /** Whether what is shown is the file that was published, as far as that is seen. */
  get identical() {
    return this.proved && this.header?.words?.warning === false;
  }

  get isBusy() {
    return this.state === 'loading' || this.state === 'refining';
  }

  /** Whether no more will come of this archive. */
  get isOver() {
    return this.state === 'complete' || (this.state === 'error' && !this.retryable);
  }
}
