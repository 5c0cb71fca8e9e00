/** Where an orthophoto lies in the system of the block that is shown. */
import { geographic_positions, local_positions, system_coordinates, system_positions } from '../../../pkg/wasm/tiepoint.js';
import { betweenSystems, groundOf } from './between';
import { remember } from '../../shared/state/remember';
import type { System, ViewGround } from './ground';
import type { LinkedPlacement } from './links';
import type { GivenOrthophoto, Placed } from './placing';
import type { BlockFile, Shown } from './state';
import type { BlockView } from './view';
import { byAffine, sheetOf, throughout } from './cells';
import type { Sheet } from './cells';
import { affineOf, after, SAME, similarity } from './under';
import { inverse, mapped } from '../../shared/state/plane-map';
import type { Place } from './under';
import type { Affine } from '../../shared/state/plane-map';

export interface Laid {
  /** From the system of the orthophoto to that of the block, in the middle of which it is nearest. */
  toBlock: Affine;
  /** From the pixels of the orthophoto to the block, as they are drawn. */
  sheet: Sheet;
  /** Images of the block that are placed on it, which say so; 0 where both have one system. */
  images: number;
  /** What the system of the orthophoto is called where both lie on the earth; null where the block says nothing of it. */
  crs: string | null;
}

/** Null where nothing says how both systems lie to each other. */
export const laidUnder = remember(
  (
    orthophoto: GivenOrthophoto | null,
    placed: ReadonlyMap<number, Placed>,
    files: readonly BlockFile[],
    shown: Shown | null,
    ground: ViewGround | null,
    system: System,
  ): Laid | null => {
    if (orthophoto === null || shown === null || ground === null || shown.view.layout.kind !== 'oriented') return null;
    if (orthophoto.ofBlock !== null) return orthophoto.ofBlock === shown.key ? byOne(orthophoto, SAME) : null;
    if (system === 'surveyed' && overlap(orthophoto, ground.footprints)) return byOne(orthophoto, SAME);
    return byImages(orthophoto, placed, files, shown, ground) ?? onEarth(orthophoto, shown);
  },
);

/** One affine map leads from all of the orthophoto to the block. */
function byOne({ info }: GivenOrthophoto, toBlock: Affine, images = 0): Laid {
  return { toBlock, sheet: throughout(after(toBlock, affineOf(info.georeference))), images, crs: null };
}

/** The images of the block that are placed show the same ground in both systems. */
function byImages(
  orthophoto: GivenOrthophoto,
  placed: ReadonlyMap<number, Placed>,
  files: readonly BlockFile[],
  shown: Shown,
  { footprints }: ViewGround,
): Laid | null {
  const [from, to]: [Place[], Place[]] = [[], []];
  let images = 0;
  const index = new Map(shown.view.images.map(({ name }, i) => [name, i]));
  for (const { id, name } of files) {
    const result = placed.get(id)?.result ?? null;
    const image = index.get(name);
    if (image === undefined || result?.verdict.kind !== 'placed' || result.placement === null) continue;
    const corners = footprints.subarray(8 * image, 8 * image + 8);
    if (corners.length < 8 || Number.isNaN(corners[0])) continue;
    images += 1;
    cornersOf(result.placement).forEach((corner, i) => {
      from.push(corner);
      to.push([corners[2 * i] ?? 0, corners[2 * i + 1] ?? 0]);
    });
  }
  const toBlock = similarity(from, to);
  return toBlock === null ? null : byOne(orthophoto, toBlock, images);
}

/** Both say where they lie on the earth. */
function onEarth(orthophoto: GivenOrthophoto, { view }: Shown): Laid | null {
  const between = betweenSystems(orthophoto, view);
  const { origin } = view;
  if (between?.kind !== 'affine' || origin === null) return null;
  const toBlock = inverse(between.toOrthophoto);
  const crs = orthophoto.raster.degrees?.crs ?? between.crs;
  // An edit moves the ground by less.
  const height = Math.round(origin.height_m + groundOf(view));
  const sheet = sheetOnEarth(orthophoto, crs, origin.longitude_deg, origin.latitude_deg, origin.height_m, height);
  return { toBlock, sheet: sheet ?? byOne(orthophoto, toBlock).sheet, images: 0, crs };
}

/** From its pixels to m east and north of an origin, on ground of a height; null where an orthophoto that reaches far beyond the block leaves its own system there. */
const sheetOnEarth = remember(
  ({ raster, info }: GivenOrthophoto, crs: string, longitude: number, latitude: number, origin: number, height: number): Sheet | null => {
    const toGround = affineOf(raster.degrees?.georeference ?? info.georeference);
    const exact = (pixels: Float64Array): Place[] => {
      const places = byAffine(toGround, pixels);
      const onEarth = system_positions(crs, Float64Array.from(places.flatMap(([x, y]) => [x, y, 0])));
      for (let i = 2; i < onEarth.length; i += 3) onEarth[i] = height;
      const local = local_positions([longitude, latitude, origin, ...onEarth]);
      return places.map((_, i) => [local[3 * i + 3] ?? NaN, local[3 * i + 4] ?? NaN]);
    };
    try {
      return sheetOf(exact, info);
    } catch {
      return null;
    }
  },
);

/** A place of the block in the system of the orthophoto that lies under it by that of both on the earth. */
export function placeUnder({ crs, toBlock }: Laid, view: BlockView, [x, y]: Place): Place {
  const near = mapped(inverse(toBlock), x, y);
  const { origin } = view;
  if (crs === null || origin === null) return near;
  try {
    const onEarth = geographic_positions([origin.longitude_deg, origin.latitude_deg, origin.height_m, x, y, groundOf(view)]);
    const [u = NaN, v = NaN] = system_coordinates(crs, onEarth);
    return [u, v];
  } catch {
    // A place outside of it, at the edge of the map.
    return [NaN, NaN];
  }
}

/** Why the orthophoto does not lie under a block that says where it lies on the earth; empty where it does, and where one of them does not say it. */
export function whyNotLaid(orthophoto: GivenOrthophoto, view: BlockView): string {
  const between = betweenSystems(orthophoto, view);
  return between?.kind === 'problem' ? between.text : '';
}

/** The places of the four corners of an image, of as many along each side of its border. */
function cornersOf({ footprint }: Pick<LinkedPlacement, 'footprint'>): Place[] {
  return [0, 1, 2, 3].map((corner) => footprint[Math.round((corner * footprint.length) / 4)] ?? [NaN, NaN]);
}

/** Whether any corner of an image lies on the orthophoto, or about it. */
function overlap({ info: { width, height, georeference } }: GivenOrthophoto, footprints: Float64Array): boolean {
  const toGround = affineOf(georeference);
  const corners = [mapped(toGround, 0, 0), mapped(toGround, width, 0), mapped(toGround, 0, height), mapped(toGround, width, height)];
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const within = (value: number, all: number[]) => value >= Math.min(...all) && value <= Math.max(...all);
  for (let i = 0; i < footprints.length; i += 2) if (within(footprints[i] ?? NaN, xs) && within(footprints[i + 1] ?? NaN, ys)) return true;
  return false;
}
