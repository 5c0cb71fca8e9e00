/** What is done to the matches by hand: reject, restore, undo, redo, and what became of the orientation. */
import { button, byId, fill, h, row } from '../../shared/panel/dom';
import { declare } from '../../shared/view/commands';
import type { Command } from '../../shared/view/commands';
import { listenKeys } from '../../shared/view/gestures';
import { count, decimalsOfError, fixed } from '../../shared/text/format';
import type { OrientedPair } from '../../shared/crate';
import { chosenLefts, editOfChoice, lackOfBegun, lackOfEdit, lackOfMatches, lackOfSelected, notListed } from '../state/choice';
import { moving, nameOfStep, stepsWithDraft } from '../state/draft';
import { comparedEdit } from '../state/compared';
import { editedPair } from '../state/edited';
import { marksHaveKeys } from './marking';
import type { Editing } from '../state/editing';
import { steps } from '../../shared/state/history';
import { hasKeys, REDO_KEYS, set, showSteps, UNDO_KEYS, undoKeys } from '../../shared/panel/history';
import { declareLack } from '../../shared/panel/lack';
import { NotListed } from '../../shared/panel/not-listed';
import type { Sorting } from '../state/edits';
import { interiorInUse } from '../state/interior';
import { countsOf, pixelMm } from '../state/residuals';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { UNKNOWNS } from './unknowns';
import { say } from '../../shared/text/words';

/** How many matches an edit is about, where it is more than one. */
function several(edit: Sorting | null): string {
  return edit !== null && edit.of.length > 1 ? ` ${count(edit.of.length)}` : '';
}

/** What the buttons of edits lack that do nothing as things are. */
function sayLacks(store: Store, reject: HTMLElement, restore: HTMLElement): void {
  declareLack([reject], () => lackOfEdit(store.state, 'reject'));
  declareLack([restore], () => lackOfEdit(store.state, 'restore'));
}

/** In the panel of the matches. `follow` shows the points that are measured, where the keyboard then is. */
export function mountEdits(host: HTMLElement, store: Store, editing: Editing, follow: () => void): void {
  const reject = button(say('reject'), 'reject', () => editing.edit('reject'), say('take-the-chosen-matches-out'));
  const restore = button(say('restore'), 'restore', () => editing.edit('restore'), say('use-the-chosen-matches-again'));
  const move = button(
    say('move'),
    'move',
    () => {
      editing.move();
      follow();
    },
    say('measure-the-selected-match-anew'),
  );
  const undo = button(say('undo'), 'undo', () => editing.step(-1), say('take-back-the-last-edit'));
  const redo = button(say('redo'), 'redo', () => editing.step(1), say('make-the-edit-again-that'));
  sayLacks(store, reject, restore);
  declareLack([move], () => lackOfSelected(store.state));
  hasKeys(undo, UNDO_KEYS);
  hasKeys(redo, REDO_KEYS);
  const others = new NotListed('not-listed', [reject, restore]);
  const hint = h('p', { class: 'note', testid: 'edit-hint' }, say('to-reject-wrong-matches-choose'));
  const compared = h('div', { testid: 'edit-compared', role: 'status' });
  const panel = h('section', { class: 'edits', testid: 'edits', aria: { label: say('edits-by-hand') } });
  panel.append(h('div', { class: 'buttons' }, reject, restore, move, undo, redo), others.element, hint, compared);
  host.append(panel);
  store.watch(
    (s) => [s.results, s.history, s.draft, s.chosen, s.filter, s.selection, s.before, s.images, s.settings, s.camera, s.photos, s.failures] as const,
    () => {
      const { state } = store;
      panel.hidden = editedPair(state) === null;
      const [off, on] = [editOfChoice(state, 'reject'), editOfChoice(state, 'restore')];
      set(reject, `${say('reject')}${several(off)}`, off === null);
      set(restore, `${say('restore')}${several(on)}`, on === null);
      others.show(notListed(state));
      move.disabled = moving(state) === null;
      const { edits } = state.history;
      const names = steps(stepsWithDraft(state), nameOfStep);
      set(undo, names.undo === null ? say('undo') : say('undo-3', { undo: names.undo }), names.undo === null);
      set(redo, names.redo === null ? say('redo') : say('redo-3', { redo: names.redo }), names.redo === null);
      undo.hidden = edits.length === 0 && state.draft === null;
      redo.hidden = names.redo === null;
      hint.hidden = edits.length > 0 || chosenLefts(state).length > 0;
      fill(compared, ...comparison(state));
    },
  );
}

const ANGLES = ['omega_deg', 'phi_deg', 'kappa_deg'] as const;

/** The figures of the orientation before the latest edit and now. */
function comparison(state: State): HTMLElement[] {
  const compared = comparedEdit(state);
  if (compared === null) return [];
  const { before, now, comes } = compared;
  const interior = interiorInUse(state)?.left;
  const pixel = interior === undefined ? NaN : pixelMm(interior);
  const used = (of: OrientedPair) => count(countsOf(of).used);
  const sigma = ({ sigma0_mm }: OrientedPair) => fixed(sigma0_mm === null ? null : sigma0_mm / pixel, 3);
  const error = (field: (typeof ANGLES)[number]) => (of: OrientedPair) => {
    const own = (of.total_standard_errors ?? of.standard_errors)?.[field];
    return fixed(own, decimalsOfError(own, 4));
  };
  const line = (name: string, testid: string, text: (of: OrientedPair) => string) =>
    row(
      name,
      h('td', { class: 'number', testid: `${testid}-before` }, text(before)),
      h('td', { class: 'number', testid: `${testid}-now` }, now === null ? (comes ? '…' : '–') : text(now)),
    );
  const head = h('tr', {}, h('th', { scope: 'col' }, say('orientation')), h('th', { scope: 'col' }, say('before')), h('th', { scope: 'col' }, say('now-2')));
  const angles = ANGLES.map((field) => {
    const symbol = UNKNOWNS.find((unknown) => unknown.field === field)?.symbol ?? field;
    return line(say('standard-error-of-4', { symbol }), `compared-${field}`, error(field));
  });
  const body = h('tbody', {}, line('σ₀, px', 'compared-sigma0', sigma), line(say('points-used'), 'compared-points', used), ...angles);
  return [h('table', { class: 'tight', aria: { label: say('orientation-before-and-after-the') } }, h('thead', {}, head), body)];
}

/** With the pictures: the tool that chooses, undo and redo; in the bar itself, which is always in sight, what is done to the choice. */
export function mountEditTools(host: HTMLElement, bar: HTMLElement, store: Store, editing: Editing): void {
  const choose = button(say('choose'), 'tool-choose', () => editing.toggle('choose'));
  choose.title = say('choose-matches-by-a-rectangle');
  const undo = button(say('undo-sign'), 'tool-undo', () => editing.step(-1));
  const redo = button(say('redo-sign'), 'tool-redo', () => editing.step(1));
  const reject = button(say('reject'), 'tool-reject', () => editing.edit('reject'), say('take-the-chosen-matches-out'));
  const restore = button(say('restore'), 'tool-restore', () => editing.edit('restore'), say('use-the-chosen-matches-again'));
  declareLack([choose], () => lackOfMatches(store.state));
  sayLacks(store, reject, restore);
  host.append(h('span', { class: 'divider' }), choose, undo, redo);
  const others = new NotListed('tool-not-listed', [reject, restore]);
  bar.append(reject, restore, others.element);
  store.watch(
    (s) => [s.tool, s.history, s.draft, s.chosen, s.filter, s.selection, s.results] as const,
    () => {
      const { state } = store;
      choose.setAttribute('aria-pressed', String(state.tool === 'choose'));
      choose.disabled = editedPair(state) === null;
      byId('view').dataset.tool = state.tool;
      const [off, on] = [editOfChoice(state, 'reject'), editOfChoice(state, 'restore')];
      set(reject, `${say('reject')}${several(off)}`, off === null);
      set(restore, `${say('restore')}${several(on)}`, on === null);
      // They are there for who chooses, and for nobody else.
      reject.hidden = state.tool !== 'choose' && state.chosen.length === 0;
      restore.hidden = reject.hidden || on === null;
      others.show(reject.hidden ? 0 : notListed(state));
      showSteps(undo, redo, stepsWithDraft(state), nameOfStep);
    },
  );
}

/** Whether there is something to take back, or to make again. */
const hasSteps = ({ history, draft }: State): boolean => history.edits.length > 0 || draft !== null;

/** Undo and redo by their keys, wherever the keyboard is but in a field that has an undo of its own; the others in the list of matches. */
export function mountEditKeys(list: HTMLElement, store: Store, editing: Editing, follow: () => void): void {
  undoKeys(
    // Where the pair is what is shown.
    () => byId('view').offsetParent !== null && hasSteps(store.state) && store.state.tool !== 'mask' && !marksHaveKeys(store.state),
    (by) => editing.step(by),
  );
  const move = () => {
    editing.move();
    follow();
  };
  const keys: Command[] = [
    {
      keys: ['Delete', 'Backspace'],
      does: say('rejects-the-chosen-matches'),
      lacks: () => lackOfEdit(store.state, 'reject'),
      run: () => editing.edit('reject'),
    },
    { keys: ['r'], does: say('restores-the-chosen-matches'), lacks: () => lackOfEdit(store.state, 'restore'), run: () => editing.edit('restore') },
    { keys: ['x'], does: say('chooses-the-selected-match-beside'), lacks: () => lackOfSelected(store.state), run: () => editing.choose(store.state.selection) },
    { keys: ['e'], does: say('measures-the-selected-match-anew'), lacks: () => lackOfSelected(store.state), run: move },
    { keys: ['Escape'], does: say('gives-up'), lacks: () => lackOfBegun(store.state), run: () => void editing.leave() },
  ];
  listenKeys(list, declare({ where: say('list-of-matches'), host: list, list: keys }));
}
