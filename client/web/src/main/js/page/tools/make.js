// @ts-check
// Elements, made by script so that the page costs no bytes for those who never see them.

const SVG = 'http://www.w3.org/2000/svg';

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {string} [className]
 * @param {string} [text]
 */
export function make(tag, className = '', text = '') {
  const made = document.createElement(tag);
  if (className !== '') made.className = className;
  if (text !== '') made.textContent = text;
  return made;
}

/**
 * A button with a picture.
 *
 * @param {string} name
 * @param {string} icon data of a path in 24 units
 */
export function button(name, icon) {
  const made = make('button');
  made.type = 'button';
  made.title = name;
  made.setAttribute('aria-label', name);
  const picture = document.createElementNS(SVG, 'svg');
  picture.setAttribute('viewBox', '0 0 24 24');
  picture.setAttribute('aria-hidden', 'true');
  const lines = document.createElementNS(SVG, 'path');
  lines.setAttribute('d', icon);
  picture.append(lines);
  made.append(picture);
  return made;
}

/**
 * A control with its name before it.
 *
 * @template {HTMLElement} T
 * @param {string} name
 * @param {T} control
 */
export function labelled(name, control) {
  const label = make('label');
  label.append(make('span', '', name), control);
  return label;
}

/**
 * Gives the page a style sheet when it is called for the first time.
 *
 * @param {string} css
 */
export function dressing(css) {
  let isDressed = false;
  return () => {
    if (isDressed) return;
    isDressed = true;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    document.adoptedStyleSheets.push(sheet);
  };
}
