/** The types that the stages of a block share. */

import type {
  Reconstruction, BlockModel, BlockSettings, Connection, ExifImage, FinishedBlock, Given, JoinCounts, Camera, PairOutcome, Pinhole, Remark, RefinementOutcome, TwoViewResult,
} from '../wasm/tiepoint.js';

/** An image file that can be read any number of times. */
export interface Source {
  /** File name; no two images have the same. */
  name: string;
  bytes(): Promise<Uint8Array>;
}

/** The jobs that workers do, from input to output. */
export interface Jobs {
  features: { input: FeatureJob; output: Uint8Array };
  pair: { input: PairJob; output: Uint8Array };
  likeness: { input: LikenessJob; output: Uint32Array };
  windows: { input: WindowJob; output: Uint8Array };
  refine: { input: RefineJob; output: Float64Array };
}

/** Finds and describes the features of an image, where its mask lets them be: a record of features. */
export interface FeatureJob {
  bytes: Uint8Array;
  key: string;
  options: BlockSettings['features'];
  mask: { name: string; bytes: Uint8Array } | null;
}

/** Matches two records of features: a record of a pair. */
export interface PairJob {
  key: string;
  left: { record: Uint8Array; key: string };
  right: { record: Uint8Array; key: string };
  cameras: [PairCamera, PairCamera];
  nearest: BlockSettings['nearest'];
  geometry: BlockSettings['geometry'];
  leastMatches: number;
}

/** A camera as a pair takes it. */
export interface PairCamera {
  pinhole: Pinhole;
  /** Whose distortion positions are freed of; null where none is known. */
  lens: Camera | null;
}

/** Counts, for one image, the mutual matches of its coarse features with those of others. */
export interface LikenessJob { own: Uint8Array; others: Uint8Array[] }

/** Cuts windows out of an image around rays (x, y and scale in px; stride 3): a record of windows. */
export interface WindowJob { bytes: Uint8Array; key: string; rays: Float64Array; options: BlockSettings['refinement'] }

/** Refines points by the windows of their rays, all as `refine_points` takes them, and gives what it gives. */
export interface RefineJob { starts: Uint32Array; rays: Float64Array; places: Uint32Array; grey: Uint8Array; options: BlockSettings['refinement'] }

/**
 * Runs jobs on workers. A job that fails rejects with what it threw; a worker that broke down is replaced. `transfer` is memory of the run's
 * own; what sources and the store have given stays theirs.
 */
export interface Pool {
  /** How many jobs run at the same time. */
  readonly size: number;
  run<N extends keyof Jobs>(name: N, input: Jobs[N]['input'], transfer?: ArrayBufferLike[]): Promise<Jobs[N]['output']>;
}

/** Keeps records by key; `put` keeps a record whole or not at all. */
export interface Store {
  get(key: string): Promise<Uint8Array | null>;
  put(key: string, record: Uint8Array): Promise<void>;
}

export type StageName = 'photos' | 'images' | 'likeness' | 'pairs' | 'points' | 'windows' | 'refinement' | 'orientation';

/** How far a stage is. */
export interface Step {
  stage: StageName;
  done: number;
  total: number;
  /** What was done last: the name of an image, or of both of a pair. */
  name?: string;
  /** How many of those done were there from an earlier run. */
  found: number;
  /** Since the stage began. */
  seconds: number;
  /** Absent until there is something to tell it by. */
  secondsLeft?: number;
}

export interface FeatureHead {
  key: string;
  width: number;
  height: number;
  format: string;
  bits_per_sample: number;
  exif: ExifImage;
}

export interface PairHead {
  key: string;
  outcome: PairOutcome;
  /** What relates the views; absent where nothing does. */
  geometry: Omit<TwoViewResult, 'inliers'> | null;
}

export interface Features { head: FeatureHead; count: number; positions: Float32Array; shapes: Float32Array; descriptors: Uint8Array }

export interface Pair { head: PairHead; count: number; indices: Uint32Array; strengths: Float32Array }

export interface WindowHead { key: string; side: number }

export interface Windows { head: WindowHead; count: number; places: Uint32Array; grey: Uint8Array }

/** What became of the rays that were refined, one after the other. */
export interface Refinement {
  points: number;
  /** The first ray of each point, and the number of rays. */
  starts: Uint32Array;
  /** How many rays had each outcome. */
  counts: Record<RefinementOutcome, number>;
  images: Uint32Array;
  /** x, y in px; stride 2. */
  positions: Float32Array;
  /** Places among `refinement_outcomes`. */
  outcomes: Uint8Array;
  /** Standard error in px relative to the reference ray, and correlation with it; NaN where a ray was not refined; stride 2. */
  precision: Float32Array;
}

/** A camera of a block before its calibration. */
export interface GroupedCamera {
  /** Make, model, focal length and size, or the pattern of the rule. */
  label: string;
  width_px: number;
  height_px: number;
  /** Null where it is not known. */
  focal_px: number | null;
  principal_point_px: [number, number];
  radial: [number, number, number];
  tangential: [number, number];
  pixel_mm: number | null;
  /** Whether the block takes it as it is. */
  fixed: boolean;
}

/** An image that was read. */
export interface BlockImage {
  name: string;
  /** Of its record of features. */
  key: string;
  width: number;
  height: number;
  features: number;
  /** Whether a mask belongs to it. */
  masked: boolean;
  /** Digest of the file's bytes. */
  content: string;
  exif: ExifImage;
  camera: number;
}

/** An image that was left out, and why. */
export interface LeftOut { name: string; reason: string }

export interface RunOptions {
  settings?: Given<BlockSettings>;
  /** Cameras in place of those of EXIF, as the text of a file. */
  cameras?: { name: string; text: string };
  /** Whether recorded positions are used, to choose pairs and, where there are no surveyed points, to place the block. */
  gps?: 'use' | 'ignore';
  control?: ControlText;
  /** Image files, 0 (black) where no features are wanted, each as large as the image whose name it has. */
  masks?: readonly Source[];
}

/** Surveyed points and where the images show them, as the texts of two files. */
export interface ControlText { points: string; marks: string }

export interface Surroundings {
  pool: Pool;
  store: Store;
  progress?: (step: Step) => void;
  /** Takes what is found, as soon as it is. */
  news?: (news: News) => void;
  signal?: AbortSignal;
}

/** What a run finds on its way; `index`: of the source. Images of a pair count without those that were left out. */
export type News =
  | { kind: 'image'; index: number; image: ReadImage }
  | { kind: 'left-out'; leftOut: LeftOut }
  | { kind: 'pair'; connection: Connection; geometry: PairHead['geometry'] };

/** What is known of an image once it was read. */
export interface ReadImage { name: string; head: FeatureHead; count: number; /** Digest of the file's bytes. */ content: string; masked: boolean }

/** Everything that a run found. */
export interface BlockRun {
  settings: BlockSettings;
  images: BlockImage[];
  leftOut: LeftOut[];
  /** Masks that belong to no image. */
  strayMasks: string[];
  /** Images that marks name and that are not in the block. */
  strayMarks: string[];
  /** What else of the input was not taken as it was given, or is hardly right. */
  remarks: Remark[];
  cameras: GroupedCamera[];
  connections: Connection[];
  /** In the order of `connections`. */
  geometries: PairHead['geometry'][];
  /** `histogram`: how many points have 0, 1, 2, … rays; `shared`: two images and how many points they have in common, stride 3. */
  points: { join: JoinCounts; count: number; rays: number; histogram: number[]; shared: number[] };
  /** Null where rays are not refined. */
  refinement: Refinement | null;
  /** Absent where the block has no model, and then why. */
  reconstruction: Reconstruction | null;
  reconstructionReason: string | null;
  model: BlockModel;
  /** All of it as the crate holds it, which writes and shows it; its owner frees it. */
  finished: FinishedBlock;
}
