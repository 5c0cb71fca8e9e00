/** What the page shows of a block: small enough to be handed from worker to page, flat where there is much of it. */
import type {
  BlockScore,
  BlockVerdict,
  Camera,
  CheckSummary,
  Connection,
  ExportFormat,
  GeographicOrigin,
  Geoid,
  OnOrthophoto,
  RefinementOutcome,
  SurveyedPoint,
  TwoView,
  VarianceComponent,
} from '../../../pkg/wasm/tiepoint.js';

export interface ViewImage {
  name: string;
  width: number;
  height: number;
  camera: number;
  /** Null in a block that was opened from its file. */
  features: number | null;
  /** Of the nine von Gruber places, those that hold a chosen point; null in a block that was opened from its file. */
  places: number | null;
  /** Of chosen points; of accepted ones after the adjustment. */
  rays: number;
  rmsePx: number | null;
  oriented: boolean;
  /** Its projection centre; null where it is not oriented. */
  position: readonly [number, number, number] | null;
  /** Of EXIF, 1 to 8: how the stored rows and columns lie; they are taken as they are stored. Null where it is not told. */
  exifOrientation: number | null;
  /** Why it is not oriented, in words; empty where it is, null while no image is. */
  why: string | null;
}

export interface ViewCamera {
  label: string;
  images: number;
  /** What was known before; null where its focal length was not. */
  given: Camera | null;
  /** As the block adjusted it; null before. */
  calibrated: Camera | null;
  focalErrorPx: number | null;
}

/** What relates two views, with the standard error of a coordinate. */
export interface ViewGeometry {
  kind: TwoView['model']['kind'];
  degenerate: TwoView['degenerate'];
  sigmaPx: number;
}

export interface ViewConnection {
  images: [number, number];
  rule: Connection['rule'];
  outcome: Connection['outcome'];
  /** Why the images are connected or are not, in words. */
  reason: string;
  /** Null where nothing relates the views. */
  geometry: ViewGeometry | null;
  /** Multi-ray points that both see. */
  shared: number;
  /** Of them, the points that were chosen and kept. */
  chosen: number;
  /** By hand. */
  rejected: boolean;
}

/** Where the images are drawn: x to the right, y up, in m or without unit. */
export interface Layout {
  /** Oriented poses, recorded positions, or only who is connected with whom. */
  kind: 'oriented' | 'recorded' | 'connections';
  /** x, y of each image; stride 2. */
  places: Float64Array;
}

/** One a point. */
export interface ViewPoints {
  count: number;
  /** The first of them, so many, take part; the others were rejected by hand, or lost. */
  taking: number;
  /** Those that no edit rejects: edits leave them without two rays that meet. */
  lost: ReadonlySet<number>;
  /** What each is, as a code (see `edits.ts`); empty where the block is not oriented. */
  sources: Float64Array;
  /** What each is called by. */
  numbers: Uint32Array;
  rays: Uint16Array;
  /** NaN where the points are not adjusted. */
  rmsePx: Float64Array;
  /** X, Y, Z; NaN where it is not intersected; stride 3. */
  positions: Float64Array;
  /** Standard errors of X, Y, Z; NaN where there are none; stride 3. */
  errors: Float64Array;
  /** Probability, 0..1, that all rays belong together. */
  confidence: Float64Array;
}

/** Residuals of the points of one number of rays. */
export interface RayCount {
  rays: number;
  points: number;
  rmsePx: number | null;
}

/** An image that is not in the block, and why. */
export interface SkippedImage {
  name: string;
  reason: string;
}

/** A surveyed point, with what it is in the block. */
export interface ViewSurveyed extends SurveyedPoint {
  /** Its number among the surveyed points that were given. */
  control: number;
  /** Index of the point. */
  point: number;
  /** Whether it takes part; else it was left out by hand, or contradicts the other observations. */
  isUsed: boolean;
  /** Whether an edit by hand added it. */
  byHand: boolean;
}

/** A control or check point that was given, or added by hand, and is not in the block: too few image measurements say where it is. */
export interface ViewGiven {
  name: string;
  /** In the unit and the system of its file. */
  position: readonly [number, number, number];
  /** In the system of the block; null where nothing leads there. */
  place: readonly [number, number, number] | null;
  /** Null of one that is not to be used. */
  role: 'control' | 'check' | null;
  /** In so many images it is measured. */
  images: number;
  /** Whether an edit by hand added it. */
  byHand: boolean;
}

export interface BlockView {
  /** Of a run that goes on or was ended: images and pairs as far as they were done. */
  partial: boolean;
  images: ViewImage[];
  leftOut: SkippedImage[];
  /** Masks that belong to no image. */
  strayMasks: string[];
  /** Images that marks name and that are not in the block. */
  strayMarks: string[];
  /** What of cameras and recorded positions is doubtful or was left out, in words. */
  remarks: string[];
  cameras: ViewCamera[];
  connections: ViewConnection[];
  /** Images that are connected with each other, the largest group first. */
  groups: number[][];
  layout: Layout;
  points: ViewPoints;
  /** Multi-ray points before some were chosen; null in a block that was opened from its file. */
  found: { points: number; rays: number } | null;
  /** What became of the rays that were refined; null where none were. */
  refinement: Record<RefinementOutcome, number> | null;
  byRays: RayCount[];
  oriented: number;
  /** What the block is worth, in one sentence; null while it is under way. */
  verdict: { kind: BlockVerdict['kind']; text: string } | null;
  /** What came of the orthophoto that it was given, in one sentence, and whether positions are not in its system but in its coordinate reference system; null where it was given none. */
  orthophoto: { kind: OnOrthophoto['kind']; inCrs: boolean; text: string } | null;
  /** Where its system touches the earth; null where that is not known. */
  origin: GeographicOrigin | null;
  /** The coordinate reference system that was chosen for control points and results; null: none. */
  crs: string | null;
  /** The name of that system, where results are in it. Absent, as null, where they are in that of the adjustment. */
  system?: string | null;
  /** The height of the zero of its heights above the ellipsoid, m; null where it is not known. */
  geoidM: number | null;
  /** The part about the block of the geoid from which they count. Absent, as null, where none was given. */
  geoid?: Geoid | null;
  rmsePx: number | null;
  sigma0Px: number | null;
  /** Ground control points and check points of the block. */
  surveyed: readonly ViewSurveyed[];
  /** How many of them the block was found with, those without figures included: edits count those that they add from there on. */
  givenControl: number;
  /** How large errors are beside stated standard errors; empty where none are stated. */
  components: readonly VarianceComponent[];
  /** What check points say of the block; null without any. */
  checks: CheckSummary | null;
  /** How near a simulated block is to its truth. */
  score: BlockScore | null;
  /** What is weak about the block, in words. */
  warnings: string[];
  formats: ExportFormat[];
}
