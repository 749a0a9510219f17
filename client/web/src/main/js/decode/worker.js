// @ts-check
// Fetches and decodes archives off the main thread: each has a connection of its own.

import { instantiate } from '../decoder/first-decoder.js';
import { Connection } from './connection.js';

addEventListener('message', ({ ports }) => new Connection(ports[0], instantiate));
postMessage('up');
