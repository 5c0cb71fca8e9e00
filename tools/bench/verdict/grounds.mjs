/** Grounds of repeated texture, and photographs of them by central projection, of which everything is known. */

import { drawn, multiplied, noisy, transposed } from './pictures.mjs';
import { dot } from './views.mjs';

/**
 * @typedef {import('./views.mjs').View} View
 * @typedef {import('./views.mjs').Pair} Pair
 * @typedef {{ height: (x: number, y: number) => number, grey: (x: number, y: number) => number }} Ground lengths in m: x to the right and y down in a photograph that is not turned, heights towards the camera
 * @typedef {'roofs' | 'plantation' | 'waves' | 'facade'} Texture
 */

/** The textures, with the distance in m after which each repeats itself along x. */
export const PERIODS_M = /** @type {const} */ ({ roofs: 14, plantation: 6, waves: 9, facade: 4 });

const [WIDTH, HEIGHT, FOCAL_PX, FLYING_HEIGHT_M] = [600, 450, 600, 100];
const NOISE_GREY = 2;

/** A number from -1 to 1 for a place of a lattice.  @param {number} seed @param {number} i @param {number} j */
function lattice(seed, i, j) {
  let h = Math.imul(i + 40503, 374761393) ^ Math.imul(j + 9176, 668265263) ^ Math.imul(seed, 2246822519);
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 2 ** 31 - 1;
}

/** Smooth numbers from -1 to 1 that change over a distance of 1.  @param {number} seed @param {number} x @param {number} y */
function smooth(seed, x, y) {
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [u, v] = [x - i, y - j].map((t) => t * t * (3 - 2 * t));
  const mix = (/** @type {number} */ a, /** @type {number} */ b, /** @type {number | undefined} */ t = 0) => a + t * (b - a);
  return mix(mix(lattice(seed, i, j), lattice(seed, i + 1, j), u), mix(lattice(seed, i, j + 1), lattice(seed, i + 1, j + 1), u), v);
}

/** The rest after division by a period, from 0.  @param {number} x @param {number} period */
const within = (x, period) => x - period * Math.floor(x / period);

/** What every period shows.  @type {Record<Texture, (x: number, y: number) => number>} */
const PATTERNS = {
  roofs(x, y) {
    const [u, v] = [within(x, PERIODS_M.roofs), within(y, 12)];
    if (u > 10 || v > 8) return 105 + 20 * smooth(3, 2 * u, 2 * v) + (Math.abs(u - 12) < 0.15 ? 60 : 0);
    if (Math.hypot(u - 3, v - 2.5) < 0.7) return 40;
    const tiles = 12 * Math.sin(5 * u) + 10 * smooth(5, 3 * u, 3 * v);
    return (v < 4 ? 165 : 95) + tiles + (Math.abs(u - 7) < 0.6 && Math.abs(v - 5.5) < 0.5 ? 70 : 0);
  },
  plantation(x, y) {
    const [u, v] = [within(x, PERIODS_M.plantation), within(y, 5)];
    const crown = Math.hypot(u - 3, v - 2.5) + 0.25 * smooth(7, 2 * u, 2 * v);
    return crown < 1.7 ? 60 + 45 * (1.7 - crown) + 15 * smooth(8, 4 * u, 4 * v) : 150 + 10 * smooth(9, u, v);
  },
  waves(x, y) {
    const turns = (2 * Math.PI) / PERIODS_M.waves;
    return (
      110 +
      35 * Math.sin(turns * (x + 0.2 * y)) +
      18 * Math.sin(turns * (2 * x - y)) +
      12 * Math.sin(turns * (x + 3 * y)) +
      8 * Math.sin(turns * (5 * x + 2 * y))
    );
  },
  facade(x, y) {
    const [u, v] = [within(x, PERIODS_M.facade), within(y, 5)];
    if (u > 1.2 && u < 2.8 && v > 1.2 && v < 3.6) return Math.abs(u - 2) < 0.08 || Math.abs(v - 2.2) < 0.08 ? 200 : 45;
    if (v > 3.6 && v < 3.9 && u > 1 && u < 3) return 220;
    return 150 + (v < 0.25 ? -40 : 0) + 8 * smooth(11, 3 * u, 3 * v);
  },
};

/**
 * @param {Texture} texture @param {number} seed of what differs from period to period
 * @param {{ variation: number, relief_m: number }} amounts variation: in grey values
 * @returns {Ground}
 */
export function ground(texture, seed, { variation, relief_m }) {
  return {
    height: (x, y) => relief_m * (smooth(seed + 17, x / 45, y / 45) + 0.4 * smooth(seed + 29, x / 18, y / 18)),
    grey: (x, y) => PATTERNS[texture](x, y) + variation * (0.6 * smooth(seed, x / 1.5, y / 1.5) + 0.4 * smooth(seed + 1, x / 7, y / 7)),
  };
}

/**
 * @param {Ground} ground @param {{ x: number, y: number, kappa_deg: number, tilt_deg?: number }} place of the camera above it @param {number} seed of the noise
 */
export function photographed(ground, { x, y, kappa_deg, tilt_deg = 0 }, seed) {
  const [ck, sk, ct, st] = [kappa_deg, tilt_deg].flatMap((deg) => [Math.cos((deg * Math.PI) / 180), Math.sin((deg * Math.PI) / 180)]);
  const kappa = [
    [ck ?? 1, sk ?? 0, 0],
    [-(sk ?? 0), ck ?? 1, 0],
    [0, 0, 1],
  ];
  const tilt = [
    [ct ?? 1, 0, -(st ?? 0)],
    [0, 1, 0],
    [st ?? 0, 0, ct ?? 1],
  ];
  const rotation = multiplied(kappa, tilt);
  const world = transposed(rotation);
  const picture = drawn(WIDTH, HEIGHT, (col, row) => {
    const [dx = 0, dy = 0, dz = 1] = world.map((line) => dot(line, [(col + 0.5 - WIDTH / 2) / FOCAL_PX, (row + 0.5 - HEIGHT / 2) / FOCAL_PX, 1]));
    let s = FLYING_HEIGHT_M / dz;
    // The ground rises less steeply than rays fall: the fixed point is reached.
    for (let k = 0; k < 5; k++) s = (FLYING_HEIGHT_M - ground.height(x + s * dx, y + s * dy)) / dz;
    return ground.grey(x + s * dx, y + s * dy);
  });
  return { view: { picture: noisy(picture, NOISE_GREY, seed), fiducials: [] }, rotation, centre: [x, y, -FLYING_HEIGHT_M] };
}

/** The pair of two photographs of one ground; without a pose of two.  @param {ReturnType<typeof photographed>} a @param {ReturnType<typeof photographed>} b @param {boolean} isOne @returns {Pair} */
export function pairOf(a, b, isOne) {
  const camera = { focal_mm: FOCAL_PX / 1000, pixel_mm: 0.001 };
  const base = a.centre.map((v, k) => v - (b.centre[k] ?? 0));
  const pose = { rotation: multiplied(b.rotation, transposed(a.rotation)), direction: b.rotation.map((row) => dot(row, base)) };
  return { left: a.view, right: b.view, camera, pose: isOne ? pose : null };
}
