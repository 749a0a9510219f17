// @ts-check
// A button of the gallery for files of this device.

import { make } from '../tools/make.js';
import { dress, PARAMETER } from './style.js';

/** @param {(files: File[]) => void} take */
export function offerFiles(take) {
  dress();
  const input = make('input');
  input.type = 'file';
  input.multiple = true;
  input.hidden = true;
  input.id = 'pick-file';
  input.addEventListener('change', () => {
    take([...(input.files ?? [])]);
    input.value = '';
  });
  const button = make('button', '', 'Open a file');
  button.type = 'button';
  button.addEventListener('click', () => input.click());
  const before = new URLSearchParams(location.search).get(PARAMETER);
  const words = before === null ? 'or drop it on the page: a .jsm archive, or a model with its materials.' : `${before} is on your device. Open it again, or drop it on the page.`;
  const line = make('div', 'pick');
  line.append(button, make('span', '', words), input);
  document.getElementById('gallery-note')?.after(line);
}
