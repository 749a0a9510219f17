// @ts-check
// The look of cards for files of this device, and of what asks for such files.

import { dressing } from '../tools/make.js';

/** Name of the file in the page's address, which nobody else can follow. */
export const PARAMETER = 'file';

const CSS = `
dialog.local { width: min(30em, calc(100vw - 24px)); padding: 18px 20px 20px; border: 1px solid var(--edge); border-radius: 16px; background: var(--ground); color: var(--ink); box-shadow: 0 18px 60px #00000055; }
dialog.local::backdrop { background: #0008; }
.local h2 { margin: 0 0 8px; font-size: 1.05rem; font-weight: 600; overflow-wrap: anywhere; }
.local p { margin: 0 0 12px; overflow-wrap: anywhere; }
.local p:empty { display: none; }
.local .soft { color: var(--soft); }
.local .bad { color: var(--bad); }
.local .fields { display: grid; gap: 10px; margin-bottom: 14px; }
.local .fields:empty { display: none; }
.local label { display: grid; gap: 3px; font-size: .9rem; }
.local input { width: 100%; padding: 8px 10px; border: 1px solid var(--edge); border-radius: 10px; background: var(--card); color: inherit; font: inherit; }
.local progress { display: block; width: 100%; margin-bottom: 8px; accent-color: var(--accent); }
.local .actions { display: flex; flex-wrap: wrap; justify-content: flex-end; gap: 8px; }
.pick { display: flex; flex-wrap: wrap; align-items: center; gap: 6px 12px; margin: 14px 0 0; color: var(--soft); }
`;

export const dress = dressing(CSS);
