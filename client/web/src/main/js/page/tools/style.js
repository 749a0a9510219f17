// @ts-check
// The look of the tools. It comes with them, not with the page's own style, which every visit waits for.

import { dressing } from './make.js';

const CSS = `
.tools { position: absolute; z-index: 1; top: 60px; left: 12px; display: grid; grid-auto-flow: column; grid-template-rows: repeat(var(--rows, 8), 38px); gap: 6px; }
.tools button, .tool header button { display: grid; place-items: center; width: 38px; height: 38px; padding: 0; }
.tools button { border-radius: 12px; background: var(--card); backdrop-filter: blur(14px); }
.tools button:hover:not(:disabled) { background: var(--ground); }
.tools [aria-expanded="true"], .tools [aria-pressed="true"] { border-color: transparent; background: var(--accent); color: var(--accent-ink); }
.tools svg, .tool header svg { width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.8; stroke-linecap: round; stroke-linejoin: round; }
.tool { position: absolute; z-index: 1; top: 60px; left: calc(14px + 44px * var(--columns, 1)); width: 270px; max-width: calc(100vw - 22px - 44px * var(--columns, 1)); padding: 6px 14px 14px; overflow: auto; border: 1px solid var(--edge); border-radius: 14px; background: var(--ground); box-shadow: 0 8px 30px #0000001f; }
.tool.over { z-index: 3; top: 8px; bottom: 8px; }
.tool header { display: flex; align-items: center; justify-content: space-between; margin-right: -8px; }
.tool header button { border: 0; }
.tool h2 { margin: 0; font-size: .95rem; font-weight: 600; }
.tool .controls { display: grid; gap: 10px; }
.tool label { white-space: nowrap; display: flex; align-items: center; justify-content: space-between; gap: 12px; }
.tool select { padding: 5px 8px; background: var(--ground); font-weight: 400; }
.tool input { min-width: 0; accent-color: var(--accent); margin: 0; }
.tool p { margin: 0; }
.tool .formats, .tool .originals { display: grid; grid-template-columns: repeat(3, 1fr); gap: 8px; }
.tool .formats button, .tool .originals button { padding: 8px 4px; }
.tool .archive { color: var(--accent); text-decoration: underline; }
.tool .chart { display: block; width: 100%; border-bottom: 1px solid var(--edge); }
.tool .rate { fill: var(--accent); opacity: .35; }
.tool .detail { fill: none; stroke: currentColor; stroke-width: 1.5; vector-effect: non-scaling-stroke; }
.tool .facts { display: grid; gap: 4px; margin: 0; font-size: .84rem; }
.tool .facts div { display: flex; justify-content: space-between; gap: 12px; }
.tool dt { color: var(--soft); }
.tool dd { margin: 0; text-align: right; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.sheet { z-index: 1; }
.fold { position: absolute; top: -13px; left: calc(50% - 24px); display: grid; place-items: center; width: 48px; height: 25px; padding: 0; border-radius: 99px; background: var(--ground); }
.fold:hover:not(:disabled) { background: var(--card); }
.folded .fold { position: static; width: 40px; height: auto; border-radius: 10px; background: none; }
.fold svg { width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.8; stroke-linecap: round; stroke-linejoin: round; }
.folded .fold svg { transform: rotate(180deg); }
.folded .figures, .folded .track, .folded #original, .folded #more:disabled { display: none; }
.panel.folded { margin-right: 0; width: fit-content; max-width: calc(100vw - 16px); padding: 8px; }
.folded .actions { width: auto; margin: 0 0 0 auto; }
.folded .actions > button { flex: none; }
.said { position: absolute; z-index: 1; top: 60px; left: 50%; max-width: 70vw; margin: 0; padding: 8px 16px; border-radius: 99px; background: #1b2426e6; color: #fff; transform: translateX(-50%); pointer-events: none; }
.said:empty { padding: 0; }
.wait.small { right: 20px; left: auto; }
`;

export const dress = dressing(CSS);
