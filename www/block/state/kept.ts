/** What of a block is kept in the browser's storage. */
import type { BlockScore, OrthophotoInfo, PlacingOptions } from '../../../pkg/wasm/tiepoint.js';
import type { GivenFilm } from './film';
import type { GivenHeights, OnGround, Purpose, RasterFile } from './placing';
import type { BlockFile, BlockOptions, BlockState, Steps } from './state';
import type { KeptDraft } from './draft';
import { areDefault } from './of-file';

/** A file that is kept by itself, under a name that does not change. */
export type KeptFile = Omit<BlockFile, 'file'> & { file: string };

/** A picture of the ground, or its heights. */
export type KeptRaster = KeptFile & Pick<RasterFile, 'world' | 'projection' | 'degrees'>;

/** What was given to place images on an orthophoto. */
export interface KeptPlacing {
  orthophoto: { raster: KeptRaster; info: OrthophotoInfo; ofBlock: string | null } | null;
  heights: Extract<GivenHeights, { kind: 'level' }> | { kind: 'model'; model: KeptRaster };
  film: GivenFilm;
  options: PlacingOptions | null;
  purpose: Purpose | null;
}

/** All but the files and the finished block. */
export interface KeptBlock {
  files: readonly KeptFile[];
  /** Images that were taken out. */
  removed: readonly KeptFile[];
  options: Omit<BlockOptions, 'masks' | 'geoid'>;
  masks: readonly KeptFile[];
  geoid: KeptFile | null;
  flight: BlockState['flight'];
  /** The name of the truth of simulated photos. */
  truth: string | null;
  opened: BlockState['opened'];
  placing: KeptPlacing;
}

/** A finished block, with what its project file does not hold. */
export interface KeptShown {
  project: Blob;
  key: string;
  /** Names its tie points; empty of a block that was opened. */
  tiePoints: string;
  /** The images that it was made from. */
  files: readonly KeptFile[];
  steps: Steps;
  seconds: number;
  score: BlockScore | null;
  ground: OnGround | null;
}

/** What was kept, ready to be shown. */
export type RestoredBlock = Pick<
  BlockState,
  'files' | 'removed' | 'options' | 'flight' | 'truth' | 'shown' | 'opened' | 'history' | 'former' | 'marks' | 'placing'
> & { draft: KeptDraft | null };

/** Whether there is nothing yet that would have to be kept. */
export function isBlank({ catalogue, files, shown, options, flight, placing }: BlockState): boolean {
  const untouched = areDefault({ catalogue, options }) && flight === catalogue?.flight && placing.options === catalogue?.placing;
  return (
    catalogue === null ||
    (files.length === 0 && shown === null && placing.orthophoto === null && placing.film.camera === null && placing.film.marks.length === 0 && untouched)
  );
}
