/** What came of a pair: its verdict, the figures that decided, and what to do next. */
import { cameraWanted } from '../../../pkg/pair/camera-wanted.js';
import { pair_hint } from '../../shared/crate';
import type { OrientedPair, PairHint, PairVerdict } from '../../shared/crate';
import type { Answer, Figure, Next } from '../../shared/panel/answer';
import { count, decimalsOfError, fixed } from '../../shared/text/format';
import { offeredCalibration } from '../state/calibration';
import { interiorInUse } from '../state/interior';
import { isCurrent } from '../state/keys';
import { whyNone } from '../state/no-orientation';
import { countsOf, pixelMm } from '../state/residuals';
import { shownPair } from '../state/select';
import { SIDES } from '../state/state';
import type { Side, State } from '../state/state';
import { summary } from './counts';
import { whyNotOriented } from './orientation';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

/** What the button beside the answer can do. */
export interface AnswerActions {
  /** Opens the image of a side, or any where there is none. */
  open: (side: Side | null) => void;
  /** Shows where the camera is given. */
  camera: () => void;
  /** Takes the camera as a block calibrated it. */
  calibrated: () => void;
  /** Takes the strategy that finds more. */
  otherStrategy: () => void;
  /** Shows what speaks against the result. */
  why: () => void;
  save: () => void;
}

/** The answer while nothing runs; `waiting`: something is about to. */
export function resting(state: State, waiting: boolean, actions: AnswerActions): Answer {
  const { images } = state;
  const line = (kind: Answer['kind'], text: string, next: Next | null = null): Answer => ({ kind, text, verdict: null, next });
  if (state.catalogue === null) return line('busy', say('loading-the-program'));
  if (images.left === null && images.right === null) return line('idle', say('ready-open-two-overlapping-images'));
  const missing = SIDES.find((side) => images[side] === null);
  if (missing !== undefined) {
    return line('idle', say('one-image-is-open-open', { missing }), { text: say('open-the-image', { missing }), act: () => actions.open(missing) });
  }
  return waiting ? line('busy', say('waiting')) : answered(state, actions);
}

function answered(state: State, actions: AnswerActions): Answer {
  const milliseconds = Object.entries(state.results).reduce(
    (sum, [stage, result]) => sum + (stage === 'inspection' || stage === 'line' || stage === 'difference' ? 0 : result.milliseconds),
    0,
  );
  // A pair that was opened took none.
  const matched = milliseconds === 0 ? `${summary(state)}.` : say('worked', { matched: summary(state), seconds: milliseconds / 1000 });
  const reason = whyNotOriented(state);
  const oriented = reason === null && isCurrent(state, 'orientation') ? state.results.orientation?.value : undefined;
  const verdict = oriented?.verdict;
  const hint = hintFor(state, verdict);
  const more = `${matched}${hint === null ? '' : ` ${message('pair_hint', hint)}`}`;
  if (oriented === undefined || verdict === undefined) {
    const next = hint === null ? nextWithout(state, actions) : { text: say('use-auto'), act: actions.otherStrategy };
    if (reason === null) return { kind: 'partial', verdict: 'not_oriented', text: more, next };
    return { kind: 'partial', verdict: 'not_oriented', text: reason, more, figures: figuresWithout(state), next };
  }
  const answer = { text: message('pair_verdict', verdict), more, figures: figuresOf(state, oriented) };
  if (verdict.kind === 'oriented') return { ...answer, kind: 'done', verdict: 'oriented', next: calibrated(state, actions) ?? nextAfter(state, actions) };
  const next = cameraWanted(verdict) !== null ? cameraNext(state, actions) : { text: say('show-why'), act: actions.why };
  return { ...answer, kind: 'partial', verdict: verdict.kind, next };
}

/** What else would do; null where the pair is oriented, or nothing is known to do better. */
function hintFor(state: State, verdict: PairVerdict | undefined): PairHint | null {
  const none = whyNone(state);
  const { value: difference } = (isCurrent(state, 'difference') && state.results.difference) || { value: null };
  const { value: offset } = (isCurrent(state, 'offset') && state.results.offset) || { value: null };
  const judged = verdict ?? (none === null ? null : ({ kind: 'not_oriented', no_orientation: none } as const));
  return state.settings === null || judged === null || isWithoutPoints(state) ? null : pair_hint(judged, state.settings, difference, offset);
}

/** Whether an image has no points: then none were compared. */
function isWithoutPoints(state: State): boolean {
  const { left, right } = shownPair(state);
  return left?.length === 0 || right?.length === 0;
}

function figuresOf(state: State, result: OrientedPair): Figure[] {
  const { used } = countsOf(result);
  const interior = interiorInUse(state)?.left;
  const half = result.half_widths_95?.kappa_deg;
  const digits = decimalsOfError(half, 2);
  return [
    { value: count(used), label: say('points-on-both-photos') },
    ...(interior === undefined || result.sigma0_mm == null
      ? []
      : [{ value: say('px-2', { value: result.sigma0_mm / pixelMm(interior) }), label: say('sigma-of-image-observations') }]),
    ...(half == null ? [] : [{ value: `${fixed(result.kappa_deg, digits)}° ± ${fixed(half, digits)}°`, label: say('right-photo-turned') }]),
  ];
}

function figuresWithout(state: State): Figure[] {
  const { match, left } = shownPair(state);
  if (match === null || left === null) return [];
  return [
    { value: count(match.counts.matches), label: say('points-on-both-photos') },
    { value: count(left.length / 3), label: say('points-tried') },
  ];
}

function nextWithout(state: State, actions: AnswerActions): Next {
  const none = whyNone(state);
  const why = { text: say('show-why'), act: actions.why };
  if (none === null) return why;
  // Other photographs help, nothing that could be given with these.
  const { kind } = none;
  if (kind === 'no_geometry' || kind === 'too_few_matches' || kind === 'parts_of_one_image')
    return { text: say('open-other-photos'), act: () => actions.open(null) };
  if (kind === 'one_photo') return { text: say('replace-the-right-image'), act: () => actions.open('right') };
  return cameraWanted({ kind: 'not_oriented', no_orientation: none }) === null ? why : cameraNext(state, actions);
}

/** Takes the camera as a block calibrated it, where it did. */
function calibrated(state: State, actions: AnswerActions): Next | null {
  return offeredCalibration(state) === null ? null : { text: say('use-the-calibrated-camera'), act: actions.calibrated };
}

/** Where the camera is what is wanting. */
function cameraNext(state: State, actions: AnswerActions): Next {
  return calibrated(state, actions) ?? { text: say('give-the-camera'), act: actions.camera };
}

/** A sound result is saved; after a simulated one come photos of one's own. */
function nextAfter({ images }: State, { open, save }: AnswerActions): Next {
  const simulated = SIDES.some((side) => images[side]?.source.kind === 'grey');
  return simulated ? { text: say('open-your-photos'), act: () => open(null) } : { text: say('save-the-project'), act: save };
}
