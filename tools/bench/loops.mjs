/**
 * Standard errors judged without a reference: orientations of three pairs of three photographs, of which two together are the third. What the
 * loop does not close by is the errors of the three alone, where a reference has errors of its own.
 */

import { match_pair } from '../../pkg/node.js';
import { poseOf, rotationError } from '../score.mjs';
import { cameraOf } from './accuracy.mjs';
import { photoOf, pinhole, posedPairs } from './data.mjs';
import { multiplied, transposed } from './verdict/pictures.mjs';

/**
 * @typedef {[number, number, number]} OfAxes degrees about x, y and z of the camera
 * @typedef {{ rotation: number[][], errors_deg: OfAxes, off_deg: OfAxes }} Oriented errors_deg: total standard errors; off_deg: from the reference
 * @typedef {{ off_deg: OfAxes, errors_deg: OfAxes }} Discrepancy
 */

/** What is not known of the cameras, as it is by default, and nothing.  @type {[string, import('../../pkg/node.js').CameraMm['uncertainty']][]} */
const CAMERAS = [
  ['cameras given', undefined],
  ['cameras without error', { focal: 0, principal_point: 0, k1: 0 }],
];

export function loops() {
  console.log('Loops of three pairs: what their rotations do not close by, by its total standard error (1 or less is right; the three share a camera)');
  const folders = new Set(posedPairs().map(({ folder }) => folder));
  for (const [way, uncertainty] of CAMERAS) {
    for (const folder of folders) {
      const oriented = orientationsOf(folder, uncertainty);
      const closed = closures(oriented);
      if (closed.length === 0) continue;
      told(`${folder}, ${way}: ${closed.length} loops, not closed by`, closed);
      const pairs = [...oriented.values()].flatMap((of) => [...of.values()]);
      told(`${folder}, ${way}: ${pairs.length} pairs, off the reference by`, pairs);
    }
  }
}

/** Together and about each axis: the base direction hides errors of φ or ω, and nothing those of κ.  @param {string} name @param {Discrepancy[]} found */
function told(name, found) {
  const together = found.map(({ off_deg, errors_deg }) => [Math.hypot(...off_deg), Math.hypot(...errors_deg)]);
  const axes = AXES.map((axis, k) => `${axis} ${figures(found.map(({ off_deg, errors_deg }) => [Math.abs(off_deg[k] ?? NaN), errors_deg[k] ?? NaN]))}`);
  console.log(`  ${name} ${figures(together)}; ${axes.join('; ')}`);
}

const AXES = ['x', 'y', 'z'];

/** @param {number[][]} found each discrepancy with its standard error, in degrees */
function figures(found) {
  const middle = (/** @type {number[]} */ values) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;
  const times = found.map(([off = NaN, error = NaN]) => off / error);
  return `${middle(found.map(([off = NaN]) => off)).toFixed(4)} deg (${middle(times).toFixed(2)} standard errors in the median, ${Math.max(...times).toFixed(2)} at most)`;
}

/** The small rotation from one to another about each axis, in degrees.  @param {number[][]} to @param {number[][]} from @returns {OfAxes} */
function difference(to, from) {
  const m = multiplied(to, transposed(from));
  const at = (/** @type {number} */ row, /** @type {number} */ col) => m[row]?.[col] ?? NaN;
  const twice = [at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)];
  const sine = Math.hypot(...twice) / 2;
  const by = sine > 0 ? rotationError(to, from) / (2 * sine) : 0;
  return /** @type {OfAxes} */ (twice.map((v) => v * by));
}

/**
 * The pairs of a folder that are oriented, by the names of their photographs.
 * @param {string} folder @param {import('../../pkg/node.js').CameraMm['uncertainty']} uncertainty @returns {Map<string, Map<string, Oriented>>}
 */
function orientationsOf(folder, uncertainty) {
  /** @type {Map<string, Map<string, Oriented>>} */
  const oriented = new Map();
  for (const { a, b, truth, pose } of posedPairs().filter((pair) => pair.folder === folder)) {
    const [left, right] = [photoOf(folder, a), photoOf(folder, b)];
    const camera = { ...cameraOf(pinhole(truth, a), left.width, left.height), uncertainty };
    const { orientation } = match_pair(left, right, { camera }, {});
    left.free();
    right.free();
    const errors = orientation?.total_standard_errors;
    if (!orientation || !errors) continue;
    const { rotation } = poseOf(orientation);
    // ω and φ change places where the photo axes are turned by 90°.
    const { omega_deg, phi_deg, kappa_deg } = errors;
    const [x, y] = orientation.turn_deg === 0 ? [omega_deg, phi_deg] : [phi_deg, omega_deg];
    const of = oriented.get(a) ?? new Map();
    oriented.set(a, of.set(b, { rotation, errors_deg: [x, y, kappa_deg], off_deg: difference(rotation, pose.rotation) }));
  }
  return oriented;
}

/** @param {Map<string, Map<string, Oriented>>} oriented @returns {Discrepancy[]} */
function closures(oriented) {
  return [...oriented].flatMap(([, of]) =>
    [...of].flatMap(([b, first]) =>
      [...(oriented.get(b) ?? [])].flatMap(([c, second]) => {
        const third = of.get(c);
        if (!third) return [];
        const off_deg = difference(multiplied(second.rotation, first.rotation), third.rotation);
        const error = (/** @type {0 | 1 | 2} */ k) => Math.hypot(first.errors_deg[k], second.errors_deg[k], third.errors_deg[k]);
        return [{ off_deg, errors_deg: /** @type {OfAxes} */ ([error(0), error(1), error(2)]) }];
      }),
    ),
  );
}
