/** How the state changes. Pure: the same state and action give the same state. */
import type { Action } from './actions';
import { editedPair, keptText } from './edited';
import { NO_HISTORY, recorded, wentTo } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { exchangedDraft } from './draft';
import { exchanged } from './edits';
import type { Edit } from './edits';
import { isCurrent, runKey } from './keys';
import { bothSides, withKept } from './kept';
import { withMarkStep, withMarkStepsDone } from './mark-steps';
import { withGivenMask } from './mask-steps';
import { exchangedSides, withoutSides } from './of-sides';
import { withFiles, withProject } from './project';
import { exchangedPair, measuredOn } from './shelf';
import { INITIAL, SIDES, TYPED_PARTS, UNEDITED } from './state';
import type { Display, PhotoData, Results, Side, StageName, State, TypedPart } from './state';

const NO_DATA: PhotoData = { fiducials: [], origin: null };

/** What a user does; what was said of an earlier deed is then over. Looking at points or moving the view is none of it. */
const DEEDS: ReadonlySet<Action['type']> = new Set([
  'images',
  'simulated',
  'opened',
  'restored',
  'cleared',
  'found',
  'flight',
  'swap',
  'settings',
  'camera',
  'photo',
  'marked',
  'marksAfter',
  'mask',
  'painted',
  'masksAfter',
  'fiducialModel',
  'offset',
  'display',
  'resume',
  'edit',
  'goto',
]);

export function reduce(state: State, action: Action): State {
  const next = withTool(withShown(state, changed(state, action)), action);
  // What is busy says itself when it ends.
  const over = DEEDS.has(action.type) && next.notice !== null && next.notice.kind !== 'busy';
  return over ? { ...next, notice: null } : next;
}

/** Marks are measured as long as one is in hand. */
function withTool(next: State, action: Action): State {
  return next.tool === 'fiducials' && next.mark === null && action.type !== 'tool' ? { ...next, tool: 'look' } : next;
}

/** The mark in hand among the marks of photos that change; null where it may be another one, or none. */
function markAmong({ mark, photos }: State, next: State['photos']): State['mark'] {
  if (mark === null) return null;
  const [before, now] = [photos, next].map((of) => of[mark.side].fiducials.length) as [number, number];
  return now < before || mark.index > now ? null : mark;
}

/** The state with other marks. */
function withMarks(state: State, marked: Pick<State, 'photos' | 'markSteps'>): State {
  // A pair that waits is not matched anew at each mark.
  return { ...state, ...marked, mark: markAmong(state, marked.photos), paused: state.paused && state.tool === 'fiducials' };
}

/** Fields show new values in place of what they held. */
function withShown(state: State, next: State): State {
  const shown = TYPED_PARTS.filter((part) => part in next.refused && next[part] !== state[part]);
  return shown.length === 0 ? next : { ...next, refused: shown.reduce(without<State['refused'], TypedPart>, next.refused) };
}

function changed(state: State, action: Action): State {
  switch (action.type) {
    case 'ready':
      return { ...state, catalogue: action.catalogue, settings: action.catalogue.defaults, flight: action.catalogue.flights[0]?.flight ?? null };
    case 'images':
      return { ...withImages(state, action.images, action.same), paused: action.waits === true };
    case 'simulated':
      return withSimulated(state, action);
    case 'opened':
      return withProject(state, action.opened);
    case 'restored':
      return withKept(state, action.restored);
    case 'cleared':
      return state.catalogue === null ? state : changed(INITIAL, { type: 'ready', catalogue: state.catalogue });
    case 'found':
      return withFiles(state, action.images);
    case 'flight':
      return { ...state, flight: action.flight };
    case 'swap':
      return swapped(state);
    case 'settings':
      return { ...state, settings: action.settings, paused: false };
    case 'refused':
      return { ...state, refused: action.label === null ? without(state.refused, action.part) : { ...state.refused, [action.part]: action.label } };
    case 'camera':
      return { ...state, camera: action.camera, paused: false };
    case 'photo':
      return withMarks(state, {
        photos: { ...state.photos, [action.side]: { ...state.photos[action.side], ...action.photo } },
        // Steps on other marks are none on these.
        markSteps: action.photo.fiducials === undefined ? state.markSteps : withoutSides(state.markSteps, [action.side]),
      });
    case 'marked':
      return withMarks(state, withMarkStep(state, action.step));
    case 'marksAfter':
      return withMarks(state, withMarkStepsDone(state, action.done));
    case 'wait':
      return { ...state, paused: true };
    case 'mask':
      return { ...state, ...withGivenMask(state, action.side, action.mask), paused: false };
    case 'painted':
      return { ...state, masks: { ...state.masks, [action.step.side]: action.mask }, maskSteps: recorded(state.maskSteps, action.step), paused: false };
    case 'masksAfter':
      return { ...state, masks: action.masks, maskSteps: wentTo(state.maskSteps, action.done), paused: false };
    case 'fiducialModel':
      return { ...state, fiducialModel: action.model, paused: false };
    case 'offset':
      return { ...state, offset: action.offset, paused: false };
    case 'select':
      return { ...state, selection: action.selection, activeSide: action.selection?.side ?? state.activeSide };
    case 'edit':
      return withHistory(state, recorded(state.history, action.edit));
    case 'goto':
      return withHistory(state, wentTo(state.history, action.done));
    case 'choose':
      return { ...state, chosen: action.chosen };
    case 'filter':
      return { ...state, filter: action.filter };
    case 'tool':
      return { ...state, tool: action.tool, draft: null, outline: null, mark: null };
    case 'draft':
      return { ...state, draft: action.draft };
    case 'mark':
      return { ...state, mark: action.mark };
    case 'outline':
      return { ...state, outline: action.outline };
    case 'activeSide':
      return { ...state, activeSide: action.side };
    case 'views':
      return { ...state, views: { ...state.views, ...action.views } };
    case 'display':
      return { ...state, display: { ...state.display, ...action.display } satisfies Display };
    case 'notice':
      return { ...state, notice: action.notice };
    default:
      return withRun(state, action);
  }
}

type RunAction = Extract<Action, { type: 'stageStarted' | 'stageDone' | 'stageFailed' | 'stageStopped' | 'cancelled' | 'resume' }>;

/** What the engine reports. */
function withRun(state: State, action: RunAction): State {
  switch (action.type) {
    case 'stageStarted':
      return { ...state, running: { ...state.running, [action.stage]: action.key } };
    case 'stageDone':
      return withKeptEdits(action.stage, {
        ...state,
        running: without(state.running, action.stage),
        failures: without(state.failures, action.stage),
        results: { ...state.results, [action.stage]: action.result },
        // An index into points that are no more.
        selection: action.stage === (state.selection?.side === 'left' ? 'pointsLeft' : 'pointsRight') ? null : state.selection,
      });
    case 'stageFailed':
      return {
        ...state,
        running: without(state.running, action.stage),
        failures: { ...state.failures, [action.stage]: action.failure },
      };
    case 'stageStopped':
      return { ...state, running: without(state.running, action.stage) };
    case 'cancelled':
      // Rendering a pair or writing a report is no run that would have to be taken up again.
      return { ...state, running: {}, paused: state.paused || Object.keys(state.running).length > 0 };
    case 'resume':
      return { ...state, paused: false, failures: {} };
  }
}

function without<T extends object, K extends keyof T>(object: T, key: K): T {
  if (!(key in object)) return object;
  const copy = { ...object };
  delete copy[key];
  return copy;
}

/** After a new run of the matching the user is told what of the edits by hand it has. */
function withKeptEdits(stage: StageName, state: State): State {
  const edited = stage === 'match' ? editedPair(state) : null;
  const text = edited === null ? null : keptText(edited);
  return text === null || state.notice?.kind === 'problem' ? state : { ...state, notice: { kind: 'info', text } };
}

/** The state with other edits. What they do to the orientation is compared with the one before them. */
function withHistory(state: State, history: History<Edit>): State {
  if (history.done === state.history.done && history.edits === state.history.edits) return state;
  const { orientation } = state.results;
  const before = isCurrent(state, 'orientation') && orientation !== undefined ? { run: runKey(state), orientation: orientation.value } : state.before;
  // The run goes on with the edited matches.
  return { ...state, history, before, paused: false };
}

/** New images. Data that belonged to a simulated pair goes with it; what was measured in an image goes with that, and the camera that the user gave stays. */
function withImages(state: State, images: Partial<Record<Side, State['images']['left']>>, same: readonly Side[] = []): State {
  const before = state.truth === null ? state : withoutTruth(state);
  const all = { ...before.images, ...images };
  const unmarked = SIDES.filter((side) => replaced(before, images, side) && !same.includes(side));
  // A mask belongs to its image.
  const unmasked = SIDES.filter((side) => images[side] !== undefined);
  const without = <T>(of: Record<Side, T>, sides: readonly Side[], none: T): Record<Side, T> => bothSides((side) => (sides.includes(side) ? none : of[side]));
  return {
    ...before,
    images: all,
    photos: without(before.photos, unmarked, NO_DATA),
    masks: without(before.masks, unmasked, null),
    givenMasks: without(before.givenMasks, unmasked, null),
    selection: null,
    paused: false,
    failures: {},
    views: { left: null, right: null },
    ...UNEDITED,
    maskSteps: withoutSides(before.maskSteps, unmasked),
    markSteps: withoutSides(before.markSteps, unmarked),
    ...exchangedPair(state, all),
  };
}

/** Whether an image takes the place of another one. What was given before there was any belongs to it. */
function replaced({ images }: State, given: Partial<State['images']>, side: Side): boolean {
  return images[side] !== null && given[side] !== undefined;
}

function withoutTruth(state: State): State {
  return {
    ...state,
    settings: withBase(state, state.catalogue?.defaults.orientation.base_mm ?? null),
    truth: null,
    camera: null,
    photos: { left: NO_DATA, right: NO_DATA },
    markSteps: NO_HISTORY,
    offset: null,
  };
}

function withBase({ settings }: State, base: number | null): State['settings'] {
  return settings === null ? null : { ...settings, orientation: { ...settings.orientation, base_mm: base } };
}

function withSimulated(state: State, { left, right, pair }: Extract<Action, { type: 'simulated' }>): State {
  const given = withImages({ ...state, truth: null }, { left, right });
  return {
    ...given,
    // Photos from one place have no base that could give by and bz their scale.
    settings: withBase(given, pair.base_mm === 0 ? null : pair.base_mm),
    camera: pair.camera,
    photos: {
      left: { fiducials: pair.left_fiducials, origin: pair.left_origin },
      right: { fiducials: pair.right_fiducials, origin: pair.right_origin },
    },
    markSteps: NO_HISTORY,
    offset: null,
    truth: {
      leftId: left.id,
      rightId: right.id,
      orientation: pair.truth,
      baseMm: pair.base_mm,
      rightPosition: pair.right_position,
      leftWidth: pair.left.width,
      leftHeight: pair.left.height,
    },
  };
}

/** Left becomes right: images, their data, and the results that belong to one image alone. */
function swapped(state: State): State {
  const results: Results = { ...state.results };
  exchange(results, 'openLeft', 'openRight');
  exchange(results, 'pointsLeft', 'pointsRight');
  exchange(results, 'descriptorsLeft', 'descriptorsRight');
  return {
    ...state,
    results,
    images: { left: state.images.right, right: state.images.left },
    photos: { left: state.photos.right, right: state.photos.left },
    masks: { left: state.masks.right, right: state.masks.left },
    givenMasks: { left: state.givenMasks.right, right: state.givenMasks.left },
    offset: state.offset === null ? null : [-state.offset[0], -state.offset[1]],
    views: { left: state.views.right, right: state.views.left },
    ...UNEDITED,
    history: exchanged(state.history),
    maskSteps: exchangedSides(state.maskSteps),
    markSteps: exchangedSides(state.markSteps),
    ...measuredOn(state.draft === null ? null : exchangedDraft(state.draft), state.tool),
    selection: null,
    failures: {},
    paused: false,
  };
}

function exchange<K extends keyof Results>(results: Results, a: K, b: K): void {
  const kept = results[a];
  results[a] = results[b];
  results[b] = kept;
}

export { INITIAL };
