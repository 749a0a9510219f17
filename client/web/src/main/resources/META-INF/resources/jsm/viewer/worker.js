// Fetches and decodes one archive off the main thread, and posts what is to be drawn.

import { DamagedArchive, DecoderMissing, loadDecoder } from './decoder.js';
import { Download, DownloadError } from './download.js';
import { Kept } from './kept.js';

/** No picture sooner than this after the one before, nor sooner than this many times what the one before cost. */
const PICTURE_MILLIS = 120;
const PICTURE_COST = 5;
/** How often a response that nobody waits for is looked at. */
const WATCH_MILLIS = 50;
/** No longer than this without a look at messages and the deadline. */
const YIELD_MILLIS = 50;

let session = null;
let openError = null;
let queue = Promise.resolve();

addEventListener('message', ({ data }) => {
  if (data.type === 'drawn') session?.drawn();
  else if (data.type === 'serverPlan') session?.setServerPlan(data.on);
  else if (data.type === 'stop') session?.stop();
  else queue = queue.then(() => handle(data));
});

async function handle(message) {
  try {
    if (message.type === 'open') {
      await open(message);
    } else if (session === null) {
      throw openError;
    } else if (message.type === 'round') {
      await session.round(message.waitMillis);
    } else if (message.type === 'prefix') {
      await session.prefix(message.bytes);
    } else if (message.type === 'complete') {
      await session.complete();
    }
    postMessage({ type: 'done', complete: session.isComplete });
  } catch (error) {
    await report(error);
  }
}

async function report(error) {
  if (error instanceof DamagedArchive) await session?.forget();
  postMessage({ type: 'error', ...inWords(error) });
}

async function open(message) {
  session = null;
  try {
    session = new Session(await loadDecoder(message.decoder), message);
  } catch (error) {
    // Wishes that are queued already find no session: they fail for the same reason.
    openError = error;
    throw error;
  }
  postMessage({ type: 'ready', decoder: session.decoder.kind });
}

function inWords(error) {
  if (error instanceof DecoderMissing) return { message: error.message, retryable: false };
  if (error instanceof DamagedArchive) return { message: `The archive is damaged: ${error.message}.`, retryable: false };
  if (error instanceof DownloadError) return { message: error.message, retryable: error.retryable, changed: error.changed };
  return { message: `The viewer stopped: ${error.message}.`, retryable: false };
}

class Session {
  #download;
  #baseBytes;
  #expectedSha256;
  #patchesUrl;
  #serverPlan;
  #abort = new AbortController();
  #knownTextures = new Set();
  #postedBatches = 0;
  #postedAt = -Infinity;
  #pictureCost = 0;
  #drawing = false;
  #proved = false;
  #requestEnd = 0;
  #reading = null;
  #stopped = false;
  #watch = null;
  #look = () => {};
  #yieldedAt = 0;
  #archive;
  #kept = null;
  #isRestored = false;

  constructor(decoder, { archiveUrl, archiveSha256, bytes, baseBytes, meshSha256, serverPlan }) {
    this.decoder = decoder;
    this.#archive = { url: archiveUrl, sha256: archiveSha256 };
    this.#baseBytes = baseBytes ?? null;
    this.#expectedSha256 = meshSha256;
    this.#patchesUrl = archiveUrl.replace(/\.jsm(\?.*)?$/, '/patches');
    this.#serverPlan = serverPlan;
    this.#download = new Download(archiveUrl, {
      begin: () => this.decoder.beginResponse(performance.now()),
      bytes: (chunk) => this.#take(chunk),
      end: (entry) => this.#learn(entry),
      waiting: (text) => this.#watch === null && postMessage({ type: 'waiting', text }),
    });
    if (bytes) this.#download.totalBytes = bytes;
  }

  get isComplete() {
    return this.decoder.isComplete;
  }

  setServerPlan(on) {
    this.#serverPlan = on;
  }

  /** Gives up what is being read. */
  stop() {
    this.#stopped = true;
    this.#abort.abort();
  }

  /** The main thread has drawn the picture before. */
  drawn() {
    this.#drawing = false;
  }

  /**
   * What can arrive within `waitMillis`; shown when they are over. The base is waited for, however long it takes. A response that the deadline overtakes goes on; the next round begins with it.
   */
  async round(waitMillis) {
    await this.#restore(Infinity);
    const { decoder } = this;
    this.#takeOver();
    decoder.beginRound(performance.now(), waitMillis);
    let look;
    const over = new Promise((resolve) => {
      // A lost connection is waited for until bytes come or it is given up: whoever waits is told.
      look = () => {
        if (!decoder.isOver(performance.now())) return;
        if (this.#download.isInterrupted) this.#show();
        else resolve(true);
      };
    });
    this.#look = look;
    const timer = setTimeout(look, waitMillis);
    try {
      for (let ended = false; !ended && !this.#stopped; ) {
        if (this.#reading === null) {
          const plan = decoder.nextRequest(performance.now());
          if (plan === null) break;
          postMessage({ type: 'plan', plan });
          this.#read((signal) => this.#fetch(plan, signal));
        }
        ended = (await Promise.race([this.#reading, over])) === true;
      }
    } finally {
      clearTimeout(timer);
      this.#look = () => {};
    }
    this.#leave();
    await this.#finish();
  }

  /** The first bytes and no more, for a preview. */
  async prefix(bytes) {
    await this.#restore(bytes);
    this.#takeOver();
    if (this.decoder.received < bytes) await this.#read((signal) => this.#download.read(this.decoder.received, bytes, signal));
    await this.#kept?.flush();
    this.#show();
  }

  /** Everything that is left. */
  async complete() {
    await this.#restore(Infinity);
    this.#takeOver();
    await this.#reading;
    if (!this.isComplete && !this.#stopped) await this.#read((signal) => this.#download.read(this.decoder.received, null, signal));
    await this.#finish();
  }

  /** What is on its way belongs to whoever asks now. */
  #takeOver() {
    this.#stopped = false;
    clearInterval(this.#watch);
    this.#watch = null;
  }

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
        if (this.isComplete) postMessage({ type: 'complete' });
      })
      .catch((error) => this.#watch === watch && report(error));
  }

  /** Drops what is kept of the archive, because something about it is wrong. */
  async forget() {
    await this.#kept?.forget();
  }

  /** Decodes what an earlier visit has left, once; nothing is learned from it about the network. */
  async #restore(limit) {
    if (this.#isRestored) return;
    this.#isRestored = true;
    this.#kept = await Kept.open(this.#archive.url, this.#archive.sha256);
    if (this.#kept === null) return;
    try {
      for await (const piece of this.#kept.pieces()) {
        this.#feedAll(piece.subarray(0, limit - this.decoder.received));
        await this.#yield();
        if (this.decoder.received >= limit) break;
      }
    } catch (error) {
      if (!(error instanceof DamagedArchive)) throw error;
      await this.#beginAgain();
    }
    postMessage({ type: 'restored', bytes: this.decoder.received });
    this.#progress();
  }

  /** What was kept is no archive: it comes over the network from the start. */
  async #beginAgain() {
    await this.#kept.forget();
    this.#kept = await Kept.open(this.#archive.url, this.#archive.sha256);
    this.decoder.open();
    this.#knownTextures.clear();
    this.#postedBatches = 0;
  }

  async #fetch(plan, signal) {
    const { header, batches, received } = this.decoder;
    this.#requestEnd = this.#clip(plan.end);
    if (this.#requestEnd <= received) throw new DamagedArchive(`it ends at byte ${received}, before its first picture`);
    // Without a picture a silent server is asked again; with one, whoever waits is told.
    const options = { endsAtStall: batches > 0 };
    // The server sends whole batches, so one that was cut is first made whole.
    const boundary = batches === 0 ? 0 : header.ends[batches - 1];
    if (this.#serverPlan && received > boundary) {
      this.#requestEnd = header === null ? this.#requestEnd : header.ends[batches];
    } else if (this.#serverPlan) {
      const query = `from=${plan.fromBatch}&bytesPerSecond=${plan.bytesPerSecond}&waitMillis=${plan.waitMillis}`;
      options.plannedUrl = `${this.#patchesUrl}?${query}`;
    }
    return this.#download.read(received, this.#requestEnd, signal, options);
  }

  #clip(end) {
    const total = this.#download.totalBytes;
    return total === null ? end : Math.min(end, total);
  }

  async #take(chunk) {
    this.decoder.arrived(performance.now(), chunk.length);
    this.#kept?.add(this.decoder.received, chunk);
    this.#feedAll(chunk);
    this.#progress();
    this.#look();
    await this.#yield();
  }

  #feedAll(chunk) {
    for (let from = 0; from < chunk.length; ) {
      const part = chunk.subarray(from, from + this.#portion());
      this.#feed(part);
      from += part.length;
    }
  }

  async #yield() {
    // Bytes that wait to be read are read before any timer or message: give those their turn.
    if (performance.now() - this.#yieldedAt < YIELD_MILLIS) return;
    await new Promise((resolve) => setTimeout(resolve));
    this.#yieldedAt = performance.now();
  }

  /** The base is fed alone, so that the first picture waits for no more than it needs; until its size is known, a little at a time. */
  #portion() {
    const { header, batches, received } = this.decoder;
    if (batches > 0) return Infinity;
    const base = header?.ends[0] ?? this.#baseBytes;
    return base === null ? 512 : Math.max(base - received, 1);
  }

  #feed(bytes) {
    const { decoder } = this;
    const before = decoder.header;
    decoder.feed(bytes);
    const { header } = decoder;
    // The first part of the header comes with the first picture, the rest a little later.
    if (header !== null && (before === null || header.whole !== before.whole)) this.#openHeader(header);
    const wait = Math.max(PICTURE_MILLIS, PICTURE_COST * this.#pictureCost);
    const soon = this.#postedBatches === 0 || (!this.#drawing && performance.now() > this.#postedAt + wait);
    if (soon) this.#show();
  }

  #openHeader(header) {
    if (header.whole && this.#download.totalBytes !== null && this.#download.totalBytes !== header.archiveBytes) {
      throw new DamagedArchive(`its index describes ${header.archiveBytes} bytes, but the file has ${this.#download.totalBytes}`);
    }
    postMessage({ type: 'header', header });
  }

  /** Posts the mesh decoded so far unless it is already on the screen. */
  #show() {
    const { decoder } = this;
    if (decoder.batches === this.#postedBatches) return;
    const start = performance.now();
    for (const [path, bytes] of decoder.newTextures(this.#knownTextures)) {
      postMessage({ type: 'texture', path, bytes }, [bytes.buffer]);
    }
    const drawn = decoder.draw();
    const arrays = [drawn.positions, drawn.normals, drawn.uvs, drawn.colours, drawn.indices, drawn.groups];
    postMessage({ type: 'picture', batches: decoder.batches, received: decoder.received, drawn }, arrays.map((a) => a.buffer));
    this.#postedBatches = decoder.batches;
    this.#drawing = true;
    this.#postedAt = performance.now();
    this.#pictureCost = this.#postedAt - start;
  }

  #progress() {
    const { decoder } = this;
    postMessage({ type: 'progress', received: decoder.received, bytesPerSecond: decoder.bytesPerSecond(performance.now()) });
  }

  #learn(entry) {
    const timing = performance.getEntriesByName(entry.url).at(-1);
    const cached = timing !== undefined && timing.transferSize === 0 && timing.decodedBodySize > 0;
    performance.clearResourceTimings();
    this.decoder.endResponse(cached);
    postMessage({ type: 'request', request: { ...entry, cached, at: performance.now() } });
    this.#progress();
  }

  async #finish() {
    this.#show();
    await this.#kept?.flush();
    if (!this.isComplete || this.#proved) return;
    postMessage({ type: 'proving' });
    const sha256 = this.decoder.sha256();
    const expected = this.#expectedSha256 ?? this.decoder.header.meshSha256;
    this.#proved = sha256 === expected && sha256 === this.decoder.header.meshSha256;
    if (!this.#proved) throw new DamagedArchive(`its mesh has the SHA-256 ${sha256}, but the original has ${expected}`);
    postMessage({ type: 'identical', sha256 });
  }
}
