// @ts-check
/** A block from its image files to its tie points: the stages in order, whatever runs their jobs and keeps their records. */

import { block_settings, FinishedBlock, refinement_outcomes } from '../wasm/tiepoint.js';
import { doubtfulCameras, groupCameras, strayRules } from './cameras.js';
import { describeBlock, impossiblePositions } from './description.js';
import { BlockError, refusal } from './errors.js';
import { readImages } from './images.js';
import { masksOf } from './masks.js';
import { matchPairs } from './pairs.js';
import { pairsOf } from './pairing.js';
import { joinPoints } from './points.js';
import { refineRays } from './refinement.js';
import { runStage } from './stage.js';

/**
 * @typedef {import('./types.js').Source} Source
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').BlockRun} BlockRun
 */

/**
 * Runs a block. What an earlier run with the same images and settings has kept in the store is not done again; the result is the same, for
 * any number of workers. An image that cannot be read is left out, and told.
 * @param {readonly Source[]} sources in the order in which they follow each other; no two have the same name
 * @param {import('./types.js').RunOptions} options @param {import('./types.js').Surroundings} surroundings @returns {Promise<BlockRun>}
 */
export async function runBlock(sources, options, surroundings) {
  const settings = block_settings(options.settings ?? {});
  const useGps = options.gps !== 'ignore';
  const given = checked(sources);
  const { masks, strays } = masksOf(given, options.masks ?? []);
  const idle = strayRules(given.map(({ name }) => name), options.cameras?.text);
  const { images: read, leftOut } = await readImages(given, masks, settings.features, surroundings);
  if (read.length < 2) throw new BlockError(`a block needs two images or more; ${read.length} of ${sources.length} could be read${firstReason(leftOut)}`);
  const { cameras, of } = groupCameras(read, options.cameras?.text);
  const images = read.map(({ name, head, count, content, masked }, index) => (
    { name, key: head.key, content, width: head.width, height: head.height, features: count, masked, exif: head.exif, camera: of[index] ?? 0 }
  ));
  const remarks = [...idle.map((images) => ({ kind: 'unused_camera', images })), ...doubtfulCameras(cameras), ...(useGps ? impossiblePositions(images) : [])];
  const { description, strayMarks } = describeBlock(images, cameras, useGps, settings.placing, options.control);
  const chosen = await pairsOf(images, settings.pairs, useGps, surroundings);
  const pairs = await matchPairs(chosen, images, cameras, settings, surroundings);
  const { block: joined, join, selected: first } = await joinPoints(images, pairs, settings, surroundings);
  /** What is oriented: all points, or those whose rays were refined.  @type {import('../wasm/tiepoint.js').BlockPoints} */
  let block = joined;
  try {
    const refined = await refineRays(joined, images, given, settings, surroundings);
    if (refined) block = refined.block;
    const selected = refined ? block.select(settings.selection) : first;
    const [{ oriented }] = /** @type {[{ oriented: Oriented }]} */ (await runStage({
      name: 'orientation', items: [null], width: 1, label: () => '',
      act: async () => ({ result: { oriented: orientation(block, description, settings.selection) }, found: false }),
      ...(surroundings.progress && { progress: surroundings.progress }), ...(surroundings.signal && { signal: surroundings.signal }),
    }));
    const model = oriented.model ?? block.model(description, selected.points);
    const connections = pairs.map(({ images: [a, b], rule, outcome }) => ({ images: /** @type {[number, number]} */ ([a, b]), rule, outcome }));
    const run = {
      settings, images, leftOut, strayMasks: strays, strayMarks, remarks, cameras, connections,
      geometries: pairs.map(({ geometry }) => geometry),
      points: { join, count: joined.count, rays: joined.ray_count, histogram: Array.from(joined.ray_histogram()), shared: Array.from(joined.shared()) },
      refinement: refined?.refinement ?? null,
      reconstruction: oriented.reconstruction, reconstructionReason: oriented.reason,
      model,
    };
    return { ...run, finished: finish(run, options) };
  } finally {
    if (block !== joined) block.free();
    joined.free();
  }
}

/**
 * The block as the crate holds it.
 * @param {Omit<BlockRun, 'finished'>} run @param {import('./types.js').RunOptions} options
 */
function finish({ settings, images, leftOut, strayMasks, strayMarks, remarks, cameras, connections, geometries, points, refinement, reconstruction, reconstructionReason, model }, { cameras: text, gps, control, masks }) {
  const refused = (/** @type {string | null} */ message) => ({ kind: 'refused', code: '', message: message ?? '', usage: false });
  /** @type {import('../wasm/tiepoint.js').SharedPoints[]} */
  const shared = [];
  for (let i = 0; i < points.shared.length; i += 3) shared.push({ images: [points.shared[i] ?? 0, points.shared[i + 1] ?? 0], points: points.shared[i + 2] ?? 0 });
  return new FinishedBlock({
    input: { images: images.map(({ name }) => name), masks: (masks ?? []).map(({ name }) => name), settings, cameras: text?.text ?? null, use_gnss: gps !== 'ignore', control: control ?? null },
    connections, cameras, remarks, model, geometries,
    images: images.map(({ width, height, ...image }) => ({ ...image, width_px: width, height_px: height })),
    skipped: leftOut.map(({ name, reason }) => ({ name, reason: refused(reason) })),
    unused_masks: strayMasks, unknown_images: strayMarks,
    points: { ...points, shared },
    refinement: refinement && refinementOf(refinement),
    reconstruction: reconstruction ? { Ok: reconstruction } : { Err: refused(reconstructionReason) },
  });
}

/** @param {import('./types.js').Refinement} refinement */
function refinementOf({ starts, images, positions, outcomes, precision }) {
  const names = refinement_outcomes();
  const known = (/** @type {number | undefined} */ value) => (value === undefined || Number.isNaN(value) ? null : value);
  return {
    starts: [...starts],
    observations: Array.from(images, (image, i) => ({
      image, position_px: [...positions.subarray(2 * i, 2 * i + 2)], outcome: names[outcomes[i] ?? 0],
      standard_error_px: known(precision[2 * i]), correlation: known(precision[2 * i + 1]),
    })),
  };
}

/**
 * A block whose images cannot be oriented keeps its points all the same.
 * @typedef {{ reconstruction: BlockRun['reconstruction'], model: BlockRun['model'] | null, reason: string | null }} Oriented
 * @param {import('../wasm/tiepoint.js').BlockPoints} block @param {import('../wasm/tiepoint.js').BlockDescription} description
 * @param {import('../wasm/tiepoint.js').SelectOptions} selection @returns {Oriented}
 */
function orientation(block, description, selection) {
  try {
    return { ...block.reconstruct(description, { selection }), reason: null };
  } catch (error) {
    return { reconstruction: null, model: null, reason: refusal(error) };
  }
}

/** @param {readonly Source[]} sources @returns {Source[]} */
function checked(sources) {
  const names = new Set();
  for (const { name } of sources) {
    if (names.has(name)) throw new BlockError(`two images have the name ${name}; allowed: each name once`);
    // Tables and texts have a line for each image.
    if (/\p{Cc}/u.test(name)) throw new BlockError(`the image name ${JSON.stringify(name)} holds a control character; allowed: names without them`);
    names.add(name);
  }
  return [...sources];
}

/** @param {import('./types.js').LeftOut[]} leftOut */
const firstReason = ([first]) => (first ? ` (${first.name}: ${first.reason})` : '');
