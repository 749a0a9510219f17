// The page's side of a streamed model: sends wishes to the worker, keeps the figures, and draws what comes back.

/** The constant time that a user waits per round. */
export const WAIT_MILLIS = 2000;
/** A host whose tags differ from one answer to the next must not be asked for ever. */
const MOST_RENEWALS = 3;

export class Session extends EventTarget {
  #worker;
  #opened = null;
  #renewals = 0;
  #pending = [];
  #stage = null;
  #lastWish = null;
  #wishStatus = '';
  #interrupted = false;

  constructor() {
    super();
    this.bytesPerSecond = 0;
    this.decoder = null;
    this.rounds = [];
    this.pictures = 0;
    this.texturesLoading = 0;
    this.renewed = null;
    this.#begin();
  }

  /** Nothing of an archive is here yet. */
  #begin() {
    this.state = 'loading';
    this.faces = 0;
    this.totalFaces = 0;
    this.bytes = 0;
    this.keptBytes = 0;
    this.totalBytes = 0;
    this.batches = 0;
    this.identical = false;
    this.sha256 = null;
    this.error = null;
    this.retryable = false;
    this.status = 'Opening';
    this.header = null;
    this.firstPicture = null;
    this.requests = [];
    this.notice = null;
    this.#interrupted = false;
    this.#worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
    this.#worker.addEventListener('message', ({ data }) => this.#hear(data));
    this.#worker.addEventListener('error', (event) => this.#fail(`The viewer could not start its decoder: ${event.message || 'the worker did not load'}.`, false));
  }

  /** Where pictures go; to be set before the task that opens the session ends. */
  set stage(stage) {
    this.#stage = stage;
  }

  /**
   * Opens an archive.
   *
   * @param manifest says where it is and, where known, its bytes, faces and identity
   * @param renew asks for the manifest as it is now
   */
  open(manifest, decoder, serverPlan, renew) {
    this.#opened = { manifest, decoder, serverPlan, renew };
    this.totalBytes = manifest.bytes ?? 0;
    this.totalFaces = manifest.faces ?? 0;
    const { archiveUrl, archiveSha256, bytes, baseBytes, meshSha256 } = manifest;
    return this.#post({ type: 'open', archiveUrl, archiveSha256, bytes, baseBytes, meshSha256, decoder, serverPlan });
  }

  /** One more round of T seconds; resolves when it is over. */
  refine() {
    return this.#wish({ type: 'round', waitMillis: WAIT_MILLIS }, 'Refining');
  }

  /** The original; resolves when it has arrived. */
  complete() {
    return this.#wish({ type: 'complete' }, 'Loading the original');
  }

  /** Tries again what failed. */
  retry() {
    this.error = null;
    return this.#lastWish === 'complete' ? this.complete() : this.refine();
  }

  /** Gives up what is being loaded; what has arrived stays. */
  stop() {
    this.#worker.postMessage({ type: 'stop' });
  }

  set serverPlan(on) {
    if (this.#opened !== null) this.#opened.serverPlan = on;
    this.#worker.postMessage({ type: 'serverPlan', on });
  }

  /** Level that is shown, 0 for the base, of how many. */
  get level() {
    return this.header === null || this.batches === 0 ? 0 : this.header.batchLevels[this.batches - 1];
  }

  get errorMean() {
    return this.header === null || this.batches === 0 ? null : this.header.errorMeans[this.batches - 1];
  }

  /** The model cannot be opened at all. */
  fail(message) {
    this.#fail(message, false);
  }

  dispose() {
    this.#worker.terminate();
  }

  async #wish(message, status) {
    if (this.state === 'complete' || (this.state === 'error' && !this.retryable)) return;
    this.#lastWish = message.type;
    this.error = null;
    if (this.batches > 0) this.state = 'refining';
    else this.state = 'loading';
    this.#wishStatus = this.batches > 0 ? status : 'Opening';
    this.status = this.#wishStatus;
    this.rounds.push({ kind: message.type, from: this.bytes, at: performance.now(), plans: [] });
    this.#changed();
    await this.#post(message);
    Object.assign(this.rounds.at(-1), { to: this.bytes, millis: performance.now() - this.rounds.at(-1).at });
  }

  #post(message) {
    return new Promise((resolve) => {
      this.#pending.push({ wish: message.type, resolve });
      this.#worker.postMessage(message);
    });
  }

  #hear(data) {
    switch (data.type) {
      case 'ready':
        this.decoder = data.decoder;
        break;
      case 'header':
        this.header = data.header;
        if (data.header.whole) {
          this.totalBytes = data.header.archiveBytes;
          this.totalFaces = data.header.faces;
        }
        this.#stage.open(data.header);
        break;
      case 'plan':
        this.rounds.at(-1)?.plans.push(data.plan);
        break;
      case 'progress':
        if (this.#interrupted && data.received > this.bytes) {
          this.#interrupted = false;
          this.status = this.#wishStatus;
        }
        this.bytes = data.received;
        this.bytesPerSecond = data.bytesPerSecond;
        break;
      case 'texture':
        this.#addTexture(data.path, data.bytes);
        break;
      case 'picture':
        this.#draw(data);
        break;
      case 'request':
        this.requests.push(data.request);
        break;
      case 'waiting':
        this.#interrupted = true;
        this.status = data.text;
        break;
      case 'proving':
        this.status = 'Comparing with the original';
        break;
      case 'identical':
        this.identical = true;
        this.sha256 = data.sha256;
        break;
      case 'done':
        this.#done(data.complete);
        break;
      case 'restored':
        this.keptBytes = data.bytes;
        break;
      case 'complete':
        if (this.state === 'idle') this.state = 'complete';
        this.status = '';
        break;
      case 'error':
        if (data.changed) this.#renew(data.message, data.changed === 'gone');
        else this.#fail(data.message, data.retryable);
        break;
    }
    this.#changed();
  }

  #draw({ batches, received, drawn }) {
    this.batches = batches;
    this.faces = drawn.indices.length / 3;
    this.pictures++;
    if (this.state === 'loading') this.state = 'refining';
    if (this.firstPicture === null) this.firstPicture = { bytes: received, millis: performance.now() };
    this.#stage.update(drawn);
    this.#worker.postMessage({ type: 'drawn' });
  }

  async #addTexture(path, bytes) {
    this.texturesLoading++;
    try {
      await this.#stage.addTexture(path, bytes);
    } catch {
      this.notice = `The texture ${path} is not an image that this browser can show.`;
      this.#changed();
    }
    this.texturesLoading--;
  }

  #done(complete) {
    if (this.#pending.length === 0) return;
    const { wish, resolve } = this.#pending.shift();
    if (wish !== 'open') {
      if (complete) this.state = 'complete';
      else if (this.batches > 0) this.state = 'idle';
      else this.#fail('Loading ended before there was anything to show.', true);
      this.status = '';
      this.#interrupted = false;
    }
    resolve();
  }

  /** The archive is another one by now, or gone: shows the new one from the start, if there is one. */
  async #renew(message, isGone) {
    const { manifest, decoder, serverPlan, renew } = this.#opened;
    let now = null;
    if (this.#renewals++ < MOST_RENEWALS) now = await renew().catch(() => null);
    const isNew = now !== null && (now.archiveSha256 === undefined ? !isGone : now.archiveSha256 !== manifest.archiveSha256);
    if (!isNew) {
      this.#fail(message, false);
      return;
    }
    const waiting = this.#pending.splice(0);
    this.#worker.terminate();
    this.#begin();
    this.#stage?.clear();
    this.renewed = 'The model was changed on the server while it was loading. This is the new one, from its beginning.';
    this.open(now, decoder, serverPlan, renew);
    await (this.#lastWish === 'complete' ? this.complete() : this.refine());
    waiting.forEach(({ resolve }) => resolve());
  }

  #fail(message, retryable) {
    this.state = 'error';
    this.status = '';
    this.#interrupted = false;
    this.error = message;
    this.retryable = retryable;
    this.identical = false;
    this.#changed();
    this.#pending.splice(0).forEach(({ resolve }) => resolve());
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}
