/** Pairs of which one photograph is mirrored, as a film that was scanned from its back. */

import { flight_presets } from '../../../pkg/node.js';
import { posedPairs } from '../data.mjs';
import { flight } from './flights.mjs';
import { byExif, calibrated } from './photographs.mjs';
import { mirrored } from './pictures.mjs';
import { hasExif } from './right.mjs';
import { ofFolder, ofSeed } from './sites.mjs';
import { withPicture } from './views.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./views.mjs').Pair} Pair */

/** @returns {Given[]} */
export function mirrors() {
  const flights = Array.from({ length: 12 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 620 + k];
    return given(`${preset} ${seed}`, ofSeed(seed), k, () => flight(preset, seed));
  });
  const photographs = posedPairs()
    .filter((_, k) => k % 3 === 0)
    .map((posed, k) =>
      given(`${posed.folder} ${posed.a} ${posed.b}`, ofFolder(posed.folder), k, () =>
        hasExif(posed.folder) && k % 2 === 0 ? byExif(posed) : calibrated(posed),
      ),
    );
  return [...flights, ...photographs];
}

/** @param {string} name @param {ReturnType<typeof ofSeed>} site @param {number} k @param {() => Pair} make @returns {Given} */
function given(name, site, k, make) {
  const what = k % 3 === 0 ? 'rows' : 'columns';
  const mirroredPair = () => {
    const pair = make();
    return { ...pair, right: withPicture(pair.right, (picture) => mirrored(picture, what)), pose: null };
  };
  return { kind: 'mirrored', name: `${name}, ${what}`, ...site, isRight: false, make: mirroredPair };
}
