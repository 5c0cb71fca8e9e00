/** How right the results are: matches, their precision, and the orientation against the truth. */

import { defaults, match_pair, message } from '../../pkg/node.js';
import { directionError, edgePrecision, poseOf, rotationError, sampsonShare } from '../score.mjs';
import { have, posed, simulated } from './data.mjs';

/** @typedef {import('../../pkg/node.js').PairSettings} PairSettings @typedef {import('../../pkg/node.js').RelativeOrientation} RelativeOrientation */

/** The paper's setting: 14.8 % candidates in each image. */
const PAPER_FRACTION = 0.148;

/** @param {(settings: PairSettings) => void} change @returns {PairSettings} */
export function settingsWith(change) {
  const settings = defaults();
  settings.matching.strategy = 'moments';
  settings.points.fraction = PAPER_FRACTION;
  change(settings);
  return settings;
}

export function accuracy() {
  console.log('Accuracy');
  if (have('simulated-a')) simulatedPair();
  if (have('semisynth_exact_caliterra')) {
    posedPair('semisynth_exact_caliterra', 'v1.png', 'v2.png', () => {});
    posedPair(
      'semisynth_exact_caliterra',
      'v1.png',
      'v2.png',
      (s) => {
        s.matching.denominator = 'floor';
      },
      'floor',
    );
  }
  if (have('pair_full_caliterra'))
    posedPair(
      'pair_full_caliterra',
      'IMG_9401.jpg',
      'IMG_9402.jpg',
      (s) => {
        s.points.suppression_window = 9;
      },
      'suppression 9 px',
    );
}

function simulatedPair() {
  const { left, right, input, truth, map, base_mm } = simulated();
  /** @type {[string, (s: PairSettings) => void][]} */
  const runs = [
    ['denominator maxabs', () => {}],
    [
      'denominator floor',
      (s) => {
        s.matching.denominator = 'floor';
      },
    ],
    [
      'determinant form',
      (s) => {
        s.orientation.method = 'determinant';
      },
    ],
    [
      'plain least squares, not robust',
      (s) => {
        s.orientation.robust = false;
      },
    ],
    [
      'plain, without parallax and ambiguity rules',
      (s) => {
        s.orientation.robust = false;
        s.matching.parallax_neighbours = 0;
        s.matching.ambiguity = 1;
      },
    ],
    [
      'robust, without parallax and ambiguity rules',
      (s) => {
        s.matching.parallax_neighbours = 0;
        s.matching.ambiguity = 1;
      },
    ],
  ];
  for (const [label, change] of runs) {
    const settings = settingsWith((s) => {
      s.orientation.base_mm = base_mm;
      change(s);
    });
    const output = match_pair(left, right, input, settings);
    const score = edgePrecision(output.match.matches, map);
    console.log(`  simulated-a, ${label}: ${output.match.counts.matches} matches, edge precision ${score.share.toFixed(3)}`);
    const o = output.orientation;
    if (!o) console.log(`    no orientation: ${output.no_orientation && message('no_orientation', output.no_orientation)}`);
    else console.log(`    ${precisionOf(o, output.pixel_mm ?? null)}; errors ${errorsOf(o, truth)}`);
  }
  const phases = match_pair(
    left,
    right,
    input,
    settingsWith(() => {}),
  );
  for (const [side, { counts }] of /** @type {const} */ ([
    ['left', phases.left],
    ['right', phases.right],
  ])) {
    console.log(`  ${side}: ${counts.candidates} candidates, ${counts.after_roundness} after roundness, ${counts.after_suppression} after suppression`);
  }
}

/** @param {RelativeOrientation} o @param {number | null} pixelMm */
function precisionOf(o, pixelMm) {
  const sigma = o.sigma0_mm === null || o.sigma0_mm === undefined || pixelMm === null ? '-' : (o.sigma0_mm / pixelMm).toFixed(3);
  return `sigma0 ${sigma} px, ${o.rejected.length} rejected`;
}

/** @param {RelativeOrientation} o @param {Record<string, number>} truth */
function errorsOf(o, truth) {
  const names = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);
  return names.map((name) => `${name} ${(o[name] - (truth[name] ?? NaN)).toFixed(4)}`).join(', ');
}

/**
 * A pair without fiducial marks, oriented as a user would: with the camera of its EXIF data, and with the known one.
 * @param {string} name @param {string} a @param {string} b @param {(s: PairSettings) => void} change @param {string} [label]
 */
function posedPair(name, a, b, change, label = 'paper settings') {
  const { left, right, cameras, rotation, direction } = posed(name, a, b);
  const [first, second] = cameras;
  if (!first || !second) throw new Error(`${name}: the truth names no camera`);
  /** @type {[string, import('../../pkg/node.js').Given<import('../../pkg/node.js').PairInput>][]} */
  const ways = [
    ['EXIF camera', {}],
    ['known camera', { camera: cameraOf(first, left.width, left.height) }],
  ];
  for (const [way, input] of ways) {
    const output = match_pair(left, right, input, settingsWith(change));
    const score = sampsonShare(output.match.matches, first, second, rotation, direction);
    console.log(`  ${name} ${a} ${b}, ${label}, ${way}: ${output.match.counts.matches} matches, ${score.share.toFixed(3)} within 1.5 px of the epipolar line`);
    if (!output.orientation) {
      console.log(`    no orientation: ${output.no_orientation && message('no_orientation', output.no_orientation)}`);
      continue;
    }
    const pose = poseOf(output.orientation);
    console.log(
      `    ${precisionOf(output.orientation, output.pixel_mm ?? null)}; rotation error ${rotationError(pose.rotation, rotation).toFixed(3)} deg, ` +
        `base direction error ${directionError(pose.direction, direction).toFixed(3)} deg`,
    );
  }
  left.free();
  right.free();
}

/**
 * A pinhole camera in the form the crate takes, with 1 mm a thousand pixels. The crate's distortion corrects what was measured, the
 * truth's distorts what is ideal: the series is inverted to its second term.
 * @param {import('../score.mjs').Pinhole} p @param {number} width @param {number} height
 */
export function cameraOf({ f, cx, cy, k1, k2 }, width, height) {
  const pixel_mm = 0.001;
  const focal_mm = f * pixel_mm;
  return {
    focal_mm,
    pixel_mm,
    principal_point_mm: /** @type {[number, number]} */ ([(cx - width / 2) * pixel_mm, (height / 2 - cy) * pixel_mm]),
    radial_distortion: /** @type {[number, number, number]} */ ([-k1 / focal_mm ** 2, (3 * k1 * k1 - k2) / focal_mm ** 4, 0]),
  };
}
