/** Right photographs with a wrong camera, or none at all: judged by their true pose, as the right pairs are. */

import { flight_presets } from '../../../pkg/node.js';
import { posedPairs } from '../data.mjs';
import { flight } from './flights.mjs';
import { byExif, calibrated, withoutExif } from './photographs.mjs';
import { hasExif } from './right.mjs';
import { ofFolder, ofSeed } from './sites.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./views.mjs').View} View @typedef {import('./views.mjs').Pair} Pair @typedef {import('./views.mjs').Fiducial} Fiducial */

const FOCAL_FACTORS = [0.4, 2.5, 2];

/** @type {[string, (marks: Fiducial[], k: number) => Fiducial[]][]} */
const MARKS = [
  ['two marks exchanged', (marks, k) => exchanged(marks, k % marks.length, (k + 1 + (k >> 2)) % marks.length)],
  ['two marks of the right photo exchanged', (marks, k) => exchanged(marks, (k + 1) % marks.length, (k + 3) % marks.length)],
  ['marks outside', (marks, k) => marks.map((mark) => ({ ...mark, col: mark.col + 900 + 100 * k }))],
  ['marks numbered the other way round', (marks) => marks.map((mark) => ({ ...mark, x_mm: -mark.x_mm }))],
];

/** @returns {Given[]} */
export function wrongCameras() {
  return [...wrongFocal(), ...oldExif(), ...noCamera(), ...wrongMarks()];
}

/** @returns {Given[]} */
function wrongFocal() {
  const flights = Array.from({ length: 12 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 680 + k];
    return { name: `${preset} ${seed}`, where: ofSeed(seed), make: () => flight(preset, seed), by: FOCAL_FACTORS[(k >> 1) % FOCAL_FACTORS.length] ?? 1 };
  });
  const photographs = posedPairs()
    .filter((_, k) => k % 4 === 1)
    .map((posed, k) => ({
      name: `${posed.folder} ${posed.a} ${posed.b}`,
      where: ofFolder(posed.folder),
      make: () => calibrated(posed),
      by: FOCAL_FACTORS[k % FOCAL_FACTORS.length] ?? 1,
    }));
  return [...flights, ...photographs].map(({ name, where, make, by }) => ({
    kind: 'wrong focal length',
    name: `${name}, times ${by}`,
    ...where,
    isRight: false,
    make: () => {
      const pair = make();
      return { ...pair, camera: { ...pair.camera, focal_mm: by * (pair.camera?.focal_mm ?? NaN) } };
    },
  }));
}

/** Halved photographs whose program kept the side of a pixel in the EXIF data as it was, and changed the number of pixels: only make and model tell.  @returns {Given[]} */
function oldExif() {
  const whole = (/** @type {View} */ view) => {
    const { exif } = view.picture;
    const camera = exif?.camera && { ...exif.camera, pixel_mm: (exif.camera.pixel_mm ?? NaN) / 2 };
    return { ...view, picture: { ...view.picture, exif: exif && { ...exif, camera: camera ?? null } } };
  };
  return posedPairs()
    .filter(({ folder }, k) => hasExif(folder) && k % 5 === 2)
    .map((posed) => ({
      kind: 'EXIF of another size',
      name: `${posed.folder} ${posed.a} ${posed.b}`,
      ...ofFolder(posed.folder),
      isRight: false,
      make: () => {
        const pair = byExif(posed);
        return { ...pair, left: whole(pair.left), right: whole(pair.right) };
      },
    }));
}

/** Nothing is known of the camera: the pair may tell enough of it, or not.  @returns {Given[]} */
function noCamera() {
  return posedPairs()
    .filter(({ folder }, k) => !hasExif(folder) || k % 5 === 3)
    .map((posed) => ({
      kind: 'no camera',
      name: `${posed.folder} ${posed.a} ${posed.b}`,
      ...ofFolder(posed.folder),
      isRight: false,
      make: () => {
        const { left, right, pose } = byExif(posed);
        return { left: withoutExif(left), right: withoutExif(right), camera: null, pose };
      },
    }));
}

/** @returns {Given[]} */
function wrongMarks() {
  return Array.from({ length: 24 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 700 + k];
    const [what, change] = MARKS[(k >> 1) % MARKS.length] ?? ['', (marks) => marks];
    const isWhole = what === 'marks outside';
    const changed = (/** @type {View} */ view) => ({ ...view, fiducials: change(view.fiducials, k), isWhole });
    const isRightAlone = what.includes('right photo');
    const make = () => {
      const pair = flight(preset, seed);
      return { ...pair, left: isRightAlone ? pair.left : changed(pair.left), right: changed(pair.right) };
    };
    return { kind: 'wrong marks', name: `${preset} ${seed}, ${what}`, ...ofSeed(seed), isRight: false, make };
  });
}

/** Measured positions of two marks exchanged.  @param {Fiducial[]} marks @param {number} i @param {number} j */
function exchanged(marks, i, j) {
  const other = i === j ? (j + 1) % marks.length : j;
  const [first, second] = [marks[i], marks[other]];
  return marks.map((mark, k) => {
    const place = k === i ? second : k === other ? first : mark;
    return { ...mark, col: place?.col ?? mark.col, row: place?.row ?? mark.row };
  });
}
