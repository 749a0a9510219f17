// @ts-check
// What happens to a streamed model, as the events of its element.

import { Figures } from '../session/figures.js';

/** @import { Session } from '../session/session.js' */
/** @typedef {(name: string, detail?: unknown) => void} Tell */

export class Progress {
  #tell;
  #level = -1;
  /** What the last change said. @type {Pick<Figures, 'error' | 'state' | 'identical' | 'isFull'>} */
  #told = new Figures();

  /** @param {Tell} tell */
  constructor(tell) {
    this.#tell = tell;
  }

  /** @param {Session} session that has changed */
  hear({ figures }) {
    if (figures.totalBytes > 0) this.#tell('progress', { totalProgress: figures.bytes / figures.totalBytes });
    if (figures.batches > 0 && figures.level !== this.#level) {
      this.#level = figures.level;
      this.#tell('level', { level: figures.level, faces: figures.faces });
    }
    const { error, state, identical, isFull } = figures;
    if (error !== null && error !== this.#told.error) this.#tell('error', { type: 'loadfailure', message: error });
    if (state === 'complete' && this.#told.state !== 'complete') this.#tell('complete');
    if (identical && !this.#told.identical) this.#tell('identical', { meshSha256: figures.sha256, modelSha256: figures.modelSha256 });
    if (isFull && !this.#told.isFull) this.#tell('budget', { faces: figures.faces });
    this.#told = { error, state, identical, isFull };
    this.#tell('change');
  }
}
