import { withUnit } from '../../shared/text/units';
import type { BlockView } from './view';

/** Coordinates of a block, with their unit where it has one: where it lies on the earth or on control points. */
export function inUnitOf({ origin, surveyed }: Pick<BlockView, 'origin' | 'surveyed'>, coordinates: string): string {
  const hasScale = origin !== null || surveyed.some(({ role }) => role === 'control');
  return withUnit(coordinates, hasScale ? 'm' : '');
}
