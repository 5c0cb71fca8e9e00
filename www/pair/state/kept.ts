/** What of the pair is kept in the browser's storage: of the state, and back. */
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { CameraMm, Flight, PairProject, Settings } from '../../shared/crate';
import { isNothing, standingOf } from './edits';
import type { Edit } from './edits';
import { isCurrent, runKey, wantedKeys } from './keys';
import { withResults } from './project';
import type { Beside, Times } from './project';
import { progress } from './select';
import { measuredOn } from './shelf';
import { INITIAL, SIDES } from './state';
import type { Display, Draft, FlightTruth, MarkStep, MaskStep, PhotoData, Side, StageName, State } from './state';

/** What is typed or read from small files. */
export interface Typed {
  settings: Settings;
  camera: CameraMm | null;
  photos: State['photos'];
  fiducialModel: State['fiducialModel'];
  offset: State['offset'];
}

/** A file that is kept by itself, under a name that does not change. */
export interface KeptFile extends KeptMask {
  id: number;
}

/** What a mask is read from, the same way. */
export interface KeptMask {
  name: string;
  file: string;
}

/** All but the files and the results. */
export interface KeptPair {
  typed: Typed;
  display: Display;
  flight: Flight | null;
  /** A run that the user ended is not taken up by itself. */
  paused: boolean;
  images: Record<Side, KeptFile | null>;
  masks: Record<Side, KeptFile | null>;
  givenMasks: Record<Side, KeptMask | null>;
  /** The positions in the right image are kept by themselves. */
  truth: (Omit<FlightTruth, 'rightPosition'> & { file: string }) | null;
}

/** The results of a pair, with what they were made from. */
export interface KeptResult {
  /** The pair's project file. */
  project: string;
  typed: Typed;
  /** The files of images and masks, as they are kept. */
  of: string;
  /** What the project file does not hold. */
  beside: Beside;
  times: Times;
}

/** What was kept, ready to be shown. */
export interface RestoredPair {
  typed: Typed;
  display: Display;
  flight: Flight | null;
  paused: boolean;
  images: State['images'];
  masks: State['masks'];
  givenMasks: State['givenMasks'];
  truth: FlightTruth | null;
  history: History<Edit>;
  maskSteps: History<MaskStep>;
  markSteps: History<MarkStep>;
  /** The match that is being measured. */
  draft: Draft | null;
  shelf: State['shelf'];
  /** The images as they are opened again. */
  opened: Pick<Beside, 'openLeft' | 'openRight'>;
  result: { project: PairProject; typed: Typed; beside: Beside; times: Times } | null;
}

export function typedOf({ settings, camera, photos, fiducialModel, offset }: State): Typed | null {
  return settings === null ? null : { settings, camera, photos, fiducialModel, offset };
}

/** Whether there is nothing yet that would have to be kept. */
export function isBlank(state: State): boolean {
  const { catalogue, settings, flight, images, camera, photos, fiducialModel, offset } = state;
  return (
    catalogue === null ||
    (images.left === null &&
      images.right === null &&
      settings === catalogue.defaults &&
      flight === (catalogue.flights[0]?.flight ?? null) &&
      camera === null &&
      photos === INITIAL.photos &&
      fiducialModel === INITIAL.fiducialModel &&
      offset === null)
  );
}

/**
 * Whether something is there that should not be lost to the next pair: matches of the user's own photographs, up to date or not, or what was done by hand to
 * whatever images. Those of a project file are the user's own without their files, too.
 */
export function isWorthKeeping(state: State): boolean {
  const areOwn = SIDES.every((side) => (state.images[side]?.source.kind ?? 'grey') !== 'grey');
  // Until the images are open, what is matched may be those before them.
  const isMatched = state.results.match !== undefined && isCurrent(state, 'openLeft') && isCurrent(state, 'openRight');
  return (areOwn && isMatched) || isEdited(state) || state.draft !== null || SIDES.some((side) => state.masks[side] !== null);
}

/** Whether marks were measured in images of the user's own, or it is said where they lie in their scans: of a simulated pair they come again. */
export function hasMarks({ images, photos, truth }: State): boolean {
  return truth === null && SIDES.some((side) => images[side] !== null && hasData(photos[side]));
}

/** Whether something was measured or said of a photo. */
export function hasData({ fiducials, origin }: PhotoData): boolean {
  return fiducials.length > 0 || origin !== null;
}

/** Stages whose results the project file holds not, or not whole. */
const BESIDE = ['interiorLeft', 'interiorRight', 'descriptorsLeft', 'descriptorsRight'] as const;

/** Whether all that is wanted was computed, so that it can be kept. */
export function isWhole(state: State): boolean {
  const { wanted, done, running } = progress(state);
  return running.length === 0 && done === wanted && isCurrent(state, 'match');
}

/** What the project file does not hold of results that are up to date. */
export function besideOf(state: State): Pick<KeptResult, 'beside' | 'times'> {
  const beside: Beside = {};
  const take = <S extends (typeof BESIDE)[number]>(stage: S) => {
    const result = state.results[stage];
    if (result !== undefined && isCurrent(state, stage)) beside[stage] = result.value as Beside[S];
  };
  BESIDE.forEach(take);
  const times = Object.entries(state.results).map(([stage, { milliseconds }]) => [stage, milliseconds]);
  return { beside, times: Object.fromEntries(times) as Times };
}

/** The pair as it would be without what was done to it by hand. */
export function unedited(state: State): State {
  return { ...state, history: NO_HISTORY };
}

export function isEdited({ history }: State): boolean {
  return !isNothing(standingOf(history.edits, history.done));
}

/** In place of the results that edits change: what is kept of them are those without edits. */
const OF_EDITS = 'edits';

/** The results by which what is kept of them is known to be the latest. */
export function resultsOf(state: State): readonly unknown[] {
  const keys = wantedKeys(state);
  const changes = isEdited(state) ? new Set<StageName>(['orientation', 'score']) : new Set<StageName>();
  const stages: readonly StageName[] = ['pointsLeft', 'pointsRight', 'offset', 'match', 'orientation', 'score', ...BESIDE];
  const value = (stage: StageName) => (changes.has(stage) ? OF_EDITS : state.results[stage]?.value);
  return [...stages.map((stage) => (keys[stage] === null ? null : value(stage))), state.images, state.masks];
}

/** Whether what is kept of these results is still what they are. Edits leave it as it is. */
export function areSame(kept: readonly unknown[], now: readonly unknown[]): boolean {
  return now.every((value, i) => value === OF_EDITS || value === kept[i]);
}

/** The state that shows a pair as it was. Results that other settings made stay so: what is out of date is computed again. */
export function withKept(state: State, { typed, history, draft, opened, result, ...others }: RestoredPair): State {
  const given = { ...typed, ...others, ...measuredOn(draft, INITIAL.tool) };
  const fresh: State = { ...INITIAL, catalogue: state.catalogue, notice: state.notice, ...given };
  if (result === null) return withOpened({ ...fresh, history }, opened);
  const made = withResults({ ...fresh, ...result.typed }, result.project, { ...result.beside, ...opened }, result.times);
  // What the edits do is compared with what was before all of them.
  const { orientation } = made.results;
  const before = history.done === 0 || orientation === undefined ? null : { run: runKey(made), orientation: orientation.value };
  return { ...made, ...typed, history, before };
}

/** With the images as they were opened, which are shown in a pair that waits, too. */
function withOpened(state: State, opened: RestoredPair['opened']): State {
  const results: State['results'] = {};
  for (const stage of ['openLeft', 'openRight'] as const) {
    const [key, value] = [wantedKeys(state)[stage], opened[stage]];
    if (key !== null && value !== undefined) results[stage] = { key, value, milliseconds: 0 };
  }
  return { ...state, results };
}

/** The same of both sides. */
export function bothSides<T>(of: (side: Side) => T): Record<Side, T> {
  const [left, right] = SIDES.map(of) as [T, T];
  return { left, right };
}
