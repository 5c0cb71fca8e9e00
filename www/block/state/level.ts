/** The height of level ground where a block says it: the median of its tie points, in the system and the unit of an orthophoto. Pure. */
import { betweenSystems } from './between';
import { median } from './ground';
import { unitOfOrthophoto } from './orthophoto-unit';
import type { GivenHeights, GivenOrthophoto, Placing } from './placing';
import { inSystem } from './result-system';
import { isInSystemOf } from './showing';
import type { Shown } from './state';
import type { BlockView } from './view';

const FOOT_M = 0.3048;
/** Far enough apart for heights that are rounded, m. */
const APART_M = 100;

/** Whether the ground is as it is where nothing was given of it, or as a block has said it. */
export function isLevelOpen(heights: GivenHeights): boolean {
  return heights.kind === 'level' && (heights.by === 'block' || (heights.by === undefined && heights.height === 0));
}

/** Level ground at the height that the block says; null where it says none, or something else was given. */
export function levelByBlock({ orthophoto, heights }: Pick<Placing, 'orthophoto' | 'heights'>, shown: Shown | null): GivenHeights | null {
  if (orthophoto === null || shown === null || !isLevelOpen(heights)) return null;
  const height = heightOf(orthophoto, shown);
  return height === null || Number.isNaN(height) ? null : { kind: 'level', height: Math.round(10 * height) / 10, by: 'block' };
}

function heightOf(orthophoto: GivenOrthophoto, { key, view }: Shown): number | null {
  if (view.partial || view.layout.kind !== 'oriented') return null;
  const [x, y, z] = [0, 1, 2].map((axis) => medianOf(view, axis));
  if (x === undefined || y === undefined || z === undefined) return null;
  const between = betweenSystems(orthophoto, view);
  if (between?.kind === 'affine') {
    const [, , low = NaN, , , high = NaN] = inSystem(view, between.crs, Float64Array.of(x, y, z, x, y, z + APART_M));
    const metres = low / ((high - low) / APART_M);
    return unitOfOrthophoto(orthophoto) === 'ft' ? metres / FOOT_M : metres;
  }
  const isOwn = orthophoto.ofBlock === key || (isInSystemOf(view) && view.orthophoto?.inCrs !== true);
  return between === null && isOwn ? z : null;
}

function medianOf({ points: { positions, taking } }: BlockView, axis: number): number {
  return median(positions.subarray(0, 3 * taking).filter((value, i) => i % 3 === axis && !Number.isNaN(value)));
}
