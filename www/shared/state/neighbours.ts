/** Where the ground at a place of one image lies in another, by points around it that both show. */

import type { Position } from './pane';

/** Where a point lies in one image, then in another. */
export type Twice = readonly [number, number, number, number];

/** Points around a place that say where it lies in the other image. */
export const NEIGHBOURS = 12;
/** Fewer of them say only how far things move. */
const LEAST_OF_MAP = 6;

/** The median of some values; NaN of none. */
function middle(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}

/** How one coordinate of the other image follows from a place, by least squares about the neighbours' middle; null where they lie along a line. */
function mapped(places: readonly Twice[], at: Position, k: 2 | 3): number | null {
  const mean = (of: (place: Twice) => number) => places.reduce((sum, place) => sum + of(place), 0) / places.length;
  const [mx, my, mv] = [mean((p) => p[0]), mean((p) => p[1]), mean((p) => p[k])];
  let [xx, xy, yy, xv, yv] = [0, 0, 0, 0, 0];
  for (const place of places) {
    const [x, y, v] = [place[0] - mx, place[1] - my, place[k] - mv];
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xv += x * v;
    yv += y * v;
  }
  const determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-3 * xx * yy)) return null;
  return mv + ((yy * xv - xy * yv) * (at[0] - mx) + (xx * yv - xy * xv) * (at[1] - my)) / determinant;
}

/** The place that follows from those around it; null where they are too few, or lie along a line. */
export function affine(places: readonly Twice[], at: Position): Position | null {
  const [x, y] = places.length < LEAST_OF_MAP ? [null, null] : [mapped(places, at, 2), mapped(places, at, 3)];
  return x === null || y === null ? null : [x, y];
}

/** The place in the other image, moved with those around it where no more is known; null without any. */
export function movedWith(places: readonly Twice[], at: Position): Position | null {
  if (places.length === 0) return null;
  return affine(places, at) ?? [at[0] + middle(places.map((p) => p[2] - p[0])), at[1] + middle(places.map((p) => p[3] - p[1]))];
}

/** The place nearest to another one along a line of positions (stride 2); the one place where there is only one, and the same without any. */
export function onLine(positions: Float64Array, [x, y]: Position): Position {
  let best: [Position, number] | null = null;
  for (let i = 0; i + 3 < positions.length; i += 2) {
    const [ax = NaN, ay = NaN, bx = NaN, by = NaN] = positions.subarray(i, i + 4);
    const [dx, dy] = [bx - ax, by - ay];
    const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    const place: Position = [ax + share * dx, ay + share * dy];
    const distance = (place[0] - x) ** 2 + (place[1] - y) ** 2;
    if (best === null || distance < best[1]) best = [place, distance];
  }
  if (best !== null) return best[0];
  const [px, py] = positions;
  return px === undefined || py === undefined ? [x, y] : [px, py];
}

/** The least angle, by its sine, at which two lines say where they cross. */
const LEAST_SINE = 0.1;

/** Where two lines of positions (stride 2) cross; null where they do not, or hardly at an angle. */
export function crossing(a: Float64Array, b: Float64Array): Position | null {
  for (let i = 0; i + 3 < a.length; i += 2) {
    for (let k = 0; k + 3 < b.length; k += 2) {
      const [ax = NaN, ay = NaN, ux = NaN, uy = NaN] = [a[i], a[i + 1], (a[i + 2] ?? NaN) - (a[i] ?? NaN), (a[i + 3] ?? NaN) - (a[i + 1] ?? NaN)];
      const [bx = NaN, by = NaN, vx = NaN, vy = NaN] = [b[k], b[k + 1], (b[k + 2] ?? NaN) - (b[k] ?? NaN), (b[k + 3] ?? NaN) - (b[k + 1] ?? NaN)];
      const across = ux * vy - uy * vx;
      if (!(Math.abs(across) > LEAST_SINE * Math.hypot(ux, uy) * Math.hypot(vx, vy))) continue;
      const along = ((bx - ax) * vy - (by - ay) * vx) / across;
      const other = ((bx - ax) * uy - (by - ay) * ux) / across;
      if (along >= 0 && along <= 1 && other >= 0 && other <= 1) return [ax + along * ux, ay + along * uy];
    }
  }
  return null;
}
