// @ts-check
// How ids are made of names: what `IdText` and `ModelPath` of the server do.

import { LATIN } from './order.js';

/**
 * A name as ids write it. Letters lose case, and Latin letters lose accents. Letters and digits of other scripts stay as
 * they are, with their marks. Runs of everything else become one hyphen.
 *
 * @param {string} name of a folder or file
 */
export function idText(name) {
  let text = '';
  let isLatin = true; // what marks belong to
  let gap = '';
  for (const c of name.normalize('NFKD').toLowerCase()) {
    const isMark = /\p{M}/u.test(c);
    if (isMark && isLatin) continue;
    const latin = /[a-z0-9]/.test(c) ? c : LATIN[c];
    const letters = latin ?? (isMark || /[\p{L}\p{Nd}]/u.test(c) ? c : '');
    isLatin = latin !== undefined || letters === '';
    if (letters !== '' && text !== '') text += gap;
    gap = letters === '' ? '-' : '';
    text += letters;
  }
  return text.normalize('NFC');
}

/** What ids begin with that are found by some words: `kitchen--big-ch` by `Kitchen/Big ch`. @param {string} words */
export function prefixOf(words) {
  const parts = words.trim().split(/\/|--/).map(idText);
  const last = parts.pop() ?? '';
  return [...parts.filter((part) => part !== ''), last].join('--');
}
