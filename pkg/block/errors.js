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
 * Why the job of an image or a pair failed; what is no fault of its own is thrown on, as of `refusal`.
 * @param {unknown} error @returns {import('../wasm/tiepoint.js').Failure}
 */
export function ownFault(error) {
  if (!(error instanceof Error)) throw error;
  // The worker was replaced.
  if (MEMORY.includes(error.name)) return { kind: 'out_of_memory', message: error.message };
  if (['Panic', 'WorkerError'].includes(error.name)) return { kind: 'broke_off', message: error.message };
  return { kind: 'refused', message: refusal(error), code: /** @type {any} */ (error).code, usage: false };
}
