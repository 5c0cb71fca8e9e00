/** Units as sentences and legends have them; heads of tables and axes have their signs. */
import { say } from '../../shared/text/words';
import type { BlockView } from './view';

export function unitInWords(unit: string): string {
  if (unit === 'px') return say('unit-of-px');
  return unit === 'm' ? say('unit-of-m') : unit;
}

/** Coordinates of a block, with their unit where it has one: where it lies on the earth or on control points. */
export function inUnitOf({ origin, surveyed }: Pick<BlockView, 'origin' | 'surveyed'>, coordinates: string): string {
  const hasScale = origin !== null || surveyed.some(({ role }) => role === 'control');
  return hasScale ? `${coordinates} ${unitInWords('m')}` : coordinates;
}
