/** What the observations of images say of other places: where they lie in another image, and on the ground. */
import { affine, movedWith, NEIGHBOURS } from '../../shared/state/neighbours';
import type { Twice } from '../../shared/state/plane-map';
import type { Position } from '../../shared/state/pane';
import { remember } from '../../shared/state/remember';
import type { ImagePoints } from './facts';
import type { ViewCamera, ViewPoints } from './view';

/** Where each point lies in an image. */
const placesOf = new WeakMap<ImagePoints, ReadonlyMap<number, Position>>();

function placesByPoint(of: ImagePoints): ReadonlyMap<number, Position> {
  const known = placesOf.get(of);
  if (known !== undefined) return known;
  const made = new Map([...of.points].map((point, i): [number, Position] => [point, [of.places[2 * i] ?? NaN, of.places[2 * i + 1] ?? NaN]]));
  placesOf.set(of, made);
  return made;
}

/** Where an image shows a point; null where it does not. */
export function placeOfPoint(of: ImagePoints, point: number): Position | null {
  return placesByPoint(of).get(point) ?? null;
}

/** The elements nearest to a place, nearest first. */
function nearest(list: readonly Twice[], [x, y]: Position): Twice[] {
  const far = list.map((twice) => ({ twice, distance: (twice[0] - x) ** 2 + (twice[1] - y) ** 2 }));
  return far
    .sort((a, b) => a.distance - b.distance)
    .slice(0, NEIGHBOURS)
    .map(({ twice }) => twice);
}

const commonOf = new WeakMap<ImagePoints, WeakMap<ImagePoints, readonly Twice[]>>();

/** The points that both images show, accepted in both. */
function common(from: ImagePoints, to: ImagePoints): readonly Twice[] {
  const known = commonOf.get(from)?.get(to);
  if (known !== undefined) return known;
  const others = placesByPoint(to);
  const rejected = new Set([...to.points].filter((_, i) => to.parts[i] !== 0));
  const made = [...from.points].flatMap((point, i): Twice[] => {
    const other = others.get(point);
    if (other === undefined || from.parts[i] !== 0 || rejected.has(point)) return [];
    return [[from.places[2 * i] ?? NaN, from.places[2 * i + 1] ?? NaN, ...other]];
  });
  const ofFrom = commonOf.get(from) ?? new WeakMap<ImagePoints, readonly Twice[]>();
  commonOf.set(from, ofFrom.set(to, made));
  return made;
}

/** Where the ground at a place of one image lies in another, by the points around it that both show; null without any. */
export function inOtherImage(from: ImagePoints, to: ImagePoints, at: Position): Position | null {
  return movedWith(nearest(common(from, to), at), at);
}

/** X, Y, Z of the ground at a place of an image, by the points around it; null where they are too few. */
export const groundAt = remember((of: ImagePoints, { positions }: ViewPoints, x: number, y: number): [number, number, number] | null => {
  const at: Position = [x, y];
  const coordinate = (point: number, axis: number) => positions[3 * point + axis] ?? NaN;
  const known = [...of.points].flatMap((point, i): [Twice, number][] => {
    const twice: Twice = [of.places[2 * i] ?? NaN, of.places[2 * i + 1] ?? NaN, coordinate(point, 0), coordinate(point, 1)];
    return of.parts[i] === 0 && !Number.isNaN(twice[2]) ? [[twice, coordinate(point, 2)]] : [];
  });
  const heights = new Map(known);
  const near = nearest([...heights.keys()], at);
  const plan = affine(near, at);
  const height = affine(
    near.map((twice): Twice => [twice[0], twice[1], heights.get(twice) ?? NaN, 0]),
    at,
  );
  return plan === null || height === null ? null : [...plan, height[0]];
});

/** Where an image shows the ground at x, y of the block, by the points around it; null where they are too few. */
export function placeOfGround(of: ImagePoints, { positions }: ViewPoints, at: Position): Position | null {
  const known = [...of.points].flatMap((point, i): Twice[] => {
    const twice: Twice = [positions[3 * point] ?? NaN, positions[3 * point + 1] ?? NaN, of.places[2 * i] ?? NaN, of.places[2 * i + 1] ?? NaN];
    return of.parts[i] === 0 && !Number.isNaN(twice[0]) ? [twice] : [];
  });
  return affine(nearest(known, at), at);
}

/** Photo coordinates in mm, x right, y up, from the principal point; null where the side of a pixel is not known. */
export function photoMm({ calibrated, given }: ViewCamera, [x, y]: Position): Position | null {
  const camera = calibrated ?? given;
  const side = camera?.pixel_mm ?? given?.pixel_mm;
  if (camera === null || side == null) return null;
  return [side * (x - camera.principal_point_px[0]), side * (camera.principal_point_px[1] - y)];
}
