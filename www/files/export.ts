/** What can be taken away: matches as CSV, everything as JSON, the picture as PNG. */
import type { Engine } from '../engine/engine';
import { pairCameras } from '../state/keys';
import { shownPair } from '../state/select';
import type { Side, State } from '../state/state';
import type { View } from '../view/view';

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
    fiducials: state.photos[side].fiducials,
    origin: state.photos[side].origin,
  };
}

function verdicts(state: State) {
  const { match } = shownPair(state);
  if (match === null) return null;
  const names = state.catalogue?.rules ?? [];
  return Array.from(match.rules, (rule, i) => ({
    rule: names[rule] ?? String(rule),
    best: match.best[i] === -1 ? null : (match.best[i] ?? null),
    measure: finite(match.measures[2 * i]),
    second: finite(match.measures[2 * i + 1]),
  }));
}

/** JSON has no infinity: null stands for "no such candidate". */
function finite(value: number | undefined): number | null {
  return value !== undefined && Number.isFinite(value) ? value : null;
}

function countsOf(state: State) {
  const match = state.results.match?.value.counts;
  const { matches, ...refused } = match ?? { matches: null };
  return {
    left: state.results.pointsLeft?.value.counts ?? null,
    right: state.results.pointsRight?.value.counts ?? null,
    matches,
    refused: match === undefined ? null : refused,
  };
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
      matches: '[x left, y left, x right, y right, measure]',
      verdicts: 'one a left point: the rule that decided, the index of the best right point, the best and the second best measure',
    },
    settings: state.settings,
    images: { left: imageOf(state, 'left'), right: imageOf(state, 'right') },
    camera: pairCameras(state),
    fiducial_model: state.fiducialModel,
    given_offset: state.offset,
    offset: state.results.offset?.value ?? null,
    counts: countsOf(state),
    thresholds: { left: state.results.pointsLeft?.value.threshold ?? null, right: state.results.pointsRight?.value.threshold ?? null },
    points: { left: left === null ? null : rows(left, 3), right: right === null ? null : rows(right, 3) },
    matches: match === null ? null : rows(match.matches, 5),
    match_indices: match === null ? null : rows(match.indices, 2),
    verdicts: verdicts(state),
    interior: {
      left: state.results.interiorLeft?.value ?? null,
      right: state.results.interiorRight?.value ?? null,
    },
    orientation,
  };
}

export async function exportMatches(state: State, engine: Engine): Promise<void> {
  const { match } = shownPair(state);
  if (match === null) return;
  const text = await engine.client('pair').call('matchesCsv', { matches: match.matches });
  save(new Blob([text], { type: 'text/csv' }), `${baseName(state)}-matches.csv`);
}

export function exportEverything(state: State): void {
  save(new Blob([JSON.stringify(everything(state))], { type: 'application/json' }), `${baseName(state)}.json`);
}

export async function exportPicture(state: State, view: View): Promise<void> {
  const canvas = view.snapshot();
  const blob = await new Promise<Blob | null>((resolve) => { canvas.toBlob(resolve, 'image/png'); });
  if (blob === null) throw new Error('the picture is too large for this browser to encode; make the window smaller');
  save(blob, `${baseName(state)}.png`);
}

function baseName(state: State): string {
  const names = [state.images.left?.name, state.images.right?.name].map((name) => (name ?? 'image').replace(/\.[^.]+$/u, ''));
  return names.join('-').replace(/[^\p{L}\p{N}._-]+/gu, '_');
}

function save(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has taken the address by then.
  window.setTimeout(() => { URL.revokeObjectURL(link.href); }, 10_000);
}
