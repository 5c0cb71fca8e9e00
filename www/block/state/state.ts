/** The state of the block's part of the page. */
import type { Step, StageName } from '../../../pkg/block/index.js';
import type { BlockEdit, BlockFlight, BlockModel, BlockSettings, Parameter, PlacingOptions } from '../../../pkg/wasm/tiepoint.js';
import type { Notice } from '../../shared/state/notice';
import type { Labels } from '../../shared/text/names';
import { UNEDITED } from './edited';
import type { Edits } from './edited';
import type { BlockFile, TextFile } from './file';
import { NO_PANES } from './panes';
import type { Panes } from './panes';
import { NO_PLACING } from './placing';
import { givenToRun } from './marks';
import type { Coordinates, MarkStep } from './marks';
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { OnGround, Placing } from './placing';
import { NOTHING_SELECTED } from './selection';
import type { Selection } from './selection';
import type { BlockView, ViewGiven } from './view';

export type { BlockFile, TextFile } from './file';

/** What the crate says of blocks: read once, when the module is there. */
export interface BlockCatalogue {
  parameters: Parameter[];
  defaults: BlockSettings;
  flightParameters: Parameter[];
  flight: BlockFlight;
  placingParameters: Parameter[];
  placing: PlacingOptions;
  /** The height of level ground. */
  levelParameter: Parameter | undefined;
  /** Of these and the pair's: messages name any of them. */
  labels: Labels;
}

/** What the user chooses of a run. */
export interface BlockOptions {
  settings: BlockSettings | null;
  gps: 'use' | 'ignore';
  /** In place of what EXIF tells. */
  cameras: TextFile | null;
  /** Surveyed points, and where the images show them; what is measured by hand is beside these. */
  control: TextFile | null;
  marks: TextFile | null;
  /** GNSS positions of images, in place of those that their files record. */
  positions: TextFile | null;
  masks: readonly BlockFile[];
  /** From which the heights of the coordinate system count. */
  geoid: BlockFile | null;
}

/** What the stage shows of the block. */
export type ViewName = 'map' | 'matrix' | 'images' | 'plots' | 'orthophoto';

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
  /** The block as it was found or opened: the same one whatever is edited. */
  found: BlockView;
  /** Names its tie points; empty where no run of this page found them. */
  tiePoints: string;
  /** The edits that the view is made of. */
  edits: readonly BlockEdit[];
  view: BlockView;
  /** Control and check points that were given beside those of the view; they change while the view stays the same. */
  given: readonly ViewGiven[];
  /** Coordinates of control and check points in the unit and the system of their table, by name; absent without one. */
  asGiven?: Coordinates;
  /** Empty for a block that was opened. */
  files: readonly BlockFile[];
  steps: Steps;
  seconds: number;
  /** Null for one that was not placed here. */
  ground: OnGround | null;
}

export interface BlockState extends Edits {
  catalogue: BlockCatalogue | null;
  files: readonly BlockFile[];
  /** Images that were taken out, and come back when that is undone. */
  removed: readonly BlockFile[];
  /** Names of files that were given and skipped, since they are no images by name; this browser does not keep them. */
  skipped: readonly string[];
  /** Of photos that were simulated. */
  truth: BlockModel | null;
  options: BlockOptions;
  /** A setting whose field holds a value that is not allowed; the options hold its last valid one. */
  refused: Parameter | null;
  flight: BlockFlight | null;
  running: Running;
  /** The block on the screen. */
  shown: Shown | null;
  selection: Selection;
  /** Image measurements of control and check points by hand, and images that were taken out. */
  marks: History<MarkStep>;
  /** What the images view shows. */
  panes: Panes;
  /** Images on an orthophoto. */
  placing: Placing;
  /** The view on the stage. */
  onStage: ViewName;
  /** The pair of the block that the pair's part shows. */
  opened: [number, number] | null;
  notice: Notice | null;
}

export const BLOCK_INITIAL: BlockState = {
  catalogue: null,
  files: [],
  removed: [],
  skipped: [],
  truth: null,
  options: { settings: null, gps: 'use', cameras: null, control: null, marks: null, positions: null, masks: [], geoid: null },
  refused: null,
  flight: null,
  running: { kind: 'no' },
  shown: null,
  selection: NOTHING_SELECTED,
  marks: NO_HISTORY,
  panes: NO_PANES,
  placing: NO_PLACING,
  ...UNEDITED,
  onStage: 'map',
  opened: null,
  notice: null,
};

/** A block with the points that were given beside it: what its tables list. */
export type Listed = Pick<Shown, 'view' | 'given' | 'asGiven'>;

/** Names what a run of the present files and options would be made from. */
export function wantedKey(state: WithOptions): string {
  return JSON.stringify([state.files.map(({ id }) => id), toRun(state)]);
}

type WithOptions = Pick<BlockState, 'files' | 'options' | 'marks' | 'shown' | 'placing'>;

function toRun(state: WithOptions) {
  const { geoid, positions } = state.options;
  return { ...state.options, ...givenToRun(state), geoid: geoid ?? undefined, positions: positions ?? undefined };
}

/** Names what a run of the present options would be made from, whatever the files: the key of a block that was opened, whose images come later. */
export function openedKey(state: WithOptions): string {
  return JSON.stringify(toRun(state));
}

/** Whether other files or options made the block on the screen. */
export function isOutdated(state: BlockState): boolean {
  const { shown, files } = state;
  if (shown === null) return false;
  if (shown.files.length > 0) return shown.key !== wantedKey(state);
  // Without images it cannot be run; one that an earlier release opened has no key.
  return shown.key !== '' && files.length >= 2 && shown.key !== openedKey(state);
}

/** A run that goes on keeps what it was given; of one that was ended nothing is left to take up where its input is another one. */
export function withoutRunUnderWay(running: Running): Running {
  return running.kind === 'yes' ? running : { kind: 'no' };
}

export function isBusy({ running, notice, placing }: BlockState): boolean {
  return running.kind === 'yes' || notice?.kind === 'busy' || placing.running !== null;
}

/** The files of the images of the block that is shown, as far as they are there. */
export function imagesOfBlock({ shown, files }: Pick<BlockState, 'shown' | 'files'>): readonly BlockFile[] {
  if (shown === null) return [];
  const byName = new Map([...files, ...shown.files].map((file) => [file.name, file]));
  return shown.view.images.flatMap(({ name }) => byName.get(name) ?? []);
}
