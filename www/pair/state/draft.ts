/** A match that is measured by hand: where it lies so far, and where its other point may be. */
import { movedWith, NEIGHBOURS, onLine } from '../../shared/state/neighbours';
import { recorded } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { remember } from '../../shared/state/remember';
import { say } from '../../shared/text/words';
import { BY_HAND, MATCHED } from './codes';
import { editedPair, placeOfLeft, targetOfLeft } from './edited';
import type { Edited } from './edited';
import { exchangedTarget, freshNumber, nameOfEdit } from './edits';
import type { Edit, Place } from './edits';
import { isCurrent } from './keys';
import { roundedPx } from '../../shared/state/pane';
import type { Position } from '../../shared/state/pane';
import { sizeOf } from './on-image';
import { leftIndexOf } from './selected';
import { otherSide } from './state';
import type { Draft, SeenAt, Side, State } from './state';

/** The places of a side, then of the other, of the matches nearest to a place; nearest first. */
function nearest({ match }: Edited, side: Side, [x, y]: Position): Place[] {
  const first = side === 'left' ? 0 : 2;
  const rows = Array.from({ length: match.matches.length / 5 }, (_, row) => {
    const [u = NaN, v = NaN] = match.matches.subarray(5 * row + first, 5 * row + first + 2);
    return { row, distance: (u - x) ** 2 + (v - y) ** 2 };
  });
  rows.sort((a, b) => a.distance - b.distance);
  return rows.slice(0, NEIGHBOURS).map(({ row }) => {
    const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = match.matches.subarray(5 * row, 5 * row + 4);
    return side === 'left' ? [xl, yl, xr, yr] : [xr, yr, xl, yl];
  });
}

/** Where the ground at a place of one image lies in the other, by the matches around it; null without matches. */
export function byNeighbours(edited: Edited, side: Side, at: Position): Position | null {
  return movedWith(nearest(edited, side, at), at);
}

const predicted = remember((edited: Edited, draft: Draft, line: SeenAt | null): Position | null => {
  const place = draft.places[otherSide(draft.side)];
  if (place === null) return null;
  const known: Position = [place[0], place[1]];
  const around = byNeighbours(edited, otherSide(draft.side), known);
  return around === null || line?.side !== draft.side ? around : onLine(line.positions, around);
});

/** Where the point that is placed now is expected: by the matches around it, on its epipolar line where one is known. */
export function expectedPlace(state: State): Position | null {
  const edited = editedPair(state);
  if (edited === null || state.draft === null) return null;
  return predicted(edited, state.draft, lineOfDraft(state));
}

/** Where the point may lie in the image in which it is placed now. */
export function lineOfDraft(state: State): SeenAt | null {
  return state.draft !== null && isCurrent(state, 'line') ? (state.results.line?.value ?? null) : null;
}

/** Where the match lies in an image: where it was placed, else where it is expected; null where neither is known. */
export function placeOfDraft(state: State, side: Side): Position | null {
  const { draft } = state;
  if (draft === null) return null;
  const own = draft.places[side];
  if (own !== null) return [own[0], own[1]];
  return side === draft.side ? expectedPlace(state) : null;
}

/** The draft with its point of a side at a place, within the image. */
export function placed(state: State, draft: Draft, side: Side, [x, y]: Position): Draft {
  const { width, height } = sizeOf(state, side) ?? { width: Infinity, height: Infinity };
  const at: Position = [roundedPx(Math.min(width, Math.max(0, x))), roundedPx(Math.min(height, Math.max(0, y)))];
  return { ...draft, places: { ...draft.places, [side]: at } };
}

/** A new match whose first point lies at a place of an image; its other point comes next. */
export function begun(state: State, side: Side, at: Position): Draft {
  const draft: Draft = { of: null, places: { left: null, right: null }, side };
  return { ...placed(state, draft, side, at), side: otherSide(side) };
}

/** The match of the selected point, to be moved; null where there is none. */
export function moving(state: State): Draft | null {
  const edited = editedPair(state);
  if (edited === null) return null;
  const left = leftIndexOf(state, edited.match.best, edited.match.rules);
  const target = left < 0 ? null : targetOfLeft(edited, left);
  const rule = edited.match.rules[left];
  if (target === null || (rule !== MATCHED && rule !== BY_HAND)) return null;
  const [xl, yl, xr, yr] = placeOfLeft(edited, left);
  return { of: target, places: { left: [xl, yl], right: [xr, yr] }, side: state.selection?.side === 'left' ? 'right' : (state.selection?.side ?? 'right') };
}

/** The draft of exchanged images. */
export function exchangedDraft({ of, places, side }: Draft): Draft {
  return { of: of === null ? null : exchangedTarget(of), places: { left: places.right, right: places.left }, side: otherSide(side) };
}

/** What is done of a match before it is accepted: a point of it. */
export const PLACE = 'place';

/** The steps as they are undone: while a match is measured its last point is the last of them, after which none can be made again. */
export function stepsWithDraft({ history, draft }: Pick<State, 'history' | 'draft'>): History<Edit | typeof PLACE> {
  return draft === null ? history : recorded<Edit | typeof PLACE>(history, PLACE);
}

/** What a step did, of a match that is measured, too. */
export const nameOfStep = (step: Edit | typeof PLACE): string => (step === PLACE ? say('step-of-draft') : nameOfEdit(step));

/** A new match without the point that was placed last; null where nothing of it is left, and of one that was there, which stays where it was. */
export function withoutPlace(draft: Draft): Draft | null {
  const { of, places, side } = draft;
  const placed = places[side] === null ? otherSide(side) : side;
  if (of !== null || places[otherSide(placed)] === null) return null;
  return { ...draft, places: { ...places, [placed]: null }, side: placed };
}

/** Whether the point that is placed now lies where it is expected: nobody has measured it yet. */
export function isPredicted(state: State): boolean {
  const { draft } = state;
  return draft !== null && draft.places[draft.side] === null && expectedPlace(state) !== null;
}

/** The edit that a draft becomes; null while a point of it is not measured: where it is expected the other matches say, and it would add nothing to them. */
export function editOfDraft(state: State): Edit | null {
  const { draft, history } = state;
  const [left, right] = [placeOfDraft(state, 'left'), placeOfDraft(state, 'right')];
  if (draft === null || left === null || right === null) return null;
  if (draft.of === null && (draft.places.left === null || draft.places.right === null)) return null;
  const at: Place = [roundedPx(left[0]), roundedPx(left[1]), roundedPx(right[0]), roundedPx(right[1])];
  if (draft.of === null) return { kind: 'add', id: freshNumber(history), at };
  // What was not moved stays to the last digit.
  const own = (k: 0 | 1, side: Side, value: number) => draft.places[side]?.[k] ?? value;
  return { kind: 'move', of: draft.of, to: [own(0, 'left', at[0]), own(1, 'left', at[1]), own(0, 'right', at[2]), own(1, 'right', at[3])] };
}
