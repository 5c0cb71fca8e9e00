/** The crate as the page's main thread sees it: its types, its fixed data, and drawing. Everything that computes runs in workers. */
import { defaults, initSync, operator_defaults, parameters, rule_names, sample_seed, version } from '../../pkg/wasm/tiepoint.js';
import type { Operator, OperatorDefaults, PairSettings as Settings, Parameter } from '../../pkg/wasm/tiepoint.js';
import { wasmModule } from './spawn';

export type {
  Camera, DetectedPoints, ExifCamera, Fiducial, FiducialModel, FiducialOrientation, FiveParameters, Interior, MatchCounts, MatchResult,
  OffsetField, PhotoInfo, PointCounts, ReducedImage, RelativeOrientation, SamplePair, WindowReport,
} from '../../pkg/wasm/tiepoint.js';
export { draw_match_lines, draw_points, draw_vectors } from '../../pkg/wasm/tiepoint.js';

export type { Parameter, Settings };

/** What the crate says of itself: read once, when the module is there. */
export interface Catalogue {
  version: string;
  parameters: Parameter[];
  defaults: Settings;
  /** What an operator does where an option is empty. */
  operatorDefaults: Record<Operator, OperatorDefaults>;
  rules: string[];
  sampleSeed: number;
}

/** Loads the module for the main thread and reads the catalogue. */
export async function loadCatalogue(): Promise<Catalogue> {
  initSync({ module: await wasmModule() });
  return {
    version: version(),
    parameters: parameters(),
    defaults: defaults(),
    operatorDefaults: operator_defaults(),
    rules: rule_names(),
    sampleSeed: sample_seed(),
  };
}
