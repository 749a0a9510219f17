// @ts-check
// What can be said of a model and of how it was loaded, in rows of a table.

import * as numbers from '../../session/numbers.js';

/** @import { Session } from '../../session/session.js' */
/** @typedef {[name: string, value: string]} Row */
/** @typedef {Pick<Session, 'figures' | 'rounds' | 'bytesPerSecond' | 'decodeMillis' | 'decoder' | 'pictures'>} Loaded */
/** @typedef {{ bytes: number, textures: number }} Memory */

/**
 * @param {Loaded} session
 * @param {Memory} memory of the graphics card
 * @returns {Row[]}
 */
export function rows({ figures: f, rounds, bytesPerSecond, decodeMillis, decoder, pictures }, memory) {
  const { header } = f;
  const cached = f.requests.filter((request) => request.cached).length;
  const bits = f.totalFaces > 0 ? (8 * f.totalBytes) / f.totalFaces : 0;
  /** @type {[string, string | false | null | undefined][]} */
  const all = [
    ['Faces', of(f.faces, f.totalFaces)],
    ['Vertices of the original', header?.vertices ? numbers.count(header.vertices) : null],
    ['Bytes', f.totalBytes > 0 ? `${numbers.count(f.bytes)} of ${numbers.count(f.totalBytes)}` : numbers.count(f.bytes)],
    ['Kept from earlier visits', f.keptBytes > 0 && numbers.bytes(f.keptBytes)],
    ['Batches', header?.whole ? of(f.batches, header.ends.length) : numbers.count(f.batches)],
    ['Rounds', numbers.count(rounds.length)],
    ['Requests', cached > 0 ? `${f.requests.length}, ${cached} from the cache` : numbers.count(f.requests.length)],
    ['Pictures', numbers.count(pictures)],
    ['Throughput', numbers.rate(bytesPerSecond)],
    ['Time to decode', `${numbers.count(Math.round(decodeMillis))} ms`],
    ['On the graphics card', `${numbers.bytes(memory.bytes)}${memory.textures > 0 ? `, ${memory.textures} textures` : ''}`],
    ['Decoder', decoder === null ? null : decoder === 'wasm' ? 'WebAssembly' : 'JavaScript'],
    ['Bits per face', bits > 0 && bits.toFixed(1)],
    ['Levels', header?.levels ? numbers.count(header.levels) : null],
    ['Bits of a coordinate', header?.precisionBits.length ? numbers.count(Math.max(...header.precisionBits)) : null],
    ['Materials', header !== null && header.slots.length > 0 && numbers.count(header.slots.length)],
    ['Attributes', header !== null && header.channels.length > 0 && header.channels.map(({ semantic, name }) => name || semantic.toLowerCase()).join(', ')],
    ['SHA-256 of the mesh', header?.meshSha256],
  ];
  return all.flatMap(([name, value]) => (value ? [/** @type {Row} */ ([name, value])] : []));
}

/** @param {number} part @param {number} all */
function of(part, all) {
  return all > 0 ? `${numbers.count(part)} of ${numbers.count(all)}` : numbers.count(part);
}
