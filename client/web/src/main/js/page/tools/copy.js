// @ts-check
// Puts a text where the system keeps what was copied.

import { make } from './make.js';

/** @param {string} text @returns {Promise<boolean>} whether it is there */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyFromField(text);
  }
}

/** Pages without encryption have no clipboard, but for what is selected. @param {string} text */
function copyFromField(text) {
  const before = document.activeElement;
  const field = make('textarea', 'unseen', '');
  field.value = text;
  document.body.append(field);
  field.select();
  const isCopied = document.execCommand('copy');
  field.remove();
  if (before instanceof HTMLElement) before.focus({ preventScroll: true });
  return isCopied;
}
