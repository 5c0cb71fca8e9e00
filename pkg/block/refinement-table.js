// @ts-check
/** What the files of a block say of the refinement of its rays. */

import { ray_outcomes } from '../wasm/tiepoint.js';

/**
 * @typedef {import('./types.js').BlockRun} BlockRun
 * @typedef {import('./types.js').Refinement} Refinement
 */

/** The crate's table of rays with the outcome of each, its standard error and its correlation.  @param {Refinement} refinement @param {string} table */
export function withOutcomes({ images, positions, outcomes, precision }, table) {
  const names = ray_outcomes();
  /** @type {Map<string, number>} */
  const rays = new Map();
  images.forEach((image, ray) => rays.set([image, positions[2 * ray], positions[2 * ray + 1]].join(), ray));
  const [header = '', ...lines] = table.trimEnd().split('\n');
  const [ofImage, ofX, ofY] = ['image', 'x_px', 'y_px'].map((column) => header.split(',').indexOf(column));
  const columns = header.split(',').length;
  const facts = (/** @type {string} */ line) => {
    const fields = fieldsOf(line, columns);
    const ray = rays.get([ofImage, ofX, ofY].map((column) => Number(fields[column ?? 0])).join());
    // Surveyed points have rays of their own.
    if (ray === undefined) return ',,';
    const known = Array.from(precision.subarray(2 * ray, 2 * ray + 2), (value) => (Number.isNaN(value) ? '' : value));
    return [names[outcomes[ray] ?? 0], ...known].join();
  };
  return [`${header},refinement,standard_error_px,correlation`, ...lines.map((line) => `${line},${facts(line)}`), ''].join('\n');
}

/** The fields of a line, of which one may stand between quotation marks.  @param {string} line @param {number} columns @returns {string[]} */
function fieldsOf(line, columns) {
  const fields = line.match(/("([^"]|"")*"|[^,]*)(,|$)/g) ?? [];
  return fields.slice(0, columns).map((field) => field.replace(/,$/, ''));
}

/** @param {BlockRun} run */
export function refinementSummary({ refinement, settings }) {
  if (!refinement) return null;
  const { reference, refined, ...kept } = refinement.counts;
  return { method: settings.refinement.method, points: refinement.points, rays: refinement.outcomes.length, references: reference, refined, kept };
}
