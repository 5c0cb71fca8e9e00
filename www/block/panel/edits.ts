import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { isEditable } from '../state/editing';
import { editOfChoice, standingOf } from '../state/edits';
import { framesOthers } from '../state/framing';
import { listedChoice } from '../state/listed';
import { withoutLast } from '../state/draft';
import { addedPoints } from '../state/added';
import { remember } from '../../shared/state/remember';
import { nameOfMarks, nameOfStep, namesOf, NO_NAMES } from '../state/naming';
import type { BlockEdit } from '../../../pkg/wasm/tiepoint.js';
import type { EditStep } from '../state/edits';
import type { Names } from '../state/naming';
import { removesOthers } from '../state/removing';
import { heldAt, timelineOf } from '../state/timeline';
import type { Held, TimedStep } from '../state/timeline';
import { isBusy } from '../state/state';
import type { BlockState } from '../state/state';
import type { Choice } from '../state/selection';
import type { BlockView } from '../state/view';
import { say } from '../../shared/text/words';

/** What is chosen and listed, which is what an edit is about; null where nothing is. */
export function chosenOf({ selection, shown }: BlockState, facts: Facts): Choice | null {
  return shown === null ? null : listedChoice(selection, shown.view, () => facts.observations()).choice;
}

/** What an edit of the choice would be; null where it cannot be made. */
export function editOf(state: BlockState, facts: Facts, kind: 'reject' | 'restore', whole = false): BlockEdit | null {
  const { shown } = state;
  return shown === null ? null : editOfChoice(kind, chosenOf(state, facts), shown.view, standingOf(shown.edits), whole);
}

/** Makes an edit, where there is one and nothing runs. */
export function makeEdit(store: BlockStore, edit: BlockEdit | null): void {
  if (edit === null) return;
  if (store.state.running.kind === 'yes') store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('edits-wait-for-the-run'), beside: true } });
  else store.dispatch({ type: 'edit', edits: [edit] });
}

/** Undoes the last step, or redoes the next; of a point that is being measured its latest place is taken back first. */
export function stepBy(store: BlockStore, by: 1 | -1): void {
  if (store.state.draft !== null) {
    if (by < 0) store.dispatch({ type: 'draft', draft: withoutLast(store.state.draft) });
    return;
  }
  goTo(store, heldAt(store.state, timelineOf(store.state).done + by));
}

/** Goes to where so many edits and so many steps beside them hold. */
export function goTo(store: BlockStore, { edits, marks: steps }: Held): void {
  const { state } = store;
  if (edits !== state.history.done && !isEditable(state)) return;
  // The block is run for other images.
  const hasOthers = removesOthers(state.marks, { ...state.marks, done: steps }) || framesOthers(state.marks, steps);
  if (hasOthers && isBusy(state)) {
    store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('edits-wait-for-the-run'), beside: true } });
    return;
  }
  if (edits !== state.history.done) store.dispatch({ type: 'goto', done: edits });
  if (steps !== state.marks.done) store.dispatch({ type: 'gotoMark', done: steps });
}

/** What a step is called, of the edits or beside them. */
export function nameOfTimed({ history, marks }: Pick<BlockState, 'history' | 'marks'>, { of, at }: TimedStep, names: Names): string {
  const [edit, mark] = [history.edits[at], marks.edits[at]];
  if (of === 'edits') return edit === undefined ? '' : nameOfStep(edit, names);
  return mark === undefined ? '' : nameOfMarks(mark);
}

/** Of the block as it was found, and of the points that its edits add. */
export function namesIn({ shown, history }: BlockState): Names {
  return shown === null ? NO_NAMES : namedIn(shown.found, history.edits);
}

const namedIn = remember((found: BlockView, steps: readonly EditStep[]): Names => {
  const names = namesOf(found);
  const added = [...addedPoints(steps.flat(), found.givenControl).values()].map(({ edit, control }): [number, string] => [control, edit.name]);
  return added.length === 0 ? names : { ...names, surveyed: new Map([...names.surveyed, ...added]) };
});
