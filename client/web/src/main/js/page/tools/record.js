// @ts-check
// How many bytes were there after how long a time of loading. What comes between rounds takes no time here: whoever looks
// at the picture does not wait.

/** @import { Round } from '../../session/figures.js' */
/** @typedef {{ seconds: number, bytes: number }} Point */

/** Points of a round that is recorded while it goes on: more than are drawn. */
const MOST_POINTS = 400;

export class Record {
  /** @type {WeakMap<Round, Point[]>} */
  #samples = new WeakMap();

  /**
   * Remembers how far the round is that goes on.
   *
   * @param {Round[]} rounds
   * @param {number} bytes
   * @param {number} now
   */
  sample(rounds, bytes, now) {
    const round = rounds.at(-1);
    if (round === undefined || round.millis !== undefined) return;
    const samples = this.#samples.get(round) ?? [];
    samples.push({ seconds: (now - round.at) / 1000, bytes });
    if (samples.length > MOST_POINTS) this.#samples.set(round, samples.filter((_, i) => i % 2 === 1));
    else this.#samples.set(round, samples);
  }

  /**
   * From the last beginning of the model on.
   *
   * @param {Round[]} rounds
   * @param {number} kept bytes that were there at the beginning
   * @returns {Point[]}
   */
  points(rounds, kept) {
    let begin = 0;
    let from = 0;
    for (const round of rounds) {
      const isAgain = round !== rounds[0] && round.from === 0;
      if (isAgain) begin = rounds.indexOf(round);
    }
    /** @type {Point[]} */
    const points = [{ seconds: 0, bytes: kept }];
    for (const round of rounds.slice(begin)) {
      const samples = this.#samples.get(round) ?? [];
      const end = round.millis === undefined ? [] : [{ seconds: round.millis / 1000, bytes: round.to ?? round.from }];
      const all = [...samples, ...end];
      points.push({ seconds: from, bytes: Math.max(kept, round.from) });
      for (const { seconds, bytes } of all) points.push({ seconds: from + seconds, bytes: Math.max(kept, bytes) });
      from = points[points.length - 1].seconds;
    }
    return points;
  }
}

/**
 * The bytes at a time between two points.
 *
 * @param {Point[]} points
 * @param {number} seconds
 */
export function bytesAt(points, seconds) {
  const next = points.findIndex((point) => point.seconds >= seconds);
  if (next < 0) return points[points.length - 1].bytes;
  if (next === 0) return points[0].bytes;
  const [a, b] = [points[next - 1], points[next]];
  return a.bytes + ((b.bytes - a.bytes) * (seconds - a.seconds)) / (b.seconds - a.seconds || 1);
}

/**
 * Throughput in so many equal parts of the time, and how many bytes were there at the end of each.
 *
 * @param {Point[]} points
 * @param {number} count
 */
export function parts(points, count) {
  const seconds = points[points.length - 1].seconds;
  const bytes = Array.from({ length: count + 1 }, (_, i) => bytesAt(points, (i * seconds) / count));
  const rates = bytes.slice(1).map((after, i) => (seconds > 0 ? Math.max(0, ((after - bytes[i]) * count) / seconds) : 0));
  return { seconds, rates, bytes: bytes.slice(1) };
}

/**
 * How many faces so many bytes bring.
 *
 * @param {number[]} ends the byte behind each batch
 * @param {number[]} batchFaces
 * @param {number} bytes
 */
export function facesOf(ends, batchFaces, bytes) {
  const behind = ends.findIndex((end) => end > bytes);
  return batchFaces[(behind < 0 ? Math.min(ends.length, batchFaces.length) : behind) - 1] ?? 0;
}
