/** All pairs of the count. Half of them must not be called oriented. */

import { apart, little } from './apart.mjs';
import { wrongCameras } from './cameras.mjs';
import { borders } from './borders.mjs';
import { identical } from './identical.mjs';
import { mirrors } from './mirrors.mjs';
import { repeated } from './repeated.mjs';
import { rightFlights, rightPhotographs } from './right.mjs';
import { planes, rotations } from './rotations.mjs';

/**
 * @typedef {import('./views.mjs').Pair} Pair
 * @typedef {{ kind: string, name: string, site: string, part: import('./sites.mjs').Part, isRight: boolean, make: () => Pair }} Given
 *   isRight: two photographs of one scene with enough overlap and its own camera, which are to be oriented
 */

/** @returns {Given[]} */
export function allPairs() {
  const kinds = [rightFlights(), rightPhotographs(), apart(), little(), repeated(), mirrors(), identical(), rotations(), planes(), wrongCameras(), borders()];
  return kinds.flat();
}
