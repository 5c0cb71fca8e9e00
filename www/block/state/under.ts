/** Plane maps: from the pixels of an orthophoto to its system, and from that to the system of a block. */
import type { Georeference } from '../../../pkg/wasm/tiepoint.js';
import { fitted, mapped } from '../../shared/state/plane-map';
import type { Affine, Twice } from '../../shared/state/plane-map';

/** Side of a tile of an orthophoto's picture, px of the halved picture. */
export const TILE_SIDE = 256;

export const SAME: Affine = { a: 1, b: 0, c: 0, d: 1, e: 0, f: 0 };

/** From pixels to the ground. */
export function affineOf({ origin, by_column: column, by_row: row }: Georeference): Affine {
  return { a: column[0], b: column[1], c: row[0], d: row[1], e: origin[0], f: origin[1] };
}

/** First `inner`, then `outer`. */
export function after(outer: Affine, inner: Affine): Affine {
  const [a, b] = mapped({ ...outer, e: 0, f: 0 }, inner.a, inner.b);
  const [c, d] = mapped({ ...outer, e: 0, f: 0 }, inner.c, inner.d);
  const [e, f] = mapped(outer, inner.e, inner.f);
  return { a, b, c, d, e, f };
}

/** How much longer lengths become, in the mean of all directions. */
export function scaleOf({ a, b, c, d }: Affine): number {
  return Math.sqrt(Math.abs(a * d - b * c));
}

export type Place = readonly [number, number];

/** Turn, scale and shift that bring places nearest to others of the same number; null from fewer than two, or of places that are one. */
export function similarity(from: readonly Place[], to: readonly Place[]): Affine | null {
  if (from.length < 2 || from.length !== to.length) return null;
  const [fx, fy] = middle(from);
  const [tx, ty] = middle(to);
  let [along, across, size] = [0, 0, 0];
  from.forEach(([x, y], i) => {
    const [u, v] = [x - fx, y - fy];
    const [p, q] = [(to[i]?.[0] ?? 0) - tx, (to[i]?.[1] ?? 0) - ty];
    along += u * p + v * q;
    across += u * q - v * p;
    size += u * u + v * v;
  });
  if (!(size > 0)) return null;
  const [a, b] = [along / size, across / size];
  if (!(Math.hypot(a, b) > 0)) return null;
  const turned = { a, b, c: -b, d: a, e: 0, f: 0 };
  const [x, y] = mapped(turned, fx, fy);
  return { ...turned, e: tx - x, f: ty - y };
}

/** The six parameters that bring places nearest to others of the same number: of places on one line those of a similarity; null where that has none either. */
export function affine(from: readonly Place[], to: readonly Place[]): Affine | null {
  const place = (i: number): Twice => [from[i]?.[0] ?? NaN, from[i]?.[1] ?? NaN, to[i]?.[0] ?? NaN, to[i]?.[1] ?? NaN];
  const map = from.length < 3 || from.length !== to.length ? null : fitted(from.length, place, ON_A_LINE);
  return map !== null && Math.abs(map.a * map.d - map.b * map.c) > 0 ? map : similarity(from, to);
}

/** Places lie on one line where 1 minus their squared correlation is below that. */
const ON_A_LINE = 1e-9;

/** How far an affine map leaves places from where they belong, in the unit of these: the largest of all. */
export function departure(by: Affine, from: readonly Place[], to: readonly Place[]): number {
  return from.reduce((most, [x, y], i) => {
    const [u, v] = mapped(by, x, y);
    return Math.max(most, Math.hypot(u - (to[i]?.[0] ?? NaN), v - (to[i]?.[1] ?? NaN)));
  }, 0);
}

function middle(places: readonly Place[]): [number, number] {
  const sum = places.reduce(([x, y], [px, py]) => [x + px, y + py], [0, 0]);
  return [(sum[0] ?? 0) / places.length, (sum[1] ?? 0) / places.length];
}
