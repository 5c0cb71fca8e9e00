/** How edits by hand change the state of a block. The block that is shown follows them: its view is made of the edits that it has. */
import { remember } from '../../shared/state/remember';
import { NO_HISTORY, recorded, wentTo } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { addedPoints } from './added';
import { placesSetAside } from './aside';
import { carriedOver, NO_PLACES_AGAIN } from './carrying';
import type { CarriedOver } from './carrying';
import { choiceAfterEdit, indexOfSource } from './edits';
import type { EditStep } from './edits';
import { nameOfStep, namesOf, NO_NAMES, withoutPlaces } from './naming';
import type { Names } from './naming';
import { pointsOf } from './selection';
import type { Choice } from './selection';
import { withRemoved } from './removing';
import { figuresOf, UNEDITED } from './edited';
import { choiceOfDraft, nameOfDraft, stepOfDraft } from './draft';
import { withFrames } from './framing';
import { awaitedOf, formerOf, nameOfTiePoints, placesBefore, wayBack, withFormer } from './former';
import type { Awaiting, Former } from './former';
import type { Draft, Edits } from './edited';
import type { BlockEdit, PlaceAgain } from '../../../pkg/wasm/tiepoint.js';
import { besideEdits, isFramesStep } from './marks';
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
  /** What is placed of the point that is measured is taken; `leaves`: the user goes on to something else, so that it is said. */
  | { type: 'accept'; leaves: boolean }
  /** Measurements of control points are taken, or taken away, or images taken out, or made of scans. */
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
      return { ...state, ...withStep(state, action.edits), draft: null, notice: afterEdit(state) };
    case 'goto':
      if (!isEditable(state)) return state;
      return { ...state, history: wentTo(state.history, action.done), draft: null, notice: afterEdit(state) };
    case 'adjusting':
      return { ...state, adjusting: action.adjusting };
    case 'edited':
      return state.shown === null ? state : withEdited(state, state.shown, action.view, action.edits);
    case 'editRefused': {
      const notice = { kind: 'problem', text: say('the-edit-was-not-made', { reason: action.reason }) } as const;
      return { ...state, ...refused(state), notice };
    }
    case 'mark':
      if (action.step.kind !== 'remove' && !isFramesStep(action.step) && !isEditable(state)) return state;
      return withSteps(state, recorded(state.marks, action.step));
    case 'gotoMark':
      return withSteps(state, wentTo(state.marks, action.done));
    case 'accept':
      return accepted(state, action.leaves);
    case 'draft':
      // What was said of the draft goes with it.
      return { ...state, draft: isEditable(state) ? action.draft : null, notice: action.draft === null && state.notice?.beside === true ? null : state.notice };
  }
}

/** The state with what is placed of the measured point; where that is too little for a point, it is still measured, or given up by who leaves it. */
function accepted(state: BlockState, leaves: boolean): BlockState {
  const { draft, shown, history } = state;
  if (draft === null || shown === null) return state;
  const names = shown.view.images.map(({ name }) => name);
  const step = stepOfDraft(draft, names, history.done, addedPoints(editsInForce(history), shown.view.givenControl));
  const taken = step === null ? state : reduceEdits(state, step);
  if (!leaves) return taken;
  if (taken === state) return { ...state, draft: null };
  return {
    ...taken,
    notice: taken.notice ?? {
      kind: 'info',
      text: say('accepted-as-placed', { name: nameOfDraft(draft, shown.view), images: draft.places.size }),
      beside: true,
    },
  };
}

/** The state after other steps beside the edits. */
function withSteps(state: BlockState, marks: History<MarkStep>): BlockState {
  return withRemoved(withFrames({ ...state, marks, draft: null, notice: afterEdit(state) }, state.marks.done));
}

/** What is under way is still said. */
function afterEdit({ notice }: BlockState): BlockState['notice'] {
  return notice?.kind === 'busy' ? notice : null;
}

/** A history without the step that was refused after those that made some edits: what was to follow it is still to be tried, and what was undone can be done again. */
export function withoutRefused(history: History<EditStep>, made: readonly BlockEdit[]): History<EditStep> {
  const { edits, done } = history;
  const kept = stepsOf(history, made);
  if (kept.some((step, i) => step !== edits[i])) return { edits: kept, done: kept.length };
  if (kept.length >= done) return { edits, done: kept.length };
  return { edits: edits.filter((_, i) => i !== kept.length), done: done - 1 };
}

/** The state without the step that was refused. */
function refused(state: BlockState): Pick<BlockState, 'history' | 'marks'> {
  const history = withoutRefused(state.history, state.shown?.edits ?? []);
  const gone = state.history.edits.findIndex((step, i) => step !== history.edits[i]);
  const place = (after: number) => Math.min(history.edits.length, gone < 0 || after <= gone ? after : after - 1);
  return { history, marks: besideEdits(state.marks, place) };
}

/** The state after one more step. */
function withStep({ history, marks }: BlockState, step: EditStep): Pick<BlockState, 'history' | 'marks'> {
  const after = recorded(history, step);
  // What was undone beside it is done again after it, and undone before it.
  return { history: after, marks: besideEdits(marks, (place, at) => (at < marks.done ? place : Math.max(place, after.done))) };
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
  const { selection, draft } = state;
  const added = edits.length > shown.edits.length ? (newPoint(edits, view) ?? takenIn(selection.chosen, view)) : null;
  const next = added ?? choiceAfterEdit(selection.chosen, shown.view, view);
  const measured = draft === null ? null : choiceOfDraft(draft, view);
  // What is measured meanwhile is the chosen one.
  const chosen = measured?.kind === 'point' && !pointsOf(next).includes(measured.point) ? measured : next;
  return { ...state, shown: { ...shown, view, edits }, before: figuresOf(shown.view), selection: { ...selection, chosen, pointed: null } };
}

/** The point that the last edit added. */
function newPoint(edits: readonly BlockEdit[], view: BlockView): Choice | null {
  if (edits.at(-1)?.kind !== 'add_point') return null;
  const point = indexOfSource(view, { manual: edits.filter(({ kind }) => kind === 'add_point').length - 1 });
  return point < 0 ? null : { kind: 'point', point };
}

/** A point beside the block that is chosen and is in it now. */
function takenIn(chosen: Choice | null, { surveyed }: BlockView): Choice | null {
  const point = chosen?.kind === 'given' ? (surveyed.find(({ name }) => name === chosen.name)?.point ?? -1) : -1;
  return point < 0 ? null : { kind: 'point', point };
}

const NOTHING_CARRIED: CarriedOver = { history: NO_HISTORY, left: [0], lost: 0, places: NO_PLACES_AGAIN, aside: [] };

type Carried = Pick<BlockState, keyof Edits | 'marks'>;

/**
 * The edits of a block that was found anew, of what the former one had, with the steps beside them; `said`: what became of them. All hold where its tie
 * points are those of the former one; where they are again those of one before it, and nothing was edited since, it has the edits of that.
 */
export function carried(state: BlockState, view: BlockView): { edits: Carried; said: string } {
  const { history, marks, shown, former } = state;
  if (shown === null || (history.edits.length === 0 && former.length === 0)) return keptOf(NOTHING_CARRIED, marks, NO_NAMES);
  const after = nameOfTiePoints(view);
  const way = shown.tiePoints === after ? [] : wayBack(former, after, history);
  const [last] = way.slice(-1);
  if (last !== undefined) {
    const back = way.reduce((steps, one) => marksBefore(one, steps), marks);
    // Places of an orthophoto that it lay on are no points of the block that was found.
    const regained = carriedOver(last.history, last.names, namesOf(view), true);
    if (regained.lost + regained.aside.length > 0 || last.names.givenControl !== view.givenControl) {
      const { edits, said, ofPlaces } = keptMeanwhile(regained, back, last.names);
      const places = back.edits.map((step) => step.after);
      const awaiting = { ...last, kept: regained.history, left: regained.left, places, sameTiePoints: true, ofPlaces };
      return { edits: { ...edits, former, awaiting }, said };
    }
    return { edits: { ...UNEDITED, former, history: last.history, marks: back }, said: saidOfKept(last.history) };
  }
  // Edits that still wait are carried on, with all that they had when they began to.
  const waiting = awaitedOf(state);
  const now = { tiePoints: shown.tiePoints, names: namesOf(shown.found), history, spots: shown.ground?.places ?? null };
  const { tiePoints, names, history: steps, spots } = waiting ?? now;
  const beside = waiting === null ? marks : marksBefore(waiting, marks);
  const isSame = tiePoints === after;
  const found = carriedOver(steps, names, namesOf(view), isSame);
  if (isSame && found.lost + found.aside.length === 0 && names.givenControl === view.givenControl)
    return { edits: { ...UNEDITED, former, history: steps, marks: beside }, said: saidOfKept(steps) };
  const { edits, said, ofPlaces } = keptMeanwhile(found, beside, names);
  const places = beside.edits.map((step) => step.after);
  const one = { tiePoints, names, history: steps, kept: found.history, left: found.left, places, spots };
  return { edits: { ...edits, former: tiePoints === '' ? [] : withFormer(former, one), awaiting: { ...one, sameTiePoints: isSame, ofPlaces } }, said };
}

/** What is kept until the block lies on the orthophoto: whether places lie again is known only then. `ofPlaces`: so many edits wait for it. */
function keptMeanwhile(found: CarriedOver, marks: BlockState['marks'], names: Names): { edits: Carried; said: string; ofPlaces: number } {
  const ofPlaces = found.places.edits;
  const { edits, said } = keptOf({ ...found, places: { ...NO_PLACES_AGAIN, edits: ofPlaces } }, marks, names);
  const saidOfPlaces = ofPlaces === 0 ? '' : say('edits-of-places-wait', { edits: ofPlaces });
  return { edits, said: [said, saidOfPlaces].filter((part) => part !== '').join(' '), ofPlaces };
}

/** What waits of the block that was kept: its latest edits, where it does not lie on the orthophoto yet that they are of. */
export function awaitingAgain(former: readonly Former[], history: History<EditStep>, shown: { tiePoints: string; ground: unknown } | null): Awaiting | null {
  const last = former.at(-1);
  if (last === undefined || last.spots === null || shown === null || shown.ground !== null) return null;
  if (last.kept.edits !== history.edits || last.kept.done !== history.done) return null;
  const ofPlaces = editsInForce(last.history).length - editsInForce(history).length;
  return { ...last, sameTiePoints: last.tiePoints === shown.tiePoints, ofPlaces: Math.max(0, ofPlaces) };
}

function saidOfKept(history: History<EditStep>): string {
  const held = editsInForce(history).length;
  return held === 0 ? '' : say('by-hand-kept', { edits: held });
}

/**
 * The same of a block whose tie points are those of the former one, in another system: only places of an orthophoto are others. `isOff`: it was taken off the
 * orthophoto, into whose system places by hand would bring it again. `again`: which places lie where they lay.
 */
export function carriedToGround(state: BlockState, view: BlockView, isOff: boolean, again: readonly PlaceAgain[]): { edits: Carried; said: string } {
  const awaited = isOff ? null : awaitedOf(state);
  if (awaited !== null) return arrived(awaited, state, view, again);
  const { history, marks, shown, former } = state;
  // What was edited before it lay there is not written over: edits of places that waited are gone.
  const gone = isOff ? 0 : (state.awaiting?.ofPlaces ?? 0);
  const saidOfGone = gone === 0 ? '' : say('of-points-of-the-former', { lost: gone });
  const names = shown === null ? NO_NAMES : namesOf(shown.found);
  // Points that were added have other numbers behind others.
  const isSame = names.givenControl === view.givenControl && withoutPlaces(names).surveyed.size === names.surveyed.size;
  const found = isSame ? allCarried(history) : carriedOver(history, names, withoutPlaces(namesOf(view)), true, again);
  const { history: left, left: places, aside } = isOff ? placesSetAside(found.history, view.givenControl) : { ...allCarried(found.history), aside: 0 };
  if (isSame && aside === 0) return { edits: { ...UNEDITED, former, history, marks }, said: saidOfGone };
  // Off it nothing can lie again.
  const ofPlaces = isOff ? NO_PLACES_AGAIN : found.places;
  const now = { ...found, places: ofPlaces, history: left, left: found.left.map((count) => places[count] ?? left.edits.length) };
  const { edits, said } = keptOf(now, marks, names);
  return {
    edits: { ...edits, former: formerOf(former, history, now.history, now.left) },
    said: [said, saidOfGone, aside === 0 ? '' : say('places-set-aside', { steps: aside })].filter((part) => part !== '').join(' '),
  };
}

/** The same of a block that was found anew: its edits are made of all that the one before it had, so that all that is lost is said. */
function arrived(awaited: Awaiting, { marks, former }: BlockState, view: BlockView, again: readonly PlaceAgain[]): { edits: Carried; said: string } {
  const { history, names, sameTiePoints } = awaited;
  const found = carriedOver(history, names, withoutPlaces(namesOf(view)), sameTiePoints, again);
  const { edits, said } = keptOf(found, marksBefore(awaited, marks), names);
  const ofIt = former.map((one) => (one.history === history ? { ...one, kept: found.history, left: found.left } : one));
  return { edits: { ...edits, former: sameTiePoints ? formerOf(former, history, found.history, found.left) : ofIt }, said };
}

/** The steps beside the edits of a former block, at their places among these. */
function marksBefore(former: Former, marks: BlockState['marks']): BlockState['marks'] {
  const places = placesBefore(former, marks.edits);
  return besideEdits(marks, (after, at) => places[at] ?? after);
}

function allCarried(history: History<EditStep>): CarriedOver {
  return { history, left: [...history.edits.keys(), history.edits.length], lost: 0, places: NO_PLACES_AGAIN, aside: [] };
}

/** So many steps are named. */
const MOST_NAMED = 3;

function keptOf({ history, left, lost: ofAll, places, aside }: CarriedOver, marks: BlockState['marks'], names: Names): { edits: Carried; said: string } {
  const named = aside.slice(0, MOST_NAMED).map((step) => nameOfStep(step, names));
  const steps = [...named, ...(aside.length > MOST_NAMED ? ['…'] : [])].join(', ');
  // Of places it is said how many.
  const lost = ofAll - places.edits;
  const said = [
    saidOfKept(history),
    lost === 0 ? '' : say('of-points-of-the-former', { lost }),
    places.held + places.lost === 0 ? '' : say('edits-of-places', { held: places.held, lost: places.lost }),
    aside.length === 0 ? '' : say('cannot-be-done-again', { undone: aside.length, steps }),
  ];
  const moved = besideEdits(marks, (after) => left[after] ?? history.edits.length);
  return { edits: { ...UNEDITED, history, marks: moved }, said: said.filter((part) => part !== '').join(' ') };
}
