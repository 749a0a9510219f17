// @ts-check
// Shows the gallery, or the model that the address names: `?m=ID`, or `?archive=URL` for an archive on any server.

import { typed } from './elements.js';
import { openGallery } from './gallery.js';
import { SHADINGS } from './shading.js';
import { openViewer } from './viewer.js';

const query = new URLSearchParams(location.search);
const models = new URL('m/', document.baseURI);
const id = query.get('m');
const archive = query.get('archive');
const decoder = query.get('decoder') ?? 'auto';
const shading = SHADINGS.find((name) => name === query.get('shading')) ?? 'smooth';
typed('home', HTMLAnchorElement).search = query.has('decoder') ? `decoder=${decoder}` : '';

if (id !== null) openViewer({ manifestUrl: new URL(`${encodeURIComponent(id)}/manifest.json`, models) }, decoder, shading);
else if (archive !== null) openViewer({ archive }, decoder, shading);
else openGallery(new URL('index.json', models), decoder);
