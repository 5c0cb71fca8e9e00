// @ts-check
/** Which pairs of images are tried: by their positions, their order, or how alike they are. */

import { choose_pairs, local_positions, pair_rule, version } from '../wasm/tiepoint.js';
import { ownFault } from './errors.js';
import { keptFeatures } from './images.js';
import { descriptorsOf, digest, readLikeness, RECORD_VERSION, writeLikeness } from './records.js';
import { runStage, throwIfAborted } from './stage.js';

/**
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {import('../wasm/tiepoint.js').PairChoice} PairChoice
 * @typedef {import('../wasm/tiepoint.js').ChosenPair} ChosenPair
 */

/** How many features of the largest scales tell whether images are alike. */
const COARSE = 256;

/**
 * @param {BlockImage[]} images @param {PairChoice} choice @param {boolean} useGps @param {Surroundings} surroundings
 * @returns {Promise<ChosenPair[]>}
 */
export async function pairsOf(images, choice, useGps, surroundings) {
  const positions = local_positions(Float64Array.from(images.flatMap(({ exif }) => (useGps && exif.position ? placeOf(exif.position) : [NaN, NaN, NaN]))));
  const similar = pair_rule(positions, choice) === 'alike' ? await likenesses(images, surroundings) : new Float64Array();
  return choose_pairs(positions, similar, choice);
}

/** @param {import('../wasm/tiepoint.js').ExifPosition} position */
const placeOf = ({ longitude_deg, latitude_deg, height_m }) => [longitude_deg, latitude_deg, height_m ?? 0];

/**
 * How many coarse features each two images have in common.
 * @param {BlockImage[]} images @param {Surroundings} surroundings @returns {Promise<Float64Array>} both images and the number; stride 3
 */
async function likenesses(images, { pool, store, progress, signal }) {
  /** @type {Uint8Array[]} */
  const coarse = [];
  for (const { key } of images) {
    throwIfAborted(signal);
    coarse.push(await coarseOf(store, key));
  }
  const items = images.slice(0, -1).map(({ name }, index) => ({ name, index }));
  /** @param {{ index: number }} item */
  const act = async ({ index }) => {
    const key = await digest(JSON.stringify(['likeness', RECORD_VERSION, version(), COARSE, ...images.slice(index).map((image) => image.key)]));
    const kept = await readLikeness(await store.get(`likeness/${key}`), key);
    if (kept) return { result: kept, found: true };
    try {
      const result = await pool.run('likeness', { own: coarse[index] ?? new Uint8Array(), others: coarse.slice(index + 1) });
      await store.put(`likeness/${key}`, await writeLikeness({ key }, result));
      return { result, found: false };
    } catch (error) {
      // Not known to be like any other: its pairs are left to those.
      ownFault(error);
      return { result: new Uint32Array(images.length - index - 1), found: false };
    }
  };
  const counts = await runStage({
    name: 'likeness', items, width: pool.size + 1, label: ({ name }) => name, act, ...(progress && { progress }), ...(signal && { signal }),
  });
  return Float64Array.from(counts.flatMap((list, a) => Array.from(list, (count, k) => [a, a + 1 + k, count]).flat()));
}

/** The descriptors of an image's features of the largest scales.  @param {Surroundings['store']} store @param {string} key */
async function coarseOf(store, key) {
  const { count, shapes, descriptors } = await keptFeatures(store, key);
  const scale = (/** @type {number} */ i) => shapes[3 * i] ?? 0;
  const order = Array.from({ length: count }, (_, i) => i).sort((a, b) => scale(b) - scale(a) || a - b).slice(0, COARSE);
  return descriptorsOf(descriptors, order);
}
