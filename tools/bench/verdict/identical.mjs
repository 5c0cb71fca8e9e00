/** One photograph twice: the same file, saved again, brightened, with noise, or another part of it. */

import { flight_presets } from '../../../pkg/node.js';
import { have } from '../data.mjs';
import { guessed, PHOTOGRAPHS } from './apart.mjs';
import { flight } from './flights.mjs';
import { photograph } from './photographs.mjs';
import { brightened, compressed, noisy } from './pictures.mjs';
import { ofFolder, ofSeed } from './sites.mjs';
import { cropped, withPicture } from './views.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./views.mjs').View} View @typedef {import('./views.mjs').Pair} Pair */

/** @type {[string, (view: View) => [View, View]][]} */
const COPIES = [
  ['the same', (view) => [view, view]],
  ['noise', (view) => [view, withPicture(view, (picture) => noisy(picture, 5, 7))]],
  ['brightened', (view) => [view, withPicture(view, (picture) => brightened(picture, 0.8, 25))]],
  ['compressed', (view) => [view, withPicture(view, (picture) => compressed(picture, 10))]],
  ['shifted', shifted],
];

/** Two crops of which each shows two thirds of the other. A digital camera's middle is then that of the crop.  @param {View} view @returns {[View, View]} */
function shifted(view) {
  const { width, height } = view.picture;
  const side = Math.floor(0.75 * width);
  return [cropped(view, 0, 0, side, height - 20), cropped(view, width - side, 20, side, height - 20)];
}

/** @returns {Given[]} */
export function identical() {
  const flights = Array.from({ length: 10 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 640 + k];
    const [what, copies] = COPIES[k % 5] ?? ['', () => []];
    const make = () => {
      const { left, camera } = flight(preset, seed);
      return pair(copies(left), camera);
    };
    return { kind: 'identical', name: `${preset} ${seed}, ${what}`, ...ofSeed(seed), isRight: false, make };
  });
  const photographs = PHOTOGRAPHS.filter(([folder]) => have(folder)).flatMap(([folder, file], k) =>
    [0, 1].map((second) => {
      const [what, copies] = COPIES[(2 * k + second) % 5] ?? ['', () => []];
      const make = () => pair(copies(photograph(folder, file)), guessed(photograph(folder, file).picture));
      return { kind: 'identical', name: `${folder}/${file}, ${what}`, ...ofFolder(folder), isRight: false, make };
    }),
  );
  return [...flights, ...photographs];
}

/** @param {View[]} views @param {Pair['camera']} camera @returns {Pair} */
function pair([left, right], camera) {
  if (!left || !right) throw new Error('a pair has two images');
  return { left, right, camera, pose: null };
}
