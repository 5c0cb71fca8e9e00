// @ts-check
/** A block from its image files to its tie points, on any kind of workers and any kind of store. */

export { groupCameras, knownCamera } from './cameras.js';
export { BlockError, MEMORY } from './errors.js';
export { runBlock } from './run.js';
