/** The calls of a block that workers answer, and what passes between a run and the page while it goes on. */
import type { BlockJob, RunOptions, Step } from '../../../pkg/block/index.js';
import type { BlockFlight, BlockModel, ExportFormat } from '../../../pkg/wasm/tiepoint.js';
import type { BlockFile } from '../state/state';
import type { BlockView } from '../state/view';

/** What the crate says against an image or a pair; the run goes on without it. */
export interface Refusal {
  message: string;
  code: string;
  /** Whether the options are to blame, and with them the whole run. */
  usage: boolean;
}

export type JobAnswer = { made: Uint8Array } | { refusal: Refusal };

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
  options: Omit<RunOptions, 'masks'>;
  masks: readonly BlockFile[];
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

export interface BlockCalls {
  // Any worker of the pool.
  blockJob: { input: BlockJob; output: JobAnswer };
  /** The truth of a flight, which names its photos. */
  blockPlan: { input: BlockFlight; output: BlockModel };
  blockPhoto: { input: { flight: BlockFlight; index: number }; output: Uint8Array<ArrayBuffer> };
  // The worker of the block: it holds the block that was run or opened last.
  blockRun: { input: RunInput; output: BlockView };
  blockOpen: { input: { bytes: Uint8Array }; output: BlockView };
  /** A message through `stop` breaks it off. */
  blockExport: { input: { kind: ExportKind; name: string; stop: MessagePort }; output: MadeFile };
}
