import { withUnit } from '../../shared/text/units';
import type { BlockView } from './view';

type Scaled = Pick<BlockView, 'origin' | 'surveyed'>;

/** The unit of a block's coordinates: it has one where it lies on the earth or on control points. */
export function unitOf({ origin, surveyed }: Scaled): 'm' | '' {
  return origin !== null || surveyed.some(({ role }) => role === 'control') ? 'm' : '';
}

/** Coordinates of a block, with their unit where it has one. */
export function inUnitOf(view: Scaled, coordinates: string): string {
  return withUnit(coordinates, unitOf(view));
}
