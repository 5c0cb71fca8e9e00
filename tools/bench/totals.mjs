/**
 * Whether total standard errors hold what they say: flights of every preset by every strategy, the mean square of error over total standard error
 * of each unknown. 1 is right. `--seeds=16` flights of each preset, all by other seeds, from `--from=865` on (earlier ones set the shares): the
 * errors of fiducial marks follow from the seed, whatever the preset. `--only=TEXT` takes the strategies with the text in their name.
 */

import { flight_preset, flight_presets, match_pair, Photo, simulate } from '../../pkg/node.js';
import { numberOption, textOption } from './options.mjs';

/** @typedef {import('../../pkg/node.js').PairSettings['matching']} Matching @typedef {import('../../pkg/node.js').Preset} Preset */

/** @type {[string, Partial<Matching>][]} */
const STRATEGIES = [
  ['auto', {}],
  ['gradient', { strategy: 'gradient' }],
  ['moments', { strategy: 'moments' }],
  ['correlation', { strategy: 'correlation' }],
  ['correlation, refined', { strategy: 'correlation', refine: 'least-squares' }],
  ['least squares', { strategy: 'least-squares' }],
];

const UNKNOWNS = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);

export function totals() {
  const [seeds, from] = [numberOption('seeds', 16), numberOption('from', 865)];
  console.log(
    `Simulated flights, ${seeds} of each preset from seed ${from} on: mean square of error over total standard error of omega phi kappa by bz (1 is right)`,
  );
  const only = textOption('only') ?? '';
  for (const [name, matching] of STRATEGIES.filter(([name]) => name.includes(only))) {
    const all = flight_presets().map((preset, number) => {
      const squares = Array.from({ length: seeds }, (_, k) => squaresOf(preset, from + number * seeds + k, matching)).filter((square) => square !== null);
      console.log(`  ${name}, ${preset}: ${text(squares)}`);
      return squares;
    });
    console.log(`  ${name}, all: ${text(all.flat())}`);
  }
}

/** @param {number[][]} squares */
function text(squares) {
  const means = UNKNOWNS.map((_, k) => squares.reduce((sum, square) => sum + (square[k] ?? NaN), 0) / squares.length);
  return `${means.map((mean) => mean.toFixed(2)).join(' ')} (${squares.length} oriented)`;
}

/** Of each unknown of a flight; null where it is not oriented.  @param {Preset} preset @param {number} seed @param {Partial<Matching>} matching */
function squaresOf(preset, seed, matching) {
  const made = simulate({ ...flight_preset(preset), seed });
  const [left, right] = [made.left, made.right].map(({ width, height, grey }) => Photo.from_grey(width, height, grey));
  if (!left || !right) throw new Error('a pair has two images');
  const side = (/** @type {'left' | 'right'} */ name) => ({ fiducials: made[`${name}_fiducials`], origin: made[`${name}_origin`] });
  const settings = { matching, orientation: { base_mm: made.base_mm } };
  const { orientation } = match_pair(left, right, { camera: made.camera, left: side('left'), right: side('right') }, settings);
  left.free();
  right.free();
  const errors = orientation?.total_standard_errors;
  if (!orientation || !errors) return null;
  return UNKNOWNS.map((name) => ((orientation[name] - made.truth[name]) / errors[name]) ** 2);
}
