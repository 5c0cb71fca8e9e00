/** What can be taken away: matches as CSV, everything as JSON, the picture as PNG. */
import { message } from '../../shared/crate';
import type { Engine } from '../engine/engine';
import { BY_HAND, CODES } from '../state/codes';
import { editedPair, isManual, placeOfLeft } from '../state/edited';
import { interiorInUse } from '../state/interior';
import { pairCameras } from '../state/cameras';
import { isCurrent } from '../state/keys';
import { wholeMarks } from '../state/marks';
import { NO_POINT, shownPair } from '../state/select';
import { truthOf } from '../state/truth';
import type { Side, State } from '../state/state';
import { save } from '../../shared/files/save';
import type { View } from '../view/view';
import { say } from '../../shared/text/words';

/** Rows of a flat array. */
function rows(values: ArrayLike<number>, stride: number): number[][] {
  return Array.from({ length: values.length / stride }, (_, i) => Array.from({ length: stride }, (_, k) => values[i * stride + k] ?? NaN));
}

function imageOf(state: State, side: Side) {
  const opened = state.results[side === 'left' ? 'openLeft' : 'openRight']?.value;
  return {
    name: state.images[side]?.name ?? null,
    width: opened?.info.width ?? null,
    height: opened?.info.height ?? null,
    format: opened?.info.format ?? null,
    exif: opened?.info.camera ?? null,
    fiducials: wholeMarks(state.photos[side]),
    origin: state.photos[side].origin,
    mask: state.masks[side]?.name ?? null,
  };
}

function framesOf(state: State, side: Side) {
  const found = state.results[side === 'left' ? 'pointsLeft' : 'pointsRight']?.value;
  return found === undefined || found.frames.length === 0 ? null : rows(found.frames, 2);
}

function verdicts(state: State) {
  const { match } = shownPair(state);
  if (match === null) return null;
  return Array.from(match.rules, (rule, i) => ({
    rule: CODES[rule] ?? String(rule),
    best: match.best[i] === -1 ? null : (match.best[i] ?? null),
    place: rows(match.places.subarray(2 * i, 2 * i + 2), 2).map((place) => place.map(finite))[0] ?? null,
    measure: finite(match.measures[2 * i]),
    second: finite(match.measures[2 * i + 1]),
  }));
}

/** JSON has no infinity: null stands for "no such candidate". */
function finite(value: number | undefined): number | null {
  return value !== undefined && Number.isFinite(value) ? value : null;
}

function countsOf(state: State) {
  const match = (editedPair(state)?.match ?? state.results.match?.value)?.counts;
  const { matches, ...rejected } = match ?? { matches: null };
  return {
    left: state.results.pointsLeft?.value.counts ?? null,
    right: state.results.pointsRight?.value.counts ?? null,
    matches,
    rejected: match === undefined ? null : rejected,
  };
}

/** What the orientation is worth, as the command's JSON has it; null without one. */
function verdictOf(state: State): object | null {
  const verdict = isCurrent(state, 'orientation') ? state.results.orientation?.value.verdict : undefined;
  return verdict === undefined ? null : { ...verdict, text: message('pair_verdict', verdict) };
}

/** The cameras and where they are known from; or what is missing. */
function camerasOf(state: State): object {
  const cameras = pairCameras(state);
  return 'missing' in cameras ? cameras : { ...cameras, from: state.camera === null ? 'exif' : 'given' };
}

/** What was done by hand; null where nothing was. */
function editsOf(state: State): object | null {
  const edited = editedPair(state);
  if (edited === null) return null;
  const { rules, matches } = edited.match;
  const off = Array.from(rules, (_, left) => left).filter((left) => rules[left] === BY_HAND);
  const manual = Array.from({ length: matches.length / 5 }, (_, row) => row).filter((row) => isManual(edited.match, row));
  if (off.length + manual.length === 0) return null;
  return { rejected_by_hand: off.map((left) => placeOfLeft(edited, left)), measured_by_hand: manual };
}

/** Everything on the page as one object; fields named as in the command's JSON. Positions in px, the top-left pixel's centre at (0.5, 0.5). */
export function everything(state: State): object {
  const { left, right, match, orientation } = shownPair(state);
  return {
    program: 'tiepoint',
    version: state.catalogue?.version ?? null,
    conventions: {
      pixel: 'the centre of the top-left pixel is (0.5, 0.5); x to the right, y down',
      photo: 'mm, x to the right, y up, origin at the principal point',
      points: '[x, y, interest value]',
      frames: 'for points of many scales: [scale in px, direction in rad from x towards y]',
      matches: '[x left, y left, x right, y right, measure]; the measure of one that was measured by hand is -1',
      match_indices: '[index of the left point, index of the right point], the right one null where the place found is no interest point',
      fits: 'least squares matching of each match: [correlation, covariance xx, xy, yy of the right position in px², iterations], null for one that it did not confirm',
      orientation_points:
        'a match: [residual y-parallax mm, redundancy number, standardised residual, detectable blunder mm, external reliability, weight, X, Y, Z mm]',
      edits:
        'rejected_by_hand: [x left, y left, x right, y right] of each match; measured_by_hand: indices of matches; left points measured by hand follow those that were found',
      verdicts: 'one a left point: the rule that decided, the index of the best right point and its place, the best and the second best measure',
    },
    verdict: verdictOf(state),
    settings: state.settings,
    images: { left: imageOf(state, 'left'), right: imageOf(state, 'right') },
    camera: camerasOf(state),
    fiducial_model: state.fiducialModel,
    given_offset: state.offset,
    offset: isCurrent(state, 'offset') ? (state.results.offset?.value ?? null) : null,
    counts: countsOf(state),
    thresholds: { left: state.results.pointsLeft?.value.threshold ?? null, right: state.results.pointsRight?.value.threshold ?? null },
    points: { left: left === null ? null : rows(left, 3), right: right === null ? null : rows(right, 3) },
    frames: { left: framesOf(state, 'left'), right: framesOf(state, 'right') },
    matches: match === null ? null : rows(match.matches, 5),
    match_indices: match === null ? null : rows(match.indices, 2).map((pair) => pair.map((index) => (index === NO_POINT ? null : index))),
    edits: editsOf(state),
    fits: match === null || match.fits.every(Number.isNaN) ? null : rows(match.fits, 5).map((fit) => (fit.every(Number.isNaN) ? null : fit.map(finite))),
    verdicts: verdicts(state),
    geometry: match?.geometry ?? null,
    no_geometry: match?.no_geometry == null ? null : { ...match.no_geometry, text: message('no_geometry', match.no_geometry) },
    interior: {
      left: state.results.interiorLeft?.value ?? null,
      right: state.results.interiorRight?.value ?? null,
      estimated: 'missing' in pairCameras(state) ? interiorInUse(state) : null,
    },
    orientation: orientation === null ? null : { ...orientation, points: rows(orientation.points, 9).map((point) => point.map(finite)) },
    truth: trueOrientation(state),
    score: scoreOf(state),
  };
}

/** The true orientation with the base that its by and bz belong to. */
function trueOrientation(state: State) {
  const truth = truthOf(state);
  return truth === null ? null : { ...truth.orientation, base_mm: truth.baseMm };
}

/** How right the matches are, where the truth is known. */
function scoreOf(state: State) {
  const score = state.results.score?.value;
  return score === undefined || !isCurrent(state, 'score') ? null : { matches: score.matches, strict: score.strict, right: score.right, missed: score.missed };
}

/** These give the name of the file that was saved. */
export async function exportMatches(state: State, engine: Engine): Promise<string | null> {
  const { match, orientation } = shownPair(state);
  if (match === null) return null;
  const text = await engine.client('pair').call('matchesCsv', { matches: match.matches, rejected: orientation?.rejected ?? null });
  return save(new Blob([text], { type: 'text/csv' }), `${baseName(state)}-matches.csv`);
}

export function exportEverything(state: State): string {
  return save(new Blob([JSON.stringify(everything(state))], { type: 'application/json' }), `${baseName(state)}.json`);
}

export async function exportPicture(state: State, view: View): Promise<string> {
  const canvas = view.snapshot();
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (blob === null) throw new Error(say('the-picture-is-too-large'));
  return save(blob, `${baseName(state)}.png`);
}

export function baseName(state: State): string {
  const names = [state.images.left?.name, state.images.right?.name].map((name) => (name ?? 'image').replace(/\.[^.]+$/u, ''));
  return names.join('-').replace(/[^\p{L}\p{N}._-]+/gu, '_');
}
