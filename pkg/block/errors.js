// @ts-check
/** What a run refuses, and what of its jobs' errors is the fault of an image or a pair alone. */

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
  // A trap of the module, or memory that is not there: the worker was replaced.
  if (error instanceof Error && ['RuntimeError', 'RangeError', 'WorkerError'].includes(error.name)) return { kind: 'broke_off', message: error.message };
  return { kind: 'refused', message: refusal(error), code: /** @type {{ code: string }} */ (error).code, usage: false };
}
