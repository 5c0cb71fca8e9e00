// @ts-check
/** What is printed of a block that was computed. */

import { fixed, listed, significant, table } from './text.js';

/** @typedef {import('../node.js').Summary} Summary */

/** @param {string} out @param {Summary} summary @returns {string[]} */
export function describe(out, { verdict, images, cameras, pairs, groups, points, selection, refinement, orientation, orthophoto, score }) {
  const models = 'models' in orientation ? orientation.models : [];
  const [first] = models;
  return [
    verdict.text,
    '',
    table([
      ['images', images.read],
      ['skipped', images.left_out.length],
      ...(images.masked > 0 ? [['with a mask', images.masked]] : []),
      ['cameras', cameras.length],
      ['features', images.features ?? '–'],
      ['pairs tried', pairs.tried],
      ['pairs connected', pairs.connected],
      ['groups of connected images', groups.length],
      ['verified matches', pairs.matches],
      ...(points
        ? [
            ['tie points', points.found],
            ['observations of tie points', points.rays],
          ]
        : []),
      ['points chosen', selection.points],
      ['observations of points chosen', selection.rays],
      ['minimum of chosen observations per image', selection.least_rays_of_an_image],
      ...(refinement ? [['observations refined', `${refinement.refined} of ${refinement.rays - refinement.references}`]] : []),
      ['images oriented', `${orientation.oriented} of ${images.read}`],
      ...(models.length > 1 ? [['models', models.length]] : []),
      ...(first
        ? [
            ['sigma0 [px]', fixed(first.sigma0_px, 3)],
            ['residuals, RMS [px]', fixed(first.rmse_px, 3)],
            ...(first.position_errors_m
              ? [
                  [
                    `standard errors of positions x y z, median [${first.in_system ? 'm' : 'units of the block'}]`,
                    first.position_errors_m.map(significant).join(' '),
                  ],
                ]
              : []),
            ...(first.angle_errors_deg ? [['standard errors of omega phi kappa, median [deg]', first.angle_errors_deg.map(significant).join(' ')]] : []),
          ]
        : []),
      ...(first?.components ?? []).map(({ name, factor, interval, applied }) => [
        `errors by residuals / stated: ${name}`,
        interval
          ? `${fixed(factor, 2)} (95 %: ${interval.map((v) => fixed(v, 2)).join(' to ')})${applied ? ', weights follow' : isOutside(interval) ? ', not in weights' : ''}`
          : 'held at 1: too little redundancy',
      ]),
      ...(first?.systematic ?? []).map(({ name, estimate, standard_errors, verdict }) => [
        `${name}, x y z [m]`,
        verdict === 'kept'
          ? estimate.map((v, k) => withError(v, standard_errors[k] ?? null)).join(', ')
          : verdict === 'undetermined'
            ? 'not determined, zero'
            : 'not significant, zero',
      ]),
      ...(first?.checks
        ? [
            ['check points', first.checks.points],
            ['check points, RMSE of x y z [m]', first.checks.rmse_m.map((v) => fixed(v, 3)).join(' ')],
            ['check points, mean of dx dy dz [m]', first.checks.mean_m.map((v) => fixed(v, 3)).join(' ')],
            ...(first.checks.ratio === null ? [] : [['their differences by predicted standard errors', fixed(first.checks.ratio, 2)]]),
          ]
        : []),
      ...(score
        ? [
            ['right points by the truth', `${score.right_points} of ${score.points}`],
            ['angles after a similarity, RMS error [deg]', fixed(score.angle_rmse_deg, 4)],
          ]
        : []),
      ...(score?.position_rmse_m ? [['positions after a similarity, RMS error [m]', score.position_rmse_m.map((v) => fixed(v, 3)).join(' ')]] : []),
    ]),
    ...(orthophoto ? ['', orthophoto.text] : []),
    ...(models.length > 1 ? ['', ...models.flatMap(describeModel)] : (first?.warnings ?? []).map(warning)),
    ...(pairs.connected > 0 ? reasons(orientation) : []),
    '',
    `written to ${out}`,
  ];
}

/** Whether what was stated is not among what the residuals allow.  @param {number[]} interval */
const isOutside = ([low = 0, high = Infinity]) => low > 1 || high < 1;

/** A model by its number and images, as images without points in common make models of their own.  @param {import('../node.js').ModelSummary} model @param {number} index @returns {string[]} */
function describeModel({ names, sigma0_px, warnings }, index) {
  const apart = index > 0 ? ', in orientation.json alone' : '';
  return [`model ${index + 1}${apart}: ${listed(names)}; sigma0 ${fixed(sigma0_px, 3)} px`, ...warnings.map((is) => `  ${warning(is)}`)];
}

/** @param {{ text: string }} warning */
const warning = ({ text }) => `warning: ${text}`;

/** @param {Summary['orientation']} orientation @returns {string[]} */
const reasons = (orientation) =>
  'reason' in orientation
    ? ['', `not oriented: ${orientation.reason.text}`]
    : orientation.unoriented.map(({ name, reason: { text } }) => `not oriented: ${name}: ${text}`);

/** A value that nothing determines is 0 without a standard error. @param {number} value @param {number | null} error */
const withError = (value, error) => (error === null ? (value === 0 ? '–' : fixed(value, 3)) : `${fixed(value, 3)} ± ${fixed(error, 3)}`);
