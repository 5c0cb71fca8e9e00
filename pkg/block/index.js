// @ts-check
/** A block from its image files to its tie points, on any kind of workers and any kind of store. */

export { BlockError } from './errors.js';
export { PROJECT_FILE, writeBlock } from './files.js';
export { runBlock } from './run.js';
