/** Pairs that are to be oriented: flights of all kinds, and every pair of photographs with truth. */

import { flight_presets } from '../../../pkg/node.js';
import { have, posedPairs, simulated } from '../data.mjs';
import { poseOf } from '../../score.mjs';
import { flight } from './flights.mjs';
import { byExif, calibrated } from './photographs.mjs';
import * as pictures from './pictures.mjs';
import { ofFolder, ofSeed } from './sites.mjs';
import * as views from './views.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./views.mjs').Pair} Pair @typedef {Partial<import('../../../pkg/node.js').Flight>} Changes */

/** What differs from the preset, in flight and afterwards.  @type {[string, Changes, ((pair: Pair) => Pair)?][]} */
const VARIANTS = [
  ['as it is', {}],
  ['short base', { base_mm: 35 }],
  ['long base', { base_mm: 125 }],
  ['rising and sideways', { by_mm: 14, bz_mm: 9 }],
  ['tilted', { omega_deg: 5, phi_deg: -6, left_omega_deg: -3, left_phi_deg: 2 }],
  ['turned by 10°', { kappa_deg: -10 }],
  ['high relief', { relief_m: 70, highest_building_m: 40 }],
  ['strong noise', { noise_grey: 11 }],
  ['haze and dark', { haze: 0.5, gain: 0.55 }],
  ['few buildings', { buildings: 60, trees: 300 }],
  ['right one turned by 180°', {}, (pair) => ({ ...pair, right: views.turned(pair.right, 180) })],
  ['right one turned by 90°', {}, (pair) => ({ ...pair, right: views.turned(pair.right, 90) })],
  ['half overlap', {}, ({ left, right, ...rest }) => ({ ...rest, left: views.cropped(left, 0, 0, 400, 380), right: views.cropped(right, 0, 190, 400, 370) })],
  [
    'large and reduced',
    { width_px: 430, height_px: 800, pixel_mm: 0.16 },
    (pair) => ({ ...pair, left: views.reduced(pair.left, 2), right: views.reduced(pair.right, 2) }),
  ],
  ['right one half as large', {}, (pair) => ({ ...pair, right: views.reduced(pair.right, 2) })],
  ['compressed', {}, (pair) => ({ ...pair, right: views.withPicture(pair.right, (of) => pictures.compressed(of, 9)) })],
  ['left and right exchanged', {}, views.exchanged],
];

/** @returns {Given[]} */
export function rightFlights() {
  return VARIANTS.flatMap(([variant, changes, after = (pair) => pair], k) =>
    flight_presets().flatMap((preset, p) =>
      [0, 1].map((odd) => {
        const seed = 200 + 10 * k + 2 * p + odd;
        return { kind: 'flight', name: `${preset} ${seed}, ${variant}`, ...ofSeed(seed), isRight: true, make: () => after(flight(preset, seed, changes)) };
      }),
    ),
  );
}

/** @returns {Given[]} */
export function rightPhotographs() {
  const posed = posedPairs();
  const given = (/** @type {(typeof posed)[number]} */ pair, /** @type {string} */ kind, /** @type {() => Pair} */ make) => ({
    kind,
    name: `${pair.folder} ${pair.a} ${pair.b}`,
    ...ofFolder(pair.folder),
    isRight: true,
    make,
  });
  const known = posed.map((pair) => given(pair, 'photographs, calibrated', () => calibrated(pair)));
  const read = posed.filter((pair) => hasExif(pair.folder)).map((pair) => given(pair, 'photographs, EXIF', () => byExif(pair)));
  const swapped = posed.filter((_, k) => k % 5 === 0).map((pair) => given(pair, 'photographs, exchanged', () => views.exchanged(calibrated(pair))));
  return [...known, ...read, ...swapped, ...oldSimulated()];
}

/** @param {string} folder */
export const hasExif = (folder) => folder === 'block_caliterra' || folder === 'pair_full_caliterra';

/** The pair of the paper's geometry that another program simulated.  @returns {Given[]} */
function oldSimulated() {
  const name = 'simulated-a';
  if (!have(name)) return [];
  const make = () => {
    const { left, right, input, camera, truth, base_mm } = simulated();
    const view = (/** @type {typeof left} */ photo, /** @type {typeof input.left} */ { fiducials, origin: [x, y] }) => {
      const picture = { width: photo.width, height: photo.height, grey: photo.grey() };
      photo.free();
      const marks = fiducials.map((/** @type {views.Fiducial} */ mark) => ({ ...mark, col: mark.col - x, row: mark.row - y }));
      return { picture, fiducials: marks };
    };
    const { focal_mm } = camera;
    return { left: view(left, input.left), right: view(right, input.right), camera: { focal_mm }, pose: poseOf({ ...truth, base_mm }) };
  };
  return [{ kind: 'photographs, calibrated', name, ...ofFolder(name), isRight: true, make }];
}
