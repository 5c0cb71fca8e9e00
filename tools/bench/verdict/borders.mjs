/** Scans that have nothing in common but the camera's frame: dark border, fiducial marks, data strip; and parts of one frame. */

import { flight_presets } from '../../../pkg/node.js';
import { have } from '../data.mjs';
import { PHOTOGRAPHS } from './apart.mjs';
import { flight } from './flights.mjs';
import { photograph } from './photographs.mjs';
import { drawn, greyAt, noisy } from './pictures.mjs';
import { ofFolder, ofSeed } from './sites.mjs';

/** @typedef {import('./pairs.mjs').Given} Given @typedef {import('./pictures.mjs').Picture} Picture @typedef {import('./views.mjs').Pair} Pair */

const BORDER_PX = 60;

/** @returns {Given[]} */
export function borders() {
  const flights = Array.from({ length: 12 }, (_, k) => {
    const [preset, seed] = [flight_presets()[k % 4] ?? 'paper', 740 + k];
    const make = () => framed(flight(preset, seed).left.picture, flight(preset, seed + 20).right.picture, k);
    return { kind: 'common frame', name: `${preset} ${seed}`, ...ofSeed(seed), isRight: false, make };
  });
  const there = PHOTOGRAPHS.filter(([folder]) => have(folder));
  const photographs = there.flatMap(([folder, file], k) => {
    const other = there.find(([second], l) => l > k && ofFolder(second).site !== ofFolder(folder).site && ofFolder(second).part === ofFolder(folder).part);
    if (!other) return [];
    const make = () => framed(photograph(folder, file).picture, photograph(other[0], other[1]).picture, k);
    return [{ kind: 'common frame', name: `${folder}/${file} and ${other.join('/')}`, ...ofFolder(folder), isRight: false, make }];
  });
  return [...flights, ...photographs, ...films()];
}

/** Real films, of which no camera is known: other years and runs, and the halves of one frame.  @returns {Given[]} */
function films() {
  const of = /** @type {const} */ ([
    ['film_fiducials_canberra', 'film_08320661.jpg', 'film_0cec8b13.jpg'],
    ['film_fiducials_canberra', 'film_5bdd5cf4.jpg', 'film_0cec8b13.jpg'],
    ['film_kh9_halves', 'half_a.jpg', 'half_b.jpg'],
  ]);
  return of
    .filter(([folder]) => have(folder))
    .flatMap(([folder, a, b]) =>
      [null, { focal_mm: 0.9, pixel_mm: 0.001 }].map((camera) => ({
        kind: 'common frame',
        name: `${folder} ${a} ${b}${camera ? ', camera guessed' : ''}`,
        ...ofFolder(folder),
        isRight: false,
        make: () => ({ left: photograph(folder, a), right: photograph(folder, b), camera, pose: null }),
      })),
    );
}

/** Two pictures in frames of one camera, scanned a little apart.  @param {Picture} one @param {Picture} other @param {number} k @returns {Pair} */
function framed(one, other, k) {
  const [width, height] = [Math.min(one.width, other.width), Math.min(one.height, other.height)];
  const scan = (/** @type {Picture} */ picture, /** @type {number} */ x, /** @type {number} */ y) => ({
    picture: noisy(inFrame(picture, width, height, x, y), 2, 3 * k + x + 1),
    fiducials: [],
  });
  const side = width + 2 * BORDER_PX;
  return { left: scan(one, 0, 0), right: scan(other, 3 + (k % 4), 5 - (k % 3)), camera: { focal_mm: 1, pixel_mm: 1 / side }, pose: null };
}

/** @param {Picture} picture @param {number} width @param {number} height of what is seen of it @param {number} x @param {number} y by which the frame lies shifted @returns {Picture} */
function inFrame(picture, width, height, x, y) {
  return drawn(width + 2 * BORDER_PX, height + 2 * BORDER_PX, (c, r) => {
    const [col, row] = [c - x - BORDER_PX, r - y - BORDER_PX];
    if (col >= 0 && row >= 0 && col < width && row < height) return greyAt(picture, col, row);
    return mark(col, row, width, height) ?? strip(col, row) ?? 14;
  });
}

/** A bright cross in a ring at the corners and in the middle of the sides.  @param {number} col @param {number} row @param {number} width @param {number} height */
function mark(col, row, width, height) {
  for (const [u, v] of [-30, width / 2, width + 30].flatMap((u) => [-30, height / 2, height + 30].map((v) => [u, v]))) {
    const [dx, dy] = [col - (u ?? 0), row - (v ?? 0)];
    const distance = Math.hypot(dx, dy);
    if (distance < 18 && (Math.min(Math.abs(dx), Math.abs(dy)) < 2 || Math.abs(distance - 14) < 1.5)) return 235;
  }
  return null;
}

/** What is printed along the upper side, as numbers and a scale would be.  @param {number} col @param {number} row */
function strip(col, row) {
  if (row < -50 || row > -16 || col < 60) return null;
  const [i, j] = [Math.floor(col / 5), Math.floor(row / 6)];
  const dot = Math.imul(i * 31 + 7, j * 17 + 113) ^ Math.imul(i, 2654435761);
  return (dot >>> 8) % 3 === 0 ? 220 : null;
}
