// @ts-check
import { message, orient_fiducials, parse_fiducials } from '../node.js';
import { about } from './errors.js';
import { readText } from './files.js';
import { JSON_FLAG, word } from './options.js';
import { print, printJson } from './output.js';
import { fixed, table } from './text.js';

/** @typedef {import('../node.js').FiducialModel} FiducialModel */

/** @type {FiducialModel[]} */
const MODELS = ['affine', 'similarity'];

/** What other commands refuse. */
const MIRRORED = { kind: 'invalid_input', refusal: { kind: 'marks_mirrored' } };

const MODEL = word('model', MODELS, 'The transformation from scan to photo: affine has six parameters, similarity four.', 'affine');

/** @type {import('./args.js').Command} */
export const interior = {
  name: 'interior',
  summary: 'Interior orientation: the transformation from measured to calibrated fiducial marks, by least squares.',
  positionals: ['FIDUCIALS.csv'],
  options: [MODEL, JSON_FLAG],
  details:
    'FIDUCIALS.csv: columns col,row,x_mm,y_mm, one line per mark. x_mm = a col + b row + tx, y_mm = d col + e row + ty. ' +
    'JSON: model, parameters [[a, b, tx], [d, e, ty]], residuals_mm, sigma0_mm, standard_errors and half_widths_95 (null without redundancy), covariance (of the three parameters of a row, the same for both rows; null without redundancy and for a similarity), degrees_of_freedom, mirrored (whether the marks lie mirrored in the scan).',
  run({ positionals: [file = ''], values }) {
    const text = readText(file);
    const model = /** @type {FiducialModel} */ (values.get('model') ?? 'affine');
    const result = about(file, () => orient_fiducials(parse_fiducials(text), model));
    const mirrored = isMirrored(result);
    if (values.has('json')) printJson({ ...result, mirrored });
    else print(...describe(result), ...(mirrored ? ['', `warning: ${message('error', MIRRORED)}`] : []));
  },
};

/** Whether the marks lie mirrored in the scan, whose rows count downwards.  @param {import('../node.js').FiducialOrientation} result */
function isMirrored({ parameters: [[a, b], [d, e]] }) {
  return a * e - b * d > 0;
}

/** @param {import('../node.js').FiducialOrientation} result @returns {string[]} */
function describe(result) {
  const { parameters, standard_errors: errors, half_widths_95: half, residuals_mm: residuals } = result;
  const names = [
    ['a', 'b', 'tx [mm]'],
    ['d', 'e', 'ty [mm]'],
  ];
  const lines = names.flatMap((row, r) => row.map((name, c) => [name, fixed(parameters[r]?.[c], 8), fixed(errors?.[r]?.[c], 8), fixed(half?.[r]?.[c], 8)]));
  return [
    `${result.model} transformation: x = a col + b row + tx, y = d col + e row + ty`,
    '',
    table([['', 'value', 'std. error', '95 % ±'], ...lines]),
    '',
    table([['mark', 'vx [mm]', 'vy [mm]'], ...residuals.map(([vx, vy], i) => [i + 1, fixed(vx, 4), fixed(vy, 4)])]),
    '',
    `sigma0 ${fixed(result.sigma0_mm, 4)} mm, ${result.degrees_of_freedom} degrees of freedom`,
  ];
}
