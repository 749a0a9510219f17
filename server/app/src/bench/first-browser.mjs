// @ts-check
// One visit of a page by a Chromium that has never been anywhere, and when what was on its screen. Speaks the DevTools protocol over a pipe.

import { spawn } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { temporary } from './model.mjs';

export const ARGUMENTS = [
  '--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage',
  '--enable-unsafe-swiftshader', '--window-size=1000,700', '--remote-debugging-pipe',
];
/** Marks what is on the screen; runs in the page before all else. */
const OBSERVER = fs.readFileSync(path.join(path.dirname(fileURLToPath(import.meta.url)), 'first-page.js'), 'utf8');
const START = '(() => { const gl = document.createElement("canvas").getContext("webgl2"); gl?.clear(gl.COLOR_BUFFER_BIT); return gl !== null; })()';

/** @typedef {{ start: number, poster?: number, picture?: number, fine?: number, whole?: number, error?: string, trouble?: string }} Marks milliseconds since 1970; `error` ends the visit, `trouble` does not */

/** The DevTools protocol over the pipes 3 and 4 of a process. */
export class Devtools {
  #write;
  #waiting = new Map();
  #last = 0;

  constructor(child) {
    this.#write = child.stdio[3];
    let text = '';
    child.stdio[4].setEncoding('utf8').on('data', (part) => {
      const messages = (text + part).split('\0');
      text = messages.pop() ?? '';
      for (const message of messages) this.#hear(JSON.parse(message));
    });
  }

  #hear({ id, result, error }) {
    const { resolve, reject } = this.#waiting.get(id) ?? {};
    this.#waiting.delete(id);
    if (error) reject?.(new Error(error.message));
    else resolve?.(result);
  }

  /** @returns {Promise<any>} */
  send(method, params = {}, sessionId = undefined) {
    const id = ++this.#last;
    this.#write.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }
}

const pause = (millis) => new Promise((resolve) => setTimeout(resolve, millis));

/**
 * @param {string} url
 * @param {{ chromium: string, patience: number, picture?: string }} how `patience` is how many milliseconds the whole model may take; a picture of the screen is taken when it is there
 * @returns {Promise<Marks>}
 */
export async function visit(url, { chromium, patience, picture }) {
  const profile = temporary(`profile-${process.hrtime.bigint()}`);
  const child = spawn(chromium, [...ARGUMENTS, `--user-data-dir=${profile}`], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.once('close', resolve));
  const failed = new Promise((_, reject) => child.once('error', (error) => reject(new Error(`${error.message}; name the browser with --chromium=PATH`))));
  const devtools = new Devtools(child);
  try {
    return await Promise.race([watch(devtools, url, patience, picture), failed]);
  } finally {
    if (child.pid !== undefined) {
      devtools.send('Browser.close').catch(() => child.kill());
      await ended;
    }
    // Its other processes may write for a moment yet.
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  }
}

/** @returns {Promise<Marks>} */
async function watch(devtools, url, patience, picture) {
  const { targetId } = await devtools.send('Target.createTarget', { url: 'about:blank' });
  const { sessionId } = await devtools.send('Target.attachToTarget', { targetId, flatten: true });
  const ask = (method, params = {}) => devtools.send(method, params, sessionId);
  const evaluate = async (expression) => (await ask('Runtime.evaluate', { expression, returnByValue: true })).result.value;
  await ask('Page.enable');
  await ask('Page.addScriptToEvaluateOnNewDocument', { source: OBSERVER });
  // A visitor's browser is up before he goes to a page, and so is its part that draws.
  if (!(await evaluate(START))) throw new Error('this Chromium has no WebGL 2');
  await pause(1500);
  await ask('Page.navigate', { url });
  const until = performance.now() + patience;
  let marks = { start: NaN };
  while (performance.now() < until) {
    await pause(200);
    marks = (await evaluate('window.marks')) ?? marks;
    if (marks.whole !== undefined || marks.error !== undefined) break;
  }
  if (picture !== undefined) fs.writeFileSync(picture, Buffer.from((await ask('Page.captureScreenshot')).data, 'base64'));
  return marks;
}
