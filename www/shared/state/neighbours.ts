/** Where the ground at a place of one image lies in another, by points around it that both show. */

import type { Position } from './pane';
import { fitted, mapped } from './plane-map';
import type { Twice } from './plane-map';

/** Points around a place that say where it lies in the other image. */
export const NEIGHBOURS = 12;
/** Fewer of them say only how far things move. */
const LEAST_OF_MAP = 6;
/** They lie along a line where 1 minus the squared correlation of x and y is below that. */
const ALONG_A_LINE = 1e-3;

/** The median of some values; NaN of none. */
function middle(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}

/** The place that follows from those around it; null where they are too few, or lie along a line. */
export function affine(places: readonly Twice[], at: Position): Position | null {
  if (places.length < LEAST_OF_MAP) return null;
  const map = fitted(places.length, (i) => places[i] ?? [NaN, NaN, NaN, NaN], ALONG_A_LINE);
  return map === null ? null : mapped(map, ...at);
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
