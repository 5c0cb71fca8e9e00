// @ts-check
import { orient_relative, parse_observations } from '../node.js';
import { about, UsageError } from './errors.js';
import { readText } from './files.js';
import { BASE, JSON_FLAG, ORIENTATION_OPTIONS, real, settingsOf } from './options.js';
import { print, printJson } from './output.js';
import { fixed, table } from './text.js';

/** @typedef {import('../node.js').RelativeOrientation} RelativeOrientation */

const FOCAL = { ...real('focal-mm', 'Focal length (principal distance) in mm; required.', (f) => f > 0, 'a number above 0'), placeholder: 'F' };
const OPTIONS = [FOCAL, BASE, ...ORIENTATION_OPTIONS, JSON_FLAG];

/** @type {import('./args.js').Command} */
export const orient = {
  name: 'orient',
  summary: 'Dependent relative orientation of two photos from measured photo coordinates.',
  positionals: ['OBSERVATIONS.csv'],
  options: OPTIONS,
  details: 'OBSERVATIONS.csv: columns x_left_mm,y_left_mm,x_right_mm,y_right_mm, x to the right and y up, principal point at 0, 0. '
    + '--focal-mm and --base-mm are required. JSON: omega_deg, phi_deg, kappa_deg, by_mm, bz_mm, standard_errors, sigma0_mm, degrees_of_freedom, '
    + 'iterations, correlations (of omega, phi, kappa, by, bz), residuals_mm [[vxl, vyl, vxr, vyr], …], rejected (indices from 0).',
  run({ positionals: [file = ''], values }) {
    const focal = values.get('focal-mm');
    if (typeof focal !== 'number') throw new UsageError('--focal-mm is missing: give the focal length in mm');
    if (!values.has('base-mm')) throw new UsageError('--base-mm is missing: give the photo base in mm');
    const settings = settingsOf(OPTIONS, values);
    const text = readText(file);
    const observations = about(file, () => parse_observations(text));
    const result = orient_relative(observations, focal, settings.orientation);
    if (values.has('json')) printJson(result);
    else print(...describeOrientation(result, null));
  },
};

/**
 * The orientation in text.
 * @param {RelativeOrientation} o @param {number | null} pixelMm the pixel's size at photo scale, where it is known @returns {string[]}
 */
export function describeOrientation(o, pixelMm) {
  const e = o.standard_errors;
  const sigma = pixelMm === null || o.sigma0_mm === null ? '' : ` = ${fixed(o.sigma0_mm / pixelMm, 3)} px`;
  return [
    table([
      ['', 'value', 'std. error'],
      ['omega [deg]', fixed(o.omega_deg, 4), fixed(e?.omega_deg, 4)],
      ['phi [deg]', fixed(o.phi_deg, 4), fixed(e?.phi_deg, 4)],
      ['kappa [deg]', fixed(o.kappa_deg, 4), fixed(e?.kappa_deg, 4)],
      ['by [mm]', fixed(o.by_mm, 4), fixed(e?.by_mm, 4)],
      ['bz [mm]', fixed(o.bz_mm, 4), fixed(e?.bz_mm, 4)],
    ]),
    '',
    `base ${fixed(o.base_mm, 3)} mm, focal length ${fixed(o.focal_mm, 3)} mm, ${o.method}`,
    `sigma0 ${fixed(o.sigma0_mm, 5)} mm${sigma}, ${o.degrees_of_freedom} degrees of freedom, ${o.iterations} iterations, ${o.rejected.length} rejected`,
  ];
}
