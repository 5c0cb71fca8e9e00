/** Every call that a worker answers for a pair: name to input and output. Both ends are typed by this one table. */
import type { WorkerClient } from '../../shared/engine/client';
import type {
  CameraMm,
  DescribedPoints,
  DetectedPoints,
  EpipolarGeometry,
  Fiducial,
  FiducialModel,
  FiducialOrientation,
  Flight,
  GivenPoints,
  MatchResult,
  MatchScore,
  NearestPiece,
  OffsetField,
  Given,
  PairInput,
  PairInterior,
  PairProject,
  ParallaxDeviation,
  PhotoDifference,
  PhotoInfo,
  ReducedImage,
  OrientedPair,
  ReportEdits,
  ReportTruth,
  SamplePair,
  SampleImage,
  Settings,
  Strategy,
  TwoViewModel,
  WindowReport,
} from '../../shared/crate';
import type { ImageSource, InteriorOutput, MaskImage, Overview } from '../state/data';
import type { Area } from '../state/state';

/** Points of both images with what is compared, and the offset between them where the strategy needs one: what matching starts from. */
export interface MatchInput {
  left: GivenPoints;
  right: GivenPoints;
  offset: OffsetField | null;
}

/** Gradient descriptors of both images: for the left ones from `first` to before `end` the nearest right ones are wanted. */
export interface NearestInput {
  left: Uint8Array;
  first: number;
  end: number;
  right: Uint8Array;
}

/** A square grid of samples in an image. */
export interface PatchInput {
  /** Its middle, px. */
  x: number;
  y: number;
  /** Direction of its rows, from x towards y. */
  direction: number;
  /** Side of the grid in px, and in samples. */
  reach: number;
  side: number;
}

/** A point of one image, and the size of the other image, in which its epipolar line is wanted. */
export interface LineInput {
  from: 'left' | 'right';
  x: number;
  y: number;
  model: TwoViewModel;
  interior: PairInterior | null;
  width: number;
  height: number;
}

/** What the truth of a simulated pair is compared with. */
export interface ScoreInput {
  matches: Float64Array;
  leftPoints: Float64Array;
  /** x, y in the right image of each left pixel; NaN where it is not seen. */
  rightPosition: Float32Array;
  left: { width: number; height: number };
  right: { width: number; height: number };
}

/** A pair as its report needs it. */
export interface ReportInput {
  images: [ImageSource, ImageSource];
  names: [string, string];
  input: Given<PairInput>;
  settings: Settings;
  truth: ReportTruth | null;
  /** Left and right. */
  masks: [Uint8Array | null, Uint8Array | null];
  /** Null where the matches are as they were found. */
  edits: ReportEdits | null;
}

/** Areas of a mask, one over the other. */
export interface PaintInput {
  /** The grey values of a mask, or its file, over which they are painted; null: nothing is masked yet. */
  over: Uint8Array | Blob | null;
  width: number;
  height: number;
  /** Corners of each outline in px. */
  areas: readonly Area[];
  overlaySide: number;
}

/** What is known of one photo's geometry. */
export interface PhotoInput {
  width: number;
  height: number;
  camera: CameraMm;
  /** The focal length of the pair: the photo is taken to it where its own is another. */
  pairFocalMm: number;
  fiducials: Fiducial[];
  model: FiducialModel;
  origin: [number, number] | null;
}

export interface PairCalls {
  // One image a worker: `open` first, the others refer to the image opened last.
  open: { input: { source: ImageSource; overviewSide: number }; output: { info: PhotoInfo; overview: Overview } };
  tile: { input: { level: number; column: number; row: number; side: number }; output: ImageBitmap };
  reduced: { input: { maxSide: number }; output: ReducedImage };
  /** Without the mask all pixels count. */
  detect: { input: { settings: Settings; mask: Uint8Array | null }; output: DetectedPoints };
  /** Finds points and describes them by gradients in one go. */
  features: { input: { settings: Settings; mask: Uint8Array | null }; output: DescribedPoints };
  describe: { input: { points: Float64Array; window: Settings['window']; strategy: Strategy }; output: Float64Array };
  grey: { input: null; output: SampleImage };
  patch: { input: PatchInput; output: Uint8Array };
  moments: { input: { col: number; row: number; window: Partial<Settings['window']> }; output: WindowReport };
  // The pair.
  simulate: { input: Flight; output: SamplePair };
  /** Gives the worker the grey values of both images, for the calls that compare them. */
  hold: { input: { left: SampleImage; right: SampleImage }; output: null };
  offset: { input: { left: ReducedImage; right: ReducedImage }; output: OffsetField };
  constantOffset: { input: { dx: number; dy: number }; output: OffsetField };
  /** One piece of the nearest neighbours that `match` looks for where it is given none. */
  nearest: { input: NearestInput; output: NearestPiece };
  match: {
    input: MatchInput & { interior: PairInterior | null; settings: Settings; nearest: NearestPiece[] | null };
    output: MatchResult;
  };
  difference: { input: null; output: PhotoDifference | null };
  candidates: { input: MatchInput & { index: number; options: Settings['matching'] }; output: Float64Array };
  parallaxDeviation: {
    input: { index: number; points: Float64Array; match: Pick<MatchResult, 'rules' | 'places'>; offset: OffsetField; options: Settings['matching'] };
    output: ParallaxDeviation | undefined;
  };
  gradientCandidates: { input: { index: number; left: Uint8Array; right: Uint8Array; most: number }; output: Float64Array };
  epipolarLine: { input: LineInput; output: Float64Array };
  score: { input: ScoreInput; output: MatchScore };
  interior: { input: PhotoInput; output: InteriorOutput };
  orient: {
    input: { matches: Float64Array; fits: Float64Array; interior: PairInterior; options: Settings['orientation']; points: [number, number] };
    output: OrientedPair;
  };
  // The report: `reportOpen` first; it gives what each step does.
  reportOpen: { input: ReportInput; output: string[] };
  reportStep: { input: null; output: boolean };
  reportPage: { input: null; output: string };
  /** Left, right and anaglyph as PNG, and their parameters, in an archive; for an oriented pair, given by the text of its project file. */
  epipolar: { input: { project: string; images: [ImageSource, ImageSource] }; output: { archive: Uint8Array<ArrayBuffer>; geometry: EpipolarGeometry } };
  // Files.
  mask: { input: { file: Blob; overlaySide: number }; output: MaskImage };
  /** A mask with areas masked or no longer, and the same as PNG. */
  paintMask: { input: PaintInput; output: MaskImage & { png: Uint8Array<ArrayBuffer> } };
  parseFiducials: { input: { text: string }; output: Fiducial[] };
  /** Null where the marks do not determine it. */
  orientMarks: { input: { fiducials: Fiducial[]; model: FiducialModel }; output: FiducialOrientation | null };
  parseCamera: { input: { text: string }; output: CameraMm };
  /** SHA-256 in hexadecimal digits. */
  digest: { input: { file: Blob }; output: string };
  projectOpen: { input: { bytes: Uint8Array }; output: PairProject };
  projectWrite: { input: PairProject; output: string };
  matchesCsv: { input: { matches: Float64Array; rejected: number[] | null }; output: string };
}

export type PairClient = WorkerClient<PairCalls>;

export type Input<K extends keyof PairCalls> = PairCalls[K]['input'];
export type Output<K extends keyof PairCalls> = PairCalls[K]['output'];
