// @ts-check
// One archive: what is kept of it, what is fetched and when that is given up, and what is told to whoever shows it.

import { DamagedArchive } from './answers.js';
import { Download } from './download.js';
import { Feeder } from './feeder.js';
import { Kept } from './kept.js';
import { inWords } from './messages.js';
import { Pictures } from './pictures.js';

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
    this.serverPlan = archive.serverPlan;
    this.#download = new Download(archive.archiveUrl, {
      begin: () => this.decoder.beginResponse(performance.now()),
      bytes: (chunk) => this.#take(chunk),
      end: (entry) => this.#learn(entry),
      waiting: (text) => {
        if (this.#watch === undefined) this.#post({ type: 'waiting', text });
      },
    });
    if (archive.bytes) this.#download.totalBytes = archive.bytes;
  }

  get isComplete() {
    return this.decoder.isComplete;
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
   * What can arrive within the wait; shown when it is over. The base is waited for, however long it takes. A response that the deadline overtakes goes on; the
   * next round begins with it.
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
      for (let ended = false; !ended && !this.#stopped; ) {
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

  /**
   * The first bytes and no more, for a preview.
   *
   * @param {number} bytes
   */
  async prefix(bytes) {
    await this.#restore(bytes);
    this.#takeOver();
    if (this.decoder.received < bytes) await this.#read((signal) => this.#download.read(this.decoder.received, bytes, signal));
    await this.#kept?.flush();
    this.#pictures.show();
  }

  /** Everything that is left. */
  async complete() {
    await this.#restore(Infinity);
    this.#takeOver();
    await this.#reading;
    if (!this.isComplete && !this.#stopped) await this.#read((signal) => this.#download.read(this.decoder.received, null, signal));
    await this.#finish();
  }

  /**
   * Tells what went wrong. What is kept of an archive that is wrong is dropped.
   *
   * @param {unknown} error
   */
  async fail(error) {
    if (error instanceof DamagedArchive) await this.#kept?.forget();
    this.#post({ type: 'error', ...inWords(error) });
  }

  /** What is on its way belongs to whoever asks now. */
  #takeOver() {
    this.#stopped = false;
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

  /**
   * Decodes what an earlier visit has left, once; nothing is learned from it about the network.
   *
   * @param {number} limit bytes
   */
  async #restore(limit) {
    if (this.#isRestored) return;
    this.#isRestored = true;
    this.#kept = await this.#openKept();
    if (this.#kept === null) return;
    try {
      for await (const piece of this.#kept.pieces()) {
        this.#feeder.feed(piece.subarray(0, limit - this.decoder.received));
        await this.#feeder.yield();
        if (this.decoder.received >= limit) break;
      }
    } catch (error) {
      if (!(error instanceof DamagedArchive)) throw error;
      await this.#beginAgain(this.#kept);
    }
    this.#post({ type: 'restored', bytes: this.decoder.received });
    this.#progress();
  }

  #openKept() {
    return Kept.open(this.#archive.archiveUrl, this.#archive.archiveSha256);
  }

  /**
   * What was kept is no archive: it comes over the network from the start.
   *
   * @param {Kept} kept
   */
  async #beginAgain(kept) {
    await kept.forget();
    this.#kept = await this.#openKept();
    this.decoder.open();
    this.#pictures.reset();
  }

  /**
   * @param {Plan} plan
   * @param {AbortSignal} signal
   */
  async #fetch(plan, signal) {
    const { header, batches, received } = this.decoder;
    this.#requestEnd = this.#clip(plan.end);
    if (this.#requestEnd <= received) throw new DamagedArchive(`it ends at byte ${received}, before its first picture`);
    /** @type {ReadOptions} Without a picture a silent server is asked again; with one, whoever waits is told. */
    const options = { endsAtStall: batches > 0 };
    // The server sends whole batches, so one that was cut is first made whole.
    const boundary = header === null || batches === 0 ? 0 : header.ends[batches - 1];
    if (this.serverPlan && received > boundary) {
      this.#requestEnd = header === null ? this.#requestEnd : header.ends[batches];
    } else if (this.serverPlan) {
      const query = `from=${plan.fromBatch}&bytesPerSecond=${plan.bytesPerSecond}&waitMillis=${plan.waitMillis}`;
      options.plannedUrl = `${this.#archive.archiveUrl.replace(/\.jsm(\?.*)?$/, '/patches')}?${query}`;
    }
    return this.#download.read(received, this.#requestEnd, signal, options);
  }

  /** @param {number} end */
  #clip(end) {
    const total = this.#download.totalBytes;
    return total === null ? end : Math.min(end, total);
  }

  /** @param {Uint8Array<ArrayBuffer>} chunk */
  async #take(chunk) {
    this.decoder.arrived(performance.now(), chunk.length);
    this.#kept?.add(this.decoder.received, chunk);
    this.#feeder.feed(chunk);
    this.#progress();
    this.#look();
    await this.#feeder.yield();
  }

  #progress() {
    const { decoder } = this;
    this.#post({ type: 'progress', received: decoder.received, bytesPerSecond: decoder.bytesPerSecond(performance.now()) });
  }

  /** @param {Entry} entry */
  #learn(entry) {
    const timing = /** @type {PerformanceResourceTiming | undefined} */ (performance.getEntriesByName(entry.url).at(-1));
    const cached = timing !== undefined && timing.transferSize === 0 && timing.decodedBodySize > 0;
    performance.clearResourceTimings();
    this.decoder.endResponse(cached);
    this.#post({ type: 'request', request: { ...entry, cached, at: performance.now() } });
    this.#progress();
  }

  async #finish() {
    this.#pictures.show();
    await this.#kept?.flush();
    const { header } = this.decoder;
    if (header === null || !this.isComplete || this.#proved) return;
    this.#post({ type: 'proving' });
    const sha256 = this.decoder.sha256();
    const expected = this.#archive.meshSha256 ?? header.meshSha256;
    this.#proved = sha256 === expected && sha256 === header.meshSha256;
    if (!this.#proved) throw new DamagedArchive(`its mesh has the SHA-256 ${sha256}, but the original has ${expected}`);
    this.#post({ type: 'identical', sha256 });
  }
}
