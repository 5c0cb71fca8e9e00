// @ts-check
/** The second stage: every chosen pair is matched once, and its verified matches are kept. */

import { version } from '../wasm/tiepoint.js';
import { pairCameras } from './cameras.js';
import { ownFault } from './errors.js';
import { keptRecord } from './images.js';
import { digest, readPair, RECORD_VERSION } from './records.js';
import { runStage } from './stage.js';

/**
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').GroupedCamera} GroupedCamera
 * @typedef {import('./types.js').PairHead} PairHead
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {import('../wasm/tiepoint.js').BlockSettings} BlockSettings
 * @typedef {import('../wasm/tiepoint.js').ChosenPair} ChosenPair
 * @typedef {{ images: [number, number], rule: ChosenPair['rule'], key: string, outcome: PairHead['outcome'], geometry: PairHead['geometry'] }} MatchedPair
 */

/** @param {string} key */
const place = (key) => `pairs/${key}`;

/**
 * The matches of a pair that was connected, as they were kept.
 * @param {Surroundings['store']} store @param {string} key
 */
export async function keptMatches(store, key) {
  return readPair(await store.get(place(key)), key);
}

/**
 * @param {ChosenPair[]} chosen @param {BlockImage[]} images @param {GroupedCamera[]} cameras @param {BlockSettings} settings
 * @param {Surroundings} surroundings @returns {Promise<MatchedPair[]>} in the order of the chosen ones
 */
export async function matchPairs(chosen, images, cameras, settings, { pool, store, progress, news, signal }) {
  const { nearest, geometry, pairs: { least_matches: leastMatches } } = settings;
  /** @param {ChosenPair} pair @returns {[BlockImage, BlockImage]} */
  const both = ({ images: [a, b] }) => [/** @type {BlockImage} */ (images[a]), /** @type {BlockImage} */ (images[b])];
  const camera = (/** @type {BlockImage} */ image) => /** @type {GroupedCamera} */ (cameras[image.camera]);
  /** @param {ChosenPair} pair @returns {Promise<{ result: MatchedPair, found: boolean }>} */
  const match = async (pair) => {
    const [left, right] = both(pair);
    const known = pairCameras(camera(left), camera(right));
    const key = await digest(JSON.stringify(['pair', RECORD_VERSION, version(), left.key, right.key, known, nearest, geometry, leastMatches]));
    const result = { ...pair, key };
    const kept = await keptMatches(store, key);
    if (kept) return { result: { ...result, outcome: kept.head.outcome, geometry: kept.head.geometry }, found: true };
    const [a, b] = await Promise.all([keptRecord(store, left.key), keptRecord(store, right.key)]);
    try {
      const job = { key, left: { record: a, key: left.key }, right: { record: b, key: right.key }, cameras: known, nearest, geometry, leastMatches };
      const record = await pool.run('pair', job);
      await store.put(place(key), record);
      const made = await readPair(record, key);
      if (!made) throw new Error('a record of a pair does not read as it was written');
      return { result: { ...result, outcome: made.head.outcome, geometry: made.head.geometry }, found: false };
    } catch (error) {
      return { result: { ...result, outcome: { kind: 'failed', failure: ownFault(error) }, geometry: null }, found: false };
    }
  };
  /** @param {ChosenPair} pair */
  const act = async (pair) => {
    const outcome = await match(pair);
    const { images: of, rule, outcome: kind, geometry: views } = outcome.result;
    news?.({ kind: 'pair', connection: { images: of, rule, outcome: kind }, geometry: views });
    return outcome;
  };
  return runStage({
    name: 'pairs', items: chosen, width: pool.size + 1, label: (pair) => both(pair).map(({ name }) => name).join(' – '), act,
    ...(progress && { progress }), ...(signal && { signal }),
  });
}
