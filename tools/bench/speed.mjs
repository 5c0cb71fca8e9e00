/** How fast the wasm module is in Node: one thread, warm, medians. */

import { constant_offset, defaults, estimate_offset, match_pair, match_photos, match_points, orient_relative, Photo, simulate } from '../../pkg/node.js';
import { cameraOf, settingsWith } from './accuracy.mjs';
import { bytesOf, have, photoOf, pinhole, posedPairs, simulated } from './data.mjs';
import { dice } from './dice.mjs';

/**
 * The median time of an action in ms after a warm-up.
 * @param {number} runs @param {() => unknown} action
 */
export function medianMs(runs, action) {
  for (let i = 0; i < Math.max(3, runs / 5); i++) action();
  const times = Array.from({ length: runs }, () => {
    const start = performance.now();
    action();
    return performance.now() - start;
  }).sort((a, b) => a - b);
  return times[Math.floor(runs / 2)] ?? NaN;
}

/** @param {string} what @param {number} ms */
const tell = (what, ms) => console.log(`  ${what}: ${ms.toFixed(1)} ms`);

export function speed() {
  console.log('Speed (wasm in Node, one thread, warm, medians)');
  if (have('simulated-a')) {
    const { left, right } = simulated();
    pair('simulated-a', left, right);
    windows('simulated-a', left, right);
  }
  const made = simulate({});
  pair('sample', .../** @type {[Photo, Photo]} */ ([made.left, made.right].map((p) => Photo.from_grey(p.width, p.height, p.grey))));
  if (have('pair_full_caliterra')) large();
  refinement();
}

/** Pairs of a folder whose time is taken. */
const OF_FOLDER = 3;

/** What refining and filling in by least squares adds to matching by gradients. */
function refinement() {
  /** @type {number[]} */
  const ratios = [];
  /** @type {Map<string, number>} */
  const taken = new Map();
  for (const { folder, a, b, truth } of posedPairs()) {
    taken.set(folder, (taken.get(folder) ?? 0) + 1);
    if ((taken.get(folder) ?? 0) > OF_FOLDER) continue;
    const photos = { left: photoOf(folder, a), right: photoOf(folder, b) };
    const input = { camera: cameraOf(pinhole(truth, a), photos.left.width, photos.left.height) };
    const seconds = (/** @type {import('../../pkg/node.js').Strategy} */ strategy) => {
      const settings = defaults();
      settings.matching.strategy = strategy;
      const start = process.cpuUsage().user;
      match_pair(photos.left, photos.right, input, settings);
      return (process.cpuUsage().user - start) / 1e6;
    };
    const times = [0, 1, 2].map(() => [seconds('gradient'), seconds('auto')]);
    const [gradient = NaN, auto = NaN] = [0, 1].map((which) => Math.min(...times.map((time) => time[which] ?? NaN)));
    console.log(`  ${folder} ${a} ${b}: gradient ${gradient.toFixed(2)} s, auto ${auto.toFixed(2)} s, ${(auto / gradient).toFixed(2)} times`);
    ratios.push(auto / gradient);
    photos.left.free();
    photos.right.free();
  }
  ratios.sort((one, other) => one - other);
  console.log(
    `  auto by gradient, processor time, ${ratios.length} pairs: median ${ratios[ratios.length >> 1]?.toFixed(2)}, at most ${ratios.at(-1)?.toFixed(2)}`,
  );
}

/** Both images from operator to matches, by stage and in all.  @param {string} name @param {Photo} left @param {Photo} right */
function pair(name, left, right) {
  const settings = settingsWith(() => {});
  const { window, matching } = settings;
  const reduced = () => estimate_offset(left.reduced(1024), right.reduced(1024));
  const estimated = reduced();
  const [dx, dy] = estimated.median_px;
  const detect = (/** @type {Photo} */ photo) => photo.detect(settings).points;
  const describe = (/** @type {Photo} */ photo, /** @type {Float64Array} */ points) => photo.describe(points, window, matching.strategy);
  const [pl, pr] = [detect(left), detect(right)];
  const [dl, dr] = [describe(left, pl), describe(right, pr)];
  const whole = (/** @type {() => import('../../pkg/node.js').OffsetField} */ offset) => () => {
    const [a, b] = [detect(left), detect(right)];
    return match_points(a, describe(left, a), b, describe(right, b), offset(), matching);
  };
  tell(
    `${name}, operators to matches of both images`,
    medianMs(
      101,
      whole(() => constant_offset(dx, dy)),
    ),
  );
  tell(`${name}, the same with the offset estimated`, medianMs(51, whole(reduced)));
  tell(
    `${name}, points of both images`,
    medianMs(101, () => [detect(left), detect(right)]),
  );
  tell(
    `${name}, moments of both images`,
    medianMs(101, () => [describe(left, pl), describe(right, pr)]),
  );
  tell(
    `${name}, matching`,
    medianMs(101, () => match_points(pl, dl, pr, dr, constant_offset(dx, dy), matching)),
  );
  tell(`${name}, offset`, medianMs(51, reduced));
}

/** 2,000 points by grey values, windows of 21 x 21 px.  @param {string} name @param {Photo} left @param {Photo} right */
function windows(name, left, right) {
  const { points } = left.detect(settingsWith(() => {}));
  const inner = Array.from({ length: points.length / 3 }, (_, i) => points.subarray(3 * i, 3 * i + 3)).filter(
    ([x = 0, y = 0]) => x > 40 && y > 40 && x < left.width - 40 && y < left.height - 40,
  );
  const chosen = Float64Array.from({ length: 6000 }, (_, i) => inner[Math.floor((Math.floor(i / 3) * inner.length) / 2000)]?.[i % 3] ?? NaN);
  const run = (/** @type {Partial<import('../../pkg/node.js').MatchOptions>} */ matching) => {
    const settings = defaults();
    Object.assign(settings.matching, { template: 21, left_right: false, strategy: 'correlation', ...matching });
    return medianMs(15, () => match_photos(left, right, { points: chosen }, { points: new Float64Array() }, constant_offset(0, 0), null, settings));
  };
  const plain = run({});
  tell(`${name}, correlation of 2,000 points, 21 x 21 px, in 25 x 25 places`, plain);
  tell(`${name}, the same with the left-right check`, run({ left_right: true }));
  tell(`${name}, correlation of 2,000 points, 21 x 21 px, in 41 x 41 places (61 x 61 px)`, run({ search: 41 }));
  tell(`${name}, least squares matching of the correlated of these, beside their correlation`, run({ refine: 'least-squares' }) - plain);
  tell(`${name}, least squares matching of 2,000 points from coarse to fine`, run({ strategy: 'least-squares' }));
  for (const share of [0, 0.3, 0.6])
    tell(
      `robust orientation of 2,000 observations, ${100 * share} % blunders`,
      medianMs(9, () => orient_relative(spoiled(share), 153.38, {}, null)),
    );
}

/** Observations of relief over 60 % overlap with noise of 0.02 mm, of which a share has right points anywhere within 3 mm.  @param {number} share */
export function spoiled(share) {
  const uniform = dice(12345);
  const noise = () => 0.02 * (uniform() + uniform() + uniform() + uniform() - 2) * Math.sqrt(3);
  return Float64Array.from(
    Array.from({ length: 2000 }, (_, i) => {
      const [x, y] = [uniform() * 130 - 20, uniform() * 200 - 100];
      const scale = 1 + 0.08 * (2 * uniform() - 1);
      const off = i < 2000 * share ? [6 * uniform() - 3, 6 * uniform() - 3] : [0, 0];
      return [x + noise(), y + noise(), x - 92 / scale + (off[0] ?? 0) + noise(), y - 1.2 / scale + (off[1] ?? 0) + noise()];
    }).flat(),
  );
}

function large() {
  const [name, file] = ['pair_full_caliterra', 'IMG_9401.jpg'];
  const bytes = bytesOf(name, file);
  tell(
    `decoding ${file} (12 MP JPEG)`,
    medianMs(5, () => Photo.decode(bytes).free()),
  );
  const photo = photoOf(name, file);
  const settings = settingsWith(() => {});
  const by = (/** @type {Partial<import('../../pkg/node.js').PointOptions>} */ options) => () =>
    photo.detect({ ...settings, points: { ...settings.points, ...options } });
  tell('ground 2 on 12 MP, 14.8 % candidates', medianMs(15, by({})));
  tell('ground 2 on 12 MP, T = 40', medianMs(15, by({ fraction: null, threshold: 40 })));
  for (const operator of /** @type {const} */ (['ground1', 'forstner', 'moravec'])) {
    tell(`${operator} on 12 MP, 14.8 % candidates`, medianMs(5, by({ operator })));
  }
  photo.free();
}
