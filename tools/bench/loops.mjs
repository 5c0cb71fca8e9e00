/**
 * Standard errors judged without a reference: orientations of three pairs of three photographs, of which two together are the third. What the
 * loop does not close by is the errors of the three alone, where a reference has errors of its own.
 */

import { match_pair } from '../../pkg/node.js';
import { poseOf, rotationError } from '../score.mjs';
import { cameraOf } from './accuracy.mjs';
import { photoOf, pinhole, posedPairs } from './data.mjs';
import { multiplied } from './verdict/pictures.mjs';

/** @typedef {{ rotation: number[][], error_deg: number }} Oriented error_deg: the total standard errors of ω, φ and κ together */

/** What is not known of the cameras, as it is by default, and nothing.  @type {[string, import('../../pkg/node.js').CameraMm['uncertainty']][]} */
const CAMERAS = [
  ['cameras given', undefined],
  ['cameras without error', { focal: 0, principal_point: 0, k1: 0 }],
];

export function loops() {
  console.log('Loops of three pairs: what their rotations do not close by, by its total standard error (1 or less is right; the three share a camera)');
  const folders = new Set(posedPairs().map(({ folder }) => folder));
  for (const [way, uncertainty] of CAMERAS) for (const folder of folders) told(`${folder}, ${way}`, closures(orientationsOf(folder, uncertainty)));
}

/** @param {string} name @param {{ deg: number, error_deg: number }[]} found */
function told(name, found) {
  if (found.length === 0) return;
  const middle = (/** @type {(closure: { deg: number, error_deg: number }) => number} */ of) => {
    const sorted = found.map(of).sort((a, b) => a - b);
    return sorted[sorted.length >> 1] ?? NaN;
  };
  const times = found.map(({ deg, error_deg }) => deg / error_deg);
  console.log(
    `  ${name}: ${found.length} loops, median ${middle(({ deg }) => deg).toFixed(4)} deg, by its standard error ${middle(({ deg, error_deg }) => deg / error_deg).toFixed(2)} ` +
      `in the median, ${Math.max(...times).toFixed(2)} at most`,
  );
}

/**
 * The pairs of a folder that are oriented, by the names of their photographs.
 * @param {string} folder @param {import('../../pkg/node.js').CameraMm['uncertainty']} uncertainty @returns {Map<string, Map<string, Oriented>>}
 */
function orientationsOf(folder, uncertainty) {
  /** @type {Map<string, Map<string, Oriented>>} */
  const oriented = new Map();
  for (const { a, b, truth } of posedPairs().filter((pair) => pair.folder === folder)) {
    const [left, right] = [photoOf(folder, a), photoOf(folder, b)];
    const camera = { ...cameraOf(pinhole(truth, a), left.width, left.height), uncertainty };
    const { orientation } = match_pair(left, right, { camera }, {});
    left.free();
    right.free();
    const errors = orientation?.total_standard_errors;
    if (!orientation || !errors) continue;
    const of = oriented.get(a) ?? new Map();
    oriented.set(a, of.set(b, { rotation: poseOf(orientation).rotation, error_deg: Math.hypot(errors.omega_deg, errors.phi_deg, errors.kappa_deg) }));
  }
  return oriented;
}

/** @param {Map<string, Map<string, Oriented>>} oriented @returns {{ deg: number, error_deg: number }[]} */
function closures(oriented) {
  return [...oriented].flatMap(([, of]) =>
    [...of].flatMap(([b, first]) =>
      [...(oriented.get(b) ?? [])].flatMap(([c, second]) => {
        const third = of.get(c);
        if (!third) return [];
        const deg = rotationError(multiplied(second.rotation, first.rotation), third.rotation);
        return [{ deg, error_deg: Math.hypot(first.error_deg, second.error_deg, third.error_deg) }];
      }),
    ),
  );
}
