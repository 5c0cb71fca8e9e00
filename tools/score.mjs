/**
 * Scores matches against truth. Right is a match
 * - by a dense map: within 1.5 px of where the surface at the left pixel, or at one of its 8 neighbours, is seen (edge precision);
 * - by a known pose: Sampson distance to the true epipolar geometry at most 1.5 px. It cannot see errors along the line: an upper bound.
 * All positions in px, the centre of the top-left pixel at (0.5, 0.5); matches flat, stride 5 (x_left, y_left, x_right, y_right, measure).
 */

/** So far from the truth a match may be. */
export const LIMIT_PX = 1.5;

/** @typedef {{ right: number, share: number }} Score how many are right, and their share */
/** @typedef {{ f: number, fy?: number, cx: number, cy: number, k1: number, k2: number }} Pinhole in px; the principal point as positions are; fy: where pixels are not square */
/** @typedef {{ width: number, height: number, at: (col: number, row: number) => [number, number] | null }} DenseMap where the centre of a left pixel is seen in the right image; null where it is hidden */
/** @typedef {number[][]} Matrix rows of a 3 x 3 matrix */

/** @param {Float64Array} matches @param {DenseMap} map @returns {Score} */
export function edgePrecision(matches, map) {
  return share(matches, (xl, yl, xr, yr) => placesOf(map, xl, yl).some(([x, y]) => Math.hypot(x - xr, y - yr) <= LIMIT_PX));
}

/** Where the surface at a left position and at the 8 pixels around it is seen in the right image.  @param {DenseMap} map @param {number} xl @param {number} yl */
export function placesOf(map, xl, yl) {
  const [col, row] = [roundHalfEven(xl - 0.5), roundHalfEven(yl - 0.5)];
  const [dx, dy] = [xl - 0.5 - col, yl - 0.5 - row];
  /** @type {[number, number][]} */
  const places = [];
  for (let dr = -1; dr <= 1; dr++) {
    for (let dc = -1; dc <= 1; dc++) {
      const seen = map.at(clamp(col + dc, map.width), clamp(row + dr, map.height));
      if (seen) places.push([seen[0] + dx, seen[1] + dy]);
    }
  }
  return places;
}

/**
 * @param {Float64Array} matches @param {Pinhole} left @param {Pinhole} right
 * @param {Matrix} rotation @param {number[]} direction X_right = R X_left + t, camera x right, y down, z forward
 * @returns {Score}
 */
export function sampsonShare(matches, left, right, rotation, direction) {
  const essential = multiply(cross(direction), rotation);
  const f = (left.f + right.f) / 2;
  return share(matches, (xl, yl, xr, yr) => {
    const [x, y] = [ray(xl, yl, left), ray(xr, yr, right)];
    const [ex, ey] = [essential.map((row) => dot(row, x)), essential.map((row) => dot(row, y))];
    const slope = ex
      .slice(0, 2)
      .concat(ey.slice(0, 2))
      .reduce((sum, v) => sum + v * v, 0);
    return (Math.abs(dot(y, ex)) / Math.sqrt(slope)) * f <= LIMIT_PX;
  });
}

/**
 * What the angles and the base of a dependent relative orientation mean to a camera with y down and z forward.
 * @param {{ omega_deg: number, phi_deg: number, kappa_deg: number, by_mm: number, bz_mm: number, base_mm: number, turn_deg?: number }} o
 *   `turn_deg`: by which the axes of all these are turned anticlockwise from those of the photos
 * @returns {{ rotation: Matrix, direction: number[] }} X_right = R X_left + t, t of unit length
 */
export function poseOf(o) {
  const axes = turn(2, o.turn_deg ?? 0);
  const back = turn(2, -(o.turn_deg ?? 0));
  const m = multiply(multiply(back, multiply(multiply(turn(2, o.kappa_deg), turn(1, o.phi_deg)), turn(0, o.omega_deg))), axes);
  const flip = [1, -1, -1];
  const rotation = m.map((row, r) => row.map((v, c) => v * (flip[r] ?? 0) * (flip[c] ?? 0)));
  const turned = [o.base_mm, o.by_mm, o.bz_mm];
  const base = back.map((row) => dot(row, turned));
  const t = m.map((row, r) => -(flip[r] ?? 0) * dot(row, base));
  const length = Math.hypot(...t);
  return { rotation, direction: t.map((v) => v / length) };
}

/** The angle in degrees between two rotations.  @param {Matrix} a @param {Matrix} b */
export function rotationError(a, b) {
  const trace = a.reduce((sum, row, r) => sum + dot(row, b[r] ?? []), 0);
  return degrees(Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2))));
}

/** The angle in degrees between two directions.  @param {number[]} a @param {number[]} b */
export function directionError(a, b) {
  return degrees(Math.acos(Math.min(1, Math.max(-1, dot(a, b) / Math.hypot(...a) / Math.hypot(...b)))));
}

/** @param {Float64Array} matches @param {(xl: number, yl: number, xr: number, yr: number) => boolean} isRight @returns {Score} */
export function share(matches, isRight) {
  let right = 0;
  for (let i = 0; i < matches.length; i += 5) {
    const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = matches.subarray(i, i + 4);
    if (isRight(xl, yl, xr, yr)) right += 1;
  }
  return { right, share: matches.length > 0 ? right / (matches.length / 5) : 0 };
}

/** The undistorted direction of a pixel.  @param {number} x @param {number} y @param {Pinhole} camera @returns {number[]} */
function ray(x, y, { f, fy = f, cx, cy, k1, k2 }) {
  const [xd, yd] = [(x - cx) / f, (y - cy) / fy];
  let [xu, yu] = [xd, yd];
  for (let i = 0; i < 10; i++) {
    const r2 = xu * xu + yu * yu;
    const factor = 1 + k1 * r2 + k2 * r2 * r2;
    [xu, yu] = [xd / factor, yd / factor];
  }
  return [xu, yu, 1];
}

/** The turn of the axes about one of them.  @param {0 | 1 | 2} axis @param {number} deg @returns {Matrix} */
function turn(axis, deg) {
  const [s, c] = [Math.sin((deg * Math.PI) / 180), Math.cos((deg * Math.PI) / 180)];
  if (axis === 0)
    return [
      [1, 0, 0],
      [0, c, s],
      [0, -s, c],
    ];
  if (axis === 1)
    return [
      [c, 0, -s],
      [0, 1, 0],
      [s, 0, c],
    ];
  return [
    [c, s, 0],
    [-s, c, 0],
    [0, 0, 1],
  ];
}

/** @param {number[]} t @returns {Matrix} */
const cross = ([x = 0, y = 0, z = 0]) => [
  [0, -z, y],
  [z, 0, -x],
  [-y, x, 0],
];

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a.reduce((sum, v, i) => sum + v * (b[i] ?? 0), 0);

/** @param {Matrix} a @param {Matrix} b @returns {Matrix} */
const multiply = (a, b) =>
  a.map((row) =>
    [0, 1, 2].map((c) =>
      dot(
        row,
        b.map((r) => r[c] ?? 0),
      ),
    ),
  );

/** @param {number} radians */
const degrees = (radians) => (radians * 180) / Math.PI;

/** @param {number} i @param {number} size */
const clamp = (i, size) => Math.min(size - 1, Math.max(0, i));

/** To the nearest whole number, halves to the even one.  @param {number} v */
function roundHalfEven(v) {
  const floor = Math.floor(v);
  if (v - floor !== 0.5) return Math.round(v);
  return floor % 2 === 0 ? floor : floor + 1;
}
