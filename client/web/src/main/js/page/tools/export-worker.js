// @ts-check
// Writes files off the main thread.

import { shapeOf, WRITERS } from './writers.js';

addEventListener('message', ({ data: { format, positions, indices, colours, origin } }) => {
  const pieces = WRITERS[/** @type {import('./writers.js').Format} */ (format)](shapeOf(positions, indices, colours, origin));
  postMessage(new Blob(pieces));
});
