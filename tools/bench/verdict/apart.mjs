/** Two photographs that share nothing, and some that share little. */

import { join } from 'node:path';
import { flight_presets } from '../../../pkg/node.js';
import { DATA, readJson } from '../../lib/paths.mjs';
import { have, OF_REFERENCE } from '../data.mjs';
import { flight } from './flights.mjs';
import { byExif, calibrated, photograph } from './photographs.mjs';
import { multiplied, transposed } from './pictures.mjs';
import { ofFolder, ofSeed } from './sites.mjs';
import { cropped, dot } from './views.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./views.mjs').Pair} Pair */

/** Photographs with EXIF data, some of each site. Those of one part are never paired with those of the other. */
export const PHOTOGRAPHS = /** @type {const} */ ([
  ['block_caliterra', 'IMG_9404.jpg'],
  ['lowtexture_nir_seneca', 'IMG_0473.jpg'],
  ['oblique_lewis', 'img_4230.jpg'],
  ['block_caliterra', 'IMG_9409.jpg'],
  ['lowtexture_nir_seneca', 'IMG_0546.jpg'],
  ['oblique_lewis', 'img_4348.jpg'],
  ['hard_blur_rollingshutter_garfield', 'IMG_161122_163239_0001_RGB.jpg'],
  ['truth_terrestrial_fountain', '0004.jpg'],
  ['degenerate_rotation_arches', 'JDW_9518.jpg'],
  ['hard_blur_rollingshutter_garfield', 'IMG_161122_165111_0169_RGB.jpg'],
  ['tiff16_multispectral_garfield', 'IMG_161122_163239_0001_GRE.TIF'],
  ['stereo_rectified_motorcycle', 'motorcycle_left.png'],
]);

/** @returns {Given[]} */
export function apart() {
  return [...townsApart(), ...sitesApart(), ...cropsApart()];
}

/** @returns {Given[]} */
function townsApart() {
  return Array.from({ length: 24 }, (_, k) => {
    const presets = flight_presets();
    const [one, other] = [presets[k % 4] ?? 'paper', presets[(k >> 2) % 4] ?? 'paper'];
    // Both seeds of a pair are of one part.
    const [seed, second] = [400 + k, 426 + k];
    const make = () => ({ ...flight(one, seed), right: flight(other, second).right, pose: null });
    return { kind: 'no overlap, flights', name: `${one} ${seed} and ${other} ${second}`, ...ofSeed(seed), isRight: false, make };
  });
}

/** @returns {Given[]} */
function sitesApart() {
  const there = PHOTOGRAPHS.filter(([folder]) => have(folder));
  const pairs = there.flatMap((a, k) => there.slice(k + 1).map((b) => /** @type {const} */ ([a, b])));
  return pairs
    .filter(([[a], [b]]) => ofFolder(a).site !== ofFolder(b).site && ofFolder(a).part === ofFolder(b).part)
    .map(([a, b]) => {
      const views = () => [a, b].map(([folder, file]) => photograph(folder, file));
      const make = () => {
        const [left, right] = views();
        if (!left || !right) throw new Error('a pair has two images');
        // A camera is given where one of them has no EXIF data.
        const camera = left.picture.exif?.camera && right.picture.exif?.camera ? null : { focal_mm: 1, pixel_mm: 1 / left.picture.width };
        return { left, right, camera, pose: null };
      };
      return { kind: 'no overlap, photographs', name: `${a.join('/')} and ${b.join('/')}`, ...ofFolder(a[0]), isRight: false, make };
    });
}

/** Crops of one photograph that do not touch.  @returns {Given[]} */
function cropsApart() {
  return PHOTOGRAPHS.filter(([folder]) => have(folder)).flatMap(([folder, file]) => {
    const whole = () => photograph(folder, file, 2048);
    const columns = () => {
      const { width, height } = whole().picture;
      const side = Math.floor(0.47 * width);
      return parts([0, 0, side, height], [width - side, 0, side, height]);
    };
    const rows = () => {
      const { width, height } = whole().picture;
      const side = Math.floor(0.47 * height);
      return parts([0, 0, width, side], [0, height - side, width, side]);
    };
    /** @param {[number, number, number, number]} a @param {[number, number, number, number]} b @returns {Pair} */
    const parts = (a, b) => ({ left: cropped(whole(), ...a), right: cropped(whole(), ...b), camera: guessed(whole().picture), pose: null });
    const given = (/** @type {string} */ what, /** @type {() => Pair} */ make) => ({
      kind: 'no overlap, crops',
      name: `${folder}/${file}, ${what}`,
      ...ofFolder(folder),
      isRight: false,
      make,
    });
    return [given('left and right part', columns), given('upper and lower part', rows)];
  });
}

/** A camera for a picture that names none: as long as it is wide.  @param {import('./pictures.mjs').Picture} picture */
export const guessed = ({ exif, width }) => (exif?.camera ? null : { focal_mm: 1, pixel_mm: 1 / width });

/** @returns {Given[]} */
export function little() {
  return [...littleFlights(), ...littlePhotographs()];
}

/** Overlap of 5 to 10 % along the longer side.  @returns {Given[]} */
function littleFlights() {
  return Array.from({ length: 12 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 460 + k];
    const make = () => {
      const { left, right, ...rest } = flight(preset, seed);
      const shared = 14 + k;
      return { ...rest, left: cropped(left, 0, 0, 400, 280), right: cropped(right, 0, 280 - shared, 400, 280) };
    };
    return { kind: 'little overlap', name: `${preset} ${seed}`, ...ofSeed(seed), isRight: false, make };
  });
}

/** Pairs of the block that its reference does not list, since few points or none are common.  @returns {Given[]} */
function littlePhotographs() {
  const folder = 'block_caliterra';
  if (!have(folder)) return [];
  const truth = readJson(join(DATA, folder, 'truth.json'));
  const listed = new Set(truth.pairs.map((/** @type {{ a: string, b: string }} */ { a, b }) => `${a} ${b}`));
  const images = /** @type {{ file: string, reference: { R_cw: number[][], C: number[] } }[]} */ (truth.images);
  return images
    .flatMap((a, k) => images.slice(k + 1).map((b) => /** @type {const} */ ([a, b])))
    .filter(([a, b]) => !listed.has(`${a.file} ${b.file}`))
    .map(([a, b], k) => {
      const [one, other] = [a.reference, b.reference];
      const base = one.C.map((v, axis) => v - (other.C[axis] ?? 0));
      const pose = { rotation: multiplied(other.R_cw, transposed(one.R_cw)), direction: other.R_cw.map((row) => dot(row, base)), uncertain: OF_REFERENCE };
      const posed = { folder, a: a.file, b: b.file, truth, pose };
      const make = () => (k % 2 === 0 ? byExif(posed) : calibrated(posed));
      return { kind: 'little overlap', name: `${folder} ${a.file} ${b.file}`, ...ofFolder(folder), isRight: false, make };
    });
}
