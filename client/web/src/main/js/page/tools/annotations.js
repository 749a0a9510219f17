// @ts-check
// A list of what people wrote about places of the model, and a form for the visitor's own.

import { textOf } from '../marks/annotation-format.js';
import { annotations } from '../marks/annotations.js';
import { AnnotationForm, button } from './annotation-form.js';
import { make } from './make.js';
import { nameOfModel } from './names.js';
import { save } from './save.js';

/** @import { Entry } from '../marks/annotations.js' */
/** @import { Use } from './list.js' */

/** @type {Use} */
export function use(viewer, session, place) {
  const { view } = viewer;
  if (view === null) return undefined;
  const all = annotations(viewer, view, session, place);
  const problems = make('p', 'problems');
  const list = make('ol', 'notes');
  const form = new AnnotationForm(viewer, view, session, place);
  const add = button('Write one', () => begin(() => form.begin((annotation) => all.add(annotation)), add));
  const store = button('Save as a file', () => {
    const name = `${nameOfModel()}.annotations.json`;
    save(new Blob([all.file()], { type: 'application/json' }), name);
    place.say(`${name} saved`);
  });
  const shown = make('input');
  shown.type = 'checkbox';
  const check = make('label', 'check');
  check.append(shown, 'Show the marks');
  const hint = make('p', 'fine');
  const buttons = make('div', 'pair');
  buttons.append(add, store);
  place.element.append(problems, list, form.element, buttons, check, hint);

  /** What is in hand while the list is made anew. @type {() => HTMLElement | null} */
  let focused = () => null;
  const titleAt = (/** @type {number} */ index) => /** @type {HTMLElement | null} */ (list.querySelectorAll('[aria-expanded]')[index] ?? null);

  const begin = (/** @type {() => void} */ ask, /** @type {HTMLElement | null} */ from) => {
    buttons.hidden = true;
    list.inert = true;
    const at = from === add ? null : all.entries.findIndex((entry) => entry === all.chosen);
    focused = () => (at === null ? add : titleAt(at));
    ask();
  };
  form.addEventListener('end', () => {
    buttons.hidden = false;
    list.inert = false;
    focused()?.focus();
  });

  const remove = (/** @type {Entry} */ entry) => {
    const at = all.entries.indexOf(entry);
    all.remove(entry);
    place.say('Annotation removed');
    (titleAt(Math.min(at, all.entries.length - 1)) ?? add).focus();
  };

  const tell = () => {
    problems.textContent = all.problems.join('\n');
    problems.hidden = all.problems.length === 0;
    const held = [...list.querySelectorAll('[aria-expanded]')].indexOf(/** @type {Element} */ (document.activeElement));
    list.replaceChildren(
      ...all.entries.map((entry) =>
        row(entry, entry === all.chosen, {
          choose: () => all.choose(entry),
          edit: () => begin(() => form.edit(entry.annotation, (annotation) => all.change(entry, annotation)), null),
          remove: () => remove(entry),
        }),
      ),
    );
    if (held >= 0) titleAt(held)?.focus();
    shown.checked = all.isShown;
    check.hidden = all.entries.length === 0;
    store.disabled = all.entries.length === 0;
    const isTooLong = textOf(all.own) === null;
    hint.textContent = isTooLong ? 'Your own are too long for a link. Save them as a file.' : all.own.length > 0 ? 'Your own go into the link to this view. Give the file to whoever publishes the model.' : '';
    hint.hidden = hint.textContent === '';
  };
  shown.addEventListener('change', () => (all.isShown = shown.checked));
  all.addEventListener('change', tell);
  tell();
  return () => {
    all.removeEventListener('change', tell);
    form.end();
  };
}

/** Shows the marks of the publisher and of the address, without controls. @type {Use} */
export function restore(viewer, session, place) {
  if (viewer.view !== null) annotations(viewer, viewer.view, session, place);
}

/** @param {Entry} entry @param {boolean} isChosen @param {{ choose: () => void, edit: () => void, remove: () => void }} does */
function row({ annotation, isOwn }, isChosen, { choose, edit, remove }) {
  const item = make('li');
  const title = button(annotation.title, choose);
  title.setAttribute('aria-expanded', String(isChosen));
  item.append(title);
  if (isOwn) {
    title.setAttribute('aria-keyshortcuts', 'Delete');
    title.addEventListener('keydown', ({ key }) => {
      if (key === 'Delete') remove();
    });
  }
  if (!isChosen) return item;
  if (annotation.text !== '') item.append(make('p', '', annotation.text));
  if (isOwn) {
    const own = make('div', 'own');
    own.append(button('Edit', edit), button('Remove', remove));
    item.append(own);
  }
  return item;
}
