// @ts-check
// What the browser keeps of archives across visits: their first bytes, as far as they have come. In IndexedDB, which pages without encryption have, too; its
// transactions leave no half entry, whatever ends the page. A browser that keeps nothing (private windows, storage switched off) is no error.

import { crc32 } from './crc32.js';

const DATABASE = 'jsm-archives';
/** All archives together; the least recently used go first. */
export const MOST_BYTES = 400e6;
/** Bytes are written in pieces of this size, after this time, or when a request ends: so much is lost when the page is closed in the middle. */
const PIECE = 1 << 18;
const PIECE_MILLIS = 100;
/** Browsers have been seen that never answer; nobody waits for their pictures so long. */
const OPEN_MILLIS = 2000;

/** @typedef {{ key: string, bytes: number, used: number }} Row of an archive: how many bytes there are, and when they were used last */
/** @typedef {{ key: string, from: number, crc: number, data: ArrayBuffer }} Piece */

/**
 * Of the whole page or worker, or on its way; null before it is asked for and after it is closed.
 *
 * @type {Promise<IDBDatabase> | null}
 */
let connection = null;

export class Kept {
  #database;
  #key;
  #mostBytes;
  /** @type {Uint8Array[]} */
  #piece = [];
  #pieceFrom = 0;
  #pieceBytes = 0;
  #writtenAt = performance.now();
  #writing = Promise.resolve();
  #isOver = false;

  /**
   * Resolves to null where nothing can be kept.
   *
   * @param {string} url of the archive: what another host says to be the same is not believed
   * @param {string | undefined} sha256 of the archive, without which nothing is kept
   */
  static async open(url, sha256, mostBytes = MOST_BYTES) {
    if (!/^[0-9a-f]{64}$/.test(sha256 ?? '')) return null;
    const { origin, pathname } = new URL(url);
    try {
      return new Kept(await openDatabase(), `${sha256} ${origin}${pathname}`, mostBytes);
    } catch {
      return null;
    }
  }

  /**
   * @param {IDBDatabase} database
   * @param {string} key of the archive
   * @param {number} mostBytes of all archives together
   */
  constructor(database, key, mostBytes) {
    this.#database = database;
    this.#key = key;
    this.#mostBytes = mostBytes;
  }

  /**
   * The pieces in file order, each checked; a damaged one and all behind it are dropped.
   *
   * @param {number} at where one begins
   */
  async *pieces(at = 0) {
    try {
      const row = await this.#touch();
      while (row !== undefined && at < row.bytes) {
        /** @type {Piece | undefined} */
        const piece = await answer(this.#database.transaction('pieces').objectStore('pieces').get([this.#key, at]));
        const bytes = new Uint8Array(piece?.data ?? []);
        if (bytes.length === 0 || crc32(bytes) !== piece?.crc) {
          await this.#truncate(at);
          return;
        }
        at += bytes.length;
        yield bytes;
      }
    } catch (error) {
      if (error instanceof DOMException) this.#isOver = true;
      else throw error;
    }
  }

  /**
   * Bytes that came over the network.
   *
   * @param {number} from offset of the first
   * @param {Uint8Array} bytes
   */
  add(from, bytes) {
    if (this.#isOver) return;
    if (this.#pieceBytes > 0 && from !== this.#pieceFrom + this.#pieceBytes) this.flush();
    if (this.#pieceBytes === 0) this.#pieceFrom = from;
    this.#piece.push(bytes.slice());
    this.#pieceBytes += bytes.length;
    if (this.#pieceBytes >= PIECE || performance.now() - this.#writtenAt > PIECE_MILLIS) this.flush();
  }

  /** Writes what was added; resolves when it is safe. */
  flush() {
    if (this.#pieceBytes > 0) {
      const bytes = new Uint8Array(this.#pieceBytes);
      let at = 0;
      for (const part of this.#piece) {
        bytes.set(part, at);
        at += part.length;
      }
      const from = this.#pieceFrom;
      this.#piece = [];
      this.#pieceBytes = 0;
      this.#writtenAt = performance.now();
      this.#writing = this.#writing.then(() => this.#write(from, bytes));
    }
    return this.#writing;
  }

  /** Drops the archive. */
  async forget() {
    this.#isOver = true;
    this.#piece = [];
    this.#pieceBytes = 0;
    await this.#writing;
    await this.#truncate(0).catch(() => {});
  }

  /**
   * @param {number} from
   * @param {Uint8Array} bytes
   */
  async #write(from, bytes) {
    if (this.#isOver) return;
    try {
      await this.#append(from, bytes);
    } catch (error) {
      // The browser's disk is full: room is made once.
      const isMade = error instanceof DOMException && error.name === 'QuotaExceededError' && (await this.#evict(0).catch(() => false));
      await (isMade ? this.#append(from, bytes) : Promise.reject(error)).catch(() => (this.#isOver = true));
    }
    await this.#evict(this.#mostBytes).catch(() => (this.#isOver = true));
  }

  /**
   * @param {number} from
   * @param {Uint8Array} bytes
   */
  async #append(from, bytes) {
    const transaction = this.#database.transaction(['archives', 'pieces'], 'readwrite');
    const archives = transaction.objectStore('archives');
    /** @type {Row} */
    const row = (await answer(archives.get(this.#key))) ?? { key: this.#key, bytes: 0, used: 0 };
    // Another tab may have been here; and there must be no gap.
    const fresh = bytes.subarray(Math.max(0, row.bytes - from));
    if (row.bytes < from || fresh.length === 0) return;
    if (row.bytes + fresh.length > this.#mostBytes) {
      this.#isOver = true;
      return;
    }
    const data = fresh.slice().buffer;
    transaction.objectStore('pieces').put({ key: this.#key, from: row.bytes, crc: crc32(fresh), data });
    archives.put({ ...row, bytes: row.bytes + fresh.length, used: Date.now() });
    await finished(transaction);
  }

  /**
   * What there is of the archive, which is used now.
   *
   * @returns {Promise<Row | undefined>}
   */
  async #touch() {
    const row = await answer(this.#database.transaction('archives').objectStore('archives').get(this.#key));
    // A full disk takes no date, but gives what it has.
    if (row !== undefined) await this.#date().catch(() => {});
    return row;
  }

  async #date() {
    const transaction = this.#database.transaction('archives', 'readwrite');
    const archives = transaction.objectStore('archives');
    const row = await answer(archives.get(this.#key));
    if (row !== undefined) archives.put({ ...row, used: Date.now() });
    await finished(transaction);
  }

  /** @param {number} bytes that are left */
  async #truncate(bytes) {
    const transaction = this.#database.transaction(['archives', 'pieces'], 'readwrite');
    const archives = transaction.objectStore('archives');
    const row = await answer(archives.get(this.#key));
    transaction.objectStore('pieces').delete(IDBKeyRange.bound([this.#key, bytes], [this.#key, Infinity]));
    if (row !== undefined && bytes > 0) archives.put({ ...row, bytes: Math.min(row.bytes, bytes) });
    else archives.delete(this.#key);
    await finished(transaction);
  }

  /**
   * Drops other archives until all are within the bytes; true if any went.
   *
   * @param {number} mostBytes
   */
  async #evict(mostBytes) {
    const transaction = this.#database.transaction(['archives', 'pieces'], 'readwrite');
    const archives = transaction.objectStore('archives');
    /** @type {Row[]} */
    const rows = await answer(archives.getAll());
    let sum = rows.reduce((all, row) => all + row.bytes, 0);
    let any = false;
    rows.sort((a, b) => a.used - b.used);
    for (const { key, bytes } of rows) {
      if (sum <= mostBytes) break;
      if (key === this.#key) continue;
      transaction.objectStore('pieces').delete(IDBKeyRange.bound([key, 0], [key, Infinity]));
      archives.delete(key);
      sum -= bytes;
      any = true;
    }
    await finished(transaction);
    return any;
  }
}

/** The one connection; rejects when there is none within a while, but a late one serves the next who asks. */
function openDatabase() {
  connection ??= inTime(connect());
  return connection;
}

/** @param {Promise<IDBDatabase>} opening */
function inTime(opening) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** @type {Promise<never>} */
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new DOMException('the database does not answer', 'TimeoutError')), OPEN_MILLIS);
  });
  const close = () => (connection = null);
  opening
    .then((database) => {
      connection = opening;
      database.onclose = close;
      // Whoever deletes the database, or a later version of this page, must not wait for this one.
      database.onversionchange = () => {
        database.close();
        close();
      };
    }, close)
    .finally(() => clearTimeout(timer));
  return Promise.race([opening, late]);
}

function connect() {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore('archives', { keyPath: 'key' });
    request.result.createObjectStore('pieces', { keyPath: ['key', 'from'] });
  };
  return answer(request);
}

/**
 * @template T
 * @param {IDBRequest<T>} request
 * @returns {Promise<T>}
 */
function answer(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/**
 * @param {IDBTransaction} transaction
 * @returns {Promise<void>}
 */
function finished(transaction) {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onerror = transaction.onabort = () => reject(transaction.error ?? new DOMException('aborted', 'AbortError'));
  });
}
