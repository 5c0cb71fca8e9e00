/** What the ready-made settings gain on every pair with truth whose camera is known: right matches, rotation error and time beside the defaults. */

import { defaults, match_pair, pair_preset, pair_presets } from '../../pkg/node.js';
import { poseOf, rotationError, sampsonShare } from '../score.mjs';
import { cameraOf } from './accuracy.mjs';
import { photoOf, pinhole, posedPairs } from './data.mjs';
import { numberOption } from './options.mjs';

/** @typedef {{ right: number, share: number, rotation: number, seconds: number }} Outcome */

export function presets() {
  const most = numberOption('pairs', 4);
  console.log(
    `Ready-made settings beside the defaults (at most ${most} pairs of a folder): right matches, share of right ones, rotation error, processor time`,
  );
  /** @type {Map<string, Outcome[]>} */
  const ratios = new Map(pair_presets().map((name) => [name, []]));
  /** @type {Map<string, number>} */
  const tried = new Map();
  for (const pair of posedPairs()) {
    const before = tried.get(pair.folder) ?? 0;
    tried.set(pair.folder, before + 1);
    if (before >= most) continue;
    const plain = outcome(pair, defaults());
    line(pair, 'defaults', plain);
    for (const [name, of] of ratios) {
      const own = outcome(pair, pair_preset(/** @type {import('../../pkg/node.js').PairPreset} */ (name)));
      line(pair, name, own);
      of.push({
        right: own.right / plain.right,
        share: own.share - plain.share,
        rotation: own.rotation / plain.rotation,
        seconds: own.seconds / plain.seconds,
      });
    }
  }
  for (const [name, of] of ratios) {
    const median = (/** @type {keyof Outcome} */ field) => of.map((one) => one[field]).sort((a, b) => a - b)[Math.floor(of.length / 2)] ?? NaN;
    console.log(
      `${name}, ${of.length} pairs, medians beside the defaults: right matches x ${median('right').toFixed(2)}, share ${median('share').toFixed(3)} more, ` +
        `rotation error x ${median('rotation').toFixed(2)}, time x ${median('seconds').toFixed(2)}`,
    );
  }
}

/** @param {import('./data.mjs').PosedPair} pair @param {import('../../pkg/node.js').PairSettings} settings @returns {Outcome} */
function outcome({ folder, a, b, truth, pose }, settings) {
  const [left, right] = [pinhole(truth, a), pinhole(truth, b)];
  const photos = { left: photoOf(folder, a), right: photoOf(folder, b) };
  const input = { camera: cameraOf(left, photos.left.width, photos.left.height) };
  const start = process.cpuUsage().user;
  const { match, orientation } = match_pair(photos.left, photos.right, input, settings);
  const seconds = (process.cpuUsage().user - start) / 1e6;
  photos.left.free();
  photos.right.free();
  const share = match.counts.matches === 0 ? 0 : sampsonShare(match.matches, left, right, pose.rotation, pose.direction).share;
  const rotation = orientation ? rotationError(poseOf(orientation).rotation, pose.rotation) : NaN;
  return { right: Math.round(share * match.counts.matches), share, rotation, seconds };
}

/** @param {import('./data.mjs').PosedPair} pair @param {string} name @param {Outcome} outcome */
function line({ folder, a, b }, name, { right, share, rotation, seconds }) {
  console.log(`  ${folder} ${a} ${b}, ${name}: ${right} right, ${share.toFixed(3)}; ${rotation.toFixed(3)} deg; ${seconds.toFixed(1)} s`);
}
