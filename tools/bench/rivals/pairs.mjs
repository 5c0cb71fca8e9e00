/** The pairs with known truth, with what is known of their cameras. */

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { DATA, readJson } from '../../lib/paths.mjs';

/** Focal lengths and principal point in px (pixel centres at halves), radial distortion.  @typedef {{ focal: [number, number], centre: [number, number], radial: [number, number] }} Camera */
/** @typedef {{ name: string, a: string, b: string, cameras: [Camera, Camera] | null }} Pair */

/** Folders as the rivals' script names them. */
const FOLDERS = [
  'homography_graf',
  'pair_full_caliterra',
  'semisynth_exact_caliterra',
  'simulated-a',
  'stereo_rectified_motorcycle',
  'truth_terrestrial_fountain',
  'homography_dogman',
  'kite_scale_rotation_boruszyn',
  'pair_full_boruszyn',
  'semisynth_exact_boruszyn',
  'stereo_rectified_aloe',
  'truth_terrestrial_herzjesu',
];

/** The pairs that are there.  @returns {Pair[]} */
export function knownPairs() {
  return FOLDERS.filter((name) => existsSync(join(DATA, name, 'truth.json'))).flatMap((name) => {
    const truth = readJson(join(DATA, name, 'truth.json'));
    if (name.startsWith('simulated')) return [{ name, a: 'left.png', b: 'right.png', cameras: scanned(truth) }];
    return (truth.pairs ?? truth.homographies).map((/** @type {{ a: string, b: string }} */ { a, b }) => {
      const [left, right] = [digital(truth, a), digital(truth, b)];
      return { name, a, b, cameras: left && right ? [left, right] : null };
    });
  });
}

/** @param {any} truth @param {string} file @returns {Camera | null} */
function digital(truth, file) {
  const image = truth.images?.find((/** @type {{ file: string }} */ i) => i.file === file);
  const { K, k1 = 0, k2 = 0 } = image?.reference ?? image ?? {};
  return K?.length === 4 ? { focal: [K[0], K[1]], centre: [K[2] + 0.5, K[3] + 0.5], radial: [k1, k2] } : null;
}

/** Patches of scanned photos by the nominal pixel size, as the rivals take them.  @param {any} truth @returns {[Camera, Camera]} */
function scanned(truth) {
  const focal = truth.f_mm / truth.pixel_mm_nominal;
  const camera = (/** @type {'left' | 'right'} */ side) => {
    const [col, row] = truth[side].patch_origin_col_row;
    return /** @type {Camera} */ ({ focal: [focal, focal], centre: [455.8 - col, 458.3 - row], radial: [0, 0] });
  };
  return [camera('left'), camera('right')];
}
