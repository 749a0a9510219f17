// @ts-check
// The look of the search box and of a long list. It comes with them.

import { dressing } from '../tools/make.js';

const CSS = `
.browse { display: flex; flex-wrap: wrap; align-items: center; gap: 10px 14px; margin: 12px -20px -12px; padding: 10px 20px; }
.browse input { flex: 1 1 220px; min-width: 0; max-width: 420px; padding: 9px 14px; border: 1px solid var(--edge); border-radius: 10px; background: var(--card); color: inherit; font: inherit; }
.browse label { display: flex; align-items: center; gap: 8px; color: var(--soft); }
.browse select { padding: 8px 10px; background: var(--card); color: var(--ink); font-weight: 400; }
.browse p { margin: 0; color: var(--soft); font-variant-numeric: tabular-nums; }
.cards.long { display: block; position: relative; }
.long li { position: absolute; width: var(--width); }
.long .card { height: var(--height); padding-bottom: 12px; }
.long .card img, .long strong { flex: none; }
.long strong, .long span { display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 2; overflow: hidden; }
@media (max-width: 640px) {
  .browse label span { display: none; }
  .browse input { flex-basis: 100%; }
}
@media (min-height: 540px) {
  .browse { position: sticky; z-index: 1; top: 0; background: color-mix(in srgb, var(--ground) 80%, transparent); backdrop-filter: blur(14px); }
  .cards li { scroll-margin: 130px 0 20px; }
}
`;

export const dress = dressing(CSS);
