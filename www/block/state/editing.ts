/** How edits by hand change the state of a block. The block that is shown follows them: its view is made of the edits that it has. */
import { remember } from '../../shared/state/remember';
import { recorded, wentTo } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { carriedOver } from './carrying';
import { choiceAfterEdit, indexOfSource } from './edits';
import type { EditStep } from './edits';
import { namesOf, NO_NAMES, withoutPlaces } from './naming';
import type { Choice } from './selection';
import { withRemoved } from './removing';
import { figuresOf, UNEDITED } from './edited';
import type { Draft, Edits } from './edited';
import type { BlockEdit } from '../../../pkg/wasm/tiepoint.js';
import type { MarkStep } from './marks';
import type { BlockState, Shown } from './state';
import type { BlockView } from './view';
import { say } from '../../shared/text/words';

export type EditsAction =
  | { type: 'edit'; edits: readonly BlockEdit[] }
  /** So many edits hold. */
  | { type: 'goto'; done: number }
  | { type: 'adjusting'; adjusting: boolean }
  /** The block was adjusted with these edits. */
  | { type: 'edited'; view: BlockView; edits: readonly BlockEdit[] }
  /** The block cannot be with all edits: those that it has stay. */
  | { type: 'editRefused'; reason: string }
  | { type: 'draft'; draft: Draft | null }
  /** Measurements of control points are taken, or taken away, or images taken out. */
  | { type: 'mark'; step: MarkStep }
  /** So many of these steps hold. */
  | { type: 'gotoMark'; done: number };

/** Whether the block on the screen can be edited. */
export function isEditable({ shown, running }: Pick<BlockState, 'shown' | 'running'>): boolean {
  return shown !== null && !shown.view.partial && shown.view.oriented > 0 && running.kind !== 'yes';
}

/** The edits of the steps that hold. */
export const editsInForce = remember(({ edits, done }: History<EditStep>): readonly BlockEdit[] => edits.slice(0, done).flat());

/** The next state on the way from some edits to those that hold; `single`: no more than a step farther. */
export function nextEdits(history: History<EditStep>, now: readonly BlockEdit[], single: boolean): { edits: readonly BlockEdit[]; several: boolean } {
  const wanted = editsInForce(history);
  let count = 0;
  const at = history.edits.findIndex((step) => {
    if (count === now.length) return true;
    count += step.length;
    return false;
  });
  const extends_ = at >= 0 && isSameList(wanted.slice(0, now.length), now);
  const several = extends_ && history.done > at + 1;
  return { edits: several && single ? history.edits.slice(0, at + 1).flat() : wanted, several };
}

export function isSameList(a: readonly BlockEdit[], b: readonly BlockEdit[]): boolean {
  return a === b || (a.length === b.length && a.every((edit, i) => edit === b[i]));
}

export function reduceEdits(state: BlockState, action: EditsAction): BlockState {
  switch (action.type) {
    case 'edit':
      if (!isEditable(state)) return state;
      return { ...state, history: recorded(state.history, action.edits), draft: null, notice: afterEdit(state) };
    case 'goto':
      if (!isEditable(state)) return state;
      return { ...state, history: wentTo(state.history, action.done), draft: null, notice: afterEdit(state) };
    case 'adjusting':
      return { ...state, adjusting: action.adjusting };
    case 'edited':
      return state.shown === null ? state : withEdited(state, state.shown, action.view, action.edits);
    case 'editRefused': {
      const notice = { kind: 'problem', text: say('the-edit-was-not-made', { reason: action.reason }) } as const;
      return { ...state, history: withoutRefused(state.history, state.shown?.edits ?? []), notice };
    }
    case 'mark':
      if (action.step.kind !== 'remove' && !isEditable(state)) return state;
      return withRemoved({ ...state, marks: recorded(state.marks, action.step), draft: null, notice: afterEdit(state) });
    case 'gotoMark':
      return withRemoved({ ...state, marks: wentTo(state.marks, action.done), draft: null, notice: afterEdit(state) });
    case 'draft':
      // What was said of the draft goes with it.
      return { ...state, draft: isEditable(state) ? action.draft : null, notice: action.draft === null && state.notice?.beside === true ? null : state.notice };
  }
}

/** What is under way is still said. */
function afterEdit({ notice }: BlockState): BlockState['notice'] {
  return notice?.kind === 'busy' ? notice : null;
}

/** A history without the step that was refused after those that made some edits: what was to follow it is still to be tried. */
export function withoutRefused(history: History<EditStep>, made: readonly BlockEdit[]): History<EditStep> {
  const kept = stepsOf(history, made);
  const extends_ = kept.length < history.done && kept.every((step, i) => step === history.edits[i]);
  const later = extends_ ? history.edits.slice(kept.length + 1, history.done) : [];
  return { edits: [...kept, ...later], done: kept.length + later.length };
}

/** The steps of a history that made some edits; what else there is of them is a step each. */
export function stepsOf({ edits: steps }: History<EditStep>, edits: readonly BlockEdit[]): readonly EditStep[] {
  let count = 0;
  const kept = steps.filter((step) => {
    const stays = count + step.length <= edits.length && step.every((edit, i) => edit === edits[count + i]);
    // What comes after a step that is not among them was made of it.
    count = stays ? count + step.length : Infinity;
    return stays;
  });
  return [...kept, ...edits.slice(kept.flat().length).map((edit) => [edit])];
}

function withEdited(state: BlockState, shown: Shown, view: BlockView, edits: readonly BlockEdit[]): BlockState {
  const { selection } = state;
  const added = edits.length > shown.edits.length ? newPoint(edits, view) : null;
  return {
    ...state,
    shown: { ...shown, view, edits },
    before: figuresOf(shown.view),
    selection: { ...selection, chosen: added ?? choiceAfterEdit(selection.chosen, shown.view, view), pointed: null },
  };
}

/** The point that the last edit added. */
function newPoint(edits: readonly BlockEdit[], view: BlockView): Choice | null {
  if (edits.at(-1)?.kind !== 'add_point') return null;
  const point = indexOfSource(view, { manual: edits.filter(({ kind }) => kind === 'add_point').length - 1 });
  return point < 0 ? null : { kind: 'point', point };
}

/** The edits of a block that was found anew, of what the former one had; `said`: what became of them. */
export function carried({ history, shown }: BlockState, view: BlockView): { edits: Edits; said: string } {
  const before = editsInForce(history);
  if (before.length === 0 || shown === null) return { edits: UNEDITED, said: '' };
  return keptOf(before, carriedOver(before, namesOf(shown.found), namesOf(view)));
}

/** The same of a block whose tie points are those of the former one, in another system: only places of an orthophoto are others. */
export function carriedToGround({ history, shown }: BlockState, view: BlockView): { edits: Edits; said: string } {
  const names = shown === null ? NO_NAMES : namesOf(shown.found);
  if (withoutPlaces(names).surveyed.size === names.surveyed.size) return { edits: { ...UNEDITED, history }, said: '' };
  const before = editsInForce(history);
  if (before.length === 0) return { edits: UNEDITED, said: '' };
  return keptOf(before, carriedOver(before, names, withoutPlaces(namesOf(view)), true));
}

function keptOf(before: readonly BlockEdit[], edits: readonly BlockEdit[]): { edits: Edits; said: string } {
  const lost = before.length - edits.length;
  const said = [edits.length === 0 ? '' : say('by-hand-kept', { edits: edits.length }), lost === 0 ? '' : say('of-points-of-the-former', { lost })];
  return { edits: { ...UNEDITED, history: { edits: edits.map((edit) => [edit]), done: edits.length } }, said: said.filter((part) => part !== '').join(' ') };
}
