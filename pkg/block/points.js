// @ts-check
/** The third stage: the matches of all pairs are joined to multi-ray points, and few of them are chosen. */

import { BlockPoints } from '../wasm/tiepoint.js';
import { BlockError } from './errors.js';
import { keptFeatures } from './images.js';
import { keptMatches } from './pairs.js';
import { runStage } from './stage.js';

/**
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {import('./pairs.js').MatchedPair} MatchedPair
 */

/**
 * Positions and matches alone come into memory, one record at a time. The caller frees what it gets.
 * @param {BlockImage[]} images @param {MatchedPair[]} pairs @param {import('../wasm/tiepoint.js').BlockSettings} settings @param {Surroundings} surroundings
 */
export async function joinPoints(images, pairs, settings, { store, progress, signal }) {
  const block = new BlockPoints(Uint32Array.from(images, ({ features }) => features));
  try {
    const connected = pairs.filter(({ outcome }) => outcome.kind === 'connected');
    /** @type {(() => Promise<void>)[]} */
    const items = [
      ...images.map((image, index) => async () => {
        const { positions } = await keptFeatures(store, image.key);
        block.set_image(index, image.width, image.height, positions);
      }),
      ...connected.map(({ images: [a, b], key }) => async () => {
        const matches = await keptMatches(store, key);
        if (!matches) throw new BlockError('what was kept of a pair was changed while the run went on: start it again');
        block.add_pair(a, b, matches.indices, matches.strengths);
      }),
    ];
    await runStage({
      name: 'points', items, width: 1, label: () => '', act: async (item) => ({ result: await item(), found: false }), ...(progress && { progress }), ...(signal && { signal }),
    });
    const join = block.join(settings.block);
    return { block, join, selected: block.select(settings.selection) };
  } catch (error) {
    block.free();
    throw error;
  }
}
