// @ts-check
// The workers that decode. Models share them: each gets a connection to the worker that has the fewest.

import { linkTo } from './link.js';

/** @import { Message, Wish } from '../decode/messages.js' */
/** @typedef {{ hear: (message: Message) => void, broken: (reason: string) => void }} Listener */
/** @typedef {{ worker: Worker, up: Promise<unknown>, connections: Set<Connection> }} Member `up` resolves when the worker runs */

/** More workers than these would take memory and bandwidth from each other. */
const MOST_WORKERS = 4;

/** @type {Member[]} */
const members = [];
/** Scripts that import a worker from another host. @type {Map<string, string>} */
const imports = new Map();
/** Where the worker is, if it was said. @type {URL | null} */
let address = null;

/** @param {URL} url where the worker is, for connections from now on */
export function setWorkerUrl(url) {
  address = url;
}

/** A way to a worker and back. */
export class Connection {
  #member;
  #port;
  #broken;

  /** @param {Listener} listener `broken` hears that the worker could not be loaded */
  constructor({ hear, broken }) {
    const { port1, port2 } = new MessageChannel();
    this.#port = port1;
    this.#broken = broken;
    port1.onmessage = ({ data }) => hear(data);
    this.#member = join(this);
    this.#member.worker.postMessage(null, [port2]);
  }

  /** @param {Wish} wish @param {Transferable[]} [transfer] what the page no longer has after that */
  send(wish, transfer = []) {
    this.#whenUp(() => this.#port.postMessage(wish.type === 'open' ? { ...wish, link: linkTo(wish.archiveUrl) } : wish, transfer));
  }

  /** What the worker's own file tells of the link is known when it runs. @param {() => void} then */
  #whenUp(then) {
    this.#member.up.then(then);
  }

  /** Nothing is heard any more. A worker without connections ends. */
  close() {
    this.#port.onmessage = null;
    this.send({ type: 'close' });
    this.#whenUp(() => this.#port.close());
    const { worker, connections } = this.#member;
    connections.delete(this);
    if (connections.size > 0) return;
    worker.terminate();
    forget(this.#member);
  }

  /** @param {string} reason */
  fail(reason) {
    this.#broken(reason);
  }
}

/** Loads worker and decoders ahead; resolves also when that is not possible. */
export async function prepareWorker() {
  /** @type {Connection | null} */
  let connection = null;
  await new Promise((resolve) => {
    connection = new Connection({ hear: resolve, broken: resolve });
    connection.send({ type: 'prepare' });
  });
  /** @type {Connection | null} */ (connection)?.close();
}

/**
 * @param {Connection} connection
 * @returns {Member}
 */
function join(connection) {
  const [idlest] = [...members].sort((a, b) => a.connections.size - b.connections.size);
  const most = Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency - 1));
  const member = idlest === undefined || (idlest.connections.size > 0 && members.length < most) ? start() : idlest;
  member.connections.add(connection);
  return member;
}

/** Bundlers find a worker by this form alone. */
function startWorker() {
  if (address !== null) return workerOf(address);
  const { origin } = new URL(import.meta.url);
  if (origin !== location.origin) return workerOf(new URL('../decode/worker.js', import.meta.url));
  return new Worker(new URL('../decode/worker.js', import.meta.url), { type: 'module' });
}

/**
 * A browser starts no worker from another host; but one of the page itself may import it.
 *
 * @param {URL} url
 */
function workerOf(url) {
  if (url.origin === location.origin) return new Worker(url, { type: 'module' });
  const own = imports.get(url.href) ?? URL.createObjectURL(new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' }));
  imports.set(url.href, own);
  return new Worker(own, { type: 'module' });
}

function start() {
  const worker = startWorker();
  /** @type {Member} */
  const member = { worker, up: new Promise((resolve) => worker.addEventListener('message', resolve, { once: true })), connections: new Set() };
  worker.addEventListener('error', (event) => {
    forget(member);
    for (const connection of member.connections) connection.fail(event.message || 'the worker did not load');
  });
  members.push(member);
  return member;
}

/** @param {Member} member that takes no more connections */
function forget(member) {
  const at = members.indexOf(member);
  if (at >= 0) members.splice(at, 1);
}
