// @ts-check
import { basename, dirname } from 'node:path';
import { withText } from '../messages.js';
import { defaults, message, model_points, model_points_csv, orient_relative, parse_observations } from '../node.js';
import { about, isRefusal, UsageError, VERDICT_CODES } from './errors.js';
import { readText, writeInto } from './files.js';
import { groupOptions, JSON_FLAG, path, settingsOf, valueOption } from './options.js';
import { print, printJson, rows } from './output.js';
import { fixed, significant, table } from './text.js';

/** @typedef {import('../node.js').RelativeOrientation} RelativeOrientation */

const FOCAL = valueOption('focal_mm');
const POINTS = path('points', 'FILE', 'Writes the object points with their standard errors as CSV, in the system of the left photo.');
const BASE = valueOption('base_length');
const OPTIONS = [FOCAL, POINTS, BASE, ...groupOptions('orientation'), JSON_FLAG];

/** @type {import('./args.js').Command} */
export const orient = {
  name: 'orient',
  summary: 'Dependent relative orientation of two photos from measured photo coordinates.',
  positionals: ['OBSERVATIONS.csv'],
  options: OPTIONS,
  details:
    'OBSERVATIONS.csv: columns x_left_mm,y_left_mm,x_right_mm,y_right_mm, x to the right and y up, principal point at 0, 0. ' +
    '--focal-mm is required. The exit code is that of the verdict: 0 oriented, 3 weak, 4 not oriented. JSON: verdict (as of `tiepoint match`; the rest is absent where it is not_oriented), omega_deg, phi_deg, kappa_deg, by_mm, bz_mm, standard_errors, total_standard_errors (with what neighbouring matches share and the interior orientations add, null where not known), half_widths_95 (of the intervals that hold the unknowns in 95 % of cases), sigma0_mm, variance_left (what the rejection has left of the variance of good observations, by which sigma0 squared and cofactors are divided), degrees_of_freedom, ' +
    'iterations, cofactors and correlations (of omega, phi, kappa, by, bz), condition, warnings, global_test, base_ellipse_mm, base_ellipse_95_mm, noncentrality (delta0 of the minimal detectable size: of a test at alpha0, with fewer than 8 degrees of freedom at alpha0 by the number of observations), residuals_mm [[vxl, vyl, vxr, vyr], …], ' +
    'points [[y-parallax mm, redundancy, w, detectable mm, external reliability, weight, X, Y, Z mm], …], rejected (indices from 0). ' +
    '--points FILE: columns point (index from 0), x, y, z, sigma_x, sigma_y, sigma_z, use (used or rejected); x and y along the axes of the left photo, which looks along -z from 0, 0, 0; the standard errors include those of the orientation.',
  run({ positionals: [file = ''], values }) {
    const focal = values.get('focal-mm');
    if (typeof focal !== 'number') throw new UsageError('--focal-mm is missing: give the focal length in mm');
    if (values.has('base-length') && !values.has('points')) throw new UsageError('--base-length needs --points');
    const settings = settingsOf(OPTIONS, values, defaults());
    const text = readText(file);
    const observations = about(file, () => parse_observations(text));
    const { verdict, orientation } = oriented(observations, focal, settings.orientation);
    const out = values.get('points');
    if (typeof out === 'string' && orientation) {
      const points = model_points(observations, focal, settings.orientation, Number(values.get('base-length') ?? 1));
      writeInto(dirname(out), basename(out), model_points_csv(points));
    }
    if (values.has('json')) printJson({ verdict: withText('pair_verdict', verdict), ...(orientation && orientationOf(orientation)) });
    else print(message('pair_verdict', verdict), ...(orientation ? ['', ...describeOrientation(orientation, null)] : []));
    return VERDICT_CODES[verdict.kind];
  },
};

/** Refusals that say that observations have no orientation. Others say that something is no observation. */
const HAVE_NONE = ['too-few', 'degenerate', 'not-converged'];

/**
 * The orientation of observations, or null, with the verdict on it.
 * @param {Float64Array} observations @param {number} focal @param {import('../node.js').Given<import('../node.js').OrientationOptions>} options
 * @returns {{ verdict: import('../node.js').PairVerdict, orientation: RelativeOrientation | null }}
 */
function oriented(observations, focal, options) {
  try {
    const orientation = orient_relative(observations, focal, options);
    return { verdict: orientation.verdict, orientation };
  } catch (error) {
    if (!isRefusal(error) || !HAVE_NONE.includes(error.code)) throw error;
    return { verdict: { kind: 'not_oriented', no_orientation: { kind: 'refused', error: error.error } }, orientation: null };
  }
}

/** The five unknowns: what they are called, and where they stand in an orientation. */
export const UNKNOWNS = /** @type {const} */ ([
  { name: 'omega', unit: 'deg', field: 'omega_deg' },
  { name: 'phi', unit: 'deg', field: 'phi_deg' },
  { name: 'kappa', unit: 'deg', field: 'kappa_deg' },
  { name: 'by', unit: 'mm', field: 'by_mm' },
  { name: 'bz', unit: 'mm', field: 'bz_mm' },
]);

/** Where the base runs along y. */
const TURNED = 'axes turned by 90°: x points up in the left image';

/** The JSON form, without the verdict, which stands beside it.  @param {RelativeOrientation & { verdict?: unknown }} o */
export const orientationOf = ({ verdict: _verdict, ...o }) => ({
  ...o,
  residuals_mm: rows(o.residuals_mm, 4),
  points: rows(o.points, 9),
  warnings: o.warnings.map((warning) => withText('warning', warning)),
});

/** @param {import('../node.js').GlobalTest} test */
const globalTest = ({ statistic, lower, upper, passed }) =>
  `global test ${passed ? 'passed' : 'FAILED'}: ${fixed(statistic, 1)}, expected between ${fixed(lower, 1)} and ${fixed(upper, 1)}`;

/** @param {import('../node.js').ErrorEllipse} e */
const ellipse = ({ semi_major: major, semi_minor: minor, bearing_deg: bearing }) =>
  `by and bz together lie in an ellipse with semi-axes of ${significant(major)} x ${significant(minor)} mm, ${fixed(bearing, 0)} deg from by to bz, in 95 % of cases`;

/**
 * The orientation in text.
 * @param {RelativeOrientation} o @param {number | null} pixelMm the pixel's size at photo scale, where it is known @returns {string[]}
 */
export function describeOrientation(o, pixelMm) {
  const rows = UNKNOWNS.map(({ name, unit, field }) => {
    const total = o.total_standard_errors ? [fixed(o.total_standard_errors[field], 4)] : [];
    return [`${name} [${unit}]`, fixed(o[field], 4), fixed(o.standard_errors?.[field], 4), ...total, fixed(o.half_widths_95?.[field], 4)];
  });
  const sigma = pixelMm === null || o.sigma0_mm === null ? '' : ` = ${fixed(o.sigma0_mm / pixelMm, 3)} px`;
  return [
    table([['', 'value', 'std. error', ...(o.total_standard_errors ? ['in total'] : []), '95 % ±'], ...rows]),
    ...(o.turn_deg === 0 ? [] : [TURNED]),
    '',
    `base ${fixed(o.base_mm, 3)} mm, focal length ${fixed(o.focal_mm, 3)} mm, ${o.method}`,
    `sigma0 ${fixed(o.sigma0_mm, 5)} mm${sigma}, ${o.degrees_of_freedom} degrees of freedom, ${o.iterations} iterations, ${o.rejected.length} rejected`,
    ...(o.base_ellipse_95_mm ? [ellipse(o.base_ellipse_95_mm)] : []),
    `condition ${significant(o.condition)}, plane misfit ${fixed(o.plane_misfit, 1)} sigma0, parallax beside a rotation ${significant(o.parallax_beside_rotation_mm)} mm`,
    ...(o.cameras ? [estimatedCamera(o.cameras[0], pixelMm)] : []),
    ...(o.global_test ? [globalTest(o.global_test)] : []),
    ...o.warnings.map((warning) => `warning: ${message('warning', warning)}`),
  ];
}

/**
 * The left camera, where it is not known without error: what is known of it after the orientation.
 * @param {import('../node.js').EstimatedCamera} camera @param {number | null} pixelMm @returns {string}
 */
function estimatedCamera(camera, pixelMm) {
  const [unit, name, digits] = pixelMm === null ? [1, 'mm', 3] : [pixelMm, 'px', 1];
  const withError = (/** @type {number} */ value, /** @type {number} */ error) => `${fixed(value / unit, digits)} ± ${fixed(error / unit, digits)} ${name}`;
  const square = camera.focal_mm ** 2;
  return (
    `camera: focal length ${withError(camera.focal_mm, camera.focal_standard_error_mm)}, ` +
    `k1 ${fixed(camera.k1_per_mm2 * square, 4)} ± ${fixed(camera.k1_standard_error_per_mm2 * square, 4)} at one focal length`
  );
}
