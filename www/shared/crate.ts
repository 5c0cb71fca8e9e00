/** The crate as the page's main thread sees it: its types, its fixed data, and drawing. Everything that computes runs in workers. */
import {
  ambiguity_defaults, defaults, flight_parameters, flight_preset, flight_presets, operator_defaults, parameters, rule_names, version,
} from '../../pkg/wasm/tiepoint.js';
import type { Flight, Operator, OperatorDefaults, PairSettings as Settings, Parameter, Preset, Strategy } from '../../pkg/wasm/tiepoint.js';

export type {
  CameraMm, DescribedPoints, DetectedPoints, ErrorEllipse, ExifCamera, Fiducial, FiducialModel, FiducialOrientation,
  FiveParameters, FocalEstimate, Given, GivenPoints, Interior, MatchCounts, MatchResult, MatchScore, NearestPiece, OffsetField, PairInput, PairInterior,
  PhotoInfo, PointCounts, ReducedImage, RelativeOrientation, ReportTruth, Rule, SampleImage, SamplePair, Strategy, TwoViewModel, Warning,
  WindowReport,
} from '../../pkg/wasm/tiepoint.js';
export { draw_match_lines, draw_points, draw_vectors, message } from '../../pkg/wasm/tiepoint.js';

export type { Flight, Parameter, Preset, Settings };

/** What the crate says of itself: read once, when the module is there. */
export interface Catalogue {
  version: string;
  parameters: Parameter[];
  defaults: Settings;
  /** What an operator does where an option is empty. */
  operatorDefaults: Record<Operator, OperatorDefaults>;
  /** The ambiguity ratio of each strategy where none is chosen. */
  ambiguityDefaults: Record<Strategy, number>;
  rules: string[];
  flightParameters: Parameter[];
  flights: { name: Preset; flight: Flight }[];
}

export function readCatalogue(): Catalogue {
  return {
    version: version(),
    parameters: parameters(),
    defaults: defaults(),
    operatorDefaults: operator_defaults(),
    ambiguityDefaults: ambiguity_defaults(),
    rules: rule_names(),
    flightParameters: flight_parameters(),
    flights: flight_presets().map((name) => ({ name, flight: flight_preset(name) })),
  };
}
