// @ts-check
/**
 * The stages between the points and their orientation: windows around the rays of many points are kept of each image, and the rays of each
 * point are matched by least squares to its reference ray.
 */

import { refinement_outcomes, version } from '../wasm/tiepoint.js';
import { BlockError } from './errors.js';
import { keptFeatures } from './images.js';
import { digest, readWindows, RECORD_VERSION } from './records.js';
import { runStage } from './stage.js';

/**
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {import('./types.js').Windows} Windows
 * @typedef {import('./types.js').Refinement} Refinement
 * @typedef {import('../wasm/tiepoint.js').BlockPoints} BlockPoints
 * @typedef {import('../wasm/tiepoint.js').BlockSettings} BlockSettings
 * @typedef {{ starts: Uint32Array, image: Uint32Array, feature: Uint32Array, shape: Float32Array }} ChosenRays rays in the order of the points; shape: x, y and scale in px, direction in rad, stride 4
 */

/** @param {string} key */
const place = (key) => `windows/${key}`;

/** Windows of so many images are in memory for points that follow each other. */
const IMAGES_AT_HAND = 32;

/**
 * Gives the points whose rays were refined as a block of their own, which the caller frees; null where none are to be.
 * @param {BlockPoints} block @param {BlockImage[]} images @param {readonly import('./types.js').Source[]} sources @param {BlockSettings} settings
 * @param {Surroundings} surroundings @returns {Promise<{ block: BlockPoints, refinement: Refinement } | null>}
 */
export async function refineRays(block, images, sources, { selection, refinement: options }, surroundings) {
  if (options.method === 'none') return null;
  // Rays that are oriented together are of one kind: the block goes on with these points alone, of which the final ones are chosen.
  const chosen = block.select({ ...selection, per_image: Math.max(selection.per_image ?? 0, options.per_image ?? 0) }).points;
  const rays = raysOf(block, chosen);
  const keys = await keepWindows(rays, images, sources, options, surroundings);
  const found = await matchRays(rays, images.length, keys, options, surroundings);
  return { block: block.moved(chosen, found.positions), refinement: found };
}

/** @param {BlockPoints} block @param {Uint32Array} chosen @returns {ChosenRays} */
function raysOf(block, chosen) {
  const table = block.table();
  const starts = new Uint32Array(chosen.length + 1);
  chosen.forEach((point, i) => { starts[i + 1] = at(starts, i) + at(table.starts, point + 1) - at(table.starts, point); });
  const count = at(starts, chosen.length);
  const rays = { starts, image: new Uint32Array(count), feature: new Uint32Array(count), shape: new Float32Array(4 * count) };
  chosen.forEach((point, i) => {
    for (let from = at(table.starts, point), to = at(starts, i); to < at(starts, i + 1); from++, to++) {
      rays.image[to] = at(table.rays, 2 * from);
      rays.feature[to] = at(table.rays, 2 * from + 1);
    }
  });
  return rays;
}

/**
 * Keeps the windows of each image that has rays, and fills in the rays' shapes; gives the key of each record, null for images without rays.
 * @param {ChosenRays} rays @param {BlockImage[]} images @param {readonly import('./types.js').Source[]} sources
 * @param {BlockSettings['refinement']} options @param {Surroundings} surroundings
 * @returns {Promise<(string | null)[]>}
 */
async function keepWindows(rays, images, sources, options, { pool, store, progress, signal }) {
  const own = raysByImage(rays.image, images.length);
  const named = new Map(sources.map((source) => [source.name, source]));
  /** @param {number} index @returns {Promise<{ result: string | null, found: boolean }>} */
  const act = async (index) => {
    const image = /** @type {BlockImage} */ (images[index]);
    const mine = /** @type {number[]} */ (own[index]);
    if (mine.length === 0) return { result: null, found: false };
    const { positions, shapes } = await keptFeatures(store, image.key);
    const wanted = new Float64Array(3 * mine.length);
    mine.forEach((ray, i) => {
      const feature = at(rays.feature, ray);
      const [x, y, scale, direction] = [at(positions, 2 * feature), at(positions, 2 * feature + 1), at(shapes, 3 * feature), at(shapes, 3 * feature + 1)];
      rays.shape.set([x, y, scale, direction], 4 * ray);
      wanted.set([x, y, scale], 3 * i);
    });
    const key = await digest(JSON.stringify(['windows', RECORD_VERSION, version(), image.key, await digest(new Uint8Array(wanted.buffer)), options.window]));
    if (await readWindows(await store.get(place(key)), key)) return { result: key, found: true };
    const bytes = await readAgain(/** @type {import('./types.js').Source} */ (named.get(image.name)));
    if (await digest(bytes) !== image.content) throw new BlockError(`${image.name} was changed while the run went on: start it again`);
    const record = await pool.run('windows', { bytes, key, rays: wanted, options });
    await store.put(place(key), record);
    return { result: key, found: false };
  };
  return runStage({
    name: 'windows', items: images.map((_, index) => index), width: pool.size + 1, label: (index) => images[index]?.name ?? '', act,
    ...(progress && { progress }), ...(signal && { signal }),
  });
}

/** @param {import('./types.js').Source} source */
async function readAgain(source) {
  try {
    return await source.bytes();
  } catch (error) {
    throw new BlockError(`${source.name} can no longer be read, which its rays are refined by: ${error instanceof Error ? error.message : String(error)}`);
  }
}

/** @param {Uint32Array} image @param {number} images @returns {number[][]} */
function raysByImage(image, images) {
  /** @type {number[][]} */
  const own = Array.from({ length: images }, () => []);
  image.forEach((index, ray) => void own[index]?.push(ray));
  return own;
}

/**
 * Refines the points that begin in the same image together, in one job.
 * @param {ChosenRays} rays @param {number} images @param {(string | null)[]} keys @param {BlockSettings['refinement']} options @param {Surroundings} surroundings
 * @returns {Promise<Refinement>}
 */
async function matchRays(rays, images, keys, options, { pool, store, progress, signal }) {
  const count = rays.image.length;
  const places = rankInImage(rays.image, images);
  const records = new RecordsAtHand(store, keys);
  const found = { points: rays.starts.length - 1, starts: rays.starts, images: rays.image, positions: new Float32Array(2 * count), outcomes: new Uint8Array(count), precision: new Float32Array(2 * count) };
  /** @param {{ first: number, end: number }} group points */
  const act = async ({ first, end }) => {
    const [from, to] = [at(rays.starts, first), at(rays.starts, end)];
    const { places: own, grey } = await gathered(from, to, rays.image, places, records);
    const starts = rays.starts.slice(first, end + 1).map((start) => start - from);
    const refined = await pool.run('refine', { starts, rays: Float64Array.from(rays.shape.subarray(4 * from, 4 * to)), places: own, grey, options }, [grey.buffer]);
    for (let ray = from; ray < to; ray++) {
      const [code = 0, x = 0, y = 0, error = NaN, correlation = NaN] = refined.subarray(5 * (ray - from), 5 * (ray - from) + 5);
      found.outcomes[ray] = code;
      found.positions.set([x, y], 2 * ray);
      found.precision.set([error, correlation], 2 * ray);
    }
    return { result: null, found: false };
  };
  await runStage({
    name: 'refinement', items: groupsOf(rays), width: pool.size + 1, label: () => '', act, ...(progress && { progress }), ...(signal && { signal }),
  });
  const outcomes = refinement_outcomes();
  const numbers = found.outcomes.reduce((sums, code) => { sums[code] = (sums[code] ?? 0) + 1; return sums; }, outcomes.map(() => 0));
  const counts = /** @type {Refinement['counts']} */ (Object.fromEntries(outcomes.map((outcome, code) => [outcome, numbers[code] ?? 0])));
  return { ...found, counts };
}

/** Points that follow each other and have their first ray in the same image.  @param {ChosenRays} rays @returns {{ first: number, end: number }[]} */
function groupsOf({ starts, image }) {
  /** @type {{ first: number, end: number }[]} */
  const groups = [];
  for (let point = 0; point + 1 < starts.length; point++) {
    const last = groups.at(-1);
    if (last && image[at(starts, last.first)] === image[at(starts, point)]) last.end = point + 1;
    else groups.push({ first: point, end: point + 1 });
  }
  return groups;
}

/** The place of each ray among those of its image.  @param {Uint32Array} image @param {number} images */
function rankInImage(image, images) {
  const counts = new Uint32Array(images);
  return image.map((index) => { const rank = at(counts, index); counts[index] = rank + 1; return rank; });
}

/**
 * The windows of some rays in one piece, the rays counted from the first of them.
 * @param {number} from @param {number} to @param {Uint32Array} image @param {Uint32Array} ranks @param {RecordsAtHand} records
 */
async function gathered(from, to, image, ranks, records) {
  /** @type {{ place: number[], grey: Uint8Array }[]} */
  const parts = [];
  for (let ray = from; ray < to; ray++) {
    const { windows, firsts } = await records.of(at(image, ray));
    const rank = at(ranks, ray);
    const area = windows.head.side ** 2;
    for (let window = at(firsts, rank); window < at(firsts, rank + 1); window++) {
      const [, halvings = 0, col = 0, row = 0] = windows.places.subarray(4 * window, 4 * window + 4);
      parts.push({ place: [ray - from, halvings, col, row], grey: windows.grey.subarray(window * area, (window + 1) * area) });
    }
  }
  const places = new Uint32Array(4 * parts.length);
  const grey = new Uint8Array(parts.reduce((sum, part) => sum + part.grey.length, 0));
  let end = 0;
  parts.forEach((part, i) => {
    places.set(part.place, 4 * i);
    grey.set(part.grey, end);
    end += part.grey.length;
  });
  return { places, grey };
}

/** Records of windows, read when they are needed, some of which stay in memory. */
class RecordsAtHand {
  /** @type {Map<number, Promise<{ windows: Windows, firsts: Uint32Array }>>} */
  #read = new Map();
  #store;
  #keys;

  /** @param {Surroundings['store']} store @param {(string | null)[]} keys */
  constructor(store, keys) {
    this.#store = store;
    this.#keys = keys;
  }

  /** The windows of an image; those of its ray i are from `firsts[i]` to before `firsts[i + 1]`.  @param {number} image */
  of(image) {
    const known = this.#read.get(image) ?? this.#fetch(this.#keys[image] ?? '');
    // What was needed last goes last.
    this.#read.delete(image);
    this.#read.set(image, known);
    for (const oldest of this.#read.keys()) {
      if (this.#read.size <= IMAGES_AT_HAND) break;
      this.#read.delete(oldest);
    }
    return known;
  }

  /** @param {string} key */
  async #fetch(key) {
    const windows = await readWindows(await this.#store.get(place(key)), key);
    if (!windows) throw new BlockError('what was kept of an image was changed while the run went on: start it again');
    const last = windows.count > 0 ? at(windows.places, 4 * (windows.count - 1)) : -1;
    const firsts = new Uint32Array(last + 2);
    // Windows stand in the order of their rays: the numbers of windows of rays, summed up.
    for (let window = 0; window < windows.count; window++) {
      const next = at(windows.places, 4 * window) + 1;
      firsts[next] = at(firsts, next) + 1;
    }
    for (let ray = 0; ray <= last; ray++) firsts[ray + 1] = at(firsts, ray) + at(firsts, ray + 1);
    return { windows, firsts };
  }
}

/** @param {Uint32Array | Float32Array} array @param {number} index @returns {number} */
const at = (array, index) => array[index] ?? 0;
