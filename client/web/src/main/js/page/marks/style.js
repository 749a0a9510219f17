// @ts-check
// The look of what tools draw over the picture, and of their controls.

import { dressing } from '../tools/make.js';

const CSS = `
.marks { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.marks > svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.marks path.length { fill: none; stroke: #1b2426; stroke-width: 2; paint-order: stroke; filter: drop-shadow(0 0 1.5px #fff) drop-shadow(0 0 1.5px #fff); }
.marks .end { fill: #0f766e; stroke: #fff; stroke-width: 2; }
.marks span.length { position: absolute; top: 0; left: 0; padding: 2px 9px; border-radius: 99px; background: #1b2426e6; color: #fff; font-size: .84rem; font-variant-numeric: tabular-nums; white-space: nowrap; }
.marks .aim { position: absolute; top: -13px; left: -13px; width: 26px; height: 26px; }
.marks .aim::before, .marks .aim::after { content: ""; position: absolute; background: #0f766e; box-shadow: 0 0 0 1px #fff; }
.marks .aim::before { inset: 12px 0; }
.marks .aim::after { inset: 0 12px; }
jsm-viewer.picking::part(stage) { cursor: crosshair; }
.tool .measured { display: grid; gap: 6px; margin: 0; padding: 0; list-style: none; counter-reset: row; }
.tool .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 8px; }
.tool .pair button { padding: 8px 4px; }
.tool .section, .tool .controls:has(.notes), .tool .form { grid-template-columns: minmax(0, 1fr); }
.tool .section select, .tool .section input { flex: 1; min-width: 0; }
.tool .measured:empty { display: none; }
.tool .measured li { display: flex; align-items: center; justify-content: space-between; gap: 10px; font-variant-numeric: tabular-nums; }
.tool .measured button { padding: 3px 10px; font-size: .84rem; font-weight: 400; }
.marks .note { position: absolute; top: -13px; left: -13px; min-width: 26px; height: 26px; padding: 0 6px; border: 2px solid #fff; border-radius: 99px; background: #1b2426; color: #fff; font-size: .8rem; line-height: 1; pointer-events: auto; transition: opacity .15s; }
.marks .note.hidden { opacity: .35; }
.marks .note.chosen, .marks .note:hover:not(:disabled) { background: #0f766e; opacity: 1; }
.marks .note:focus-visible { opacity: 1; border-radius: 99px; }
.tool .notes { display: grid; gap: 4px; margin: 0; padding: 0; list-style: none; counter-reset: note; }
.tool .notes:empty, .tool .form:empty { display: none; }
.tool .notes li { display: grid; gap: 6px; counter-increment: note; }
.tool .notes [aria-expanded] { padding: 6px 10px; text-align: left; font-weight: 400; overflow-wrap: anywhere; }
.tool .notes [aria-expanded]::before { content: counter(note) ". "; color: var(--soft); }
.tool .notes [aria-expanded="true"] { border-color: var(--accent); background: var(--wash); color: inherit; font-weight: 600; }
.tool .notes p, .tool .problems { white-space: pre-wrap; overflow-wrap: anywhere; }
.tool .notes .own { display: flex; gap: 8px; }
.tool .notes .own button { padding: 3px 10px; font-size: .84rem; font-weight: 400; }
.tool .problems { color: var(--bad); font-size: .88rem; }
.tool .check { justify-content: flex-start; }
.tool .form { display: grid; gap: 8px; }
.tool .form input, .tool .form textarea { flex: 1; min-width: 0; padding: 6px 8px; border: 1px solid var(--edge); border-radius: 8px; background: var(--card); color: inherit; font: inherit; }
.tool .form textarea { resize: vertical; }
@media (max-width: 640px) {
  .tool:has(.measured, .notes, .section) { z-index: 3; top: auto; right: 8px; bottom: 8px; left: 8px; width: auto; max-width: none; max-height: 38% !important; }
}
`;

export const dress = dressing(CSS);
