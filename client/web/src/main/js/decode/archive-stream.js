// @ts-check
// One archive: what is kept of it, what is fetched and when that is given up, and what is told to whoever shows it.

import { DamagedArchive } from './answers.js';
import { Download } from './download.js';
import { Feeder } from './feeder.js';
import { Kept } from './kept.js';
import { inWords } from './messages.js';
import { Pictures } from './pictures.js';
import { proven } from './proof.js';
import { Succession } from './succession.js';
import { cameFromCache } from './timing.js';

/** @import { Decoder, Plan } from './decoder.js' */
/** @import { Entry, ReadOptions } from './download.js' */
/** @import { Archive, Post } from './messages.js' */

/** How often a response that nobody waits for is looked at. */
const WATCH_MILLIS = 50;

export class ArchiveStream {
  #archive;
  #post;
  #download;
  #pictures;
  #feeder;
  #succession;
  #abort = new AbortController();
  #proved = false;
  #requestEnd = 0;
  /** @type {Promise<void> | null} */
  #reading = null;
  #stopped = false;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #watch;
  #look = () => {};
  /** @type {Kept | null} */
  #kept = null;
  #isRestored = false;

  /**
   * @param {Decoder} decoder
   * @param {Archive} archive
   * @param {Post} post
   */
  constructor(decoder, archive, post) {
    this.decoder = decoder;
    this.#archive = archive;
    this.#post = post;
    this.#pictures = new Pictures(decoder, post);
    this.#feeder = new Feeder(decoder, this.#pictures, post, archive.baseBytes ?? null, () => this.#download.totalBytes);
    this.#succession = new Succession(decoder);
    this.mostFaces = archive.mostFaces ?? Infinity;
    this.serverPlan = archive.serverPlan;
    const listener = {
      begin: () => this.decoder.beginResponse(performance.now()),
      bytes: (/** @type {Uint8Array<ArrayBuffer>} */ chunk) => this.#take(chunk),
      end: (/** @type {Entry} */ entry) => this.#learn(entry),
      waiting: (/** @type {string} */ text) => this.#watch === undefined && this.#post({ type: 'waiting', text }),
    };
    this.#download = new Download(archive.archiveUrl, listener, archive.access);
    if (archive.bytes) this.#download.totalBytes = archive.bytes;
  }

  /** @param {import('./limiter.js').Limiter | null} value */
  set limiter(value) {
    this.#download.limiter = value;
  }

  get isComplete() {
    return this.decoder.isComplete;
  }

  /** @param {number} faces after which refinement stops */
  set mostFaces(faces) {
    this.#feeder.mostFaces = faces;
  }

  /** Gives up what is being read. */
  stop() {
    this.#stopped = true;
    this.#abort.abort();
  }

  /** The picture before is on the screen. */
  drawn() {
    this.#pictures.drawn();
  }

  /**
   * What can arrive within the wait; shown when it is over. The base is waited for, however long it takes. A response that the deadline overtakes goes on.
   *
   * @param {number} waitMillis
   */
  async round(waitMillis) {
    await this.#restore(Infinity);
    const { decoder } = this;
    this.#takeOver();
    decoder.beginRound(performance.now(), waitMillis);
    let look = () => {};
    /** @type {Promise<boolean>} */
    const over = new Promise((resolve) => {
      // A lost connection is waited for until bytes come or it is given up: whoever waits is told.
      look = () => {
        if (!decoder.isOver(performance.now())) return;
        if (this.#download.isInterrupted) this.#pictures.show();
        else resolve(true);
      };
    });
    this.#look = look;
    const timer = setTimeout(look, waitMillis);
    try {
      for (let ended = false; !ended && !this.#stopped && !this.#feeder.isFull; ) {
        let reading = this.#reading;
        if (reading === null) {
          const plan = decoder.nextRequest(performance.now());
          if (plan === null) break;
          this.#post({ type: 'plan', plan });
          reading = this.#read((signal) => this.#fetch(plan, signal));
        }
        ended = (await Promise.race([reading, over])) === true;
      }
    } finally {
      clearTimeout(timer);
      this.#look = () => {};
    }
    this.#leave();
    await this.#finish();
  }

  /** The first bytes and no more, for a preview. @param {number} bytes */
  async prefix(bytes) {
    await this.#restore(bytes);
    this.#takeOver();
    if (this.decoder.received < bytes) await this.#read((signal) => this.#download.read(this.decoder.received, bytes, signal));
    await this.#feeder.catchUp();
    await this.#kept?.flush();
    this.#pictures.show();
  }

  /** Everything that is left. */
  async complete() {
    await this.#restore(Infinity);
    this.#takeOver();
    await this.#reading;
    await this.#feeder.catchUp();
    const { isFull, limit } = this.#feeder;
    const end = limit === Infinity ? null : limit;
    if (!this.isComplete && !this.#stopped && !isFull) await this.#read((signal) => this.#download.read(this.decoder.received, end, signal));
    await this.#finish();
  }

  /**
   * Tells what went wrong. What came before damage is shown; what is kept of an archive that is wrong is dropped.
   *
   * @param {unknown} error
   */
  async fail(error) {
    if (error instanceof DamagedArchive) {
      this.#pictures.showBeforeDamage();
      await this.#kept?.forget();
    }
    this.#post({ type: 'error', ...inWords(error) });
  }

  /** What is on its way belongs to whoever asks now. */
  #takeOver() {
    this.#stopped = false;
    this.#succession.begin(this.decoder.bytesPerSecond(performance.now()));
    clearInterval(this.#watch);
    this.#watch = undefined;
  }

  /** @param {(signal: AbortSignal) => Promise<void>} start */
  #read(start) {
    this.#abort = new AbortController();
    const reading = start(this.#abort.signal).finally(() => {
      this.#reading = null;
      clearInterval(this.#watch);
    });
    this.#reading = reading;
    reading.catch(() => {}); // whoever waits for it is told
    return reading;
  }

  /** Nobody waits any more: what is on its way is read on for a while, as the planner says. */
  #leave() {
    if (this.#reading === null) return;
    const watch = setInterval(() => {
      const left = this.#requestEnd - this.decoder.received;
      if (this.#download.isInterrupted || !this.decoder.mayGoOn(performance.now(), left)) this.#abort.abort();
    }, WATCH_MILLIS);
    this.#watch = watch;
    this.#reading
      .then(async () => {
        if (this.#watch !== watch) return;
        await this.#finish();
        if (this.isComplete) this.#post({ type: 'complete' });
      })
      .catch(async (error) => {
        if (this.#watch === watch) await this.fail(error);
      });
  }

  /** Decodes what an earlier visit has left, once; nothing is learned from it about the network. @param {number} limit bytes */
  async #restore(limit) {
    if (this.#isRestored) return;
    this.#isRestored = true;
    this.#kept = await Kept.open(this.#archive.archiveUrl, this.#archive.archiveSha256);
    if (this.#kept === null) return;
    try {
      for await (const piece of this.#kept.pieces()) {
        await this.#feeder.feed(piece.subarray(0, limit - this.decoder.received));
        if (this.decoder.received >= limit || this.#feeder.isFull) break;
      }
    } catch (error) {
      if (!(error instanceof DamagedArchive)) throw error;
      await this.#beginAgain(this.#kept);
    }
    this.#post({ type: 'restored', bytes: this.decoder.received });
    this.#progress();
  }

  /** What was kept is no archive: it comes over the network from the start. @param {Kept} kept */
  async #beginAgain(kept) {
    await kept.forget();
    this.#kept = await Kept.open(this.#archive.archiveUrl, this.#archive.archiveSha256);
    this.decoder.open();
    this.#pictures.reset();
  }

  /** @param {Plan} plan @param {AbortSignal} signal */
  async #fetch(plan, signal) {
    await this.#feeder.catchUp(); // what the first decoder left is no cut batch
    const { header, batches, received } = this.decoder;
    this.#requestEnd = this.#clip(plan.end);
    if (this.#requestEnd <= received) throw new DamagedArchive(`it ends at byte ${received}, before its first picture`);
    /** @type {ReadOptions} Without a picture a silent server is asked again; with one, whoever waits is told. */
    const options = { endsAtStall: batches > 0 };
    const { firstUrl, firstBytes = 0 } = this.#archive;
    // The server sends whole batches, so one that was cut is first made whole.
    const boundary = header === null || batches === 0 ? 0 : header.ends[batches - 1];
    if (received === 0 && firstUrl !== undefined && firstBytes > 0) {
      this.#requestEnd = this.#clip(firstBytes);
      options.plannedUrl = firstUrl;
    } else if (this.serverPlan && received > boundary) {
      this.#requestEnd = header === null ? this.#requestEnd : header.ends[batches];
    } else if (this.serverPlan) {
      const query = `from=${plan.fromBatch}&bytesPerSecond=${plan.bytesPerSecond}&waitMillis=${plan.waitMillis}`;
      const [, path, signed] = /^([^?]*?)(?:\.jsm)?(?:\?(.*))?$/.exec(this.#archive.archiveUrl) ?? [];
      options.plannedUrl = `${path}/patches?${signed ? `${signed}&` : ''}${query}`;
    }
    return this.#download.read(received, this.#requestEnd, signal, options);
  }

  /** @param {number} end */
  #clip(end) {
    return Math.min(end, this.#download.totalBytes ?? Infinity, this.#feeder.limit);
  }

  /** @param {Uint8Array<ArrayBuffer>} chunk */
  async #take(chunk) {
    this.decoder.arrived(performance.now(), chunk.length);
    this.#succession.hear(this.decoder.bytesPerSecond(performance.now()));
    const from = this.decoder.received;
    await this.#feeder.feed(chunk);
    this.#kept?.add(from, chunk.subarray(0, this.decoder.received - from));
    if (this.#feeder.isFull) this.#abort.abort();
    this.#progress();
    this.#look();
  }

  #progress() {
    const { decoder } = this;
    this.#post({ type: 'progress', received: decoder.received, bytesPerSecond: decoder.bytesPerSecond(performance.now()), decodeMillis: this.#feeder.millis });
  }

  /** @param {Entry} entry */
  #learn(entry) {
    const cached = cameFromCache(entry.url);
    // What comes out of a cache at the pace of a link tells of that link.
    this.decoder.endResponse(cached && this.#download.limiter === null);
    this.#post({ type: 'request', request: { ...entry, cached, at: performance.now() } });
    this.#progress();
  }

  async #finish() {
    await this.#feeder.catchUp();
    this.#pictures.show();
    await this.#kept?.flush();
    if (this.#reading === null) this.#succession.rest();
    if (this.#feeder.isFull) this.#post({ type: 'full' });
    const { header } = this.decoder;
    if (header === null || !this.isComplete || this.#proved) return;
    this.#post({ type: 'proving' });
    const { meshSha256, modelSha256 } = proven(this.decoder, this.#archive);
    this.#proved = true;
    this.#post({ type: 'proved', meshSha256, modelSha256 });
  }
}
