/** A match that is measured by hand: where it lies so far, and where its other point may be. */
import { remember } from '../../shared/state/remember';
import { BY_HAND, MATCHED } from './codes';
import { editedPair, placeOfLeft, targetOfLeft } from './edited';
import type { Edited } from './edited';
import { freshNumber } from './edits';
import type { Edit, Place } from './edits';
import { isCurrent } from './keys';
import type { Position } from './selected';
import { leftIndexOf } from './selected';
import { otherSide } from './state';
import type { Draft, SeenAt, Side, State } from './state';

/** Matches around a place that say where it lies in the other image. */
const NEIGHBOURS = 12;
/** Fewer of them say only how far things move. */
const LEAST_OF_MAP = 6;

/** Places are kept to so many parts of a px: nobody measures better. */
const STEPS_OF_PX = 100;

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

/** The median of some values; NaN of none. */
function middle(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}

/** How one coordinate of the other image follows from a place, by least squares about the neighbours' middle; null where they lie along a line. */
function mapped(places: readonly Place[], at: Position, k: 2 | 3): number | null {
  const mean = (of: (place: Place) => number) => places.reduce((sum, place) => sum + of(place), 0) / places.length;
  const [mx, my, mv] = [mean((p) => p[0]), mean((p) => p[1]), mean((p) => p[k])];
  let [xx, xy, yy, xv, yv] = [0, 0, 0, 0, 0];
  for (const place of places) {
    const [x, y, v] = [place[0] - mx, place[1] - my, place[k] - mv];
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xv += x * v;
    yv += y * v;
  }
  const determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-3 * xx * yy)) return null;
  return mv + ((yy * xv - xy * yv) * (at[0] - mx) + (xx * yv - xy * xv) * (at[1] - my)) / determinant;
}

/** Where the ground at a place of one image lies in the other, by the matches around it; null without matches. */
export function byNeighbours(edited: Edited, side: Side, at: Position): Position | null {
  const places = nearest(edited, side, at);
  if (places.length === 0) return null;
  const [x, y] = places.length < LEAST_OF_MAP ? [null, null] : [mapped(places, at, 2), mapped(places, at, 3)];
  if (x !== null && y !== null) return [x, y];
  return [at[0] + middle(places.map((p) => p[2] - p[0])), at[1] + middle(places.map((p) => p[3] - p[1]))];
}

/** The place nearest to another one along a line of positions (stride 2); the one place where there is only one, and the same without any. */
export function onLine({ positions }: SeenAt, [x, y]: Position): Position {
  let best: [Position, number] | null = null;
  for (let i = 0; i + 3 < positions.length; i += 2) {
    const [ax = NaN, ay = NaN, bx = NaN, by = NaN] = positions.subarray(i, i + 4);
    const [dx, dy] = [bx - ax, by - ay];
    const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    const place: Position = [ax + share * dx, ay + share * dy];
    const distance = (place[0] - x) ** 2 + (place[1] - y) ** 2;
    if (best === null || distance < best[1]) best = [place, distance];
  }
  if (best !== null) return best[0];
  const [px, py] = positions;
  return px === undefined || py === undefined ? [x, y] : [px, py];
}

const predicted = remember((edited: Edited, draft: Draft, line: SeenAt | null): Position | null => {
  const place = draft.places[otherSide(draft.side)];
  if (place === null) return null;
  const known: Position = [place[0], place[1]];
  const around = byNeighbours(edited, otherSide(draft.side), known);
  return around === null || line?.side !== draft.side ? around : onLine(line, around);
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

const rounded = (value: number): number => Math.round(value * STEPS_OF_PX) / STEPS_OF_PX;

/** The size of an image; null while it is not open. */
function sizeOf({ results }: State, side: Side): { width: number; height: number } | null {
  return results[side === 'left' ? 'openLeft' : 'openRight']?.value.info ?? null;
}

/** The draft with its point of a side at a place, within the image. */
export function placed(state: State, draft: Draft, side: Side, [x, y]: Position): Draft {
  const { width, height } = sizeOf(state, side) ?? { width: Infinity, height: Infinity };
  const at: Position = [rounded(Math.min(width, Math.max(0, x))), rounded(Math.min(height, Math.max(0, y)))];
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

/** The edit that a draft becomes; null while a point of it is not placed. */
export function editOfDraft(state: State): Edit | null {
  const { draft, history } = state;
  const [left, right] = [placeOfDraft(state, 'left'), placeOfDraft(state, 'right')];
  if (draft === null || left === null || right === null) return null;
  const at: Place = [rounded(left[0]), rounded(left[1]), rounded(right[0]), rounded(right[1])];
  if (draft.of === null) return { kind: 'add', id: freshNumber(history), at };
  // What was not moved stays to the last digit.
  const own = (k: 0 | 1, side: Side, value: number) => draft.places[side]?.[k] ?? value;
  return { kind: 'move', of: draft.of, to: [own(0, 'left', at[0]), own(1, 'left', at[1]), own(0, 'right', at[2]), own(1, 'right', at[3])] };
}
