/** What the panels and views read from the state. Pure; the costly ones are remembered for the last input. */
import type { MatchResult, RelativeOrientation } from '../engine/wasm';
import type { GivenImage, Side, StageName, State } from './state';
import { isStale, wantedKeys } from './keys';

/** Code of a match that the adjustment rejected; codes 0 to 6 are the crate's rules. */
export const GROSS_ERROR = 7;
/** Code of a point that nothing was decided about yet, and of a right point that no match uses. */
export const UNDECIDED = 8;

/** Remembers the last result of a function of a few arguments, compared by identity. */
export function remember<A extends readonly unknown[], R>(compute: (...args: A) => R): (...args: A) => R {
  let last: { args: A; result: R } | null = null;
  return (...args) => {
    if (last === null || last.args.some((arg, i) => !Object.is(arg, args[i]))) last = { args, result: compute(...args) };
    return last.result;
  };
}

/** The results that are shown together: a match only with the points it was made from. */
export interface ShownPair {
  left: Float64Array | null;
  right: Float64Array | null;
  match: MatchResult | null;
  orientation: RelativeOrientation | null;
}

/**
 * The points, matches and orientation that fit each other and the images on the screen. Matches refer to points by index: once points are
 * newer than the matches, the matches are no longer shown on them.
 */
export function shownPair(state: State): ShownPair {
  const left = pointsOfShownImage(state, 'left');
  const right = pointsOfShownImage(state, 'right');
  const match = state.results.match?.value ?? null;
  const fits = match !== null && left !== null && right !== null && match.rules.length * 3 === left.length && matchIsOf(state, match, left, right);
  const orientation = state.results.orientation?.value ?? null;
  const oriented = fits && orientation !== null && orientation.residuals_mm.length * 5 === match.matches.length;
  return { left, right, match: fits ? match : null, orientation: oriented ? orientation : null };
}

function pointsOfShownImage(state: State, side: Side): Float64Array | null {
  const opened = side === 'left' ? 'openLeft' : 'openRight';
  if (state.results[opened] === undefined || state.results[opened].key !== wantedKeys(state)[opened]) return null;
  return state.results[side === 'left' ? 'pointsLeft' : 'pointsRight']?.value.points ?? null;
}

/** Whether the first and last match lie where their points lie. */
function matchIsOf(_state: State, match: MatchResult, left: Float64Array, right: Float64Array): boolean {
  const count = match.indices.length / 2;
  return [0, count - 1].every((i) => {
    if (i < 0 || count === 0) return true;
    const l = match.indices[2 * i] ?? 0;
    const r = match.indices[2 * i + 1] ?? 0;
    return left[3 * l] === match.matches[5 * i] && right[3 * r] === match.matches[5 * i + 2];
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
  for (let i = 1; i < match.indices.length; i += 2) codes[match.indices[i] ?? 0] = 0;
  for (const i of orientation?.rejected ?? []) codes[match.indices[2 * i + 1] ?? 0] = GROSS_ERROR;
  return codes;
});

/** The code of each match: 0, or `GROSS_ERROR`. */
export const matchCodes = remember((match: MatchResult | null, orientation: RelativeOrientation | null) => {
  const codes = new Uint8Array((match?.matches.length ?? 0) / 5);
  for (const i of orientation?.rejected ?? []) codes[i] = GROSS_ERROR;
  return codes;
});

/** Stages that are part of the run itself; looking at a point is not. */
const RUN_STAGES: readonly StageName[] = [
  'openLeft', 'openRight', 'pointsLeft', 'pointsRight', 'descriptorsLeft', 'descriptorsRight', 'offset', 'match', 'interiorLeft',
  'interiorRight', 'orientation',
];

/** How far the run is: stages that are wanted, and those of them that are there. */
export function progress(state: State): { wanted: number; done: number; running: StageName[] } {
  const keys = wantedKeys(state);
  const wanted = RUN_STAGES.filter((stage) => keys[stage] !== null);
  return {
    wanted: wanted.length,
    done: wanted.filter((stage) => state.results[stage]?.key === keys[stage] || state.failures[stage]?.key === keys[stage]).length,
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

/** "sample-left.png, sample-right.png", or what is missing. */
export function pairName(images: Record<Side, GivenImage | null>): string {
  return [images.left?.name, images.right?.name].filter((name) => name !== undefined).join(' – ');
}
