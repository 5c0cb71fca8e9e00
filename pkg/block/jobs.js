// @ts-check
/** What a worker does, of whatever kind it is: jobs by name, on the module that its host has initialised. */

import { match_descriptors, match_guided_descriptors, Photo, read_exif, two_view } from '../wasm/tiepoint.js';
import { readFeatures, writeFeatures, writePair } from './records.js';

/**
 * @typedef {import('./types.js').Jobs} Jobs
 * @typedef {import('./types.js').Features} Features
 * @typedef {import('./types.js').PairJob} PairJob
 * @typedef {import('../wasm/tiepoint.js').PairOutcome} PairOutcome
 */

/** @type {{ [N in keyof Jobs]: (input: Jobs[N]['input']) => Promise<Jobs[N]['output']> }} */
export const jobs = { features, pair, likeness };

/** The image is decoded once, and let go with the job.  @param {Jobs['features']['input']} job */
async function features({ bytes, key, options }) {
  const photo = Photo.decode(bytes);
  try {
    const { width, height, format, bits_per_sample } = photo.info();
    const found = photo.features(options);
    const count = found.points.length / 5;
    const positions = new Float32Array(2 * count);
    const shapes = new Float32Array(3 * count);
    for (let i = 0; i < count; i++) {
      positions.set(found.points.subarray(5 * i, 5 * i + 2), 2 * i);
      shapes.set(found.points.subarray(5 * i + 2, 5 * i + 5), 3 * i);
    }
    const head = { key, width, height, format, bits_per_sample, exif: read_exif(bytes, width, height) };
    return await writeFeatures(head, positions, shapes, found.descriptors);
  } finally {
    photo.free();
  }
}

/** @param {PairJob} job */
async function pair(job) {
  const [left, right] = await Promise.all([job.left, job.right].map(({ record, key }) => readFeatures(record, key)));
  if (!left || !right) throw new Error('the features of an image of the pair are damaged');
  const { outcome, geometry, indices, squares } = matchFeatures(left, right, job);
  // Where nothing is connected, no match is kept.
  const kept = outcome.kind === 'connected' ? indices : new Uint32Array();
  const strengths = Float32Array.from({ length: kept.length / 2 }, (_, i) => -Math.sqrt(squares[2 * i] ?? 0));
  return await writePair({ key: job.key, outcome, geometry }, kept, strengths);
}

/**
 * @typedef {{ outcome: PairOutcome, geometry: import('./types.js').PairHead['geometry'], indices: Uint32Array, squares: Uint32Array }} Matched
 * @param {Features} left @param {Features} right @param {PairJob} job @returns {Matched}
 */
function matchFeatures(left, right, { cameras, nearest, geometry, leastMatches }) {
  const none = { geometry: null, indices: new Uint32Array(), squares: new Uint32Array() };
  const first = match_descriptors(left.descriptors, right.descriptors, nearest);
  const matches = first.indices.length / 2;
  if (matches < leastMatches) return { ...none, outcome: { kind: 'too_few_matches', matches, needed: leastMatches } };
  const options = { ...geometry, left: cameras[0], right: cameras[1] };
  const positions = [left, right].map(({ positions }) => Float64Array.from(positions));
  const [of_left = new Float64Array(), of_right = new Float64Array()] = positions;
  try {
    const start = two_view(both(of_left, of_right, first.indices), options);
    const { model } = start;
    const guide = 'homography' in model ? { homography: model.homography.flat() } : { fundamental: model.fundamental.flat() };
    const second = match_guided_descriptors(of_left, left.descriptors, of_right, right.descriptors, guide, { radius_px: 2 * start.threshold_px });
    const better = two_view(both(of_left, of_right, second.indices), options);
    const [{ inliers, ...found }, all] = better.inliers.length >= start.inliers.length ? [better, second] : [start, first];
    const rows = (/** @type {Uint32Array} */ flat) => Uint32Array.from({ length: 2 * inliers.length }, (_, i) => flat[2 * (inliers[i >> 1] ?? 0) + (i & 1)] ?? 0);
    const [indices, squares] = [rows(all.indices), rows(all.squares)];
    if (inliers.length < leastMatches) return { ...none, outcome: { kind: 'too_few_matches', matches: inliers.length, needed: leastMatches } };
    return { outcome: { kind: 'connected', matches: inliers.length }, geometry: found, indices, squares };
  } catch (error) {
    // Data of no common geometry; a bad call goes on to the caller.
    if (!(error instanceof Error) || error.name !== 'TiepointError' || /** @type {any} */ (error).usage) throw error;
    return { ...none, outcome: { kind: 'not_oriented', matches, reason: error.message } };
  }
}

/** @param {Float64Array} left @param {Float64Array} right @param {Uint32Array} indices @returns {Float64Array} x, y left, x, y right; stride 4 */
function both(left, right, indices) {
  const flat = new Float64Array(2 * indices.length);
  for (let i = 0; i < indices.length / 2; i++) {
    const [a, b] = [2 * (indices[2 * i] ?? 0), 2 * (indices[2 * i + 1] ?? 0)];
    flat.set(left.subarray(a, a + 2), 4 * i);
    flat.set(right.subarray(b, b + 2), 4 * i + 2);
  }
  return flat;
}

/** @param {Jobs['likeness']['input']} job */
async function likeness({ own, others }) {
  return Uint32Array.from(others, (other) => match_descriptors(own, other, {}).indices.length / 2);
}
