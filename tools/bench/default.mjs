/**
 * What two photographs give whose owner sets nothing: `match_pair` without an option on every pair with truth, and on simulated flights of
 * all kinds. Medians of the errors, and of the errors by the total standard errors that are printed with them.
 */

import { flight_preset, flight_presets, match_pair, message, Photo, score_matches, simulate } from '../../pkg/node.js';
import { cameraOf } from './accuracy.mjs';
import { directionError, poseOf, rotationError, sampsonShare } from '../score.mjs';
import { photoOf, pinhole, posedPairs } from './data.mjs';

/**
 * @typedef {import('../../pkg/node.js').PairOutput} PairOutput
 * @typedef {import('../../pkg/node.js').PairSettings} PairSettings
 * @typedef {import('../../pkg/node.js').Given<import('../../pkg/node.js').PairInput>} PairInput
 * @typedef {{ rotation: number[][], direction: number[] }} Pose
 * @typedef {{ name: string, left: Photo, right: Photo, input: PairInput, pose: Pose, share: (matches: Float64Array) => number }} Case
 * @typedef {{ share: number, rotation: number, direction: number, inErrors: number, verdict: string }} Outcome
 */

/** Seeds of the simulated flights: those of no test. */
const SEEDS = [101, 102, 103, 104, 105, 106];

/** @type {[string, import('../../pkg/node.js').Given<PairSettings>][]} */
const WAYS = [
  ['default', {}],
  ['gradient', { matching: { strategy: 'gradient' } }],
  ['moments', { matching: { strategy: 'moments' } }],
];

export function byDefault() {
  console.log('Two photographs, nothing set (share of right matches; rotation and base direction error; rotation error by its total standard error)');
  for (const [way, settings] of WAYS) {
    /** @type {Record<'photographs' | 'calibrated' | 'simulated', Outcome[]>} */
    const outcomes = { photographs: [], calibrated: [], simulated: [] };
    for (const given of photographs(false)) outcomes.photographs.push(run(way, given, settings));
    for (const given of photographs(true)) outcomes.calibrated.push(run(way, given, settings));
    for (const given of flights()) outcomes.simulated.push(run(way, given, settings));
    for (const [kind, of] of Object.entries(outcomes)) summary(`${way}, ${kind}`, of);
  }
}

/** @param {string} way @param {Case} given @param {import('../../pkg/node.js').Given<PairSettings>} settings @returns {Outcome} */
function run(way, { name, left, right, input, pose, share }, settings) {
  const start = performance.now();
  const output = match_pair(left, right, input, settings);
  const seconds = (performance.now() - start) / 1000;
  left.free();
  right.free();
  const outcome = { share: share(output.match.matches), ...errors(output, pose), verdict: message('pair_verdict', output.verdict, 'label') };
  const why = output.no_orientation ? `: ${message('no_orientation', output.no_orientation)}` : '';
  console.log(
    `  ${way}, ${name}: ${output.match.counts.matches} matches, ${outcome.share.toFixed(3)}; ${outcome.rotation.toFixed(3)} deg, ` +
      `${outcome.direction.toFixed(2)} deg; ${outcome.inErrors.toFixed(1)}; ${outcome.verdict}${why}, ${seconds.toFixed(1)} s`,
  );
  return outcome;
}

/** @param {PairOutput} output @param {Pose} truth */
function errors({ orientation }, truth) {
  if (!orientation) return { rotation: NaN, direction: NaN, inErrors: NaN };
  const pose = poseOf(orientation);
  const { omega_deg, phi_deg, kappa_deg } = orientation.total_standard_errors ??
    orientation.standard_errors ?? { omega_deg: NaN, phi_deg: NaN, kappa_deg: NaN };
  const rotation = rotationError(pose.rotation, truth.rotation);
  return { rotation, direction: directionError(pose.direction, truth.direction), inErrors: rotation / Math.hypot(omega_deg, phi_deg, kappa_deg) };
}

/** @param {string} what @param {Outcome[]} outcomes */
function summary(what, outcomes) {
  if (outcomes.length === 0) return;
  const oriented = outcomes.filter((o) => Number.isFinite(o.rotation));
  const median = (/** @type {(o: Outcome) => number} */ of) => {
    const sorted = oriented.map(of).sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? NaN;
  };
  console.log(
    `${what}: ${oriented.length} of ${outcomes.length} oriented; medians: share ${median((o) => o.share).toFixed(3)}, rotation ${median((o) => o.rotation).toFixed(3)} deg, ` +
      `base direction ${median((o) => o.direction).toFixed(2)} deg, rotation error by its standard error ${median((o) => o.inErrors).toFixed(2)}`,
  );
}

/** Every pair of photographs whose pose is known, with its calibrated cameras or without any.  @param {boolean} calibrated @returns {Generator<Case>} */
function* photographs(calibrated) {
  for (const { folder, a, b, truth, pose } of posedPairs()) {
    const [left, right] = [pinhole(truth, a), pinhole(truth, b)];
    const share = (/** @type {Float64Array} */ matches) => sampsonShare(matches, left, right, pose.rotation, pose.direction).share;
    const photos = { left: photoOf(folder, a), right: photoOf(folder, b) };
    const input = calibrated ? { camera: cameraOf(left, photos.left.width, photos.left.height) } : {};
    yield { name: `${folder} ${a} ${b}${calibrated ? ', calibrated' : ''}`, ...photos, input, pose, share };
  }
}

/** Simulated flights with the camera that their flight names, scanned without fiducial marks.  @returns {Generator<Case>} */
function* flights() {
  for (const preset of flight_presets()) {
    for (const seed of SEEDS) {
      const made = simulate({ ...flight_preset(preset), seed });
      const [left, right] = [made.left, made.right].map((p) => Photo.from_grey(p.width, p.height, p.grey));
      if (!left || !right) throw new Error('a pair has two images');
      const [{ width, height }, other] = [made.left, made.right];
      const share = (/** @type {Float64Array} */ matches) => {
        const score = score_matches(matches, new Float64Array(), made.right_position, width, height, other.width, other.height);
        return score.right / score.matches;
      };
      const side = (/** @type {'left' | 'right'} */ name) => ({ fiducials: made[`${name}_fiducials`], origin: made[`${name}_origin`] });
      const input = { camera: made.camera, left: side('left'), right: side('right') };
      yield { name: `${preset} ${seed}`, left, right, input, pose: poseOf({ ...made.truth, base_mm: made.base_mm }), share };
    }
  }
}
