/** A pair as the command matches and orients it, as an entry of a result file. */

import { match_descriptors, match_pair, message } from '../../../pkg/node.js';
import { poseOf } from '../../score.mjs';
import { calibratedInput } from '../calibrated.mjs';
import { photoOf, simulated } from '../data.mjs';
import { medianMs } from '../speed.mjs';

/** @typedef {{ case: string, a: string, b: string, matches: number[][], R: number[][] | null, t: number[] | null, points?: number[], seconds: Record<string, number>, note?: string }} Entry */
/** @typedef {import('../../../pkg/node.js').Photo} Photo */

/** The median time of an image's features in s, of the matching of their descriptors, and the numbers of points.  @param {Photo} left @param {Photo} right */
function stages(left, right) {
  const [first, second] = [left, right].map((photo) => {
    let found = photo.features({});
    const ms = medianMs(3, () => {
      found = photo.features({});
    });
    return { ...found, ms };
  });
  if (!first || !second) throw new Error('a pair has two images');
  const matching = medianMs(3, () => match_descriptors(first.descriptors, second.descriptors, {}));
  return { points: [first, second].map(({ points }) => points.length / 5), seconds: { features: (first.ms + second.ms) / 1000, matching: matching / 1000 } };
}

/** What the command is given of the cameras.  @param {import('./pairs.mjs').Pair} pair @param {Photo} left @param {Photo} right */
function inputOf({ name, cameras }, left, right) {
  if (!cameras) return {};
  if (name.startsWith('simulated')) return simulated().input;
  const [first, second] = cameras.map(({ focal: [f, fy], centre: [cx, cy], radial: [k1, k2] }) => ({ f, fy, cx, cy, k1, k2 }));
  if (!first || !second) throw new Error('a pair has two cameras');
  return calibratedInput([first, second], [left, right]);
}

/** By one strategy; the times of its stages where it is the one by gradients.  @param {import('./pairs.mjs').Pair} pair @param {'gradient' | 'auto'} strategy @returns {Entry} */
export function ours(pair, strategy) {
  const { name, a, b } = pair;
  const [left, right] = [photoOf(name, a), photoOf(name, b)];
  const input = inputOf(pair, left, right);
  const parts = strategy === 'gradient' ? stages(left, right) : { seconds: {} };
  const start = performance.now();
  const { match, orientation, verdict, no_orientation } = match_pair(left, right, input, { matching: { strategy } });
  const seconds = { ...parts.seconds, all: (performance.now() - start) / 1000 };
  left.free();
  right.free();
  const matches = Array.from({ length: match.matches.length / 5 }, (_, k) => [...match.matches.subarray(5 * k, 5 * k + 4)]);
  const pose = orientation && poseOf(orientation);
  const note = [message('pair_verdict', verdict, 'label'), no_orientation ? message('no_orientation', no_orientation) : ''].filter(Boolean).join(', ');
  return { case: name, a, b, ...parts, seconds, matches, R: pose?.rotation ?? null, t: pose?.direction ?? null, note };
}
