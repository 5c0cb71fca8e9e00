/** What the panels and views read from the state. Pure; the costly ones are remembered for the last input. */
import type { MatchResult, RelativeOrientation } from '../../shared/crate';
import type { MatchesOf } from './data';
import type { Side, StageName, State } from './state';
import { STAGES } from './stages';
import { BY_HAND, GROSS_ERROR, MANUAL, MATCHED, UNDECIDED } from './codes';
import { editedPair, isManual, NO_POINT, rowsOfLefts } from './edited';
import type { Edited } from './edited';
import { isStale, wantedKeys } from './keys';
import { remember, rememberCodes } from '../../shared/state/remember';
import { countsOf, POINT_STRIDE, RESIDUAL_STRIDE } from './residuals';

export { NO_POINT };

/** The results that are shown together: a match only with the points it was made from. */
export interface ShownPair {
  left: Float64Array | null;
  right: Float64Array | null;
  match: MatchResult | null;
  orientation: RelativeOrientation | null;
  /** The matches with what was done to them by hand. */
  edited: Edited | null;
}

/**
 * The points, matches and orientation that fit each other and the images on the screen. Matches refer to points by index: once points are
 * newer than the matches, the matches are no longer shown on them. An orientation is shown while another is on its way, and not where
 * none will come.
 */
export function shownPair(state: State): ShownPair {
  const found = pointsOfShownImage(state, 'left');
  const right = pointsOfShownImage(state, 'right');
  const made = state.results.match?.value ?? null;
  const fits = made !== null && found !== null && right !== null && made.rules.length * 3 === found.length && matchIsOf(made, found, right);
  const edited = fits ? editedPair(state) : null;
  const comes = wantedKeys(state).orientation !== null && !isBarred(state, 'orientation');
  const result = comes ? state.results.orientation : undefined;
  const key = state.results.match?.key ?? '';
  const orientation = edited === null || result === undefined ? null : orientationOf(result.value, result.of ?? null, edited, key);
  return { left: edited?.left ?? found, right, match: edited?.match ?? null, orientation, edited };
}

/** The orientation of the matches as they are now. One that was made before the latest edit is shown of the matches that it knows. */
const orientationOf = remember((orientation: RelativeOrientation, of: MatchesOf | null, { match }: Edited, key: string): RelativeOrientation | null => {
  const count = match.matches.length / 5;
  if (of === null || of.match === match) return countsOf(orientation).all === count ? orientation : null;
  // By the key of the matching: settings that are taken back find the same matches again, and the orientation is not computed again.
  if (of.key !== key) return null;
  const then = rowsThen(of.match, match);
  const wasRejected = new Set(orientation.rejected);
  const points = new Float64Array(POINT_STRIDE * count).fill(NaN);
  const residuals = new Float64Array(RESIDUAL_STRIDE * count).fill(NaN);
  const rejected: number[] = [];
  then.forEach((own, row) => {
    if (own < 0) return;
    for (let k = 0; k < POINT_STRIDE; k++) points[POINT_STRIDE * row + k] = orientation.points[POINT_STRIDE * own + k] ?? NaN;
    for (let k = 0; k < RESIDUAL_STRIDE; k++) residuals[RESIDUAL_STRIDE * row + k] = orientation.residuals_mm[RESIDUAL_STRIDE * own + k] ?? NaN;
    if (wasRejected.has(own)) rejected.push(row);
  });
  return { ...orientation, points, residuals_mm: residuals, rejected };
});

/** The row that each match had among earlier ones; -1 where none of them was the same. */
function rowsThen(earlier: MatchResult, now: MatchResult): Int32Array {
  const rowOfLeft = rowsOfLefts(earlier);
  const rows = new Int32Array(now.indices.length / 2).fill(-1);
  for (let row = 0; row < rows.length; row++) {
    const then = rowOfLeft[now.indices[2 * row] ?? NO_POINT] ?? -1;
    let same = then >= 0;
    for (let k = 0; same && k < 4; k++) same = earlier.matches[5 * then + k] === now.matches[5 * row + k];
    if (same) rows[row] = then;
  }
  return rows;
}

function pointsOfShownImage(state: State, side: Side): Float64Array | null {
  const opened = side === 'left' ? 'openLeft' : 'openRight';
  if (state.results[opened] === undefined || state.results[opened].key !== wantedKeys(state)[opened]) return null;
  return state.results[side === 'left' ? 'pointsLeft' : 'pointsRight']?.value.points ?? null;
}

/** Whether the first and last match start where their left points lie and refer to right points that exist. */
function matchIsOf(match: MatchResult, left: Float64Array, right: Float64Array): boolean {
  const count = match.indices.length / 2;
  return [0, count - 1].every((i) => {
    if (i < 0 || count === 0) return true;
    const l = match.indices[2 * i] ?? 0;
    const r = match.indices[2 * i + 1] ?? NO_POINT;
    return left[3 * l] === match.matches[5 * i] && (r === NO_POINT || 3 * r < right.length);
  });
}

/** The code of each left point: the rule that decided, or that the adjustment rejected its match. */
export const leftCodes = rememberCodes((left: Float64Array | null, match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((left?.length ?? 0) / 3).fill(UNDECIDED);
  if (match === null) return codes;
  codes.set(match.rules);
  for (let row = 0; 5 * row < match.matches.length; row++) if (isManual(match, row)) codes[match.indices[2 * row] ?? NO_POINT] = MANUAL;
  for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i] ?? 0] = GROSS_ERROR;
  return codes;
});

/** The code of each right point: matched, rejected by hand or by the adjustment, or unused. */
export const rightCodes = rememberCodes((right: Float64Array | null, match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((right?.length ?? 0) / 3).fill(UNDECIDED);
  if (match === null) return codes;
  match.rules.forEach((rule, left) => {
    if (rule === BY_HAND) codes[match.best[left] ?? -1] = BY_HAND;
  });
  // A place that is no point has an index beyond the array, which takes no value.
  for (let i = 1; i < match.indices.length; i += 2) codes[match.indices[i] ?? NO_POINT] = MATCHED;
  for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i + 1] ?? NO_POINT] = GROSS_ERROR;
  return codes;
});

/** The code of each match: `MATCHED`, `MANUAL` or `GROSS_ERROR`. */
export const matchCodes = rememberCodes((match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((match?.matches.length ?? 0) / 5);
  for (let row = 0; match !== null && row < codes.length; row++) codes[row] = isManual(match, row) ? MANUAL : MATCHED;
  for (const i of orientation?.rejected ?? []) codes[i] = GROSS_ERROR;
  return codes;
});

/** Matched places of the right image that are no interest points: stride 3 (x, y, measure), with the left point and the code of each. */
export interface Places {
  points: Float64Array;
  codes: Uint8Array;
  lefts: Uint32Array;
}

export const loosePlaces = remember((match: MatchResult | null, codes: Uint8Array): Places => {
  const most = match === null ? 0 : match.rules.length + codes.length;
  const [points, ofPlaces, lefts] = [new Float64Array(3 * most), new Uint8Array(most), new Uint32Array(most)];
  let count = 0;
  const put = (left: number, code: number, x: number, y: number, measure: number) => {
    points[3 * count] = x;
    points[3 * count + 1] = y;
    points[3 * count + 2] = measure;
    ofPlaces[count] = code;
    lefts[count] = left;
    count += 1;
  };
  match?.rules.forEach((rule, left) => {
    if (rule !== BY_HAND || (match.best[left] ?? -1) >= 0) return;
    const [x = NaN, y = NaN] = match.places.subarray(2 * left, 2 * left + 2);
    if (!Number.isNaN(x)) put(left, BY_HAND, x, y, 0);
  });
  codes.forEach((code, row) => {
    if (match?.indices[2 * row + 1] !== NO_POINT) return;
    const at = (k: number) => match.matches[5 * row + k] ?? NaN;
    put(match.indices[2 * row] ?? 0, code, at(2), at(3), at(4));
  });
  return { points: points.slice(0, 3 * count), codes: ofPlaces.slice(0, count), lefts: lefts.slice(0, count) };
});

/** The match of each left point; -1 where it has none. */
export const matchOfLeft = remember(rowsOfLefts);

/** Stages that are part of the run itself; looking at a point is not. */
const RUN_STAGES: readonly StageName[] = [
  'openLeft',
  'openRight',
  'pointsLeft',
  'pointsRight',
  'descriptorsLeft',
  'descriptorsRight',
  'offset',
  'match',
  'interiorLeft',
  'interiorRight',
  'orientation',
  'score',
];

/** Whether a stage failed for what is wanted now, or cannot be reached since one that it needs did. */
function isBarred(state: State, stage: StageName): boolean {
  const failure = state.failures[stage];
  return (failure !== undefined && failure.key === wantedKeys(state)[stage]) || STAGES[stage].needs.some((needed) => isBarred(state, needed));
}

/** How far the run is: stages that are wanted, and those of them that are there or will not come. */
export function progress(state: State): { wanted: number; done: number; running: StageName[] } {
  const keys = wantedKeys(state);
  const wanted = RUN_STAGES.filter((stage) => keys[stage] !== null);
  return {
    wanted: wanted.length,
    done: wanted.filter((stage) => state.results[stage]?.key === keys[stage] || isBarred(state, stage)).length,
    running: RUN_STAGES.filter((stage) => state.running[stage] !== undefined),
  };
}

/** Whether something is under way that can be cancelled. */
export function isBusy(state: State): boolean {
  return Object.keys(state.running).length > 0 || state.notice?.kind === 'busy';
}

/** The first failure that stands for what is wanted now. */
export function currentFailure(state: State): { stage: StageName; message: string; ended: boolean } | null {
  const keys = wantedKeys(state);
  for (const stage of [...RUN_STAGES, 'inspection', 'line'] as const) {
    const failure = state.failures[stage];
    if (failure !== undefined && failure.key === keys[stage]) return { stage, message: failure.message, ended: failure.ended };
  }
  return null;
}

/** Whether any result on the screen was made by other settings than the wanted ones. */
export function anyStale(state: State): boolean {
  return RUN_STAGES.some((stage) => isStale(state, stage));
}
