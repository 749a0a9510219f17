// @ts-check
// What the desktop viewer is started with: addresses and lines for the visitor's system.

/** @typedef {'Linux' | 'Windows' | 'macOS' | 'other'} System */
/** @typedef {{ url: string, bytes: number }} Jar */

/** @param {string} platform as the browser names it @returns {System} */
export function systemOf(platform) {
  if (/win/i.test(platform)) return 'Windows';
  if (/mac/i.test(platform)) return 'macOS';
  return /linux|bsd|x11/i.test(platform) ? 'Linux' : 'other';
}

/**
 * The address that the viewer takes: of the manifest, because the model may be encoded again, else of the archive.
 *
 * @param {string} archiveUrl as it is shown, empty where nothing is yet
 * @param {string} search of the page
 * @param {string} base of the page
 * @param {string | undefined} manifestUrl in a page that was made for the model
 * @returns {string | null} null for a file that is on the visitor's device alone
 */
export function addressOf(archiveUrl, search, base, manifestUrl) {
  if (/^(blob|file):/.test(archiveUrl)) return null;
  const query = new URLSearchParams(search);
  const id = query.get('m');
  if (id === null && (query.has('archive') || manifestUrl === undefined)) return archiveUrl || null;
  if (id === null) return new URL(/** @type {string} */ (manifestUrl), base).href;
  const address = new URL(`m/${encodeURIComponent(id)}/manifest.json`, base);
  for (const part of ['expires', 'signature']) {
    const value = query.get(part);
    if (value !== null) address.searchParams.set(part, value);
  }
  return address.href;
}

/**
 * What a server says to programs that start the viewer; only servers have it, and only for models of theirs.
 *
 * @param {string} address of the manifest
 */
export function launchUrl(address) {
  const url = new URL(address);
  return url.pathname.endsWith('/manifest.json') ? new URL(`viewer.jnlp${url.search}`, url).href : null;
}

/**
 * Where such a text says that the viewer is.
 *
 * @param {string} text
 * @param {string} address of the manifest
 * @returns {Jar | null}
 */
export function jarIn(text, address) {
  const tag = /<jar\s[^>]*>/.exec(text)?.[0] ?? '';
  const href = /\shref="([\w./-]+)"/.exec(tag)?.[1];
  return href === undefined ? null : { url: new URL(`../${href}`, address).href, bytes: Number(/\ssize="(\d+)"/.exec(tag)?.[1] ?? 0) };
}

/**
 * Lines for a terminal.
 *
 * @param {System} system
 * @param {string} address
 * @param {Jar | null} jar to be downloaded first
 */
export function lines(system, address, jar) {
  const quote = system === 'Windows' ? '"' : "'";
  // Neither a shell nor PowerShell finds anything of its own in what is left.
  const quoted = (/** @type {string} */ text) => quote + text.replaceAll("'", '%27').replaceAll('$', '%24').replaceAll('`', '%60').replaceAll('"', '%22') + quote;
  const curl = system === 'Windows' ? 'curl.exe' : 'curl';
  const start = `java -jar jsm-viewer.jar ${quoted(address)}`;
  return jar === null ? start : `${curl} -fLO ${quoted(jar.url)}\n${start}`;
}
