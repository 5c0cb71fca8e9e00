/** Cameras that only turned, and a wall of which no camera is known. */

import { flight_presets } from '../../../pkg/node.js';
import { have } from '../data.mjs';
import { PHOTOGRAPHS } from './apart.mjs';
import { flight } from './flights.mjs';
import { photograph, withoutExif } from './photographs.mjs';
import { multiplied, noisy, warped } from './pictures.mjs';
import { ofFolder, ofSeed } from './sites.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./views.mjs').View} View @typedef {import('./views.mjs').Pair} Pair */

/** Turns about x, y and z in degrees. */
const TURNS = /** @type {[number, number, number][]} */ ([
  [0, 8, 0],
  [6, -4, 3],
  [0, 12, 2],
  [3, 3, 40],
  [-9, 5, -1],
  [0, 0, 25],
]);

/** @param {number} k @returns {[number, number, number]} */
const turns = (k) => TURNS[k % TURNS.length] ?? [0, 0, 0];

/** @returns {Given[]} */
export function rotations() {
  const flights = Array.from({ length: 10 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 660 + k];
    const make = () => digital(flight(preset, seed).left.picture, 1.1, k);
    return { kind: 'pure rotation', name: `${preset} ${seed}`, ...ofSeed(seed), isRight: false, make };
  });
  const photographs = PHOTOGRAPHS.filter(([folder]) => have(folder)).flatMap(([folder, file], k) =>
    [0, 1].map((second) => {
      const make = () => byPhotograph(photograph(folder, file), 2 * k + second);
      return { kind: 'pure rotation', name: `${folder}/${file}, turned by ${turns(2 * k + second).join('°, ')}°`, ...ofFolder(folder), isRight: false, make };
    }),
  );
  return [...flights, ...photographs, ...arches()];
}

/** @param {View} view @param {number} k @returns {Pair} */
function byPhotograph(view, k) {
  const camera = view.picture.exif?.camera;
  if (!camera?.pixel_mm) return digital(withoutExif(view).picture, 1, k);
  // The camera's true focal length is near what EXIF says of it, as it is of most.
  const right = turnedView(view, (1.02 * camera.focal_mm) / camera.pixel_mm, k);
  return { left: view, right, camera: null, pose: null };
}

/** A digital camera whose focal length is known, in widths of its image.  @param {import('./pictures.mjs').Picture} picture @param {number} focal @param {number} k @returns {Pair} */
function digital(picture, focal, k) {
  const left = { picture, fiducials: [] };
  return { left, right: turnedView(left, focal * picture.width, k), camera: { focal_mm: focal, pixel_mm: 1 / picture.width }, pose: null };
}

/** @param {View} view @param {number} focal_px @param {number} k @returns {View} */
function turnedView({ picture }, focal_px, k) {
  const middle = [picture.width / 2, picture.height / 2];
  const [x = 0, y = 0] = middle;
  const camera = [
    [focal_px, 0, x],
    [0, focal_px, y],
    [0, 0, 1],
  ];
  const inverse = [
    [1 / focal_px, 0, -x / focal_px],
    [0, 1 / focal_px, -y / focal_px],
    [0, 0, 1],
  ];
  return { picture: noisy(warped(picture, multiplied(camera, multiplied(rotation(turns(k)), inverse))), 2, 11 + k), fiducials: [] };
}

/** @param {[number, number, number]} turns @returns {number[][]} */
function rotation(turns) {
  const [a, b, c] = turns.map((deg) => ({ c: Math.cos((deg * Math.PI) / 180), s: Math.sin((deg * Math.PI) / 180) }));
  if (!a || !b || !c) throw new Error('a rotation has three angles');
  const about = [
    [
      [1, 0, 0],
      [0, a.c, -a.s],
      [0, a.s, a.c],
    ],
    [
      [b.c, 0, b.s],
      [0, 1, 0],
      [-b.s, 0, b.c],
    ],
    [
      [c.c, -c.s, 0],
      [c.s, c.c, 0],
      [0, 0, 1],
    ],
  ];
  return about.reduce(multiplied);
}

/** Photographs from one place, with their EXIF data, without them, and with a focal length that is somewhat wrong.  @returns {Given[]} */
function arches() {
  const folder = 'degenerate_rotation_arches';
  if (!have(folder)) return [];
  const views = () => ({ left: photograph(folder, 'JDW_9518.jpg'), right: photograph(folder, 'JDW_9519.jpg') });
  const given = (/** @type {string} */ what, /** @type {() => Pair} */ make) => ({
    kind: 'pure rotation',
    name: `${folder}, ${what}`,
    ...ofFolder(folder),
    isRight: false,
    make,
  });
  return [
    given('EXIF', () => ({ ...views(), camera: null, pose: null })),
    given('no camera', () => ({ left: withoutExif(views().left), right: withoutExif(views().right), camera: null, pose: null })),
    ...[0.8, 1.25].map((by) => given(`focal length times ${by}`, () => ({ ...views(), camera: { focal_mm: 40 * by, pixel_mm: 0.0334 }, pose: null }))),
  ];
}

/** A painted wall.  @returns {Given[]} */
export function planes() {
  const folder = 'homography_graf';
  if (!have(folder)) return [];
  const make = () => ({ left: photograph(folder, 'graf1.png'), right: photograph(folder, 'graf3.png'), camera: null, pose: null });
  return [{ kind: 'plane, no camera', name: folder, ...ofFolder(folder), isRight: false, make }];
}
