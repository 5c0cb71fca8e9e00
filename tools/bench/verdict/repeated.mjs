/** Repeated texture: tiled roofs, rows of a plantation, waves, facades. What differs from period to period is little. */

import { ground, PERIODS_M, pairOf, photographed } from './grounds.mjs';
import { ofSeed } from './sites.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./grounds.mjs').Texture} Texture @typedef {Parameters<typeof ground>[2]} Amounts */

const TEXTURES = /** @type {Texture[]} */ (Object.keys(PERIODS_M));
/** By how many grey values periods differ. */
const VARIATIONS = [0, 2, 4, 8, 16, 30];
/** Over flat ground every shift by periods is a geometry. */
const RELIEFS_M = [6, 0.5, 2];

/** @returns {Given[]} */
export function repeated() {
  return TEXTURES.flatMap((texture, t) =>
    VARIATIONS.flatMap((variation, v) => {
      const amounts = { variation, relief_m: RELIEFS_M[(t + v) % RELIEFS_M.length] ?? 0 };
      return [elsewhere(texture, amounts, 500 + 13 * t + v), sameGround(texture, amounts, 560 + 13 * t + v)];
    }),
  );
}

/** Two grounds of one texture, whose periods lie alike.  @param {Texture} texture @param {Amounts} amounts @param {number} seed @returns {Given} */
function elsewhere(texture, amounts, seed) {
  const make = () =>
    pairOf(
      photographed(ground(texture, seed, amounts), { x: 0, y: 0, kappa_deg: 0, tilt_deg: 1 }, seed),
      photographed(ground(texture, seed + 100, amounts), { x: 40 * PERIODS_M[texture] + 17, y: 2, kappa_deg: seed % 5, tilt_deg: -2 }, seed + 1),
      false,
    );
  return {
    kind: 'repeated, no overlap',
    name: `${texture} ${seed}, variation ${amounts.variation}, relief ${amounts.relief_m} m`,
    ...ofSeed(seed),
    isRight: false,
    make,
  };
}

/** One ground, seen from places several periods apart.  @param {Texture} texture @param {Amounts} amounts @param {number} seed @returns {Given} */
function sameGround(texture, amounts, seed) {
  const make = () => {
    const of = ground(texture, seed, amounts);
    return pairOf(photographed(of, { x: 0, y: 0, kappa_deg: 0 }, seed), photographed(of, { x: 28, y: 3, kappa_deg: 4, tilt_deg: 2 }, seed + 1), true);
  };
  return {
    kind: 'repeated, overlap',
    name: `${texture} ${seed}, variation ${amounts.variation}, relief ${amounts.relief_m} m`,
    ...ofSeed(seed),
    isRight: false,
    make,
  };
}
