/** Links of placed images in flat columns: thousands of images have some thousands of links each. */
import type { Link, LinkUse, PlacedImage, Placement } from '../../../pkg/wasm/tiepoint.js';

export const USES: readonly LinkUse[] = ['used', 'check', 'rejected'];

export interface Links {
  count: number;
  /** Columns and rows in px; stride 2. */
  at: Float64Array;
  /** X, Y, Z; stride 3. */
  places: Float64Array;
  /** In px of the image; stride 2. */
  residuals: Float64Array;
  /** Of each coordinate in the image, in px; absent in what earlier releases kept. */
  sigmas?: Float64Array;
  /** Places in `USES`. */
  uses: Uint8Array;
  /** 1 for those that were measured by hand. */
  byHand: Uint8Array;
}

/** As the crate has it, with its links in columns. */
export type LinkedPlacement = Omit<Placement, 'links'> & { links: Links };

export type LinkedImage = Omit<PlacedImage, 'placement'> & {
  placement: LinkedPlacement | null;
  /** Width and height in px. */
  size: readonly [number, number];
};

export function inColumns({ placement, ...image }: PlacedImage, size: readonly [number, number]): LinkedImage {
  return { ...image, size, placement: placement === null ? null : { ...placement, links: columnsOf(placement.links) } };
}

function columnsOf(links: readonly Link[]): Links {
  return {
    count: links.length,
    at: Float64Array.from(links.flatMap(({ at }) => at)),
    places: Float64Array.from(links.flatMap(({ place }) => place)),
    residuals: Float64Array.from(links.flatMap(({ residual_px: residual }) => residual ?? [Number.NaN, Number.NaN])),
    sigmas: Float64Array.from(links, ({ sigma_px: sigma }) => sigma ?? Number.NaN),
    uses: Uint8Array.from(links, ({ role }) => USES.indexOf(role)),
    byHand: Uint8Array.from(links, ({ by_hand: byHand }) => (byHand ? 1 : 0)),
  };
}

/** As the crate takes it. */
export function inRows({ placement, size: _, ...image }: LinkedImage): PlacedImage {
  return {
    ...image,
    placement: placement === null ? null : { ...placement, links: Array.from({ length: placement.links.count }, (_, i) => linkOf(placement.links, i)) },
  };
}

export function linkOf({ at, places, residuals, sigmas, uses, byHand }: Links, link: number): Link {
  const pair = (of: Float64Array): [number, number] => [of[2 * link] ?? NaN, of[2 * link + 1] ?? NaN];
  return {
    at: pair(at),
    place: [places[3 * link] ?? NaN, places[3 * link + 1] ?? NaN, places[3 * link + 2] ?? NaN],
    residual_px: Number.isNaN(residuals[2 * link]) ? null : pair(residuals),
    sigma_px: sigmaOf(sigmas?.[link]),
    role: USES[uses[link] ?? 0] ?? 'used',
    by_hand: byHand[link] === 1,
  };
}

/** How many links are used so. */
export function usedSo({ uses }: Links, use: LinkUse): number {
  const code = USES.indexOf(use);
  return uses.reduce((sum, own) => sum + (own === code ? 1 : 0), 0);
}

const sigmaOf = (sigma: number | undefined): number | null => (sigma === undefined || Number.isNaN(sigma) ? null : sigma);
