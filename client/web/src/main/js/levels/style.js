// @ts-check
// The look of what this tool puts on the page.

import { dressing } from '../page/tools/make.js';

const CSS = `
.comparison { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.comparison .divider { position: absolute; top: 0; bottom: 0; left: calc(100% * var(--share)); width: 28px; margin-left: -14px; cursor: ew-resize; pointer-events: auto; touch-action: none; }
.comparison .divider::before { content: ""; position: absolute; top: 0; bottom: 0; left: 13px; width: 2px; background: #1b2426; }
.comparison .divider::after { content: "◂ ▸"; position: absolute; top: 45%; left: -3px; width: 34px; height: 34px; border-radius: 50%; background: #1b2426; color: #fff; font-size: 12px; line-height: 34px; text-align: center; white-space: nowrap; }
.comparison .of { position: absolute; top: 62px; margin: 0; padding: 4px 10px; border-radius: 10px; background: #1b2426d9; color: #fff; font-size: .8rem; white-space: pre-line; }
.comparison .left { right: calc(100% * (1 - var(--share)) + 10px); text-align: right; }
.comparison .right { left: calc(100% * var(--share) + 10px); }
.levels label.range { display: grid; justify-content: stretch; gap: 4px; }
.levels input[type="range"] { width: 100%; }
.levels .check { justify-content: flex-start; }
.levels output { color: var(--soft); font-size: .85rem; font-variant-numeric: tabular-nums; }
.levels .scale { height: 14px; border-radius: 4px; }
.levels .ends { display: flex; justify-content: space-between; font-size: .8rem; font-variant-numeric: tabular-nums; }
.levels .fine { font-size: .8rem; }
/* A phone shows the model above the controls, which lie on the panel meanwhile. */
@media (max-width: 640px) {
  .tool:has(.levels) { z-index: 3; top: auto; right: 8px; bottom: 8px; left: 8px; width: auto; max-width: none; max-height: 45% !important; }
  .levels { gap: 6px; }
  .levels:has(.range + .check + .range:not([hidden])) output { display: none; }
  .comparison .of { padding: 3px 7px; font-size: .7rem; }
}
`;

export const dress = dressing(CSS);
