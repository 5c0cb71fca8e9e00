/** Edits by hand: undo and redo by their names and keys, and the list of all of them. */
import { inSight, steps } from '../state/history';
import type { History } from '../state/history';
import { declare } from '../view/commands';
import { button, fill, h } from './dom';
import { declareLack } from './lack';
import { say } from '../text/words';

export const UNDO_KEYS = ['Ctrl+Z'] as const;
export const REDO_KEYS = ['Ctrl+Shift+Z', 'Ctrl+Y'] as const;

/** Says of a button which keys do the same. */
export function hasKeys(made: HTMLButtonElement, keys: readonly string[]): void {
  made.setAttribute('aria-keyshortcuts', keys.join(' ').replaceAll('Ctrl', 'Control'));
}

/** A button that says what it would do, and cannot be pressed where that is nothing. */
export function set(made: HTMLButtonElement, text: string, disabled: boolean): void {
  if (made.textContent !== text) made.textContent = text;
  made.disabled = disabled;
}

/** Undo and redo as signs, which are there once there is an edit; what they would do is their title. */
export function showSteps<E>(undo: HTMLButtonElement, redo: HTMLButtonElement, history: History<E>, nameOf: (edit: E) => string): void {
  const names = steps(history, nameOf);
  for (const [made, name, keys] of [
    [undo, names.undo === null ? say('undo') : say('undo-3', { undo: names.undo }), UNDO_KEYS],
    [redo, names.redo === null ? say('redo') : say('redo-3', { redo: names.redo }), REDO_KEYS],
  ] as const) {
    made.title = `${name} (${keys[0]})`;
    hasKeys(made, keys);
    made.setAttribute('aria-label', name);
    made.hidden = history.edits.length === 0;
  }
  declareLack([undo], () => (names.undo === null ? say('no-edit-to-undo') : ''));
  declareLack([redo], () => (names.redo === null ? say('no-edit-to-redo') : ''));
  undo.disabled = names.undo === null;
  redo.disabled = names.redo === null;
}

/** So many edits before and after the present state are listed at first: a list of all would be made anew by each edit. */
const LISTED = 50;

/** How many are listed, where more were asked for. */
const reaches = new WeakMap<HTMLElement, number>();

/** Every state can be gone to by a press; `first` is the name of the one before all edits, `prefix` that of test ids. */
export function showHistory<E>(
  host: HTMLElement,
  prefix: string,
  first: string,
  history: History<E>,
  nameOf: (edit: E) => string,
  go: (done: number) => void,
): void {
  const { edits, done } = history;
  const reach = reaches.get(host) ?? LISTED;
  const { from, to } = inSight(history, reach);
  const focused = host.contains(document.activeElement);
  const entry = (place: number, name: string) => {
    const press = button(name, `${prefix}history-${String(place)}`, () => go(place));
    press.className = 'link';
    if (place === done) press.setAttribute('aria-current', 'step');
    return h('li', { class: place > done ? 'undone' : '' }, press);
  };
  const more = (testid: string, text: string) => {
    const press = button(text, `${prefix}history-${testid}`, () => {
      reaches.set(host, 4 * reach);
      showHistory(host, prefix, first, history, nameOf, go);
    });
    press.className = 'link';
    return h('li', {}, press);
  };
  const listed = edits.slice(from, to).map((edit, i) => entry(from + i + 1, nameOf(edit)));
  const earlier = from > 0 ? [more('earlier', say('history-earlier', { edits: from }))] : [];
  const later = to < edits.length ? [more('later', say('history-later', { edits: edits.length - to }))] : [];
  fill(host, entry(0, first), ...earlier, ...listed, ...later);
  if (focused) host.querySelector<HTMLElement>('[aria-current]')?.focus({ preventScroll: true });
}

/** Fields in which text is typed have an undo of their own, not sliders and checkboxes, which keep the keyboard once they are set. Dialogs lie over what is undone. */
export const hasOwnUndo = (target: EventTarget | null): boolean =>
  target instanceof Element && target.closest('input:not([type="range"], [type="checkbox"], [type="radio"]), textarea, dialog') !== null;

/** Undo and redo by their keys, wherever the keyboard is but in a field that has an undo of its own. */
export function undoKeys(isActive: () => boolean, step: (by: 1 | -1) => void): void {
  const act = declare({
    where: say('anywhere-after-edits'),
    host: document.body,
    list: [
      { keys: UNDO_KEYS, does: say('takes-back-the-last-edit'), can: isActive, run: () => step(-1) },
      { keys: REDO_KEYS, does: say('makes-the-edit-again'), can: isActive, run: () => step(1) },
    ],
  });
  document.addEventListener('keydown', (event) => {
    const { target, key } = event;
    if (!(event.ctrlKey || event.metaKey) || event.altKey || hasOwnUndo(target)) return;
    if (act(`Ctrl+${event.shiftKey ? 'Shift+' : ''}${key.toUpperCase()}`, event.shiftKey)) event.preventDefault();
  });
}
