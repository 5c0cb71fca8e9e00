/** The types that a host of a block's run knows. */

import type { BlockSettings, ControlTexts, Given, News as FoundOrStep, StageName as RunStage } from '../wasm/tiepoint.js';

/** A file that can be read any number of times. */
export interface Source {
  /** File name; no two images have the same. */
  name: string;
  bytes(): Promise<Uint8Array>;
}

/** A task of the crate, and the bytes that it needs. */
export interface BlockJob {
  task: string;
  inputs: Uint8Array[];
}

/**
 * Runs jobs on workers. A job that fails rejects with what it threw, or with its plain form (`plainError`); a worker that broke down is
 * replaced. `transfer` is memory of the run's own; what sources and the store have given stays theirs.
 */
export interface Pool {
  /** How many jobs run at the same time. */
  readonly size: number;
  run(name: 'block', input: BlockJob, transfer: ArrayBuffer[]): Promise<Uint8Array>;
}

/** Keeps records by key, a text of letters, digits and slashes; `put` keeps a record whole or not at all. */
export interface Store {
  get(key: string): Promise<Uint8Array | null>;
  put(key: string, record: Uint8Array): Promise<void>;
}

/** Photos are those of a simulated block. */
export type StageName = 'photos' | RunStage;

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

/** What a run finds on its way. Images of a pair count without those that were skipped. */
export type News = Exclude<FoundOrStep, { kind: 'step' }>;

export interface RunOptions {
  settings?: Given<BlockSettings>;
  /** Cameras in place of those of EXIF, as the text of a file. */
  cameras?: { name: string; text: string } | null;
  /** Whether GNSS positions are used, to choose pairs and, where there are no ground control points, to georeference the block. */
  gps?: 'use' | 'ignore';
  /** Ground control points and their image measurements. */
  control?: ControlTexts | null;
  /** Image files, 0 (black) where no features are wanted, each as large as the image whose name it has. */
  masks?: readonly Source[] | null;
  /**
   * What becomes of masks that belong to none of the images, whose own would be missing where a name has a slip: they are refused, by default, or
   * listed as `stray_masks` of the summary, for folders that hold masks of other images too.
   */
  strayMasks?: 'refuse' | 'list';
  /** The geoid from which the heights of the coordinate system count: a GeoTIFF of longitudes and latitudes, GTX, or PGM of GeographicLib. */
  geoid?: Source | null;
  /** GNSS positions of images in place of those that their files record, as the text of a table (`parse_image_positions`). */
  positions?: string | null;
  /** Whether an orthophoto is to place the block afterwards (`BlockOnOrthophoto`): then fewer than three control points, or check points alone, are of use. */
  onOrthophoto?: boolean;
}

export interface Surroundings {
  pool: Pool;
  store: Store;
  progress?: (step: Step) => void;
  /** Takes what is found, as soon as it is. */
  news?: (news: News) => void;
  signal?: AbortSignal;
}
