import type { BlockModel, ExportFormat, Camera } from '../wasm/tiepoint.js';
import type { BlockRun, GroupedCamera, ReadImage, RunOptions, Source, Surroundings } from './types.js';

export type * from './types.js';

/** Names of the errors of a module or of a host without memory. */
export const MEMORY: readonly string[];

/** Images or options that make no block. */
export class BlockError extends Error {}

/** The name of a block's own file. */
export const PROJECT_FILE: string;

/** The files that a block is written as whatever formats are asked for; where nothing was oriented without `orientation.json`. */
export const FIXED_FILES: readonly string[];

/** Writes the files of a block; gives the summary that is among them, with what it is to hold beside the run. */
export function writeBlock(run: BlockRun, formats: readonly ExportFormat[], write: (path: string, text: string) => void, beside?: object): object;

/** As `writeBlock`, in steps of about one file, between which the caller may do otherwise or break off. */
export function writing(run: BlockRun, formats: readonly ExportFormat[], write: (path: string, text: string) => void, beside?: object): Generator<void, object, void>;

/** The cameras of images, by EXIF or by the text of a file of cameras, and which is whose. */
export function groupCameras(images: readonly Pick<ReadImage, 'name' | 'head'>[], rulesText?: string): { cameras: GroupedCamera[]; of: number[] };

/** How many points of a block both images of a pair see, by both their numbers with a comma between, the smaller one first. */
export function chosenOf(model: Pick<BlockModel, 'points'>): Map<string, number>;

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
