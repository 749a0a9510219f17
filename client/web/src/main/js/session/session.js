// @ts-check
// The page's side of a streamed model: sends wishes to the worker, keeps the figures, and draws what comes back.

/** The constant time that a user waits per round. */
export const WAIT_MILLIS = 2000;
/** A host whose tags differ from one answer to the next must not be asked for ever. */
const MOST_RENEWALS = 3;

import { budgetEnd, mostFacesFor, smallerBudget, withinBudget } from './budget.js';
import { whenDrawn } from './drawn.js';
import { messageOf } from './errors.js';
import { Figures } from './figures.js';
import { isAnother } from './manifest.js';
import { Connection } from './pool.js';
import { Refinement } from './refinement.js';
import { Wishes } from './wishes.js';

/** @import { Round } from './figures.js' */
/** @import { Manifest } from './manifest.js' */
/** @import { Listener } from './pool.js' */
/** @import { Access, Message, Wish } from '../decode/messages.js' */

/** @typedef {{ decoder: string, serverPlan: boolean, access?: Access, mostFaces?: number, renew: () => Promise<Manifest> }} Options `renew` asks for the manifest as it is now; `mostFaces` is what the device is given */
/** @typedef {Pick<import('../viewer/model-view.js').ModelView, 'open' | 'update' | 'addTexture' | 'clear'> & { lacksMemory?: () => void }} Screen where pictures go; it calls `lacksMemory` */

export class Session extends EventTarget {
  #connection;
  /** What is shown, and how its host is asked. @type {({ manifest: Manifest } & Options) | null} */
  opened = null;
  #renewals = 0;
  #wishes = new Wishes();
  /** @type {Screen | null} */
  #stage = null;
  /** @type {'round' | 'complete' | null} */
  #lastWish = null;
  #wishStatus = '';
  #interrupted = false;
  #limit = 0; // bytes per second, or none
  #heldFaces = Infinity; // for which the graphics card has memory
  #connect;
  #refinement = new Refinement((arrays) => this.#stage?.update(arrays), undefined, undefined, () => this.#lackRoom());

  /** @param {(listener: Listener) => Pick<Connection, 'send' | 'close'>} connect to a worker */
  constructor(connect = (listener) => new Connection(listener)) {
    super();
    this.#connect = connect;
    this.figures = new Figures();
    this.bytesPerSecond = 0;
    this.decodeMillis = 0;
    /** @type {'wasm' | 'js' | null} */
    this.decoder = null;
    /** @type {Round[]} */
    this.rounds = [];
    this.pictures = 0;
    this.texturesLoading = 0;
    /** @type {string | null} */
    this.renewed = null;
    this.#connection = this.#reach();
  }

  #reach() {
    const broken = (/** @type {string} */ reason) => this.fail(`The viewer could not start its decoder: ${reason}.`);
    return this.#connect({ hear: (message) => this.#hear(message), broken });
  }

  /** What is to be drawn. */
  get arrays() {
    return this.#refinement.arrays;
  }

  /** @param {Screen} stage where pictures go; to be set before the task that opens the session ends */
  set stage(stage) {
    this.#stage = Object.assign(stage, { lacksMemory: () => this.#spare() });
  }

  /** Opens an archive; one that cannot be shown is only known. @param {Manifest} manifest says where it is and, where known, its bytes, faces and identity @param {Options} options */
  open(manifest, options) {
    this.opened = { ...options, manifest };
    const { decoder, serverPlan, access, mostFaces = mostFacesFor() } = options;
    this.opened.mostFaces = mostFaces;
    Object.assign(this.figures, { totalBytes: manifest.bytes ?? 0, totalFaces: manifest.faces ?? 0 });
    if (this.figures.error !== null) return this.#changed();
    const { archiveUrl, archiveSha256, firstUrl, firstBytes, bytes, baseBytes, meshSha256, modelSha256 } = manifest;
    return this.#post({ type: 'open', archiveUrl, archiveSha256, firstUrl, firstBytes, bytes, baseBytes, meshSha256, modelSha256, decoder, serverPlan, access, mostFaces });
  }

  /** One more round of T; resolves when it is over. */
  refine(waitMillis = WAIT_MILLIS) {
    return this.#wish({ type: 'round', waitMillis }, 'Refining');
  }

  /** The original; resolves when it has arrived. */
  complete() {
    return this.#wish({ type: 'complete' }, 'Loading the original');
  }

  /** Tries again what failed. */
  retry() {
    this.figures.error = null;
    return this.#lastWish === 'complete' ? this.complete() : this.refine();
  }

  /** Gives up what is being loaded; what has arrived stays. */
  stop() {
    this.#connection.send({ type: 'stop' });
  }

  /** @param {boolean} on */
  set serverPlan(on) {
    if (this.opened !== null) this.opened.serverPlan = on;
    this.#connection.send({ type: 'serverPlan', on });
  }

  /** Reads no faster from now on. @param {number} bytesPerSecond 0 for no limit */
  set limit(bytesPerSecond) {
    this.#limit = bytesPerSecond;
    this.#connection.send({ type: 'limit', bytesPerSecond });
  }

  /** Shows the model from its beginning, without what this browser has kept of it; resolves after a round. */
  async again(waitMillis = WAIT_MILLIS) {
    if (this.opened !== null) await this.show({ ...this.opened.manifest, archiveSha256: undefined }, this.opened, waitMillis);
  }

  /** Shows an archive in place of the one before; resolves after a round. @param {Manifest} manifest @param {Options} options */
  async show(manifest, options, waitMillis = WAIT_MILLIS) {
    this.renewed = null;
    const waiting = this.#begin(manifest, options);
    await this.refine(waitMillis);
    waiting();
  }

  /** @param {number | undefined} given faces that the device is given from now on; undefined for what is good for it */
  set mostFaces(given) {
    const faces = Math.min(given ?? mostFacesFor(), this.#heldFaces);
    if (this.opened !== null) this.opened.mostFaces = faces;
    Object.assign(this.figures, { isHeld: faces === this.#heldFaces, isFull: this.figures.bytes >= budgetEnd(this.figures.header, faces) });
    this.#connection.send({ type: 'mostFaces', faces });
    this.#changed();
  }

  dispose() {
    this.#connection.close();
  }

  /** @param {Extract<Wish, { type: 'round' | 'complete' }>} message @param {string} status */
  async #wish(message, status) {
    if (this.figures.isOver) return;
    this.#lastWish = message.type;
    this.figures.error = null;
    this.figures.state = this.figures.batches > 0 ? 'refining' : 'loading';
    this.#wishStatus = this.figures.batches > 0 ? status : 'Opening';
    this.figures.status = this.#wishStatus;
    this.rounds.push({ kind: message.type, from: this.figures.bytes, at: performance.now(), plans: [] });
    this.#changed();
    await this.#post(message);
    const round = this.rounds.at(-1);
    if (round !== undefined) Object.assign(round, { to: this.figures.bytes, millis: performance.now() - round.at });
  }

  /** @param {Extract<Wish, { id?: number }>} wish resolves when it is answered */
  #post(wish) {
    return this.#wishes.send(wish, (numbered) => this.#connection.send(numbered));
  }

  /** @param {Message} data */
  #hear(data) {
    const { figures } = this;
    figures.take(data);
    switch (data.type) {
      case 'ready':
        this.decoder = data.decoder;
        break;
      case 'header':
        this.arrays.expect(withinBudget(data.header, this.opened?.mostFaces ?? Infinity));
        this.#await(this.#stage?.open(data.header), (reason) => `The materials could not be loaded (${reason}). Reload the page.`);
        break;
      case 'plan':
        this.rounds.at(-1)?.plans.push(data.plan);
        break;
      case 'progress':
        if (this.#interrupted && data.received > figures.bytes) {
          this.#interrupted = false;
          figures.status = this.#wishStatus;
        }
        figures.bytes = data.received;
        this.bytesPerSecond = data.bytesPerSecond;
        this.decodeMillis = data.decodeMillis;
        break;
      case 'texture':
        this.#await(this.#stage?.addTexture(data.paths, data.bytes), () => `The texture ${data.paths[0]} is not an image that this browser can show.`);
        break;
      case 'picture':
        this.#draw(data);
        break;
      case 'waiting':
        this.#interrupted = true;
        figures.status = data.text;
        break;
      case 'done':
        this.#done(data);
        break;
      case 'error':
        if (data.changed) this.#renew(data.message, data.changed === 'gone');
        else this.fail(data.message, data.retryable);
        break;
    }
    this.#changed();
  }

  /** @param {Extract<Message, { type: 'picture' }>} message */
  #draw({ changes }) {
    this.pictures++;
    const connection = this.#connection; // another archive has another one
    this.#refinement.take(changes, () => whenDrawn(() => connection.send({ type: 'drawn', used: changes.data }, [changes.data.buffer])));
  }

  /** Something that the picture still lacks. @param {Promise<void> | undefined} work @param {(reason: string) => string} noticeOf */
  async #await(work, noticeOf) {
    this.texturesLoading++;
    try {
      await work;
    } catch (error) {
      this.figures.notice = noticeOf(messageOf(error));
      this.#changed();
    }
    this.texturesLoading--;
  }

  /** @param {Extract<Message, { type: 'done' }>} answer */
  async #done({ id, complete }) {
    const answered = this.#wishes.answered(id);
    if (answered === undefined) return;
    const { wish, resolve } = answered;
    const { figures } = this; // another model may come meanwhile
    if (!this.#refinement.isResting) await this.#refinement.settled();
    if (wish !== 'open') {
      if (complete || figures.state === 'complete') figures.state = 'complete';
      else if (figures.batches > 0) figures.state = 'idle';
      else this.fail('Loading ended before there was anything to show.', true);
      figures.status = '';
      this.#interrupted = false;
    }
    resolve();
    this.#changed();
  }

  /** The archive is another one by now, or gone: shows the new one from the start, if there is one. @param {string} message @param {boolean} isGone */
  async #renew(message, isGone) {
    if (this.opened === null) return;
    const { manifest, ...options } = this.opened;
    const now = this.#renewals++ < MOST_RENEWALS ? await options.renew().catch(() => null) : null;
    if (now === null || !isAnother(now, manifest, isGone)) return this.fail(message);
    this.renewed = 'The model was changed on the server while it was loading. This is the new one, from its beginning.';
    const waiting = this.#begin(now, options);
    await (this.#lastWish === 'complete' ? this.complete() : this.refine());
    return waiting();
  }

  /** Opens an archive in place of the one before; gives what resolves the wishes that nobody answers any more. @param {Manifest} manifest @param {Options} options */
  #begin(manifest, options) {
    const waiting = this.#wishes.clear();
    this.#connection.close();
    this.figures = new Figures();
    this.#interrupted = false;
    this.#connection = this.#reach();
    if (this.#limit > 0) this.limit = this.#limit;
    this.#stage?.clear();
    this.#refinement = this.#refinement.another();
    this.open(manifest, options);
    return waiting;
  }

  /** The graphics card has no memory for what was to come. */
  #spare() {
    const { header, faces } = this.figures;
    const most = smallerBudget(header, this.opened?.mostFaces ?? Infinity, faces);
    if (header === null || most === null) return this.#lackRoom();
    this.arrays.fit(withinBudget(header, most));
    this.mostFaces = this.#heldFaces = most;
    return this.#stage?.update(this.arrays);
  }

  #lackRoom() {
    this.stop();
    this.fail('This browser has no memory for more of the model. What is shown stays. Close other pages, or open it with a smaller limit of faces.');
  }

  /** Ends what is going on. @param {string} message the reason @param {boolean} [retryable] whether trying again may help */
  fail(message, retryable = false) {
    Object.assign(this.figures, { state: 'error', status: '', error: message, retryable, proved: false });
    this.#interrupted = false;
    this.#changed();
    this.#wishes.clear()();
  }

  #changed() {
    this.dispatchEvent(new Event('change'));
  }
}
