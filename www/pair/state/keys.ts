/**
 * What each stage's result depends on, as a key. A result is current where its key equals the wanted one; a stage whose key did not
 * change is not computed again, whatever was changed elsewhere.
 */
import { pairCameras, photoFacts } from './cameras';
import { assumedInterior } from './interior';
import { measuredPhoto } from './marks';
import { resolved } from '../../shared/crate';
import type { Settings } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import { isNothing, standingOf } from './edits';
import type { Standing } from './edits';
import { truthOf } from './truth';
import { oneImage } from './one-image';
import { otherSide } from './state';
import type { Side, StageName, State } from './state';

/** The wanted key of each stage; null where an input is missing. */
export type WantedKeys = Record<StageName, string | null>;

const numbers = new Map<string, string>();

/** A short name for a value: equal values get equal names. Keys of keys would otherwise grow with every stage. */
function shortName(parts: readonly unknown[]): string {
  const text = JSON.stringify(parts);
  let name = numbers.get(text);
  if (name === undefined) {
    name = `k${String(numbers.size)}`;
    numbers.set(text, name);
  }
  return name;
}

const standings = new WeakMap<Standing, number>();
let lastStanding = 0;

/** What is made of the matches depends on the edits by hand too; without any it is what it would be without editing. */
function withEdits({ history }: State, match: string | null): string | null {
  const standing = standingOf(history.edits, history.done);
  if (isNothing(standing)) return match;
  const number = standings.get(standing) ?? ++lastStanding;
  standings.set(standing, number);
  return keyOf('edited', [match], number);
}

/** The key of a stage from its inputs; null where one of them is missing. */
function keyOf(kind: string, inputs: readonly (string | null)[], options: unknown = null): string | null {
  return inputs.includes(null) ? null : shortName([kind, inputs, options]);
}

/** Whether a strategy searches the right image itself, in place of its interest points. */
export function comparesGreyValues({ matching }: Settings): boolean {
  return matching.strategy === 'correlation' || matching.strategy === 'least-squares';
}

/** Whether a strategy compares gradient descriptors: it looks for no expected place, and the geometry of the two views verifies its matches. */
export function comparesGradients(settings: Settings): boolean {
  return inFull(settings).matching.strategy === 'gradient';
}

/** The settings with what follows from them, as the strategy where it is to be chosen. */
const inFull = remember(resolved);

/** Whether a strategy compares the moments of windows. */
export function comparesMoments(settings: Settings): boolean {
  return !comparesGreyValues(settings) && !comparesGradients(settings);
}

/** What the points depend on: of the groups `multiscale` and `gradient` only what is used. */
function pointSettings(settings: Settings): unknown[] {
  const gradients = comparesGradients(settings);
  const scales = gradients || settings.points.operator === 'multiscale';
  return [settings.points, scales ? settings.multiscale : null, gradients ? settings.gradient : null];
}

/** What the interior orientation of the matches' own making comes from beside them, where they tell it or are still to come. */
function estimatedFrom(state: State, settings: Settings, match: string | null): string | null {
  const result = state.results.match;
  const tellsNone = result !== undefined && result.key === match && assumedInterior(state) === null;
  return comparesGradients(settings) && !tellsNone ? keyOf('assumed', [], photoFacts(state)) : null;
}

/** Photos from one place, and images of one, have no base: there is nothing to orient. */
function withoutBase(state: State, match: string | null): boolean {
  const result = state.results.match;
  return result !== undefined && result.key === match && (result.value.geometry?.degenerate === 'pure-rotation' || oneImage(state) !== null);
}

/** Whether matches are there, and no orientation of them that nothing speaks against. */
function isPoor({ results, failures }: State, match: string | null, orientation: string | null): boolean {
  if (match === null || results.match?.key !== match) return false;
  if (orientation === null || failures.orientation?.key === orientation) return true;
  return results.orientation?.key === orientation && results.orientation.value.verdict.kind !== 'oriented';
}

function openKey(state: State, side: Side): string | null {
  const image = state.images[side];
  return image === null ? null : keyOf('open', [], image.id);
}

/** What of the cameras matching depends on: the geometry that verifies gradients, and matching along epipolar lines. */
function ofCameras(settings: Settings | null, interiors: readonly (string | null)[]): unknown[] {
  if (settings === null) return [];
  if (comparesGradients(settings)) return [...interiors, settings.geometry];
  return settings.matching.epipolar ? [...interiors, settings.orientation] : [];
}

/** The point whose place in the other image is looked for. */
function knownOfDraft({ draft }: State): unknown {
  return draft === null ? null : [draft.side, draft.places[otherSide(draft.side)]];
}

/** The keys, and that of the orientation as it would be without edits by hand. */
interface Computed {
  keys: WantedKeys;
  run: string | null;
}

function compute(state: State): Computed {
  const { settings } = state;
  const openLeft = openKey(state, 'left');
  const openRight = openKey(state, 'right');
  const points = (side: Side, open: string | null) => (settings === null ? null : keyOf('points', [open], [pointSettings(settings), state.masks[side]?.id]));
  const pointsLeft = points('left', openLeft);
  const pointsRight = points('right', openRight);
  const described = settings === null || !comparesMoments(settings) ? [] : [settings.window, settings.matching.strategy];
  const descriptorsLeft = keyOf('descriptors', [pointsLeft], described);
  const descriptorsRight = keyOf('descriptors', [pointsRight], described);
  const gradients = settings !== null && comparesGradients(settings);
  const given = state.offset === null ? keyOf('offset', [openLeft, openRight]) : keyOf('offset', [], state.offset);
  const offset = gradients ? null : given;
  const cameras = pairCameras(state);
  // Both photos are taken to the focal length of the left one; else the camera of the other one changes nothing.
  const interior = (side: Side, open: string | null) =>
    'missing' in cameras
      ? null
      : keyOf('interior', [open], [cameras[side], cameras.left.focal_mm, side, measuredPhoto(state.photos[side]), state.fiducialModel]);
  const interiorLeft = interior('left', openLeft);
  const interiorRight = interior('right', openRight);
  const together = 'missing' in cameras ? null : keyOf('together', [], [cameras.doubt, cameras.one_lens]);
  const match = keyOf(
    'match',
    [descriptorsLeft, descriptorsRight, gradients ? '' : offset],
    [settings?.matching, ofCameras(settings, [interiorLeft, interiorRight, together])],
  );
  const unknown = settings === null || ('missing' in cameras && cameras.missing.kind === 'panorama') ? null : estimatedFrom(state, settings, match);
  const interiors = 'missing' in cameras ? [unknown] : [interiorLeft, interiorRight, together];
  const orientable = withoutBase(state, match) ? null : '';
  const truth = truthOf(state);
  const edited = withEdits(state, match);
  // What was found of a point stays what it is whatever is rejected.
  const placed = standingOf(state.history.edits, state.history.done).placed.size > 0;
  const orientation = (matches: string | null) => keyOf('orientation', [matches, orientable, ...interiors], settings?.orientation);
  const keys = {
    openLeft,
    openRight,
    pointsLeft,
    pointsRight,
    descriptorsLeft,
    descriptorsRight,
    offset,
    match,
    interiorLeft,
    interiorRight,
    orientation: orientation(edited),
    score: keyOf('score', [edited, truth === null ? null : ''], [truth?.leftId, truth?.rightId]),
    difference: gradients || !isPoor(state, match, orientation(edited)) ? null : keyOf('difference', [openLeft, openRight]),
    line: keyOf('line', [match, state.draft === null ? null : ''], knownOfDraft(state)),
    inspection: keyOf('inspection', [placed ? edited : match, state.selection === null ? null : ''], [state.selection, settings?.window]),
  };
  return { keys, run: orientation(match) };
}

let last: ({ state: State } & Computed) | null = null;

function computed(state: State): Computed {
  if (last?.state !== state) last = { state, ...compute(state) };
  return last;
}

/** The wanted keys of a state; computed once a state. */
export function wantedKeys(state: State): WantedKeys {
  return computed(state).keys;
}

/** What the orientation of a state depends on beside the edits by hand: the same as long as these alone change. */
export function runKey(state: State): string | null {
  return computed(state).run;
}

/** Whether a stage's result is there and made by the settings that are wanted now. */
export function isCurrent(state: State, stage: StageName): boolean {
  const key = wantedKeys(state)[stage];
  return key !== null && state.results[stage]?.key === key;
}

/** Whether a stage shows a result that other settings made. What is not part of the run is neither shown nor out of date. */
export function isStale(state: State, stage: StageName): boolean {
  const key = wantedKeys(state)[stage];
  return key !== null && state.results[stage] !== undefined && state.results[stage].key !== key;
}
