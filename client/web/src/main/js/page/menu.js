// @ts-check
// A menu that opens on a press of its summary, and closes on another, on Escape, or on a press elsewhere.

/** @param {HTMLDetailsElement} menu */
export function bindMenu(menu) {
  const close = () => {
    if (!menu.open) return;
    const isInside = menu.contains(document.activeElement);
    menu.open = false;
    if (isInside) menu.querySelector('summary')?.focus();
  };
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') close();
  });
  document.addEventListener('pointerdown', (event) => {
    if (event.target instanceof Node && !menu.contains(event.target)) menu.open = false;
  });
}
