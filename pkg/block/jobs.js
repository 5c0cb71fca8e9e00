// @ts-check
/** What a worker does, of whatever kind it is: jobs by name, on the module that its host has initialised. */

import { undistorted_positions, match_descriptors, match_features, Photo, read_exif } from '../wasm/tiepoint.js';
import { descriptorsOf, readFeatures, writeFeatures, writePair } from './records.js';
import { refine, windows } from './refinement-jobs.js';

/**
 * @typedef {import('./types.js').Jobs} Jobs
 * @typedef {import('./types.js').Features} Features
 * @typedef {import('./types.js').PairJob} PairJob
 * @typedef {import('../wasm/tiepoint.js').PairOutcome} PairOutcome
 */

/** @type {{ [N in keyof Jobs]: (input: Jobs[N]['input']) => Promise<Jobs[N]['output']> }} */
export const jobs = { features, pair, likeness, windows, refine };

/** The image is decoded once, and let go with the job.  @param {Jobs['features']['input']} job */
async function features({ bytes, key, options, mask }) {
  const photo = Photo.decode(bytes);
  try {
    const { width, height, format, bits_per_sample } = photo.info();
    const found = mask ? photo.features(options, maskOf(mask, width, height)) : photo.features(options);
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

/**
 * The grey values of a mask.
 * @param {NonNullable<Jobs['features']['input']['mask']>} mask @param {number} width @param {number} height of its image
 */
function maskOf({ name, bytes }, width, height) {
  const photo = decodedMask(name, bytes);
  try {
    if (photo.width === width && photo.height === height) return photo.grey();
    throw refusal(`its mask ${name} is ${photo.width} x ${photo.height} px; allowed: the image's ${width} x ${height} px`);
  } finally {
    photo.free();
  }
}

/** @param {string} name @param {Uint8Array} bytes */
function decodedMask(name, bytes) {
  try {
    return Photo.decode(bytes);
  } catch (error) {
    throw error instanceof Error && error.name === 'TiepointError' ? refusal(`its mask ${name}: ${error.message}`) : error;
  }
}

/** What is said against an image, as the crate says it.  @param {string} message */
const refusal = (message) => Object.assign(new Error(message), { name: 'TiepointError', code: 'invalid-input', usage: false });

/** @param {PairJob} job */
async function pair(job) {
  const [left, right] = await Promise.all([job.left, job.right].map(({ record, key }) => readFeatures(record, key)));
  if (!left || !right) throw new Error('the features of an image of the pair are damaged');
  const { outcome, geometry, indices, squares } = matched(left, right, job);
  // Where nothing is connected, no match is kept.
  const kept = outcome.kind === 'connected' ? indices : new Uint32Array();
  const strengths = Float32Array.from({ length: kept.length / 2 }, (_, i) => -Math.sqrt(squares[2 * i] ?? 0));
  return await writePair({ key: job.key, outcome, geometry }, kept, strengths);
}

/**
 * @param {Features} left @param {Features} right @param {PairJob} job
 * @returns {{ outcome: PairOutcome, geometry: import('./types.js').PairHead['geometry'], indices: Uint32Array, squares: Uint32Array }}
 */
function matched(left, right, { cameras, nearest, geometry, leastMatches }) {
  const [ofLeft, ofRight] = cameras;
  const sizeOf = (/** @type {Features} */ { head }) => /** @type {[number, number]} */ ([head.width, head.height]);
  const options = { nearest, sizes: /** @type {[[number, number], [number, number]]} */ ([sizeOf(left), sizeOf(right)]), geometry: { ...geometry, left: ofLeft.pinhole, right: ofRight.pinhole } };
  const [a, b] = [usable(left, ofLeft), usable(right, ofRight)];
  const found = match_features(a.positions, a.descriptors, b.positions, b.descriptors, options);
  found.indices.forEach((index, i) => { found.indices[i] = (i % 2 === 0 ? a : b).numbers[index] ?? 0; });
  const matches = found.indices.length / 2;
  const { geometry: views, no_geometry } = found;
  if (no_geometry || !views) return { ...found, geometry: null, outcome: { kind: 'not_oriented', no_geometry: /** @type {import('../wasm/tiepoint.js').NoGeometry} */ (no_geometry) } };
  if (matches < leastMatches) return { ...found, geometry: views, outcome: { kind: 'too_few_matches', matches, needed: leastMatches } };
  return { ...found, geometry: views, outcome: { kind: 'connected', matches } };
}

/**
 * Features by positions freed of what is known of the camera's distortion, with their numbers; without those where it folds the image.
 * @param {Features} features @param {import('./types.js').PairCamera} camera
 */
function usable({ count, positions, descriptors }, { lens }) {
  const measured = Float64Array.from(positions);
  const ideal = lens ? undistorted_positions(lens, measured) : measured;
  const numbers = Uint32Array.from({ length: count }, (_, i) => i).filter((i) => Number.isFinite(ideal[2 * i]));
  if (numbers.length === count) return { numbers, positions: ideal, descriptors };
  const places = new Float64Array(2 * numbers.length);
  numbers.forEach((i, k) => { places.set(ideal.subarray(2 * i, 2 * i + 2), 2 * k); });
  return { numbers, positions: places, descriptors: descriptorsOf(descriptors, numbers) };
}

/** @param {Jobs['likeness']['input']} job */
async function likeness({ own, others }) {
  return Uint32Array.from(others, (other) => match_descriptors(own, other, {}).indices.length / 2);
}
