/** The calls of a block that workers answer, and what passes between a run and the page while it goes on. */
import type { Frame, FrameInput, FramePlan, PlanInput } from './film';
import type { BlockJob, RunOptions, Step } from '../../../pkg/block/index.js';
import type { PlainError } from '../../../pkg/block/wire.js';
import type {
  BlockFlight,
  BlockModel,
  BlockPlaces,
  ExifPosition,
  ExportFormat,
  OrthophotoInfo,
  PlaceAgain,
  Placement,
  PlacingVerdict,
  PointDetail,
  Remark,
} from '../../../pkg/wasm/tiepoint.js';
import type { Position } from '../../shared/state/pane';
import type { LinksInput } from './block-links';
import type { Turn, Window } from './match';
import type {
  AdjustInput,
  ControlInput,
  ElsewhereInput,
  Ground,
  LaidInput,
  LaidPicture,
  MosaicInput,
  MosaicPlan,
  PlaceInput,
  PredictInput,
  TileInput,
} from './orthophoto';
import type { ProjectInput } from './project-input';
import type { AddedControl } from '../state/added';
import type { EditStep } from '../state/edits';
import type { ImagePoints, ViewObservations } from '../state/facts';
import type { LinkedImage } from '../state/links';
import type { BlockFile } from '../state/state';
import type { ViewGround } from '../state/ground';
import type { BlockView } from '../state/view';

/** `refusal`: what the crate says against an image or a pair; the run goes on without it. */
export type JobAnswer = { made: Uint8Array } | { refusal: PlainError };

/** What a run tells the page. */
export type FromRun =
  | { kind: 'step'; step: Step }
  /** What has been found so far. */
  | { kind: 'part'; view: BlockView }
  | { kind: 'keep'; key: string; record: Blob }
  | { kind: 'job'; id: number; job: BlockJob };

/** What the page tells a run. */
export type ToRun =
  | { kind: 'answer'; id: number; answer: JobAnswer }
  /** The worker of a job broke down. */
  | { kind: 'broke'; id: number; message: string }
  | { kind: 'stop' };

export interface RunInput {
  files: readonly BlockFile[];
  options: Omit<RunOptions, 'masks' | 'geoid'>;
  masks: readonly BlockFile[];
  geoid: BlockFile | null;
  /** Of a simulated block. */
  truth: BlockModel | null;
  /** How many jobs run at the same time. */
  workers: number;
  /** Records of earlier runs. */
  kept: ReadonlyMap<string, Blob>;
  port: MessagePort;
}

/** What a block is saved as: its own file, everything, or what another program reads. */
export type ExportKind = 'project' | 'everything' | ExportFormat;

/** A file to save. */
export interface MadeFile {
  name: string;
  type: string;
  bytes: Uint8Array<ArrayBuffer>;
}

/** A block of a file, with the steps of edits that it was saved with, and what it was made of. */
export interface OpenedBlock {
  view: BlockView;
  steps: readonly EditStep[];
  made: ProjectInput;
}

export interface BlockCalls {
  // Any worker of the pool.
  blockJob: { input: BlockJob; output: JobAnswer };
  /** The truth of a flight, which names its photos. */
  blockPlan: { input: BlockFlight; output: BlockModel };
  blockPhoto: { input: { flight: BlockFlight; index: number }; output: Uint8Array<ArrayBuffer> };
  /** The grey values of an image that the browser cannot decode. */
  blockGrey: { input: { file: Blob }; output: ImageBitmap };
  /** The grey values around a place of an image. */
  blockWindow: { input: { file: Blob; at: Position; turn: Turn | null }; output: Window };
  blockFit: { input: { left: Window; right: Window }; output: Position | null };
  // The worker of the block: it holds the block that was run or opened last.
  blockRun: { input: RunInput; output: BlockView };
  blockOpen: { input: { bytes: Uint8Array; truth: BlockModel | null }; output: OpenedBlock };
  blockPlaces: { input: null; output: BlockPlaces };
  /** Which places of an orthophoto lie where these lay. */
  blockPlacesAgain: { input: { before: BlockPlaces }; output: PlaceAgain[] };
  /** The block as it was found with these edits, adjusted anew. */
  blockEdited: { input: { steps: readonly EditStep[]; truth: BlockModel | null }; output: BlockView };
  blockImagePoints: { input: { image: number }; output: ImagePoints };
  blockObservations: { input: { images: number }; output: ViewObservations };
  blockGround: { input: null; output: ViewGround };
  blockPoint: { input: { point: number }; output: PointDetail };
  blockLine: { input: { from: number; x: number; y: number; to: number }; output: Float64Array };
  /** A message through `stop` breaks it off. */
  blockExport: { input: { kind: ExportKind; name: string; stop: MessagePort }; output: MadeFile };
  // The worker that reads what images record.
  imagePosition: { input: { file: Blob }; output: ExifPosition | null };
  // The worker that shows an orthophoto, and those that place images on it.
  orthoInfo: { input: Ground; output: OrthophotoInfo };
  orthoTile: { input: TileInput; output: ImageBitmap };
  /** What is to be said of images before they are placed. */
  orthoElsewhere: { input: ElsewhereInput; output: Remark | null };
  orthoSearch: { input: Pick<PlaceInput, 'ground' | 'options'>; output: number };
  orthoPlace: { input: PlaceInput; output: LinkedImage };
  orthoRectified: { input: { ground: Ground; file: Blob; placement: Placement }; output: Uint8Array };
  orthoAdjust: { input: AdjustInput; output: LinkedImage };
  orthoPredict: { input: PredictInput; output: [number, number] | null };
  orthoControl: { input: ControlInput; output: AddedControl };
  orthoLaid: { input: LaidInput; output: LaidPicture };
  // The worker that places a block on it; the images by their indices.
  linksOpen: { input: LinksInput; output: (string | null)[] };
  linksPlace: { input: { index: number; file: Blob }; output: PlacingVerdict | null };
  linksFinish: { input: null; output: Uint8Array };
  filmPlan: { input: PlanInput; output: FramePlan };
  filmFrame: { input: FrameInput; output: Frame };
  mosaicOpen: { input: MosaicInput; output: MosaicPlan };
  mosaicAdd: { input: { index: number; file: Blob }; output: null };
  mosaicFinish: { input: null; output: Blob };
  sceneOrthophoto: { input: { flight: BlockFlight; gsd: number }; output: { picture: Uint8Array<ArrayBuffer>; heights: Uint8Array<ArrayBuffer> } };
}
