// @ts-check
// The element's own style. A constructed sheet is allowed where a strict policy forbids style elements.

const CSS = `
:host { display: block; position: relative; width: 300px; height: 300px; overflow: hidden; contain: strict; }
:host([hidden]) { display: none; }
.stage, .poster, .poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
.stage { background: radial-gradient(farthest-corner at 50% 42%, var(--jsm-ground, #dde1e5), var(--jsm-ground-edge, #c3c8ce)); outline: none; }
.stage:focus-visible { box-shadow: inset 0 0 0 3px var(--jsm-focus, #1f6feb); }
.stage.held { cursor: grabbing; }
.stage.controlled { cursor: grab; }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
.poster { pointer-events: none; transition: opacity 200ms; }
.poster img { object-fit: contain; }
.poster.gone { opacity: 0; visibility: hidden; transition: opacity 200ms, visibility 0s 200ms; }
@media (prefers-reduced-motion: reduce) { .poster, .poster.gone { transition: none; } }
`;

/** @param {ShadowRoot} root */
export function dress(root) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(CSS);
  root.adoptedStyleSheets = [sheet];
}
