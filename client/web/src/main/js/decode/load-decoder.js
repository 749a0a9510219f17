// @ts-check
// Loads decoders: a first one soon, the whole one behind it, in JavaScript where the browser knows no WebAssembly GC.

import { DecoderMissing } from './answers.js';
import { Decoder } from './decoder.js';
import { Relay } from './relay.js';

/** @import { Java } from './decoder.js' */
/** @typedef {{ kind: 'wasm' | 'js', java: Java }} Whole the whole decoder: what DecoderMain exports */

const WHOLE = new URL('../decoder/decoder.wasm', import.meta.url);
/** A module with a type that WebAssembly has had since it has GC. */
const WITH_GC = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 95, 1, 120, 0);

/**
 * What is compiled or on its way: archives share it.
 *
 * @type {Promise<WebAssembly.Module> | null}
 */
let compiled = null;
let isWholeHere = false;

/**
 * Loads a decoder.
 *
 * @param {string} wanted 'wasm' or 'js' for the whole decoder of that sort; 'first' for the first decoder and then the whole one; else the same, unless the whole
 *   decoder is there already
 * @param {() => Java} [first] makes a first decoder: what FirstDecoderMain exports
 * @param {(whole: Whole) => void} [come] is told of the whole decoder that comes behind it
 */
export async function loadDecoder(wanted, first, come) {
  const takesFirst = wanted === 'first' || (wanted !== 'wasm' && wanted !== 'js' && !isWholeHere);
  if (first !== undefined && takesFirst) {
    return relayed(first(), async () => {
      const whole = await loadWhole();
      come?.(whole);
      return whole;
    });
  }
  try {
    const { kind, java } = await loadWhole(wanted);
    return new Decoder(kind, java);
  } catch (reason) {
    throw new DecoderMissing(reason, wanted === 'wasm' ? 'Reload the page, or leave decoder=wasm out of its address' : 'Reload the page');
  }
}

/** Loads the whole decoder for archives that come later. Whoever cannot is told when one comes. */
export async function prepare() {
  await Promise.allSettled([loadWhole()]);
}

/**
 * A decoder that begins with the first one.
 *
 * @param {Java} first
 * @param {() => Promise<Whole>} load loads the whole one
 */
export function relayed(first, load) {
  const relay = new Relay(first, load);
  return new Decoder('js', relay.java, relay);
}

/**
 * Every archive has a decoder of its own.
 *
 * @param {string} [wanted] 'wasm' or 'js' for that sort alone
 * @returns {Promise<Whole>}
 */
async function loadWhole(wanted) {
  if (wanted === 'wasm' || (wanted !== 'js' && WebAssembly.validate(WITH_GC))) {
    try {
      // Of no use before there is the decoder, so it does not come before the first picture.
      const { compile, loadWebAssembly } = await import('./decoder-wasm.js');
      compiled ??= compile(WHOLE);
      const java = /** @type {any} */ (await loadWebAssembly(await compiled));
      isWholeHere = true;
      return { kind: 'wasm', java };
    } catch (reason) {
      compiled = null; // whoever asks next may have more luck
      if (wanted === 'wasm') throw reason;
    }
  }
  const { instantiate } = await import('../decoder/decoder.js');
  isWholeHere = true;
  return { kind: 'js', java: instantiate() };
}
