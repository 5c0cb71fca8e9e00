/** The state of the block's part of the page. */
import type { Step, StageName } from '../../../pkg/block/index.js';
import type { BlockFlight, BlockModel, BlockSettings, Parameter } from '../../../pkg/wasm/tiepoint.js';
import type { Notice } from '../../shared/state/notice';
import type { Labels } from '../../shared/text/names';
import type { BlockView } from './view';

/** An image file of a block. */
export interface BlockFile {
  /** Differs for every file ever given. */
  id: number;
  /** No two of a block have the same. */
  name: string;
  file: Blob;
}

/** What the crate says of blocks: read once, when the module is there. */
export interface BlockCatalogue {
  parameters: Parameter[];
  defaults: BlockSettings;
  flightParameters: Parameter[];
  flight: BlockFlight;
  /** Of these and the pair's: messages name any of them. */
  labels: Labels;
}

/** A file that was read as text. */
export interface TextFile {
  name: string;
  text: string;
}

/** What the user chooses of a run. */
export interface BlockOptions {
  settings: BlockSettings | null;
  gps: 'use' | 'ignore';
  /** In place of what EXIF tells. */
  cameras: TextFile | null;
  /** Surveyed points, and where the images show them: of use together. */
  control: TextFile | null;
  marks: TextFile | null;
  masks: readonly BlockFile[];
}

export type Mode = 'pair' | 'block';

export function isMode(text: string): text is Mode {
  return text === 'pair' || text === 'block';
}

/** An image or a pair that is looked at. */
export type Choice = { kind: 'image'; image: number } | { kind: 'pair'; images: [number, number] };

/** How far each stage is that was begun. */
export type Steps = Partial<Record<StageName, Step>>;

export type Running =
  | { kind: 'no' }
  | { kind: 'yes'; key: string; steps: Steps }
  /** Ended by the user or by a failure, whose message it then has. */
  | { kind: 'ended'; steps: Steps; failure: string | null };

/** A block, and what it was made from. */
export interface Shown {
  key: string;
  view: BlockView;
  /** Empty for a block that was opened. */
  files: readonly BlockFile[];
  steps: Steps;
  seconds: number;
}

export interface BlockState {
  mode: Mode;
  catalogue: BlockCatalogue | null;
  files: readonly BlockFile[];
  /** Of photos that were simulated. */
  truth: BlockModel | null;
  options: BlockOptions;
  /** The label of a setting whose field holds a value that is not allowed; the options hold its last valid one. */
  refused: string | null;
  flight: BlockFlight | null;
  running: Running;
  /** The block on the screen. */
  shown: Shown | null;
  choice: Choice | null;
  /** The pair of the block that the pair's part shows. */
  opened: [number, number] | null;
  notice: Notice | null;
}

export const BLOCK_INITIAL: BlockState = {
  mode: 'pair',
  catalogue: null,
  files: [],
  truth: null,
  options: { settings: null, gps: 'use', cameras: null, control: null, marks: null, masks: [] },
  refused: null,
  flight: null,
  running: { kind: 'no' },
  shown: null,
  choice: null,
  opened: null,
  notice: null,
};

/** Names what a run of the present files and options would be made from. */
export function wantedKey({ files, options }: Pick<BlockState, 'files' | 'options'>): string {
  return JSON.stringify([files.map(({ id }) => id), options]);
}

/** Whether other files or options made the block on the screen. */
export function isOutdated(state: BlockState): boolean {
  return state.shown !== null && state.shown.files.length > 0 && state.shown.key !== wantedKey(state);
}

export function isBusy({ running, notice }: BlockState): boolean {
  return running.kind === 'yes' || notice?.kind === 'busy';
}
