/** A pair by our own features, matching and geometry, as an entry of a result file. */

import { match_descriptors, match_features, message } from '../../../pkg/node.js';
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
 * Features matched and verified, as the strategy of a pair and of blocks does it.
 * @param {import('./pairs.mjs').Pair} pair @returns {Entry}
 */
export function ours({ name, a, b, cameras }) {
  const [left, right] = [described(name, a), described(name, b)];
  const matching = medianMs(3, () => match_descriptors(left.descriptors, right.descriptors, {}));
  const focal = cameras ? Math.sqrt(cameras[0].focal[0] * cameras[1].focal[0]) : 1;
  const [p, q] = cameras ? [ideal(left.positions, cameras[0], focal), ideal(right.positions, cameras[1], focal)] : [left.positions, right.positions];
  const camera = { focal_px: focal, principal_px: /** @type {[number, number]} */ ([0, 0]) };
  const geometry = cameras ? { left: camera, right: camera } : {};
  const verified = () => match_features(p, left.descriptors, q, right.descriptors, { geometry });
  const found = verified();
  const seconds = { features: (left.ms + right.ms) / 1000, matching: matching / 1000, geometry: (medianMs(3, verified) - matching) / 1000 };
  const entry = { case: name, a, b, points: [left.positions.length / 2, right.positions.length / 2], seconds };
  if (!found.geometry) return { ...entry, matches: [], R: null, t: null, note: found.no_geometry ? message('no_geometry', found.no_geometry) : '' };
  const all = joined(left.positions, right.positions, found.indices);
  const matches = Array.from({ length: found.indices.length / 2 }, (_, k) => [...all.subarray(4 * k, 4 * k + 4)]);
  const note = [found.geometry.model.kind, found.geometry.degenerate ?? '', `sigma ${found.geometry.sigma_px.toFixed(3)} px`].filter(Boolean).join(', ');
  return { ...entry, matches, ...poseOf(found.geometry.model), note };
}

/** The pose with x right, y down, z forward, X_b = R X_a + t.  @param {import('../../../pkg/node.js').TwoViewModel} model */
function poseOf(model) {
  if (model.kind !== 'calibrated') return { R: null, t: null };
  const sign = [1, -1, -1];
  const R = model.rotation.map((row, i) => row.map((v, j) => (sign[i] ?? 1) * (sign[j] ?? 1) * v));
  const base = model.base.map((v, i) => (sign[i] ?? 1) * v);
  return { R, t: R.map((row) => -row.reduce((sum, v, j) => sum + v * (base[j] ?? 0), 0)) };
}
