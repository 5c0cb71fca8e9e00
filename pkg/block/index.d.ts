import type { Camera } from '../wasm/tiepoint.js';
import type { BlockRun, GroupedCamera, ReadImage, RunOptions, Source, Surroundings } from './types.js';

export type * from './types.js';

/** Names of the errors of a module or of a host without memory. */
export const MEMORY: readonly string[];

/** Images or options that make no block. */
export class BlockError extends Error {}

/** The cameras of images, by EXIF or by the text of a file of cameras, and which is whose. */
export function groupCameras(images: readonly Pick<ReadImage, 'name' | 'head'>[], rulesText?: string): { cameras: GroupedCamera[]; of: number[] };

/** A camera as a block holds it; null where its focal length is not known. */
export function knownCamera(camera: GroupedCamera): Camera | null;

/**
 * Runs a block from its image files to its tie points and orientation. What the store holds from an earlier run with the same images and
 * settings is not done again; the result is the same, for any number of workers. An image that cannot be read is left out and told in
 * `leftOut`. The module must be initialised. Joining points and orienting images take the calling thread: a page calls this in a worker.
 *
 * Rejects with a `BlockError` for images that make no block, with a `TiepointError` for options outside their range, and with the reason of
 * `signal`, each once the jobs under way have ended; what was kept until then stays.
 */
export function runBlock(sources: readonly Source[], options: RunOptions, surroundings: Surroundings): Promise<BlockRun>;
