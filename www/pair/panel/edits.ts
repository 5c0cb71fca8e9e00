/** What is done to the matches by hand: reject, restore, undo, redo, the history, and what became of the orientation. */
import { button, byId, fill, h, row } from '../../shared/panel/dom';
import { count, fixed } from '../../shared/text/format';
import type { OrientedPair } from '../../shared/crate';
import { chosenLefts, editOfChoice } from '../state/choice';
import { moving } from '../state/draft';
import { editedPair } from '../state/edited';
import type { Editing } from '../state/editing';
import { nameOfEdit } from '../state/edits';
import type { Sorting } from '../state/edits';
import { interiorInUse } from '../state/interior';
import { isCurrent } from '../state/keys';
import { pixelMm } from '../state/residuals';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { UNKNOWNS } from './unknowns';

/** The name of the edit that undo takes back, and of the one that redo makes again; null where there is none. */
function steps({ history: { edits, done } }: State): { undo: string | null; redo: string | null } {
  const [last, next] = [edits[done - 1], edits[done]];
  return { undo: last === undefined ? null : nameOfEdit(last), redo: next === undefined ? null : nameOfEdit(next) };
}

/** How many matches an edit is about, where it is more than one. */
function several(edit: Sorting | null): string {
  return edit !== null && edit.of.length > 1 ? ` ${count(edit.of.length)}` : '';
}

/** A button that says what it would do, and cannot be pressed where that is nothing. */
function set(made: HTMLButtonElement, text: string, disabled: boolean): void {
  if (made.textContent !== text) made.textContent = text;
  made.disabled = disabled;
}

/** In the panel of the matches. */
export function mountEdits(host: HTMLElement, store: Store, editing: Editing, follow: () => void): void {
  const reject = button('Reject', 'reject', () => editing.edit('reject'), 'Take the chosen matches out of the orientation (Delete)');
  const restore = button('Restore', 'restore', () => editing.edit('restore'), 'Use the chosen matches again (R)');
  const move = button(
    'Move',
    'move',
    () => {
      editing.move();
      follow();
    },
    'Measure the selected match anew, in either image (E)',
  );
  const undo = button('Undo', 'undo', () => editing.step(-1), 'Take back the last edit (Ctrl+Z)');
  const redo = button('Redo', 'redo', () => editing.step(1), 'Make the edit again that was undone (Ctrl+Shift+Z or Ctrl+Y)');
  const hint = h(
    'p',
    { class: 'note', testid: 'edit-hint' },
    'To reject wrong matches, choose them: press a row or a point, with Ctrl for more of them, or draw a rectangle in a picture with Shift. Then press Delete.',
  );
  const compared = h('div', { testid: 'edit-compared', role: 'status' });
  const history = h('ol', { class: 'history', testid: 'history' });
  const unfold = h('summary', {}, '');
  const details = h('details', { testid: 'history-section' }, unfold, history);
  const panel = h('section', { class: 'edits', testid: 'edits', aria: { label: 'Edits by hand' } });
  panel.append(h('div', { class: 'buttons' }, reject, restore, move, undo, redo), hint, compared, details);
  host.append(panel);
  store.watch(
    (s) => [s.results, s.history, s.chosen, s.selection, s.before, s.images] as const,
    () => {
      const { state } = store;
      panel.hidden = editedPair(state) === null;
      const [off, on] = [editOfChoice(state, 'reject'), editOfChoice(state, 'restore')];
      set(reject, `Reject${several(off)}`, off === null);
      set(restore, `Restore${several(on)}`, on === null);
      move.disabled = moving(state) === null;
      const { edits } = state.history;
      const names = steps(state);
      set(undo, names.undo === null ? 'Undo' : `Undo: ${names.undo}`, names.undo === null);
      set(redo, names.redo === null ? 'Redo' : `Redo: ${names.redo}`, names.redo === null);
      undo.hidden = edits.length === 0;
      redo.hidden = names.redo === null;
      hint.hidden = edits.length > 0 || chosenLefts(state).length > 0;
      details.hidden = edits.length === 0;
      unfold.textContent = `History: ${count(edits.length)} ${edits.length === 1 ? 'edit' : 'edits'}`;
      fill(compared, ...comparison(state));
    },
  );
  store.watch(['history'], () => showHistory(history, store.state, store));
}

/** Every state can be gone to by a press. */
function showHistory(host: HTMLElement, { history: { edits, done } }: State, store: Store): void {
  const focused = host.contains(document.activeElement);
  const entry = (place: number, name: string) => {
    const go = button(name, `history-${String(place)}`, () => store.dispatch({ type: 'goto', done: place }));
    go.className = 'link';
    if (place === done) go.setAttribute('aria-current', 'step');
    return h('li', { class: place > done ? 'undone' : '' }, go);
  };
  fill(host, entry(0, 'as matched'), ...edits.map((edit, i) => entry(i + 1, nameOfEdit(edit))));
  if (focused) host.querySelector<HTMLElement>('[aria-current]')?.focus({ preventScroll: true });
}

const ANGLES = ['omega_deg', 'phi_deg', 'kappa_deg'] as const;

/** The figures of the orientation before the latest edit and now. */
function comparison(state: State): HTMLElement[] {
  const { before, history } = state;
  if (history.edits.length === 0 || before === null) return [];
  const now = isCurrent(state, 'orientation') ? (state.results.orientation?.value ?? null) : null;
  const interior = interiorInUse(state)?.left;
  const pixel = interior === undefined ? NaN : pixelMm(interior);
  const used = ({ residuals_mm, rejected }: OrientedPair) => count(residuals_mm.length - rejected.length);
  const sigma = ({ sigma0_mm }: OrientedPair) => fixed(sigma0_mm === null ? null : sigma0_mm / pixel, 3);
  const error = (field: (typeof ANGLES)[number]) => (of: OrientedPair) => fixed((of.total_standard_errors ?? of.standard_errors)?.[field], 4);
  const line = (name: string, testid: string, text: (of: OrientedPair) => string) =>
    row(
      name,
      h('td', { class: 'number', testid: `${testid}-before` }, text(before)),
      h('td', { class: 'number', testid: `${testid}-now` }, now === null ? '…' : text(now)),
    );
  const head = h('tr', {}, h('th', { scope: 'col' }, 'Orientation'), h('th', { scope: 'col' }, 'before'), h('th', { scope: 'col' }, 'now'));
  const angles = ANGLES.map((field) => {
    const symbol = UNKNOWNS.find((unknown) => unknown.field === field)?.symbol ?? field;
    return line(`standard error of ${symbol}, °`, `compared-${field}`, error(field));
  });
  const body = h('tbody', {}, line('σ₀, px', 'compared-sigma0', sigma), line('points used', 'compared-points', used), ...angles);
  return [h('table', { class: 'tight', aria: { label: 'Orientation before and after the edit' } }, h('thead', {}, head), body)];
}

/** With the pictures: the tool that chooses, undo and redo; in the bar itself, which is always in sight, what is done to the choice. */
export function mountEditTools(host: HTMLElement, bar: HTMLElement, store: Store, editing: Editing): void {
  const choose = button('Choose', 'tool-choose', () => editing.toggle('choose'));
  choose.title = 'Choose matches by a rectangle, to reject or restore them (S; or Shift with a drag)';
  const undo = button('↶', 'tool-undo', () => editing.step(-1));
  const redo = button('↷', 'tool-redo', () => editing.step(1));
  const reject = button('Reject', 'tool-reject', () => editing.edit('reject'), 'Take the chosen matches out of the orientation (Delete)');
  const restore = button('Restore', 'tool-restore', () => editing.edit('restore'), 'Use the chosen matches again (R)');
  host.append(h('span', { class: 'divider' }), choose, undo, redo);
  bar.append(reject, restore);
  store.watch(
    (s) => [s.tool, s.history, s.chosen, s.selection, s.results.match] as const,
    () => {
      const { state } = store;
      choose.setAttribute('aria-pressed', String(state.tool === 'choose'));
      byId('view').dataset.tool = state.tool;
      const [off, on] = [editOfChoice(state, 'reject'), editOfChoice(state, 'restore')];
      set(reject, `Reject${several(off)}`, off === null);
      set(restore, `Restore${several(on)}`, on === null);
      // They are there for who chooses, and for nobody else.
      reject.hidden = state.tool !== 'choose' && state.chosen.length === 0;
      restore.hidden = reject.hidden || on === null;
      const names = steps(state);
      for (const [made, name, keys] of [
        [undo, names.undo === null ? 'Undo' : `Undo: ${names.undo}`, 'Ctrl+Z'],
        [redo, names.redo === null ? 'Redo' : `Redo: ${names.redo}`, 'Ctrl+Shift+Z'],
      ] as const) {
        made.title = `${name} (${keys})`;
        made.setAttribute('aria-label', name);
        made.hidden = state.history.edits.length === 0;
      }
      undo.disabled = names.undo === null;
      redo.disabled = names.redo === null;
    },
  );
}

/** Undo and redo by their keys, wherever the keyboard is but in a field that has an undo of its own; the others in the list of matches. */
export function mountEditKeys(list: HTMLElement, store: Store, editing: Editing): void {
  document.addEventListener('keydown', (event) => {
    const { target, key } = event;
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (target instanceof Element && target.closest('input, textarea, select, dialog') !== null)) return;
    // The pair is not what is shown.
    if (byId('view').offsetParent === null || store.state.history.edits.length === 0) return;
    const letter = key.toLowerCase();
    if (letter === 'z') editing.step(event.shiftKey ? 1 : -1);
    else if (letter === 'y') editing.step(1);
    else return;
    event.preventDefault();
  });
  list.addEventListener('keydown', (event) => {
    const { target, key } = event;
    if (event.ctrlKey || event.metaKey || event.altKey || (target instanceof Element && target.closest('input, select') !== null)) return;
    if (key === 'Delete' || key === 'Backspace') editing.edit('reject');
    else if (key === 'r' || key === 'R') editing.edit('restore');
    else if (key === 'x' || key === 'X') editing.choose(store.state.selection);
    else if (key === 'e' || key === 'E') editing.move();
    else if (key === 'Escape') editing.leave();
    else return;
    event.preventDefault();
  });
}
