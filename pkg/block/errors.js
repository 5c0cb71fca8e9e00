// @ts-check
/** What a run refuses, and what of its jobs' errors is the fault of an image or a pair alone. */

/** Names of the errors of a module or of a host without memory. Faults of the module have the name `Panic`. */
export const MEMORY = ['RuntimeError', 'RangeError'];

/** Images or options that make no block. */
export class BlockError extends Error {}

/**
 * What the crate says against its input; other errors are thrown on, bad options among them.
 * @param {unknown} error @returns {string}
 */
export function refusal(error) {
  if (error instanceof Error && error.name === 'TiepointError' && !(/** @type {{ usage?: boolean }} */ (error).usage)) return error.message;
  throw error;
}

/**
 * Why the job of an image or a pair failed, in words; what is no fault of its own is thrown on, as of `refusal`.
 * @param {unknown} error @returns {string}
 */
export function ownFault(error) {
  if (!(error instanceof Error)) throw error;
  // The worker was replaced.
  if (MEMORY.includes(error.name)) return `memory ran out (${error.message})`;
  if (['Panic', 'WorkerError'].includes(error.name)) return `the computation broke off at a fault of the program (${error.message}): please report it`;
  return refusal(error);
}
