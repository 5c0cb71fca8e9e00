/** A pair by our own features, matching and geometry, as an entry of a result file. */

import { match_descriptors, match_guided_descriptors, two_view } from '../../../pkg/node.js';
import { medianMs } from '../speed.mjs';
import { photoOf } from '../data.mjs';
import { ideal } from './pairs.mjs';

/** @typedef {{ case: string, a: string, b: string, matches: number[][], R: number[][] | null, t: number[] | null, points: number[], seconds: Record<string, number>, note?: string }} Entry */

/** Positions x, y (stride 2) and descriptors of one photo, and the time in ms.  @param {string} name @param {string} file */
function described(name, file) {
  const photo = photoOf(name, file);
  let { points, descriptors } = photo.features({});
  const ms = medianMs(3, () => ({ points, descriptors } = photo.features({})));
  photo.free();
  const positions = Float64Array.from({ length: (points.length / 5) * 2 }, (_, k) => points[5 * (k >> 1) + (k & 1)] ?? NaN);
  return { positions, descriptors, ms };
}

/** Matches as `[x left, y left, x right, y right]`, one after the other.  @param {Float64Array} left @param {Float64Array} right @param {Uint32Array} indices */
function joined(left, right, indices) {
  const matches = new Float64Array(2 * indices.length);
  for (let k = 0; k < indices.length; k += 2) {
    const [i, j] = [2 * (indices[k] ?? 0), 2 * (indices[k + 1] ?? 0)];
    matches.set([left[i] ?? NaN, left[i + 1] ?? NaN, right[j] ?? NaN, right[j + 1] ?? NaN], 2 * k);
  }
  return matches;
}

/**
 * The nearest descriptors, the geometry they agree on, guided matches, and the geometry of these.
 * @param {import('./pairs.mjs').Pair} pair @returns {Entry}
 */
export function ours({ name, a, b, cameras }) {
  const [left, right] = [described(name, a), described(name, b)];
  const nearest = () => match_descriptors(left.descriptors, right.descriptors, {}).indices;
  const [first, matching] = [nearest(), medianMs(3, nearest)];
  const focal = cameras ? Math.sqrt(cameras[0].focal[0] * cameras[1].focal[0]) : 1;
  const [p, q] = cameras ? [ideal(left.positions, cameras[0], focal), ideal(right.positions, cameras[1], focal)] : [left.positions, right.positions];
  const camera = { focal_px: focal, principal_px: /** @type {[number, number]} */ ([0, 0]) };
  const options = cameras ? { left: camera, right: camera } : {};
  const entry = { case: name, a, b, points: [left.positions.length / 2, right.positions.length / 2] };
  const verified = () => {
    const start = two_view(joined(p, q, first), options);
    // Candidates beyond the threshold tell how many wrong ones lie within it.
    const near = { radius_px: 3 * start.threshold_px };
    const indices = match_guided_descriptors(p, left.descriptors, q, right.descriptors, guideOf(start.model), near).indices;
    const found = two_view(joined(p, q, indices), { ...options, threshold_px: start.threshold_px });
    return { indices, found };
  };
  try {
    const { indices, found } = verified();
    const seconds = { features: (left.ms + right.ms) / 1000, matching: matching / 1000, geometry: medianMs(3, verified) / 1000 };
    const all = joined(left.positions, right.positions, indices);
    const matches = [...found.inliers].map((k) => [...all.subarray(4 * k, 4 * k + 4)]);
    const note = [found.model.kind, found.degenerate ?? '', `sigma ${found.sigma_px.toFixed(3)} px`].filter(Boolean).join(', ');
    return { ...entry, matches, ...poseOf(found.model), seconds, note };
  } catch (error) {
    const seconds = { features: (left.ms + right.ms) / 1000, matching: matching / 1000 };
    return { ...entry, matches: [], R: null, t: null, seconds, note: String(/** @type {Error} */ (error).message) };
  }
}

/** @param {import('../../../pkg/node.js').TwoViewModel} model */
function guideOf(model) {
  return 'fundamental' in model ? { fundamental: model.fundamental.flat() } : { homography: model.homography.flat() };
}

/** The pose with x right, y down, z forward, X_b = R X_a + t.  @param {import('../../../pkg/node.js').TwoViewModel} model */
function poseOf(model) {
  if (model.kind !== 'calibrated') return { R: null, t: null };
  const sign = [1, -1, -1];
  const R = model.rotation.map((row, i) => row.map((v, j) => (sign[i] ?? 1) * (sign[j] ?? 1) * v));
  const base = model.base.map((v, i) => (sign[i] ?? 1) * v);
  return { R, t: R.map((row) => -row.reduce((sum, v, j) => sum + v * (base[j] ?? 0), 0)) };
}
