/** The crate as the page's main thread sees it: its types, its fixed data, and drawing. Everything that computes runs in workers. */
import {
  defaults,
  flight_parameters,
  flight_preset,
  flight_presets,
  pair_preset,
  pair_presets,
  paper,
  parameters,
  rule_names,
  version,
} from '../../pkg/wasm/tiepoint.js';
import type { Flight, PairPreset, PairSettings as Settings, Paper, Parameter, Preset } from '../../pkg/wasm/tiepoint.js';

export type {
  Camera,
  CameraMm,
  DescribedPoints,
  DetectedPoints,
  EpipolarGeometry,
  ErrorEllipse,
  ExifCamera,
  Fiducial,
  FiducialModel,
  FiducialOrientation,
  FiveParameters,
  FocalEstimate,
  Given,
  GivenPoints,
  Interior,
  MatchCounts,
  MatchResult,
  MatchScore,
  NearestPiece,
  NoOrientation,
  OffsetField,
  OrientedPair,
  PairCameras,
  PairHint,
  PairInput,
  PairInterior,
  PairEdit,
  PairEdits,
  PairProject,
  ParallaxDeviation,
  PairTruth,
  PairVerdict,
  PhotoDifference,
  PhotoFacts,
  PhotoInfo,
  PointCounts,
  ReducedImage,
  RelativeOrientation,
  ReportEdits,
  ReportTruth,
  Rule,
  SampleImage,
  SamplePair,
  Strategy,
  TwoViewModel,
  Warning,
  WindowReport,
} from '../../pkg/wasm/tiepoint.js';
export {
  acting_block_parameters,
  acting_parameters,
  assumed_interior,
  pair_hint,
  camera_label,
  camera_of_exif,
  draw_match_lines,
  draw_points,
  draw_vectors,
  message,
  few_matches,
  masks_of_images,
  one_image,
  camera_of_focal_px,
  pair_cameras,
  project_kind,
  refused_kind,
  resolved,
} from '../../pkg/wasm/tiepoint.js';

export type { Flight, PairPreset, Paper, Parameter, Preset, Settings };

/** What the crate says of itself: read once, when the module is there. */
export interface Catalogue {
  version: string;
  parameters: Parameter[];
  defaults: Settings;
  /** Ready-made settings. */
  presets: { name: PairPreset; settings: Settings }[];
  rules: string[];
  flightParameters: Parameter[];
  flights: { name: Preset; flight: Flight }[];
  paper: Paper;
}

export function readCatalogue(): Catalogue {
  return {
    version: version(),
    parameters: parameters(),
    defaults: defaults(),
    presets: pair_presets().map((name) => ({ name, settings: pair_preset(name) })),
    rules: rule_names(),
    flightParameters: flight_parameters(),
    paper: paper(),
    flights: flight_presets().map((name) => ({ name, flight: flight_preset(name) })),
  };
}
