/** How the system of a block lies to that of an orthophoto, where both say where they lie on the earth. */
import { geographic_positions, system_coordinates } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { GivenOrthophoto } from './placing';
import { affine, affineOf, departure, scaleOf } from './under';
import { inverse, mapped } from '../../shared/state/plane-map';
import type { Place } from './under';
import type { Affine } from '../../shared/state/plane-map';
import type { BlockView } from './view';

/** What leads from one to the other, and whether that is as near as what is measured in one of both needs it in the other; or why nothing does. */
export type Between = { kind: 'affine'; toOrthophoto: Affine; crs: string; isNear: boolean } | { kind: 'problem'; text: string };

/** An affine map may be wrong by so many pixels of the orthophoto, or by this share of the block, which is a pixel of a screen that shows all of it. */
const MOST_PIXELS = 3;
const MOST_SHARE = 0.001;

/** So many points are enough to say where the ground is. */
const ENOUGH = 4000;

/** Points beyond this share on either side do not say how far the block reaches: some may be wrong. */
const BEYOND = 0.02;

/** The system of an orthophoto: of one that does not say any, that which was chosen for the results of the block. */
function crsOf({ epsg, described }: GivenOrthophoto['info'], chosen: string | null): string | null {
  if (epsg !== null) return `EPSG:${String(epsg)}`;
  // One without a code is another than that of the block, as far as is known. A project of an earlier release does not say it.
  return (described ?? null) === null ? chosen : null;
}

/** An affine map by places all over the block, on its ground; null where one of both does not say where it lies on the earth. */
export const betweenSystems = remember((orthophoto: GivenOrthophoto, view: BlockView): Between | null => {
  const { origin } = view;
  const crs = crsOf(orthophoto.info, view.crs);
  const places = placesOf(view);
  if (origin === null || crs === null || places === null) return null;
  const { from, height } = places;
  try {
    const local = from.flatMap(([x, y]) => [x, y, height]);
    const onEarth = geographic_positions(Float64Array.from([origin.longitude_deg, origin.latitude_deg, origin.height_m, ...local]));
    const there = system_coordinates(crs, onEarth);
    const to = from.map((_, i): Place => [there[3 * i] ?? NaN, there[3 * i + 1] ?? NaN]);
    return judged(orthophoto, crs, from, to);
  } catch (error) {
    return { kind: 'problem', text: say('the-orthophoto-is-not-laid-under', { reason: messageOf(error) }) };
  }
});

/** The affine map of places in both systems, unless the block lies elsewhere. */
function judged({ info }: GivenOrthophoto, crs: string, from: readonly Place[], to: readonly Place[]): Between {
  const isInside = to.every(([x, y]) => Number.isFinite(x + y));
  const toOrthophoto = isInside ? affine(from, to) : null;
  if (toOrthophoto === null) return { kind: 'problem', text: say('the-block-is-outside-the-system', { crs }) };
  // The unit of the system may be degrees or feet, that of the block is m.
  const unitsPerMetre = scaleOf(toOrthophoto);
  const most = departure(toOrthophoto, from, to) / unitsPerMetre;
  const limit = Math.max((MOST_PIXELS * info.gsd) / unitsPerMetre, MOST_SHARE * Math.hypot(span(from, 0), span(from, 1)));
  const toPixels = inverse(affineOf(info.georeference));
  const pixels = to.map(([x, y]): Place => mapped(toPixels, x, y));
  const meets = ([0, 1] as const).every((axis) => {
    const own = pixels.map((place) => place[axis]);
    return Math.max(...own) >= 0 && Math.min(...own) <= (axis === 0 ? info.width : info.height);
  });
  return meets ? { kind: 'affine', toOrthophoto, crs, isNear: most <= limit } : { kind: 'problem', text: say('the-orthophoto-lies-elsewhere', { crs }) };
}

function span(places: readonly Place[], axis: 0 | 1): number {
  const own = places.map((place) => place[axis]);
  return Math.max(...own) - Math.min(...own);
}

/** How high the ground of a block lies in its own system: the median of its tie points. */
export const groundOf = remember((view: BlockView): number => placesOf(view)?.height ?? 0);

/** Three by three places over all that images and most points take, and the height of the ground; null where the block has no places. */
function placesOf({ images, points }: BlockView): { from: Place[]; height: number } | null {
  const centres = images.flatMap(({ position }) => (position === null ? [] : [position]));
  const step = Math.ceil(points.taking / ENOUGH);
  const coordinates = [0, 1, 2].map((axis) =>
    Float64Array.from({ length: Math.ceil(points.taking / step) || 0 }, (_, i) => points.positions[3 * step * i + axis] ?? NaN)
      .filter((value) => !Number.isNaN(value))
      .sort(),
  );
  const at = (axis: number, share: number) => coordinates[axis]?.[Math.round(share * (coordinates[axis].length - 1))] ?? NaN;
  const height = at(2, 0.5);
  if (centres.length === 0 || Number.isNaN(height)) return null;
  const [columns, rows] = ([0, 1] as const).map((axis) => {
    const own = [...centres.map((centre) => centre[axis]), at(axis, BEYOND), at(axis, 1 - BEYOND)];
    const [low, high] = own.reduce(([least, largest], value) => [Math.min(least, value), Math.max(largest, value)], [Infinity, -Infinity] as [number, number]);
    return [low, (low + high) / 2, high];
  });
  return { from: (rows ?? []).flatMap((y) => (columns ?? []).map((x): Place => [x, y])), height };
}
