/** One pair in figures: everything that a verdict could be built from, beside the true errors. */

/**
 * @typedef {import('../../../pkg/node.js').PairOutput} PairOutput
 * @typedef {import('./judge.mjs').Errors} Errors
 */

const GRIDS = [8, 16];

/** @param {PairOutput} output @param {[{ width: number, height: number }, { width: number, height: number }]} sizes of the left and right picture */
export function figures(output, sizes) {
  const { match, interior, pixel_mm, orientation, no_orientation } = output;
  const { geometry, no_geometry } = match;
  const rejected = new Set(orientation?.rejected ?? []);
  const rows = Array.from({ length: match.matches.length / 5 }, (_, k) => [...match.matches.subarray(5 * k, 5 * k + 4)]);
  const accepted = rows.filter((_, k) => !rejected.has(k));
  return {
    features: [output.left.points.length / 3, output.right.points.length / 3],
    counts: match.counts,
    matches: rows.length,
    accepted: accepted.length,
    cells: cells(accepted, sizes),
    map: affine(accepted),
    geometry: geometry && { ...geometry, model: geometry.model.kind, homography: undefined },
    no_geometry,
    interior: interior && { focal_mm: interior.focal_mm, pixel_mm, left: inside(interior.left), right: inside(interior.right) },
    no_orientation,
    orientation: orientation && summary(orientation, pixel_mm ?? NaN),
  };
}

/** The sign of the area of a pixel, below 0 unless mirrored, and the place of the principal point in px.  @param {import('../../../pkg/node.js').Interior} interior */
function inside({ parameters, principal_point_mm, uncertainty }) {
  const [[a, b, tx], [d, e, ty]] = parameters;
  const [x, y] = [principal_point_mm[0] - tx, principal_point_mm[1] - ty];
  const area = a * e - b * d;
  return { area: Math.sign(area), principal_px: [(x * e - y * b) / area, (y * a - x * d) / area], uncertainty: uncertainty ?? null };
}

/** @param {NonNullable<PairOutput['orientation']>} found @param {number} pixel_mm */
function summary(found, pixel_mm) {
  const { points, residuals_mm, rejected, cofactors, correlations, ...rest } = found;
  const behind = Array.from({ length: points.length / 9 }, (_, k) => points[9 * k + 8] ?? NaN).filter((z) => z > 0).length;
  return {
    ...rest,
    rejected: rejected.length,
    behind,
    sigma0_px: (found.sigma0_mm ?? NaN) / pixel_mm,
    parallax_px: found.parallax_beside_rotation_mm / pixel_mm,
  };
}

/** Cells of a grid over each image that hold matches, and pairs of cells.  @param {number[][]} rows @param {{ width: number, height: number }[]} sizes */
function cells(rows, sizes) {
  return Object.fromEntries(
    GRIDS.map((side) => {
      const of = (/** @type {number[]} */ row, /** @type {0 | 1} */ k) => {
        const { width = 1, height = 1 } = sizes[k] ?? {};
        return Math.floor((side * (row[2 * k] ?? 0)) / width) + side * Math.floor((side * (row[2 * k + 1] ?? 0)) / height);
      };
      const count = (/** @type {(row: number[]) => number | string} */ by) => new Set(rows.map(by)).size;
      return [side, { left: count((row) => of(row, 0)), right: count((row) => of(row, 1)), both: count((row) => `${of(row, 0)} ${of(row, 1)}`) }];
    }),
  );
}

/** The affine map that fits the matches best: its determinant (below 0 where one image is mirrored) and its root mean square residual in px.  @param {number[][]} rows */
function affine(rows) {
  const count = rows.length;
  if (count < 4) return null;
  const mean = [0, 1, 2, 3].map((k) => rows.reduce((sum, row) => sum + (row[k] ?? 0), 0) / count);
  const product = (/** @type {number} */ i, /** @type {number} */ j) =>
    rows.reduce((sum, row) => sum + ((row[i] ?? 0) - (mean[i] ?? 0)) * ((row[j] ?? 0) - (mean[j] ?? 0)), 0);
  const [xx, xy, yy] = [product(0, 0), product(0, 1), product(1, 1)];
  const det = xx * yy - xy * xy;
  const [[a, b], [c, d]] = /** @type {[[number, number], [number, number]]} */ (
    [2, 3].map((k) => [(product(0, k) * yy - product(1, k) * xy) / det, (product(1, k) * xx - product(0, k) * xy) / det])
  );
  const square = rows.reduce((sum, row) => {
    const [x, y, u, v] = row.map((value, k) => value - (mean[k] ?? 0));
    return sum + ((u ?? 0) - a * (x ?? 0) - b * (y ?? 0)) ** 2 + ((v ?? 0) - c * (x ?? 0) - d * (y ?? 0)) ** 2;
  }, 0);
  return { determinant: a * d - b * c, residual_px: Math.sqrt(square / count / 2) };
}
