/** Which settings have no effect under others, so that the panel can say so. */
import type { Settings } from '../engine/wasm';

type Test = (settings: Settings) => boolean;

const UNUSED: Readonly<Record<string, [Test, string]>> = {
  'points.tiled': [(s) => s.points.operator !== 'moravec', 'Moravec only'],
  'points.operator_window': [(s) => s.points.operator.startsWith('ground'), 'The ground operators use 3 px'],
  'points.roundness': [(s) => s.points.operator === 'moravec' || s.points.operator === 'ground1', 'Ground 2 and Förstner only'],
  'matching.parallax_tolerance': [(s) => s.matching.parallax_neighbours === 0, 'The y-parallax rule is off'],
  'orientation.rejection': [(s) => !s.orientation.robust, 'Robust only'],
  'orientation.seed': [(s) => !s.orientation.robust, 'Robust only'],
};

/** Why a setting has no effect now; null where it has. */
export function unusedBecause(key: string, settings: Settings): string | null {
  const rule = UNUSED[key];
  return rule !== undefined && rule[0](settings) ? rule[1] : null;
}
