/** Where a picture lies in a system that no affine map of the whole leads to well enough: in cells, each with the places of its corners. Pure. */
import { affine, departure, scaleOf } from './under';
import { mapped } from '../../shared/state/plane-map';
import type { Place } from './under';
import type { Affine } from '../../shared/state/plane-map';

/** From positions in px (column and row, stride 2) to their places in the other system. */
export type Exact = (pixels: Float64Array) => readonly Place[];

interface Size {
  width: number;
  height: number;
}

export interface Cells {
  /** Along each side. */
  number: number;
  /** Of their corners, row by row. */
  corners: readonly Place[];
  /** So far what they show may lie outside of where the affine map of the whole has it, px. */
  margin: number;
}

export interface Sheet {
  /** From pixels to the other system. */
  whole: Affine;
  /** Null where the affine map of the whole is near enough. */
  cells: Cells | null;
  /** How far what is drawn lies from where it belongs, at most, px of the picture. */
  departs: number;
}

/** The affine map is found by so many places along each side: the corners of the picture, the middles of its edges, and between them. */
const PLACES = 5;
/** What is half a pixel off is not seen; cells are made to leave half of that. */
export const NEAR_PX = 0.5;
const AIM_PX = 0.25;
/** Along each side: more take longer to convert than a map may take to be drawn. */
const MOST_CELLS = 24;

/** The affine map of a whole picture, and how far it departs; null where not all of the picture lies in the other system. */
export function wholeOf(exact: Exact, size: Size): Sheet | null {
  const pixels = latticeOf(size, PLACES - 1);
  const there = exact(flat(pixels));
  if (!there.every(([x, y]) => Number.isFinite(x + y))) return null;
  const whole = affine(pixels, there);
  return whole === null ? null : { whole, cells: null, departs: departure(whole, pixels, there) / scaleOf(whole) };
}

/** In cells where the affine map of the whole departs by more than half a pixel. */
export function sheetOf(exact: Exact, size: Size): Sheet | null {
  const plain = wholeOf(exact, size);
  if (plain === null || plain.departs <= NEAR_PX) return plain;
  const { whole, departs } = plain;
  // Half as long cells leave a quarter of it.
  const number = Math.min(MOST_CELLS, Math.ceil(Math.sqrt(departs / AIM_PX)));
  const fine = exact(flat(latticeOf(size, 2 * number)));
  if (!fine.every(([x, y]) => Number.isFinite(x + y))) return plain;
  const side = 2 * number + 1;
  const cells: Cells = { number, corners: fine.filter((_, i) => (i % side) % 2 === 0 && Math.floor(i / side) % 2 === 0), margin: Math.ceil(2 * departs) };
  const left = latticeOf(size, 2 * number).reduce((most, pixel, i) => {
    const [x, y] = placeIn(cells, size, pixel);
    return Math.max(most, Math.hypot(x - (fine[i]?.[0] ?? NaN), y - (fine[i]?.[1] ?? NaN)));
  }, 0);
  return { whole, cells, departs: left / scaleOf(whole) };
}

/** Where a position in px lies, between the corners of its cell. */
export function placeIn({ number, corners }: Cells, { width, height }: Size, [x, y]: Place): [number, number] {
  const [across, down] = [(x / width) * number, (y / height) * number];
  const [column, row] = [across, down].map((at) => Math.min(number - 1, Math.max(0, Math.floor(at)))) as [number, number];
  const [u, v] = [across - column, down - row];
  const corner = (right: number, below: number): Place => corners[(row + below) * (number + 1) + column + right] ?? [NaN, NaN];
  const between = (axis: 0 | 1) =>
    (1 - v) * ((1 - u) * corner(0, 0)[axis] + u * corner(1, 0)[axis]) + v * ((1 - u) * corner(0, 1)[axis] + u * corner(1, 1)[axis]);
  return [between(0), between(1)];
}

/** The affine map of a part of the picture, by its corners; that of the whole without cells. */
export function affineOfPart(
  { whole, cells }: Pick<Sheet, 'whole' | 'cells'>,
  size: Size,
  [left, top, right, bottom]: readonly [number, number, number, number],
): Affine {
  if (cells === null) return whole;
  const pixels: Place[] = [
    [left, top],
    [right, top],
    [left, bottom],
    [right, bottom],
  ];
  const there = pixels.map((pixel) => placeIn(cells, size, pixel));
  return affine(pixels, there) ?? whole;
}

/** Positions in px all over a picture, so many steps along each side, row by row. */
function latticeOf({ width, height }: Size, steps: number): Place[] {
  const along = Array.from({ length: steps + 1 }, (_, i) => i / steps);
  return along.flatMap((y) => along.map((x): Place => [x * width, y * height]));
}

function flat(places: readonly Place[]): Float64Array {
  return Float64Array.from(places.flat());
}

/** As an affine map has it, where that is exact. */
export function throughout(by: Affine): Sheet {
  return { whole: by, cells: null, departs: 0 };
}

/** Positions in px by an affine map. */
export function byAffine(by: Affine, pixels: Float64Array): Place[] {
  return Array.from({ length: pixels.length / 2 }, (_, i) => mapped(by, pixels[2 * i] ?? NaN, pixels[2 * i + 1] ?? NaN));
}
