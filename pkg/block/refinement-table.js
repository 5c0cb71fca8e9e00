// @ts-check
/** What the files of a block say of the refinement of its rays. */

import { refinement_outcomes } from '../wasm/tiepoint.js';

/**
 * @typedef {import('./types.js').BlockRun} BlockRun
 * @typedef {import('./types.js').Refinement} Refinement
 */

/**
 * The crate's table of rays with the outcome of each, its standard error and its correlation. A point of the table is the refined one that
 * it has most places in common with: an image may show two features at one place.
 * @param {Refinement} refinement @param {string} table
 */
export function withOutcomes(refinement, table) {
  const [header = '', ...lines] = table.trimEnd().split('\n');
  const columns = header.split(',');
  const [ofPoint, ...ofPlace] = ['point', 'image', 'x_px', 'y_px'].map((column) => columns.indexOf(column));
  const rows = lines.map((line) => {
    const fields = fieldsOf(line, columns.length);
    return { line, point: fields[ofPoint ?? 0], place: ofPlace.map((column) => Number(fields[column])).join() };
  });
  const rays = raysAt(refinement);
  const names = refinement_outcomes();
  const refined = samePoints(rows, rays);
  const facts = (/** @type {(typeof rows)[number]} */ { point, place }) => {
    const own = rays.get(place)?.find((ray) => ray.point === refined.get(point));
    // Surveyed points have rays of their own.
    if (!own) return ',,';
    const known = Array.from(refinement.precision.subarray(2 * own.ray, 2 * own.ray + 2), (value) => (Number.isNaN(value) ? '' : value));
    return [names[refinement.outcomes[own.ray] ?? 0], ...known].join();
  };
  return [`${header},refinement,standard_error_px,correlation`, ...rows.map((row) => `${row.line},${facts(row)}`), ''].join('\n');
}

/** The refined rays at each place of an image.  @param {Refinement} refinement */
function raysAt({ starts, images, positions }) {
  /** @type {Map<string, { point: number, ray: number }[]>} */
  const rays = new Map();
  for (let point = 0; point + 1 < starts.length; point++) {
    for (let ray = starts[point] ?? 0; ray < (starts[point + 1] ?? 0); ray++) {
      const place = [images[ray], positions[2 * ray], positions[2 * ray + 1]].join();
      const others = rays.get(place);
      if (others) others.push({ point, ray });
      else rays.set(place, [{ point, ray }]);
    }
  }
  return rays;
}

/**
 * The refined point of each point of the table.
 * @param {{ point: string | undefined, place: string }[]} rows @param {ReturnType<typeof raysAt>} rays @returns {Map<string | undefined, number>}
 */
function samePoints(rows, rays) {
  /** @type {Map<string | undefined, Map<number, number>>} */
  const common = new Map();
  for (const { point, place } of rows) {
    const counts = common.get(point) ?? new Map();
    for (const ray of rays.get(place) ?? []) counts.set(ray.point, (counts.get(ray.point) ?? 0) + 1);
    common.set(point, counts);
  }
  return new Map([...common].flatMap(([point, counts]) => {
    const [most] = [...counts].sort(([a, m], [b, n]) => n - m || a - b);
    return most ? [[point, most[0]]] : [];
  }));
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
