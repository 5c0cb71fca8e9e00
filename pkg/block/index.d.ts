/// <reference path="../libs.d.ts" />
import type { FinishedBlock } from '../wasm/tiepoint.js';
import type { RunOptions, Source, Surroundings } from './types.js';

export type * from './types.js';

export { breakdownOf } from './faults.js';
export { errorOf, plainError, type PlainError } from './wire.js';

/**
 * Runs a block from its image files to its orientation. What the store holds from an earlier run with the same images and settings is not
 * done again; the result is the same, for any number of workers, and the caller frees it. Images that cannot be read are skipped and listed.
 * The module must be initialised. Joining points and orienting images take the calling thread: a page calls this in a worker.
 *
 * Rejects with a `TiepointError` for images that make no block and for options outside their range, and with the reason of `signal`, each
 * once the jobs under way have ended; what was kept until then stays.
 */
export function runBlock(sources: readonly Source[], options: RunOptions, surroundings: Surroundings): Promise<FinishedBlock>;
