/** Which settings have an effect under the others: the panel shows those alone. */
import type { Settings } from '../engine/wasm';
import { comparesGreyValues } from '../state/keys';

type Test = (settings: Settings) => boolean;

const comparesMoments: Test = (s) => !comparesGreyValues(s);
const correlates: Test = (s) => s.matching.strategy === 'correlation';
const hasAmbiguity: Test = (s) => s.matching.strategy !== 'least-squares';
const adjusts: Test = (s) => s.matching.strategy === 'least-squares' || s.matching.refine === 'least-squares';
const robust: Test = (s) => s.orientation.robust;

const USED: Readonly<Record<string, Test>> = {
  'points.tiled': (s) => s.points.operator === 'moravec',
  'points.operator_window': (s) => !s.points.operator.startsWith('ground'),
  'points.roundness': (s) => s.points.operator === 'forstner' || s.points.operator === 'ground2',
  'window.side': comparesMoments,
  'window.shape': comparesMoments,
  'window.brightness': comparesMoments,
  'matching.denominator': comparesMoments,
  'matching.max_measure': comparesMoments,
  'matching.refine': (s) => s.matching.strategy !== 'least-squares',
  'matching.ambiguity': hasAmbiguity,
  'matching.parallax_tolerance': (s) => s.matching.parallax_neighbours > 0,
  'matching.template': (s) => comparesGreyValues(s) || adjusts(s),
  'matching.min_correlation': (s) => comparesGreyValues(s) || adjusts(s),
  'matching.left_right': correlates,
  'matching.max_standard_error': adjusts,
  'orientation.seed': robust,
};

/** Whether a setting has an effect now. */
export function isUsed(key: string, settings: Settings): boolean {
  return USED[key]?.(settings) ?? true;
}
