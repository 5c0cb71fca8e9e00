/** The value in the middle of a list that is left as it is. */

/** @param {number[]} values @returns {number} of an even number of values the mean of the two in the middle; NaN of none */
export function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  return ((sorted[(sorted.length - 1) >> 1] ?? NaN) + (sorted[sorted.length >> 1] ?? NaN)) / 2;
}
