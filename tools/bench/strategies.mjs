/** All strategies on the same points through the same rules: right matches, precision, and true errors beside standard errors. */

import { flight_preset, flight_presets, match_pair, message, Photo, score_matches, simulate } from '../../pkg/node.js';
import { edgePrecision } from '../score.mjs';
import { settingsWith } from './accuracy.mjs';
import { have, simulated } from './data.mjs';

/**
 * @typedef {import('../../pkg/node.js').PairSettings} PairSettings
 * @typedef {import('../../pkg/node.js').PairOutput} PairOutput
 * @typedef {import('../../pkg/node.js').FiveParameters} FiveParameters
 * @typedef {{ left: Photo, right: Photo, input: import('../../pkg/node.js').Given<import('../../pkg/node.js').PairInput>, base_mm: number, truth: FiveParameters, share: (matches: Float64Array) => number }} Case
 */

/** Rules of matching, and the operator where it is not the paper's.  @type {[string, Partial<PairSettings['matching']>, PairSettings['points']['operator']?][]} */
const STRATEGIES = [
  ['moments', {}],
  ['moments, floor', { denominator: 'floor' }],
  ['invariants', { strategy: 'invariants' }],
  ['correlation', { strategy: 'correlation' }],
  ['moments, floor, refined', { denominator: 'floor', refine: 'least-squares' }],
  ['the same, along epipolar lines', { denominator: 'floor', refine: 'least-squares', epipolar: true }],
  ['correlation, refined', { strategy: 'correlation', refine: 'least-squares' }],
  ['least squares', { strategy: 'least-squares' }],
  ['multiscale points, gradients', { strategy: 'gradient' }, 'multiscale'],
];

const NAMES = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);

export function strategies() {
  console.log(
    "Strategies (paper's points, ground 2, 14.8 %, where no others are named; edge precision of all matches; true errors of omega phi kappa [deg] by bz [mm], in brackets divided by the total standard error)",
  );
  if (have('simulated-a')) compare('simulated-a', fromData());
  for (const preset of flight_presets()) compare(`preset ${preset}`, flown(preset));
}

/** @returns {Case} */
function fromData() {
  const { left, right, input, truth, map, base_mm } = simulated();
  return { left, right, input, base_mm, truth: /** @type {FiveParameters} */ (truth), share: (matches) => edgePrecision(matches, map).share };
}

/** @param {import('../../pkg/node.js').Preset} preset @returns {Case} */
function flown(preset) {
  const made = simulate(flight_preset(preset));
  const [left, right] = [made.left, made.right].map((p) => Photo.from_grey(p.width, p.height, p.grey));
  if (!left || !right) throw new Error('a pair has two images');
  const share = (/** @type {Float64Array} */ matches) => {
    const score = score_matches(matches, new Float64Array(), made.right_position, left.width, left.height, right.width, right.height);
    return score.right / score.matches;
  };
  const side = (/** @type {'left' | 'right'} */ name) => ({ fiducials: made[`${name}_fiducials`], origin: made[`${name}_origin`] });
  return { left, right, input: { camera: made.camera, left: side('left'), right: side('right') }, base_mm: made.base_mm, truth: made.truth, share };
}

/** @param {string} name @param {Case} given */
function compare(name, { left, right, input, base_mm, truth, share }) {
  for (const [label, matching, operator] of STRATEGIES) {
    const settings = settingsWith((s) => {
      s.orientation.base_mm = base_mm;
      Object.assign(s.matching, matching);
      if (operator) s.points.operator = operator;
    });
    const output = match_pair(left, right, input, settings);
    const found = `  ${name}, ${label}: ${output.match.counts.matches} matches, edge precision ${share(output.match.matches).toFixed(3)}`;
    const o = output.orientation;
    if (!o) {
      console.log(`${found}; no orientation: ${output.no_orientation && message('no_orientation', output.no_orientation)}`);
      continue;
    }
    const errors = NAMES.map(
      (n) => `${(o[n] - truth[n]).toFixed(4)} (${((o[n] - truth[n]) / (o.total_standard_errors ?? o.standard_errors ?? o)[n]).toFixed(1)})`,
    );
    console.log(`${found}, sigma0 ${((o.sigma0_mm ?? NaN) / (output.pixel_mm ?? NaN)).toFixed(3)} px; errors ${errors.join(' ')}`);
  }
  left.free();
  right.free();
}
