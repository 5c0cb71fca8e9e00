/** The one state object of the page. Results keep the key of the settings that made them: stale is a comparison, never a flag. */
import { OWN_LIGHT } from '../../shared/state/light';
import type { Light } from '../../shared/state/light';
import type { PaneView } from '../../shared/state/pane';
import type { ImageSource, InteriorOutput, MaskImage, MatchesOf, Overview } from './data';
import type {
  CameraMm,
  Catalogue,
  DescribedPoints,
  DetectedPoints,
  Fiducial,
  FiducialModel,
  FiveParameters,
  Flight,
  MatchResult,
  MatchScore,
  OffsetField,
  Settings,
  PhotoDifference,
  PhotoInfo,
  OrientedPair,
  ParallaxDeviation,
  WindowReport,
} from '../../shared/crate';
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { Edit, Target } from './edits';
import type { Notice } from '../../shared/state/notice';
import type { Filter } from '../../shared/state/rows';

export type Side = 'left' | 'right';
export const SIDES: readonly Side[] = ['left', 'right'];

export function otherSide(side: Side): Side {
  return side === 'left' ? 'right' : 'left';
}

/** An image the user gave. `id` differs for every image ever given. */
export interface GivenImage {
  id: number;
  name: string;
  source: ImageSource;
}

/** Where an image holds no points that are wanted. `id` differs for every mask ever given. */
export interface GivenMask extends MaskImage {
  id: number;
  name: string;
  source: ImageSource;
}

/** What a mask is read from. */
export type MaskFile = Pick<GivenMask, 'name' | 'source'>;

/** What the user says of a photo. */
export interface PhotoData {
  fiducials: Fiducial[];
  /** Where the image's top-left pixel lies in the scan whose fiducials were measured. */
  origin: [number, number] | null;
}

/** The known answers of a simulated pair, for the images with these ids. */
export interface FlightTruth {
  leftId: number;
  rightId: number;
  orientation: FiveParameters;
  /** The base that gives by and bz of the orientation their scale. */
  baseMm: number;
  /** x, y in the right image of each left pixel, row by row; NaN where it is not seen there. */
  rightPosition: Float32Array;
  leftWidth: number;
  leftHeight: number;
}

/** The window of a point or place, or why it has no moments. `col` and `row` are those of its centre pixel. */
export interface PointWindow {
  col: number;
  row: number;
  report: WindowReport | null;
  problem: string | null;
}

/** A point with its gradient descriptor, and what of the image it describes. */
export interface FeatureView {
  /** 4 x 4 cells of 8 directions. */
  descriptor: Uint8Array;
  scale: number;
  /** Of the grid's rows in the image, rad from x towards y. */
  direction: number;
  /** Side of the 4 x 4 cells in px. */
  reach: number;
  /** The cells turned and scaled to the frame of the point, and their surroundings as they lie in the image: grey values row by row. */
  turned: Uint8Array;
  upright: Uint8Array;
}

/** A place of a match that is no interest point: it was placed by least squares or by hand, and has no descriptor. */
export interface PlaceView {
  descriptor: null;
  byHand: boolean;
  /** What the image shows there, as it lies in it: grey values row by row. */
  upright: Uint8Array;
}

/** Where the selected point may be seen in the other image: x, y in px along its epipolar line, or of one place; stride 2. */
export interface SeenAt {
  side: Side;
  positions: Float64Array;
}

/** What is looked up about the selected point. */
export interface Inspection {
  left: PointWindow | null;
  right: PointWindow | null;
  /** For the strategy that compares gradients, in place of the windows. */
  features: Record<Side, FeatureView | PlaceView | null> | null;
  /** Stride 2: right index, measure; best first. Empty where the strategy searches the image in place of points. */
  candidates: Float64Array;
  /** Its y-parallax beside those of its nearest matches; null where there is none, or the strategy does not compare them. */
  parallax: ParallaxDeviation | null;
  line: SeenAt | null;
}

/** Points; those of the strategy gradient come with 128 bytes each, the others with none. */
export type FoundPoints = DetectedPoints & Pick<DescribedPoints, 'gradients'>;

/** What the strategy compares of each point. */
export type GivenDescriptors = Pick<DescribedPoints, 'moments' | 'gradients'>;

/** What each stage makes. */
export interface StageValues {
  openLeft: { info: PhotoInfo; overview: Overview };
  openRight: { info: PhotoInfo; overview: Overview };
  pointsLeft: FoundPoints;
  pointsRight: FoundPoints;
  descriptorsLeft: GivenDescriptors;
  descriptorsRight: GivenDescriptors;
  offset: OffsetField;
  match: MatchResult;
  interiorLeft: InteriorOutput;
  interiorRight: InteriorOutput;
  orientation: OrientedPair;
  score: MatchScore;
  /** How the photos lie to each other in their planes; null where they do not match. */
  difference: PhotoDifference | null;
  inspection: Inspection;
  /** Where the point that is measured may lie; null where no geometry of the two views is known. */
  line: SeenAt | null;
}

export type StageName = keyof StageValues;

export interface StageResult<S extends StageName> {
  key: string;
  value: StageValues[S];
  milliseconds: number;
  /** Of an orientation the matches that it was made from. */
  of?: MatchesOf;
}

export type Results = { [S in StageName]?: StageResult<S> };

/** Why a stage has no result for a key. */
export interface StageFailure {
  key: string;
  message: string;
  /** The worker ended: it can be tried again as it is. */
  ended: boolean;
  /** With its figures, where the crate refused. */
  error: { kind: string } | null;
}

export interface Selection {
  side: Side;
  index: number;
}

/** `matched`: accepted matches alone; `all`: the points that were rejected too, and those that nothing was decided about. */
export type PointLayer = 'all' | 'matched' | 'none';
export type LineLayer = 'all' | 'some' | 'none';

export interface Display extends Light {
  points: PointLayer;
  lines: LineLayer;
  /** Enlargement of the residual vectors; 0 hides them. */
  vectors: number;
  linked: boolean;
  magnifier: boolean;
  /** Codes of `pointCodes` that are hidden. */
  hidden: readonly number[];
}

/** Matches of one kind: those that the adjustment used, that it rejected, that were rejected or measured by hand, that the truth says are wrong. */
export type MatchKind = 'all' | 'used' | 'rejected' | 'by-hand' | 'wrong';

/** Which matches their table and the pictures show: those of a kind that meet what is typed over the columns. */
export interface MatchFilter {
  kind: MatchKind;
  conditions: Filter;
}

export const ALL_MATCHES: MatchFilter = { kind: 'all', conditions: {} };

/** `look`: a drag moves the pictures; `choose`: it draws a rectangle around matches; `measure`: a press places a point; `mask`: a drag outlines an area; `fiducials`: a press measures a mark. */
export type Tool = 'look' | 'choose' | 'measure' | 'mask' | 'fiducials';

/** The fiducial mark that is measured now. */
export interface MarkInHand {
  side: Side;
  /** Among the marks of its photo; behind the last one for a new mark. */
  index: number;
  /** Where the marks that were measured have it, in px of the image; null where they do not tell. */
  expected: readonly [x: number, y: number] | null;
}

/** An area that is being outlined: corners in px of its image. */
export interface Outline {
  side: Side;
  corners: readonly (readonly [x: number, y: number])[];
}

/** An area of a mask: it holds no points, or holds them again. */
export interface Area {
  corners: Outline['corners'];
  masked: boolean;
}

/** What was done to the mask of an image: an area was painted, or a file took its place; null: it was removed. */
export type MaskStep = { side: Side } & (Area | { given: MaskFile | null });

/** What was done to a fiducial mark. */
export type Deed = 'measured' | 'moved' | 'nudged' | 'cleared' | 'typed' | 'coordinates' | 'added' | 'removed' | 'all_removed' | 'given';

/** What was done to the marks of a photo: those from a place on that were there gave way to others. */
export interface MarkStep {
  side: Side;
  deed: Deed;
  at: number;
  out: readonly Fiducial[];
  put: readonly Fiducial[];
}

/** A match that is being measured: a point in one image, then its place in the other. */
export interface Draft {
  /** The match that is moved; null for a new one. */
  of: Target | null;
  /** Where its points were placed. */
  places: Record<Side, readonly [x: number, y: number] | null>;
  /** The image in which it is placed now. */
  side: Side;
}

/** What was done by hand in a pair that is not on the page: its edits, and the match that was being measured. */
export interface Shelved extends History<Edit> {
  draft: Draft | null;
}

/** Parts of the state that are typed in fields. */
export const TYPED_PARTS = ['settings', 'camera', 'photos', 'offset'] as const;
export type TypedPart = (typeof TYPED_PARTS)[number];

export interface State {
  catalogue: Catalogue | null;
  settings: Settings | null;
  /** Labels of fields that hold a value that is not allowed; the last valid one is in use. */
  refused: Readonly<Partial<Record<TypedPart, string>>>;
  images: Record<Side, GivenImage | null>;
  photos: Record<Side, PhotoData>;
  masks: Record<Side, GivenMask | null>;
  /** The masks that were there before all steps. */
  givenMasks: Record<Side, MaskFile | null>;
  camera: CameraMm | null;
  fiducialModel: FiducialModel;
  /** Offset given by the user; estimated where null. */
  offset: [number, number] | null;
  truth: FlightTruth | null;
  /** The flight that the panel of simulation shows; null until the crate is loaded. */
  flight: Flight | null;
  results: Results;
  running: Partial<Record<StageName, string>>;
  failures: Partial<Record<StageName, StageFailure>>;
  /** Nothing runs until the user asks or changes something. */
  paused: boolean;
  selection: Selection | null;
  /** What was done to the matches by hand. */
  history: History<Edit>;
  /** What was done by hand to masks and to fiducial marks. */
  maskSteps: History<MaskStep>;
  markSteps: History<MarkStep>;
  /** The edits of other pairs, which may be opened again. */
  shelf: ReadonlyMap<string, Shelved>;
  /** Keys of the matches that are chosen together, beside the selection. */
  chosen: readonly string[];
  filter: MatchFilter;
  /** The orientation before the latest edit, and of which run it is (`runKey`). */
  before: { run: string | null; orientation: OrientedPair } | null;
  /** What a press or a drag on the pictures does. */
  tool: Tool;
  draft: Draft | null;
  outline: Outline | null;
  mark: MarkInHand | null;
  activeSide: Side;
  views: Record<Side, PaneView | null>;
  display: Display;
  notice: Notice | null;
}

/** What belongs to the matches of a pair, and to what was done by hand, goes with its images. */
export const UNEDITED: Pick<State, 'history' | 'maskSteps' | 'markSteps' | 'chosen' | 'filter' | 'before' | 'draft' | 'outline' | 'mark'> = {
  history: NO_HISTORY,
  maskSteps: NO_HISTORY,
  markSteps: NO_HISTORY,
  chosen: [],
  filter: ALL_MATCHES,
  before: null,
  draft: null,
  outline: null,
  mark: null,
};

export const INITIAL: State = {
  catalogue: null,
  settings: null,
  refused: {},
  images: { left: null, right: null },
  photos: { left: { fiducials: [], origin: null }, right: { fiducials: [], origin: null } },
  masks: { left: null, right: null },
  givenMasks: { left: null, right: null },
  camera: null,
  fiducialModel: 'affine',
  offset: null,
  truth: null,
  flight: null,
  results: {},
  running: {},
  failures: {},
  paused: false,
  selection: null,
  ...UNEDITED,
  shelf: new Map(),
  tool: 'look',
  activeSide: 'left',
  views: { left: null, right: null },
  display: { points: 'matched', lines: 'some', vectors: 0, linked: true, magnifier: false, hidden: [], ...OWN_LIGHT },
  notice: null,
};
