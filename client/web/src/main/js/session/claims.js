// @ts-check
// What the page says of the original, in the words of the decoder.

/** @import { Figures } from './figures.js' */

/**
 * @param {string} clause
 * @returns {string}
 */
const sentence = (clause) => (clause === '' ? '' : `${clause.charAt(0).toUpperCase()}${clause.slice(1)}.`);

/**
 * The badge, which stands for the claim in few words, and the line beneath that says more; empty where there is nothing to say.
 *
 * @param {Figures} figures
 */
export function claims(figures) {
  const words = figures.header?.words;
  if (!figures.proved || !words) return { badge: '', isWarning: false, title: '', line: '' };
  const badge = words.warning ? 'not the whole original' : 'identical to the original';
  const line = [words.warning ? `\u26a0 ${sentence(words.claim)}` : '', sentence(words.notKept)].filter((text) => text !== '').join(' ');
  const hashes = `SHA-256 of the decoded mesh: ${figures.sha256}; of mesh and pictures: ${figures.modelSha256}`;
  return { badge, isWarning: words.warning, title: `${sentence(words.claim)} ${hashes}`, line };
}
