// @ts-check
// What of a view goes into a link to it, part by part: `#camera=30,75,1,0,0,0&shading=flat`.

/**
 * One part. A tool that is loaded later may add its own, and hears at once what the address has of it.
 *
 * @typedef {object} Part
 * @property {() => string | null} write null where everybody sees the same without it
 * @property {(text: string) => void} read what the address says; ignores what it does not understand
 */

export class State {
  /** @type {Map<string, Part>} */
  #parts = new Map();
  /** What the address says and no part has read yet. @type {Map<string, string>} */
  #wanted = new Map();

  /**
   * @param {string} name
   * @param {Part} part
   */
  add(name, part) {
    this.#parts.set(name, part);
    const text = this.#wanted.get(name);
    this.#wanted.delete(name);
    if (text !== undefined) part.read(text);
  }

  /** @param {string} name whether the address had this part, and nobody has read it yet */
  isWanted(name) {
    return this.#wanted.has(name);
  }

  /** @param {string} fragment of an address, with `#` or without */
  read(fragment) {
    this.#wanted = new Map(new URLSearchParams(fragment.replace(/^#/, '')));
    for (const [name, part] of [...this.#parts]) this.add(name, part);
  }

  /** All parts that differ from what everybody sees, as the fragment of an address without `#`. */
  write() {
    const written = [];
    for (const [name, part] of this.#parts) {
      const text = part.write();
      if (text !== null) written.push(`${name}=${encodeURIComponent(text).replaceAll('%2C', ',')}`);
    }
    return written.join('&');
  }
}
