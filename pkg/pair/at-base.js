// @ts-check
/** The base is the unit of by and bz. */

/**
 * An orientation with by and bz at the scale of another base; NaN where its own base is 0, which has no scale.
 * @param {import('../node.js').FiveParameters} orientation @param {number} baseMm its own base @param {number} otherMm @returns {import('../node.js').FiveParameters}
 */
export function atBase(orientation, baseMm, otherMm) {
  const scale = baseMm === 0 ? NaN : otherMm / baseMm;
  return { ...orientation, by_mm: scale * orientation.by_mm, bz_mm: scale * orientation.bz_mm };
}
