// @ts-check
/** The first stage: every image is decoded once, and its features are kept. */

import { message, version } from '../wasm/tiepoint.js';
import { BlockError, ownFault } from './errors.js';
import { digest, readFeatures, RECORD_VERSION } from './records.js';
import { runStage } from './stage.js';

/**
 * @typedef {import('./types.js').Source} Source
 * @typedef {import('./types.js').LeftOut} LeftOut
 * @typedef {import('./types.js').Features} Features
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {import('./types.js').ReadImage} ReadImage
 */

/** Where the store keeps the features of an image.  @param {string} key */
const place = (key) => `features/${key}`;

/**
 * A record that the first stage has kept, unread.
 * @param {Surroundings['store']} store @param {string} key @returns {Promise<Uint8Array>}
 */
export async function keptRecord(store, key) {
  const record = await store.get(place(key));
  if (!record) throw new BlockError(CHANGED);
  return record;
}

const CHANGED = 'what was kept of an image was changed while the run went on: start it again';

/**
 * Features that the first stage has kept.
 * @param {Surroundings['store']} store @param {string} key @returns {Promise<Features>}
 */
export async function keptFeatures(store, key) {
  const features = await readFeatures(await keptRecord(store, key), key);
  if (!features) throw new BlockError(CHANGED);
  return features;
}

/**
 * @param {Source[]} sources @param {(Source | null)[]} masks of the sources
 * @param {import('../wasm/tiepoint.js').FeatureOptions} options @param {Surroundings} surroundings
 * @returns {Promise<{ images: ReadImage[], leftOut: LeftOut[] }>} images in the order of their sources
 */
export async function readImages(sources, masks, options, { pool, store, progress, news, signal }) {
  /** @param {Source} source @param {Source | null} ownMask @returns {Promise<{ result: ReadImage | LeftOut, found: boolean }>} */
  const read = async (source, ownMask) => {
    const { name } = source;
    const masked = ownMask !== null;
    /** @type {Uint8Array} */
    let bytes;
    /** @type {import('./types.js').FeatureJob['mask']} */
    let mask = null;
    try {
      bytes = await source.bytes();
      if (ownMask) mask = { name: ownMask.name, bytes: await ownMask.bytes() };
    } catch (error) {
      return { result: { name, reason: error instanceof Error ? error.message : String(error) }, found: false };
    }
    // An image belongs to its content: renamed, it is the same; changed, it is another.
    const content = await digest(bytes);
    const key = await digest(JSON.stringify(['features', RECORD_VERSION, version(), content, ...(mask ? [await digest(mask.bytes)] : []), options]));
    const kept = await readFeatures(await store.get(place(key)), key);
    if (kept) return { result: { name, head: kept.head, count: kept.count, content, masked }, found: true };
    try {
      const record = await pool.run('features', { bytes, key, options, mask });
      await store.put(place(key), record);
      const made = await readFeatures(record, key);
      if (!made) throw new Error('a record of features does not read as it was written');
      return { result: { name, head: made.head, count: made.count, content, masked }, found: false };
    } catch (error) {
      return { result: { name, reason: message('failure', ownFault(error)) }, found: false };
    }
  };
  /** @param {number} index */
  const act = async (index) => {
    const outcome = await read(/** @type {Source} */ (sources[index]), masks[index] ?? null);
    const { result } = outcome;
    news?.('head' in result ? { kind: 'image', index, image: result } : { kind: 'left-out', leftOut: result });
    return outcome;
  };
  const results = await runStage({
    name: 'images', items: [...sources.keys()], width: pool.size + 1, label: (index) => sources[index]?.name ?? '', act, ...(progress && { progress }), ...(signal && { signal }),
  });
  return { images: results.filter((r) => 'head' in r), leftOut: results.filter((r) => 'reason' in r) };
}
