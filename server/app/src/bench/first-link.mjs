// @ts-check
// A link of a given rate and round trip, as a proxy for TCP. It keeps what went over it: a record for each request of HTTP/1.1.

import net from 'node:net';

/** What one packet carries. */
const PACKET = 1448;
/** Bytes of a connection that may wait for the link: 200 ms, or ten packets where that is less. */
const queueOf = (kbps) => Math.max(10 * PACKET, kbps * 25);

/** Milliseconds since 1970, in fractions; pages have the same clock. */
export const now = () => performance.timeOrigin + performance.now();

/** @typedef {{ path: string, begin: number, end: number, bytes: number, chunks: { at: number, bytes: number }[] }} Exchange a request and its answer with headers; `at` and `end` are when bytes came */

/** Calls one after the other, each at its time. */
class Delayed {
  /** The first one has a timer. */
  #calls = [];

  push(at, call) {
    this.#calls.push({ at: Math.max(at, this.#calls.at(-1)?.at ?? 0), call });
    if (this.#calls.length === 1) this.#wait();
  }

  #wait() {
    setTimeout(() => {
      while (this.#calls.length > 0 && this.#calls[0].at <= now()) this.#calls.shift().call();
      if (this.#calls.length > 0) this.#wait();
    }, Math.max(0, this.#calls[0].at - now()));
  }
}

/** One rate for what comes down over all connections, which take turns packet by packet. */
class Downlink {
  #bytesPerMilli;
  #delay;
  #arriving = new Delayed();
  /** Connections with something to send. @type {Set<{ packets: { bytes: Buffer, at: number }[], deliver: (bytes: Buffer) => void }>} */
  #senders = new Set();
  #freeAt = 0;
  #timer = null;

  constructor(kbps, delay) {
    this.#bytesPerMilli = kbps / 8;
    this.#delay = delay;
  }

  /** @param {{ packets: { bytes: Buffer, at: number }[], deliver: (bytes: Buffer) => void }} sender has packets now */
  wake(sender) {
    this.#senders.add(sender);
    if (this.#timer === null) this.#go();
  }

  #go() {
    this.#timer = null;
    for (let [sender] = this.#senders; sender !== undefined; [sender] = this.#senders) {
      if (this.#freeAt > now()) {
        this.#timer = setTimeout(() => this.#go(), this.#freeAt - now());
        return;
      }
      this.#senders.delete(sender);
      const packet = sender.packets.shift();
      if (packet === undefined) continue;
      this.#freeAt = Math.max(this.#freeAt, packet.at) + packet.bytes.length / this.#bytesPerMilli;
      this.#arriving.push(this.#freeAt + this.#delay, () => sender.deliver(packet.bytes));
      if (sender.packets.length > 0) this.#senders.add(sender);
    }
  }
}

export class Link {
  /** @type {Exchange[]} */
  exchanges = [];
  #roundTrip;
  #queue;
  #downlink;
  #upstream;
  #server = net.createServer({ allowHalfOpen: true, noDelay: true }, (client) => this.#connect(client));
  /** @type {Set<net.Socket>} */
  #sockets = new Set();

  /** @param {number} kbps @param {number} roundTrip in milliseconds @param {number} upstream port of the server */
  constructor(kbps, roundTrip, upstream) {
    this.#roundTrip = roundTrip;
    this.#queue = queueOf(kbps);
    this.#downlink = new Downlink(kbps, roundTrip / 2);
    this.#upstream = upstream;
  }

  /** @returns {Promise<number>} its port */
  listen() {
    return new Promise((resolve) => {
      this.#server.listen(0, '127.0.0.1', () => resolve(/** @type {net.AddressInfo} */ (this.#server.address()).port));
    });
  }

  close() {
    this.#server.close();
    for (const socket of this.#sockets) socket.destroy();
  }

  /** @param {net.Socket} client */
  #connect(client) {
    const server = net.connect({ port: this.#upstream, host: '127.0.0.1', noDelay: true, allowHalfOpen: true });
    const up = new Delayed();
    const openAt = now() + this.#roundTrip;
    /** @type {Exchange | null} */
    let exchange = null;
    const sender = {
      packets: [],
      waiting: 0,
      ended: false,
      deliver: (bytes) => {
        sender.waiting -= bytes.length;
        if (sender.waiting < this.#queue) server.resume();
        if (client.destroyed) return;
        client.write(bytes);
        if (exchange !== null) {
          exchange.end = now();
          exchange.bytes += bytes.length;
          exchange.chunks.push({ at: exchange.end, bytes: bytes.length });
        }
        if (sender.ended && sender.waiting === 0) client.end();
      },
    };
    client.on('data', (bytes) => {
      const [, path] = /^[A-Z]+ (\S+) HTTP\/1/.exec(bytes.toString('latin1', 0, 2000)) ?? [];
      if (path !== undefined) this.exchanges.push((exchange = { path, begin: now(), end: NaN, bytes: 0, chunks: [] }));
      up.push(Math.max(openAt, now()) + this.#roundTrip / 2, () => server.write(bytes));
    });
    client.on('end', () => up.push(Math.max(openAt, now()) + this.#roundTrip / 2, () => server.end()));
    server.on('data', (bytes) => {
      for (let from = 0; from < bytes.length; from += PACKET) sender.packets.push({ bytes: bytes.subarray(from, from + PACKET), at: now() });
      sender.waiting += bytes.length;
      if (sender.waiting >= this.#queue) server.pause();
      this.#downlink.wake(sender);
    });
    server.on('end', () => {
      sender.ended = true;
      if (sender.waiting === 0) client.end();
    });
    for (const [socket, other] of [[client, server], [server, client]]) {
      this.#sockets.add(socket);
      socket.on('error', () => other.destroy());
      socket.on('close', () => {
        this.#sockets.delete(socket);
        if (socket === client) {
          sender.packets.length = 0;
          server.destroy();
        }
      });
    }
  }
}
