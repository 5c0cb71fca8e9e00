/** A pair as a project file holds it: of the state, and back. */
import type { MatchResult, NoOrientation, PairEdit, PairEdits, PairProject, PairTruth } from '../../shared/crate';
import { BY_HAND, codeOf, UNDECIDED } from './codes';
import { countsByHand, editedPair } from './edited';
import type { Edited } from './edited';
import { interiorInUse } from './interior';
import { isCurrent, wantedKeys } from './keys';
import { measuredPhoto } from './marks';
import { whyNone } from './no-orientation';
import { exchangedPair } from './shelf';
import { SIDES, UNEDITED } from './state';
import type { GivenImage, GivenMask, Results, Side, StageName, StageValues, State } from './state';
import type { MatchesOf, Overview } from './data';
import { truthOf } from './truth';

/** A project, and what of it the page makes for itself. */
export interface OpenedProject {
  project: PairProject;
  /** In place of the images, whose files are not there. */
  images: Record<Side, GivenImage>;
  overviews: Record<Side, Overview>;
  masks: Record<Side, GivenMask | null>;
}

/** What a project says where nothing tells yet why there is no orientation. */
const NOT_YET: NoOrientation = { kind: 'no_camera', side: 'left' };

/** All that is known of the pair on the screen; null while parts of it are missing or out of date. `contents`: digests of the image files. */
export function projectOf(state: State, contents: Record<Side, string | null>): PairProject | null {
  const { settings, camera, offset, photos, fiducialModel, results } = state;
  const { openLeft, openRight, pointsLeft, pointsRight, match, orientation } = results;
  const whole = (['pointsLeft', 'pointsRight', 'match'] as const).every((stage) => isCurrent(state, stage));
  if (!whole || settings === null || openLeft === undefined || openRight === undefined) return null;
  const edited = editedPair(state);
  if (pointsLeft === undefined || pointsRight === undefined || match === undefined || edited === null) return null;
  const opened = { left: openLeft, right: openRight };
  const photo = (side: Side) => {
    const { width, height, format, bits_per_sample, camera: named } = opened[side].value.info;
    const name = state.images[side]?.name ?? '';
    const mask = state.masks[side]?.name ?? null;
    return { name, content: contents[side], width_px: width, height_px: height, format, bits_per_sample, mask, camera: named };
  };
  const oriented = isCurrent(state, 'orientation') ? (orientation?.value ?? null) : null;
  const none = oriented === null ? (whyNone(state) ?? NOT_YET) : null;
  const interior = interiorInUse(state);
  const points = ({ counts, threshold, points: at, frames }: StageValues['pointsLeft']) => ({ counts, threshold, points: at, frames });
  const given = (side: Side) => ({ ...measuredPhoto(photos[side]), model: fiducialModel });
  return {
    images: [photo('left'), photo('right')],
    input: { camera, offset, left: given('left'), right: given('right') },
    settings,
    output: {
      left: points({ ...pointsLeft.value, ...appendedTo(pointsLeft.value, edited.left) }),
      right: points(pointsRight.value),
      offset: isCurrent(state, 'offset') ? (results.offset?.value ?? null) : null,
      match: filed(edited.match),
      interior,
      pixel_mm: null,
      orientation: oriented,
      no_orientation: none,
      // Made anew from the rest when the project is opened.
      verdict: oriented?.verdict ?? { kind: 'not_oriented', no_orientation: none ?? NOT_YET },
    },
    truth: truthFor(state),
    edited: editsFor(state, edited),
  };
}

/** The edits that hold, with what was found before them; null where there are none. */
function editsFor({ history: { edits, done } }: State, { found }: Edited): PairEdits | null {
  return done === 0 ? null : { edits: edits.slice(0, done) as PairEdit[], found };
}

/** Points with those measured by hand, at the one scale of points that have none. */
function appendedTo({ points, frames }: StageValues['pointsLeft'], left: Float64Array): Pick<StageValues['pointsLeft'], 'points' | 'frames'> {
  const more = (left.length - points.length) / 3;
  if (more === 0) return { points, frames };
  const own = Array.from({ length: frames.length === 0 ? 0 : more }, () => [1, 0]).flat();
  return { points: left, frames: Float64Array.from([...frames, ...own]) };
}

const NO_CANDIDATE = codeOf('no_candidate');

/**
 * Matches as a file holds them, which knows the rules of the crate alone. What was rejected by hand has no candidate there, but keeps its place:
 * a point without a candidate has none.
 */
function filed<M extends MatchResult>(match: M): M {
  const own = match.rules.reduce((sum, rule) => sum + Number(rule === BY_HAND || rule === UNDECIDED), 0);
  if (own === 0) return match;
  const rules = match.rules.map((rule) => (rule === BY_HAND || rule === UNDECIDED ? NO_CANDIDATE : rule));
  return { ...match, rules, counts: { ...match.counts, no_candidate: match.counts.no_candidate + own } };
}

/** The opposite of `filed`. */
function unfiled<M extends MatchResult>(match: M): M {
  const byHand = (rule: number, left: number) => rule === NO_CANDIDATE && !Number.isNaN(match.places[2 * left]);
  const own = match.rules.reduce((sum, rule, left) => sum + Number(byHand(rule, left)), 0);
  if (own === 0) return match;
  const rules = match.rules.map((rule, left) => (byHand(rule, left) ? BY_HAND : rule));
  return { ...match, rules, counts: { ...match.counts, no_candidate: match.counts.no_candidate - own } };
}

/** How many matches of a file were rejected and measured by hand that does not hold the edits themselves: those of former versions do not. */
export function editsOfFile({ output, edited }: PairProject): { rejected: number; manual: number } {
  return edited == null ? countsByHand(unfiled(output.match)) : { rejected: 0, manual: 0 };
}

function truthFor(state: State): PairTruth | null {
  const truth = truthOf(state);
  const score = isCurrent(state, 'score') ? state.results.score?.value : undefined;
  return truth === null || score === undefined ? null : { orientation: truth.orientation, base_mm: truth.baseMm, score };
}

/** The state that shows a project: its results stand as if they had just been computed. What costs nothing and needs no image is computed. */
export function withProject(state: State, { project, images, overviews, masks }: OpenedProject): State {
  const { input, settings, truth, edited } = project;
  const [left] = project.images;
  const photo = (side: Side) => ({ fiducials: input[side]?.fiducials ?? [], origin: input[side]?.origin ?? null });
  const given: State = {
    ...state,
    // What is read back is whole.
    settings: settings as State['settings'],
    camera: (input.camera ?? null) as State['camera'],
    photos: { left: photo('left'), right: photo('right') },
    fiducialModel: input.left?.model ?? 'affine',
    offset: input.offset ?? null,
    images,
    masks,
    givenMasks: masks,
    truth:
      truth === null
        ? null
        : {
            leftId: images.left.id,
            rightId: images.right.id,
            orientation: truth.orientation,
            baseMm: truth.base_mm,
            // Its score is known, and the images to compute another one are not there.
            rightPosition: new Float32Array(),
            leftWidth: left.width_px,
            leftHeight: left.height_px,
          },
    refused: {},
    failures: {},
    paused: false,
    selection: null,
    ...UNEDITED,
    ...exchangedPair(state, images),
    ...(edited == null ? {} : { history: { edits: edited.edits, done: edited.edits.length } }),
    views: { left: null, right: null },
  };
  return withResults(given, project, standingFor({ project, overviews }), {});
}

/** What stands for images whose files are not there. */
export function standingFor({ project: { images }, overviews }: Pick<OpenedProject, 'project' | 'overviews'>): Pick<Beside, 'openLeft' | 'openRight'> {
  const [left, right] = images;
  const info = ({ width_px, height_px, format, bits_per_sample, camera }: typeof left) => ({
    width: width_px,
    height: height_px,
    format,
    bits_per_sample,
    camera: camera ?? null,
    drone: null,
  });
  return { openLeft: { info: info(left), overview: overviews.left }, openRight: { info: info(right), overview: overviews.right } };
}

/** Results of stages that a project file does not hold. */
export type Beside = Partial<Pick<StageValues, 'openLeft' | 'openRight' | 'interiorLeft' | 'interiorRight' | 'descriptorsLeft' | 'descriptorsRight'>>;

/** The times that the stages took, in ms. */
export type Times = Partial<Record<StageName, number>>;

/** The state with the results of a project, which it was made from: they are kept under the keys of what the state has now. Its history is that of the project. */
export function withResults(state: State, project: PairProject, beside: Beside, times: Times): State {
  const { output, truth, edited } = project;
  let next: State = { ...state, results: {} };
  const put = <S extends StageName>(stage: S, value: StageValues[S] | null | undefined, of?: MatchesOf) => {
    const key = wantedKeys(next)[stage];
    if (value != null && key !== null)
      next = { ...next, results: { ...next.results, [stage]: { key, value, milliseconds: times[stage] ?? 0, ...(of === undefined ? {} : { of }) } } };
  };
  const { descriptorsLeft = nothing(), descriptorsRight = nothing() } = beside;
  put('openLeft', beside.openLeft);
  put('openRight', beside.openRight);
  const match = edited == null ? unfiled(output.match) : { ...output.match, ...edited.found };
  put('pointsLeft', { ...firstOf(output.left, match.rules.length), gradients: descriptorsLeft.gradients });
  put('pointsRight', { ...output.right, gradients: descriptorsRight.gradients });
  put('descriptorsLeft', descriptorsLeft);
  put('descriptorsRight', descriptorsRight);
  put('offset', output.offset);
  put('interiorLeft', beside.interiorLeft);
  put('interiorRight', beside.interiorRight);
  put('match', match);
  const used = editedPair(next) ?? { match, found: match };
  // What another version of the page makes of the edits is oriented anew.
  if (used.match.matches.length === output.match.matches.length) {
    put('orientation', output.orientation, { ...used, key: next.results.match?.key ?? '' });
    put('score', truth?.score);
  }
  return next;
}

/** Points without those that were measured by hand, which come last. */
function firstOf<P extends { points: Float64Array; frames: Float64Array }>(all: P, count: number): P {
  return 3 * count === all.points.length ? all : { ...all, points: all.points.slice(0, 3 * count), frames: all.frames.slice(0, 2 * count) };
}

const nothing = () => ({ moments: new Float64Array(), gradients: new Uint8Array() });

/** The state with the files of images that a project names: their pixels are read, and what the project does not hold of their points is made. */
export function withFiles(state: State, images: Partial<Record<Side, GivenImage>>): State {
  const results: Results = { ...state.results };
  for (const side of SIDES.filter((one) => images[one] !== undefined)) {
    const [open, points, descriptors] = OF_IMAGE[side];
    delete results[open];
    // Without its mask an image would have other points.
    if (state.masks[side] === null) {
      delete results[points];
      delete results[descriptors];
    }
  }
  return { ...state, results, failures: {}, images: { ...state.images, ...images } };
}

const OF_IMAGE = {
  left: ['openLeft', 'pointsLeft', 'descriptorsLeft'],
  right: ['openRight', 'pointsRight', 'descriptorsRight'],
} as const;
