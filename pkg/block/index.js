// @ts-check
/** A block from its image files to its orientation, on any kind of workers and any kind of store. */

export { MEMORY, runBlock } from './run.js';
