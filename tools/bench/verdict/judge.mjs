/**
 * Whether a pose is wrong. It is where no pose exists: without overlap or base, or mirrored. Elsewhere it is wrong where it is off by more than 1°,
 * in rotation or base direction, and lies outside its own region of 99.9 % as well: an error that is stated is no lie, and one below 1° hurts
 * nobody who was told of standard errors. Both are counted by themselves too. A truth that is a reconstruction itself adds what it may be off by.
 */

import { directionError, poseOf, rotationError } from '../../score.mjs';
import { multiplied, transposed } from './pictures.mjs';
import { dot } from './views.mjs';

/**
 * @typedef {import('../../../pkg/node.js').RelativeOrientation} RelativeOrientation
 * @typedef {import('../../../pkg/node.js').FiveParameters} FiveParameters
 * @typedef {import('./views.mjs').Pose} Pose
 * @typedef {{ rotation_deg: number, direction_deg: number, over_deg: number, inRegion: number }} Errors
 *   over_deg: by how much the larger of them exceeds what is allowed; inRegion: the largest error of ω φ κ by bz by its half-width of 99.9 %, jointly
 */

const MOST_DEG = 1;

/** Probability of the region, and of the interval of each of five unknowns that all hold jointly (Bonferroni). */
const OUTSIDE_REGION = 0.001;
const UNKNOWNS = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);

/** @param {RelativeOrientation} orientation @param {Pose} truth @returns {Errors} */
export function errorsOf(orientation, truth) {
  const pose = poseOf(orientation);
  const rotation_deg = rotationError(pose.rotation, truth.rotation);
  const direction_deg = directionError(pose.direction, truth.direction);
  return { rotation_deg, direction_deg, over_deg: overOf(rotation_deg, direction_deg, truth), inRegion: inRegion(orientation, truth) };
}

/** By how much the larger error exceeds what is allowed.  @param {number} rotation_deg @param {number} direction_deg @param {Pose} truth */
export function overOf(rotation_deg, direction_deg, { uncertain = { rotation_deg: 0, direction_deg: 0 } }) {
  return Math.max(rotation_deg - uncertain.rotation_deg, direction_deg - uncertain.direction_deg) - MOST_DEG;
}

/** @param {Errors} errors */
export const isOff = ({ over_deg }) => over_deg > 0;

/** @param {Errors} errors */
export const isOutside = ({ inRegion }) => !(inRegion <= 1);

/** @param {Errors | null} errors of a pair that has a pose */
export const isWrong = (errors) => errors === null || (isOff(errors) && isOutside(errors));

/** The largest error of ω φ κ by bz by its half-width in a joint region; at most 1 where the region holds the truth.  @param {RelativeOrientation} orientation @param {Pose} truth @param {number} [outside] probability that it does not */
export function inRegion(orientation, truth, outside = OUTSIDE_REGION) {
  const { half_widths_95, degrees_of_freedom, sigma0_a_priori_mm } = orientation;
  const unknowns = unknownsOf(truth, orientation);
  if (!half_widths_95 || !unknowns) return Infinity;
  const freedom = sigma0_a_priori_mm === null ? degrees_of_freedom : Infinity;
  const wider = student(outside / UNKNOWNS.length, freedom) / student(0.05, freedom);
  return Math.max(...UNKNOWNS.map((name) => Math.abs(difference(name, orientation[name], unknowns[name])) / (wider * half_widths_95[name])));
}

/** @param {keyof FiveParameters} name @param {number} a @param {number} b */
function difference(name, a, b) {
  if (name.endsWith('mm')) return a - b;
  return ((((a - b + 180) % 360) + 360) % 360) - 180;
}

/**
 * The true ω φ κ by bz in the photo axes and at the base of an orientation; null where the true base points the other way.
 * The inverse of `poseOf`.
 * @param {Pose} truth @param {RelativeOrientation} of @returns {FiveParameters | null}
 */
export function unknownsOf({ rotation, direction }, { turn_deg, base_mm }) {
  const flip = [1, -1, -1];
  const flipped = (/** @type {number[][]} */ m) => m.map((row, r) => row.map((v, c) => v * (flip[r] ?? 0) * (flip[c] ?? 0)));
  const [c, s] = [Math.cos((turn_deg * Math.PI) / 180), Math.sin((turn_deg * Math.PI) / 180)];
  const axes = [
    [c, s, 0],
    [-s, c, 0],
    [0, 0, 1],
  ];
  const m = multiplied(multiplied(axes, flipped(rotation)), transposed(axes));
  // The projection centre of the right photo, in the left one's system.
  const base = transposed(rotation).map((row, r) => -dot(row, direction) * (flip[r] ?? 0));
  const [bx = 0, by = 0, bz = 0] = axes.map((row) => dot(row, base));
  if (bx * base_mm <= 0) return null;
  const [first = [], second = [], third = []] = m;
  const deg = (/** @type {number} */ radians) => (radians * 180) / Math.PI;
  return {
    omega_deg: deg(Math.atan2(-(third[1] ?? 0), third[2] ?? 0)),
    phi_deg: deg(Math.asin(Math.max(-1, Math.min(1, third[0] ?? 0)))),
    kappa_deg: deg(Math.atan2(-(second[0] ?? 0), first[0] ?? 0)),
    by_mm: (by / bx) * base_mm,
    bz_mm: (bz / bx) * base_mm,
  };
}

/**
 * The value that Student's distribution exceeds, on both sides together, with a probability.
 * @param {number} outside the probability @param {number} freedom degrees of freedom
 */
export function student(outside, freedom) {
  const z = normalLimit(outside);
  if (!Number.isFinite(freedom)) return z;
  // Abramowitz & Stegun 1964, Handbook of Mathematical Functions, 26.7.5.
  const terms = [(z ** 3 + z) / 4, (5 * z ** 5 + 16 * z ** 3 + 3 * z) / 96, (3 * z ** 7 + 19 * z ** 5 + 17 * z ** 3 - 15 * z) / 384];
  return terms.reduce((sum, term, k) => sum + term / freedom ** (k + 1), z);
}

/** The same of the normal distribution (Abramowitz & Stegun 1964, 26.2.23, to 0.0005).  @param {number} outside */
function normalLimit(outside) {
  const t = Math.sqrt(-2 * Math.log(outside / 2));
  return t - (2.515517 + 0.802853 * t + 0.010328 * t * t) / (1 + 1.432788 * t + 0.189269 * t * t + 0.001308 * t ** 3);
}
