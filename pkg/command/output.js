// @ts-check
/** What every command prints: one JSON object, or text. */

/** @param {object} value */
export const printJson = (value) => void process.stdout.write(`${JSON.stringify(value, plain)}\n`);

/** @param {string[]} lines */
export const print = (...lines) => void process.stdout.write(`${lines.join('\n')}\n`);

/** One line beside the result, on stderr.  @param {string} text */
export const note = (text) => void process.stderr.write(`tiepoint: ${text}\n`);

/** Typed arrays as plain ones, for JSON.  @param {string} _key @param {unknown} value */
function plain(_key, value) {
  return ArrayBuffer.isView(value) && !(value instanceof DataView) ? Array.from(/** @type {Float64Array} */ (value)) : value;
}

/**
 * Rows of a flat array.
 * @param {Float64Array} flat @param {number} stride @returns {number[][]}
 */
export function rows(flat, stride) {
  return Array.from({ length: flat.length / stride }, (_, i) => Array.from(flat.subarray(i * stride, (i + 1) * stride)));
}
