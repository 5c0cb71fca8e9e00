/** Units as sentences and legends have them; heads of tables and axes have their signs. */
import { say } from '../../shared/text/words';

export function unitInWords(unit: string): string {
  if (unit === 'px') return say('unit-of-px');
  return unit === 'm' ? say('unit-of-m') : unit;
}
