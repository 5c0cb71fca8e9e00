/** What the panels and views read from the state. Pure; the costly ones are remembered for the last input. */
import type { MatchResult, RelativeOrientation } from '../../shared/crate';
import type { Side, StageName, State } from './state';
import { STAGES } from './stages';
import { GROSS_ERROR, MATCHED, UNDECIDED } from './codes';
import { isStale, wantedKeys } from './keys';
import { remember } from '../../shared/state/remember';

/** Stands for the right point of a match whose place is none. */
export const NO_POINT = 0xffffffff;

/** The results that are shown together: a match only with the points it was made from. */
export interface ShownPair {
  left: Float64Array | null;
  right: Float64Array | null;
  match: MatchResult | null;
  orientation: RelativeOrientation | null;
}

/**
 * The points, matches and orientation that fit each other and the images on the screen. Matches refer to points by index: once points are
 * newer than the matches, the matches are no longer shown on them. An orientation is shown while another is on its way, and not where
 * none will come.
 */
export function shownPair(state: State): ShownPair {
  const left = pointsOfShownImage(state, 'left');
  const right = pointsOfShownImage(state, 'right');
  const match = state.results.match?.value ?? null;
  const fits = match !== null && left !== null && right !== null && match.rules.length * 3 === left.length && matchIsOf(match, left, right);
  const comes = wantedKeys(state).orientation !== null && !isBarred(state, 'orientation');
  const orientation = comes ? (state.results.orientation?.value ?? null) : null;
  const oriented = fits && orientation !== null && orientation.residuals_mm.length * 5 === match.matches.length;
  return { left, right, match: fits ? match : null, orientation: oriented ? orientation : null };
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
export const leftCodes = remember((left: Float64Array | null, match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((left?.length ?? 0) / 3).fill(UNDECIDED);
  if (match === null) return codes;
  codes.set(match.rules);
  for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i] ?? 0] = GROSS_ERROR;
  return codes;
});

/** The code of each right point: matched, rejected by the adjustment, or unused. */
export const rightCodes = remember((right: Float64Array | null, match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((right?.length ?? 0) / 3).fill(UNDECIDED);
  if (match === null) return codes;
  // A place that is no point has an index beyond the array, which takes no value.
  for (let i = 1; i < match.indices.length; i += 2) codes[match.indices[i] ?? NO_POINT] = MATCHED;
  for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i + 1] ?? NO_POINT] = GROSS_ERROR;
  return codes;
});

/** The code of each match: `MATCHED`, or `GROSS_ERROR`. */
export const matchCodes = remember((match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((match?.matches.length ?? 0) / 5);
  for (const i of orientation?.rejected ?? []) codes[i] = GROSS_ERROR;
  return codes;
});

/** Matched places of the right image that are no interest points: stride 3 (x, y, measure), with the match and the code of each. */
export interface Places {
  points: Float64Array;
  codes: Uint8Array;
  matches: Uint32Array;
}

export const loosePlaces = remember((match: MatchResult | null, codes: Uint8Array): Places => {
  const matches = match === null ? new Uint32Array() : Uint32Array.from(codes, (_, i) => i).filter((i) => match.indices[2 * i + 1] === NO_POINT);
  const points = new Float64Array(3 * matches.length);
  matches.forEach((at, i) => {
    points.set(match?.matches.subarray(5 * at + 2, 5 * at + 5) ?? [], 3 * i);
  });
  return { points, codes: Uint8Array.from(matches, (at) => codes[at] ?? MATCHED), matches };
});

/** The match of each left point; -1 where it has none. */
export const matchOfLeft = remember((match: MatchResult): Int32Array => {
  const matches = new Int32Array(match.rules.length).fill(-1);
  for (let i = 0; i < match.indices.length; i += 2) matches[match.indices[i] ?? NO_POINT] = i / 2;
  return matches;
});

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

/** The first failure that stands for what is wanted now. */
export function currentFailure(state: State): { stage: StageName; message: string; ended: boolean } | null {
  const keys = wantedKeys(state);
  for (const stage of [...RUN_STAGES, 'inspection'] as const) {
    const failure = state.failures[stage];
    if (failure !== undefined && failure.key === keys[stage]) return { stage, message: failure.message, ended: failure.ended };
  }
  return null;
}

/** Whether any result on the screen was made by other settings than the wanted ones. */
export function anyStale(state: State): boolean {
  return RUN_STAGES.some((stage) => isStale(state, stage));
}
