// @ts-check
/** What a run refuses, and what of its jobs' errors is the fault of an image or a pair alone. */

/** Images or options that make no block. */
export class BlockError extends Error {}

/**
 * Why an image or a pair failed, in words; what is no fault of its own is thrown on: bad options, and errors nobody foresaw.
 * @param {unknown} error @returns {string}
 */
export function ownFault(error) {
  if (!(error instanceof Error)) throw error;
  const refused = error.name === 'TiepointError' && !(/** @type {{ usage?: boolean }} */ (error).usage);
  if (refused) return error.message;
  // A trap of the module, or memory that is not there: the worker was replaced.
  if (error.name === 'RuntimeError' || error.name === 'RangeError' || error.name === 'WorkerError') return `the computation broke off (${error.message})`;
  throw error;
}
