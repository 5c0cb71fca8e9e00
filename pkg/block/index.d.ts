import type { ExportFormat } from '../wasm/tiepoint.js';
import type { BlockRun, RunOptions, Source, Surroundings } from './types.js';

export type * from './types.js';

/** Images or options that make no block. */
export class BlockError extends Error {}

/** The name of a block's own file. */
export const PROJECT_FILE: string;

/** Writes the files of a block; gives the summary that is among them. */
export function writeBlock(run: BlockRun, formats: readonly ExportFormat[], write: (path: string, text: string) => void): object;

/** Runs a block from its image files to its tie points. */
export function runBlock(sources: readonly Source[], options: RunOptions, surroundings: Surroundings): Promise<BlockRun>;
