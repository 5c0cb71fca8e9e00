/** Simulated flights as pairs of views. Each is computed once. */

import { flight_preset, simulate } from '../../../pkg/node.js';
import { poseOf } from '../../score.mjs';

/** @typedef {import('../../../pkg/node.js').Flight} Flight @typedef {import('../../../pkg/node.js').Preset} Preset @typedef {import('./views.mjs').Pair} Pair */

/** @type {Map<string, Pair>} */
const flown = new Map();

/** @param {Preset} preset @param {number} seed @param {Partial<Flight>} [changes] @returns {Pair} */
export function flight(preset, seed, changes = {}) {
  const all = { ...flight_preset(preset), width_px: 400, height_px: 560, ...changes, seed };
  const key = JSON.stringify(all);
  const kept = flown.get(key);
  if (kept) return kept;
  const made = simulate(all);
  const view = (/** @type {'left' | 'right'} */ side) => {
    const [x, y] = made[`${side}_origin`];
    return { picture: made[side], fiducials: made[`${side}_fiducials`].map((mark) => ({ ...mark, col: mark.col - x, row: mark.row - y })) };
  };
  const [left, right] = [view('left'), view('right')];
  const seen = { left, right, right_position: made.right_position };
  const pair = { left, right, camera: made.camera, pose: poseOf({ ...made.truth, base_mm: made.base_mm }), seen };
  flown.set(key, pair);
  return pair;
}
