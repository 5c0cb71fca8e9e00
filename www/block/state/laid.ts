/** Where an orthophoto lies in the system of the block that is shown. */
import { betweenSystems } from './between';
import { remember } from '../../shared/state/remember';
import type { System, ViewGround } from './ground';
import type { LinkedPlacement } from './links';
import type { GivenOrthophoto, Placed } from './placing';
import type { BlockFile, Shown } from './state';
import type { BlockView } from './view';
import { affineOf, inverse, mapped, SAME, similarity } from './under';
import type { Affine } from './under';

type Place = readonly [number, number];

export interface Laid {
  /** From the system of the orthophoto to that of the block. */
  toBlock: Affine;
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
    if (orthophoto.ofBlock !== null) return orthophoto.ofBlock === shown.key ? { toBlock: SAME, images: 0, crs: null } : null;
    if (system === 'surveyed' && overlap(orthophoto, ground.footprints)) return { toBlock: SAME, images: 0, crs: null };
    return byImages(placed, files, shown, ground) ?? onEarth(orthophoto, shown);
  },
);

/** The images of the block that are placed show the same ground in both systems. */
function byImages(placed: ReadonlyMap<number, Placed>, files: readonly BlockFile[], shown: Shown, { footprints }: ViewGround): Laid | null {
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
  return toBlock === null ? null : { toBlock, images, crs: null };
}

/** Both say where they lie on the earth. */
function onEarth(orthophoto: GivenOrthophoto, { view }: Shown): Laid | null {
  const between = betweenSystems(orthophoto, view);
  return between?.kind === 'similar' ? { toBlock: inverse(between.toOrthophoto), images: 0, crs: between.crs } : null;
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
