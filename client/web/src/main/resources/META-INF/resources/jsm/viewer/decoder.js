// The decoder behind one face, whether it runs as WebAssembly or as JavaScript.

import { loadWebAssembly } from './decoder-wasm.js';

const FAILED = -1;
const ARRAYS = [
  ['positions', Float32Array],
  ['normals', Float32Array],
  ['uvs', Float32Array],
  ['colours', Uint32Array],
  ['indices', Uint32Array],
  ['groups', Uint32Array],
];

/** Loads WebAssembly, or JavaScript when it is asked for or the browser knows no WebAssembly GC. */
export async function loadDecoder(wanted) {
  if (wanted !== 'js') {
    try {
      return new Decoder('wasm', await loadWebAssembly(new URL('decoder/decoder.wasm', import.meta.url)));
    } catch (reason) {
      if (wanted === 'wasm') throw new DecoderMissing(reason, 'Reload the page, or leave decoder=wasm out of its address');
    }
  }
  try {
    return new Decoder('js', await import('./decoder/decoder.js'));
  } catch (reason) {
    throw new DecoderMissing(reason, 'Reload the page');
  }
}

/** The decoder cannot be loaded, in words. */
export class DecoderMissing extends Error {
  constructor(reason, remedy) {
    super(`The decoder could not be loaded (${reason.message}). ${remedy}.`);
  }
}

export class DamagedArchive extends Error {}

class Decoder {
  #java;

  constructor(kind, java) {
    this.kind = kind;
    this.#java = java;
    this.open();
  }

  /** Forgets the archive before. */
  open() {
    this.#java.open();
    this.received = 0;
    this.batches = 0;
    this.header = null;
  }

  /** Decodes the next bytes of the archive; throws DamagedArchive. */
  feed(bytes) {
    for (let from = 0; from < bytes.length; ) {
      const staging = this.#java.staging();
      const part = bytes.subarray(from, from + staging.length);
      staging.set(part);
      this.batches = this.#call(() => this.#java.feed(part.length));
      this.received += part.length;
      from += part.length;
      if (!this.header?.whole) this.header = JSON.parse(this.#java.header());
    }
  }

  get isComplete() {
    return this.#java.isComplete();
  }

  /** Copies of the arrays to draw, by name. */
  draw() {
    const vertices = this.#call(() => this.#java.draw());
    const drawn = { vertices };
    ARRAYS.forEach(([name, Type], array) => {
      drawn[name] = new Type(this.#java.count(array));
      for (let from = 0; from < drawn[name].length; ) {
        const count = this.#java.copy(array, from);
        const staging = this.#java.staging();
        drawn[name].set(new Type(staging.buffer, staging.byteOffset, count), from);
        from += count;
      }
    });
    this.#java.release();
    return drawn;
  }

  /** Images that can be shown and were not given before, as [path, bytes]: textures that have arrived whole, and previews of others. `known` keeps what was given. */
  newTextures(known) {
    const lines = this.#java.textures();
    const textures = [];
    if (lines === '') return textures;
    lines.split('\n').forEach((line, index) => {
      if (known.has(line)) return;
      known.add(line);
      const path = line.split('\t')[0];
      const bytes = new Uint8Array(this.#java.textureBytes(index));
      for (let from = 0; from < bytes.length; ) {
        const count = this.#java.copyTexture(index, from);
        bytes.set(this.#java.staging().subarray(0, count), from);
        from += count;
      }
      textures.push([path, bytes]);
    });
    return textures;
  }

  /** Identity of the mesh decoded so far, from its faces. */
  sha256() {
    const hash = this.#java.sha256();
    if (hash === null) throw new DamagedArchive(this.#java.error());
    return hash;
  }

  beginRound(now, waitMillis) {
    this.#java.beginRound(now, waitMillis);
  }

  /** The planner's next request, or null. */
  nextRequest(now) {
    const text = this.#java.nextRequest(now, this.received);
    if (text === null) return null;
    const [from, end, fromBatch, endBatch, bytesPerSecond, waitMillis] = text.split(' ').map(Number);
    return { from, end, fromBatch, endBatch, bytesPerSecond, waitMillis };
  }

  beginResponse(now) {
    this.#java.beginResponse(now);
  }

  arrived(now, bytes) {
    this.#java.arrived(now, bytes);
  }

  endResponse(cached) {
    this.#java.endResponse(cached);
  }

  /** Whether what is there is to be shown now, though a response is under way. */
  isOver(now) {
    return this.#java.isOver(now);
  }

  /** Whether, after the round, the rest of a response is read on. */
  mayGoOn(now, bytesLeft) {
    return this.#java.mayGoOn(now, bytesLeft);
  }

  bytesPerSecond(now) {
    return this.#java.bytesPerSecond(now);
  }

  /** Damaged bytes make Java answer FAILED, or, where it does not look, trap. */
  #call(method) {
    let answer;
    try {
      answer = method();
    } catch (trap) {
      throw new DamagedArchive(`the decoder stopped (${trap.message ?? 'for an unknown reason'})`);
    }
    if (answer === FAILED) throw new DamagedArchive(this.#java.error() ?? 'the decoder stopped');
    return answer;
  }
}
