// @ts-check
/** A block from its image files to its orientation, on any kind of workers and any kind of store. */

export { breakdownOf } from './faults.js';
export { runBlock } from './run.js';
export { errorOf, plainError } from './wire.js';
