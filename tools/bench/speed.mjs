/** How fast the wasm module is in Node: one thread, warm, medians. */

import { estimate_offset, match_points, constant_offset, sample, sample_seed, Photo } from '../../pkg/node.js';
import { settingsWith } from './accuracy.mjs';
import { bytesOf, have, photoOf, simulated } from './data.mjs';

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
  }
  const made = sample(sample_seed());
  pair('sample', ...(/** @type {[Photo, Photo]} */ ([made.left, made.right].map((p) => Photo.from_grey(p.width, p.height, p.grey)))));
  if (have('pair_full_caliterra')) large();
}

/** Both images from operator to matches, by stage and in all.  @param {string} name @param {Photo} left @param {Photo} right */
function pair(name, left, right) {
  const settings = settingsWith(() => {});
  const { window, matching } = settings;
  const reduced = () => estimate_offset(left.reduced(1024), right.reduced(1024));
  const estimated = reduced();
  const [dx, dy] = estimated.median_px;
  const detect = (/** @type {Photo} */ photo) => photo.detect(settings.points).points;
  const describe = (/** @type {Photo} */ photo, /** @type {Float64Array} */ points) => photo.describe(points, window, matching.measure);
  const [pl, pr] = [detect(left), detect(right)];
  const [dl, dr] = [describe(left, pl), describe(right, pr)];
  const whole = (/** @type {() => import('../../pkg/node.js').OffsetField} */ offset) => () => {
    const [a, b] = [detect(left), detect(right)];
    return match_points(a, describe(left, a), b, describe(right, b), offset(), matching);
  };
  tell(`${name}, operators to matches of both images`, medianMs(101, whole(() => constant_offset(dx, dy))));
  tell(`${name}, the same with the offset estimated`, medianMs(51, whole(reduced)));
  tell(`${name}, points of both images`, medianMs(101, () => [detect(left), detect(right)]));
  tell(`${name}, moments of both images`, medianMs(101, () => [describe(left, pl), describe(right, pr)]));
  tell(`${name}, matching`, medianMs(101, () => match_points(pl, dl, pr, dr, constant_offset(dx, dy), matching)));
  tell(`${name}, offset`, medianMs(51, reduced));
}

function large() {
  const [name, file] = ['pair_full_caliterra', 'IMG_9401.jpg'];
  const bytes = bytesOf(name, file);
  tell(`decoding ${file} (12 MP JPEG)`, medianMs(5, () => Photo.decode(bytes).free()));
  const photo = photoOf(name, file);
  const { points } = settingsWith(() => {});
  tell('ground 2 on 12 MP, 14.8 % candidates', medianMs(15, () => photo.detect(points)));
  tell('ground 2 on 12 MP, T = 40', medianMs(15, () => photo.detect({ ...points, fraction: undefined, threshold: 40 })));
  for (const operator of /** @type {const} */ (['ground1', 'forstner', 'moravec'])) {
    tell(`${operator} on 12 MP, 14.8 % candidates`, medianMs(5, () => photo.detect({ ...points, operator })));
  }
  photo.free();
}
