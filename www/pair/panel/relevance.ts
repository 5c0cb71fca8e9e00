/** Which settings have an effect under the others: the panel shows those alone. */
import type { Settings } from '../../shared/crate';
import { comparesGradients, comparesGreyValues, comparesMoments } from '../state/keys';

type Test = (settings: Settings) => boolean;

/** Points of one scale, by a threshold in each pixel. */
const byPixels: Test = (s) => s.points.operator !== 'multiscale';
const byScales: Test = (s) => s.points.operator === 'multiscale';
const ofPlaces: Test = (s) => !comparesGradients(s);
const correlates: Test = (s) => s.matching.strategy === 'correlation';
const hasAmbiguity: Test = (s) => s.matching.strategy !== 'least-squares';
const adjusts: Test = (s) => s.matching.strategy === 'least-squares' || s.matching.refine === 'least-squares';
const robust: Test = (s) => s.orientation.robust;

const USED: Readonly<Record<string, Test>> = {
  'points.threshold': byPixels,
  'points.fraction': byPixels,
  'points.tiled': (s) => s.points.operator === 'moravec',
  'points.operator_window': (s) => byPixels(s) && !s.points.operator.startsWith('ground'),
  'points.roundness': (s) => s.points.operator === 'forstner' || s.points.operator === 'ground2',
  'points.suppression_window': byPixels,
  'points.ties': byPixels,
  'multiscale.number': byScales,
  // Gradients are taken from the pyramid whatever found the points.
  'multiscale.levels': (s) => byScales(s) || comparesGradients(s),
  'multiscale.contrast': byScales,
  'multiscale.roundness': byScales,
  'multiscale.cells': byScales,
  'multiscale.position': byScales,
  'gradient.upright': comparesGradients,
  'gradient.orientations': (s) => comparesGradients(s) && !s.gradient.upright,
  'gradient.cell': comparesGradients,
  'gradient.roots': comparesGradients,
  'window.side': comparesMoments,
  'window.shape': comparesMoments,
  'window.brightness': comparesMoments,
  'matching.search': ofPlaces,
  'matching.epipolar': ofPlaces,
  'matching.denominator': comparesMoments,
  'matching.max_measure': (s) => !comparesGreyValues(s),
  'matching.refine': (s) => s.matching.strategy !== 'least-squares',
  'matching.ambiguity': hasAmbiguity,
  'matching.parallax_neighbours': ofPlaces,
  'matching.parallax_tolerance': (s) => ofPlaces(s) && s.matching.parallax_neighbours > 0,
  'matching.template': (s) => comparesGreyValues(s) || adjusts(s),
  'matching.min_correlation': (s) => comparesGreyValues(s) || adjusts(s),
  'matching.left_right': (s) => correlates(s) || comparesGradients(s),
  'matching.without_frame': comparesGradients,
  'matching.max_standard_error': adjusts,
  'geometry.threshold_px': comparesGradients,
  'geometry.largest_threshold_px': (s) => comparesGradients(s) && s.geometry.threshold_px === null,
  'geometry.confidence': comparesGradients,
  'geometry.max_samples': comparesGradients,
  'geometry.seed': comparesGradients,
  'orientation.seed': robust,
};

/** Whether a setting has an effect now. */
export function isUsed(key: string, settings: Settings): boolean {
  return USED[key]?.(settings) ?? true;
}
