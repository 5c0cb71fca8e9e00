//! Photogrammetric matching: from overlapping photographs to oriented tie points.
//!
//! Conventions: pixel positions are in px, x to the right, y down, the centre of the top-left pixel at (0.5, 0.5). Photo
//! coordinates are in mm, x to the right, y up, origin at the principal point. Angles are in radians inside and in degrees
//! where a name ends in `_deg`.
//!
#![doc = include_str!("../docs/rust.md")]
// The runner calls the tests of wasm-bindgen by their exports. Without a `main`, which calls all others, these are not compiled to wasm.
#![cfg_attr(all(test, target_arch = "wasm32"), no_main)]

// Integration tests name the crate as its users do.
#[cfg(test)]
extern crate self as tiepoint;

mod adjustment;
mod camera;
mod catalogue;
mod crs;
mod descriptors;
mod editing;
mod epipolar_images;
mod error;
mod film;
mod formats;
mod georeferenced;
mod html;
mod image;
#[cfg(all(test, integration, not(target_arch = "wasm32")))]
#[path = "../tests/integration.rs"]
mod integration;
mod json;
mod matching;
mod math;
mod message;
mod model;
mod orientation;
mod orthophoto;
mod outputs;
mod pair;
mod pipeline;
mod points;
mod reconstruction;
mod report;
mod simulate;
mod source;
mod tables;
mod text;
mod tracks;
mod two_view;
#[cfg(target_arch = "wasm32")]
#[cfg_attr(test, path = "wasm/tested.rs")]
mod wasm;

pub use adjustment::{
    AdjustmentOptions, AdjustmentResult, AxisPrior, Block, BlockImage, BlockObservation, CameraPrior, CameraStatistics, ControlPoint,
    Datum, Factors95, FixedParameter, GroupWeighting, ImageStatistics, LeftOut, Loss, ObjectPointStatistics, ObservationGroup,
    ObservationStatistics, ObservationVerdict, PositionPrior, PriorStatistics, RayCountRmse, Similarity, Strip, SystematicError,
    SystematicResult, SystematicStatistics, SystematicVerdict, VarianceComponent, adjust_block, ellipsoid_semi_axes,
};
pub use camera::{
    Attitude, Camera, CameraCaution, CameraMm, CameraOrigin, CameraUncertainty, DroneRecord, ExifCamera, ExifImage, ExifPosition, Fiducial,
    FiducialModel, FiducialOrientation, FreeParameters, Interior, Pose, RtkSolution, angles_from_rotation, orient_fiducials,
    rotation_from_angles,
};
pub use catalogue::{CALL_PARAMETERS, Group, Parameter, ParameterKind, PartlyGiven, acting, with_defaults};
pub use crs::{Geoid, HeightZero, coordinates_in_system, places_of_coordinates};
pub use descriptors::{
    Brightness, Descriptor, Feature, FeatureOptions, GradientOptions, Measure, WindowMoments, WindowOptions, WindowShape, describe,
    features, gradient_features, window_moments,
};
pub use editing::{BlockEdit, EditedMatch, HandMeasurement, MeasuredBy, PairEdit, PointImage};
pub use epipolar_images::{EpipolarGeometry, EpipolarImages, Parallaxes, StereoPair, StereoSystem, StereoView, write_anaglyph};
pub use error::{
    Allowed, CameraParameter, Cause, Computation, Damage, DescribedBy, Document, Element, Error, Failure, Few, FileFault, FileKind,
    FilePlace, ImageFault, ImageOperation, Input, Interruption, Location, PointName, Refusal, Side, Unsettled, Unsupported,
};
pub use film::{
    FilmFrame, FilmInput, FilmScan, FrameOfScan, FramedMeasurements, SCAN_LIMITS, decode_scan, film_cameras, film_frame, film_pattern,
    film_pixel_mm, film_warning, measurements_in_frames,
};
pub use formats::{
    CameraRule, ColmapFeature, ExportFormat, GroundControlRow, ImageMeasurementRow, ImagePositionRow, ImagePositions, colmap_features,
    colmap_matches, export_block, parse_camera_rules, parse_ground_control_points, parse_image_measurements, parse_image_positions,
    read_colmap_model,
};
pub use georeferenced::{Georeference, Sidecars};
pub use image::{
    Bands, DecodeLimits, Decoded, GreyImage, GreyView, Header, Reduced, decode, decode_bands, halve, read_header, reduce_to, refused_kind,
    write_bands, write_png,
};
pub use json::{JsonFault, JsonKind, JsonSlip, JsonSyntax, JsonWanted};
pub use matching::{
    Candidate, DESCRIPTOR_BYTES, Denominator, Described, DescriptorMatch, Descriptors, EpipolarLines, Expectation, Fit, Guide,
    GuidedOptions, Located, Match, MatchCounts, MatchImage, MatchOptions, MatchSet, Nearest, NearestOptions, NearestTable, OffsetField,
    ParallaxDeviation, Refinement, Rule, Strategy, Verdict, candidates_of, estimate_offset, estimate_offset_of_reduced,
    gradient_candidates, guided_matches, match_images, match_points, nearest, nearest_matches, nearest_of, parallax_deviation,
};
pub use math::{geographic_from_local, local_from_geographic};
pub use message::{Message, Texts};
pub use model::{
    BlockDescription, BlockModel, ControlRole, GeographicOrigin, GnssErrors, GroundControlPoint, ImageObservation, ImpossiblePosition,
    KnownCamera, KnownImage, ModelImage, NamedCamera, ObjectPoint, ObservedPosition, PlaceSlip, Remark,
};
pub use orientation::{
    ErrorEllipse, ErrorModel, EstimatedCamera, FiveParameters, GlobalTest, ModelPoint, Observation, OrientationMethod, OrientationOptions,
    PointStatistics, RelativeOrientation, SharedErrors, Warning, Weighting, model_points, orient_relative, orient_relative_with,
};
pub use orthophoto::{
    BlockLinks, GivenLink, GivenUse, HeightFactor, HeightModel, Heights, Link, LinkChecks, LinkUse, Mosaic, NotPlaced, Orthophoto,
    PlaceSearch, PlacedImage, Placement, PlacingCamera, PlacingOptions, PlacingVerdict, PlacingWeakness, RecordedPosition, Rectified,
    Relief, SearchArea, control_by_hand, ground_positions, heights_of_block, heights_of_points, image_positions, links_table,
    place_by_links, place_film, place_film_by_links, place_image, place_recorded, placed_table, rectify, rectify_placed, write_geotiff,
    write_heights,
};
pub use outputs::{
    AccuracyMap, AccuracySummary, BlockFiles, BlockOverview, BlockVerdict, CameraRow, CheckSummary, CovarianceUnknown, Covariances,
    Coverage, Expected, ExportOutcome, FoundPoints, ImagePlace, ImagePoint, ImageReason, ImageRow, ObservationDetail, ObservationPart,
    OverviewWarning, PROJECT_VERSION, PairEdits, PairPhoto, PairRow, PairRun, PairTruth, PointColumns, PointDetail, Project, ProjectKind,
    RayCount, ResultSystem, Summary, SystematicSummary, WithText, accuracy_map, block_covariances, block_epipolar_line, block_files,
    covariance_table, coverage, export_run, image_points, meeting_place, planned_files, point_detail, point_ids, project_kind,
    read_project, write_block_project, write_pair_project,
};
pub use pair::{
    DescribedImage, FeatureMatchOptions, KnownPhoto, KnownWorst, NoOrientation, OneImage, PairCameras, PairHint, PairImage, PairInput,
    PairInterior, PairMatching, PairPreset, PairResult, PairSettings, PairVerdict, PhotoDifference, PhotoInput, VerifiedMatches,
    describe_image, epipolar_line, judged, judged_observations, match_described_pair, match_features, match_in_rounds, match_pair,
    observations, orient_matches, photo_interior, photo_marks,
};
pub use pipeline::{
    BlockPlaces, BlockRun, CameraRules, CarriedEdits, CarriedSteps, Carrying, ControlTables, ControlTexts, EditNames, EditedRun,
    FileNeeded, GivenPosition, InitialCamera, Job, JoinedPoints, News, NotLinked, OnOrthophoto, PlaceAgain, PositionTable, ReadImage,
    RefinedObservation, RefinementTable, Run, RunImage, RunInput, SeenIn, SeenPlace, SkippedImage, StageName, Step, Task, Work,
    carried_steps, digest, execute, masks_of, measurements_of_images,
};
#[cfg(not(target_arch = "wasm32"))]
pub use pipeline::{images_in, replace_file, run_block};
pub use points::{
    Candidates, InterestPoint, LEAST_FRACTION, LocalFrame, MultiscaleOptions, Operator, PointCounts, PointOptions, PointPosition, PointSet,
    ScalePoint, ScaleSpace, Selection, Ties, detect, forstner, ground1, ground2, moravec, multiscale_points,
};
pub use reconstruction::{
    Axis, BlockWarning, ControlApart, ControlKind, LengthUnit, Mistake, ObservationSource, Observed, PointSource, ReconstructedModel,
    Reconstruction, ReconstructionOptions, RefusedControl, RejectedObservation, RejectedPosition, SupportingPoint, SupportingRay,
    SurveyedPoint, UnorientedImage, UnorientedReason, reconstruct_block,
};
pub use report::{PAPER, Paper, PrintedOrientation, Report, ReportEdits, ReportImage, ReportStep, ReportTruth};
pub use simulate::{
    BlockFlight, BlockPreset, BlockScene, BlockScore, BlockView, DenseTruth, Exposure, Flight, MatchScore, Preset, RIGHT_WITHIN_PX,
    Rightness, SAMPLE_SEED, Sample, SimulatedBlock, SimulatedNetwork, check_flight, check_truth, sample_pair, score_block, score_matches,
    simulate, simulate_block, simulate_network,
};
pub use source::{DiskFile, FileSource};
pub use tables::{matches_csv, model_points_csv, parse_camera, parse_fiducials, parse_observations, points_csv};
pub use tracks::{
    BlockMatches, BlockOptions, BlockSettings, ChosenPair, Conflicts, Connection, ConnectionGraph, FeatureMatch, FeatureObservation,
    GeoreferencingOptions, ImageFeatures, JoinCounts, MatchReliability, ObservationRefinement, ObservationWindow, ObservationWindows,
    PairChoice, PairOutcome, PairRule, PointRefiner, RefinedPoint, RefinementMethod, RefinementOptions, RefinementOutcome, SelectOptions,
    SelectedPoints, SharedPoints, TiePoints, WindowCentre, WindowedObservation, alike_pairs, all_pairs, choose_pairs, merge_pairs,
    near_pairs, observation_windows, select_points, sequence_pairs, shared_points, tie_points,
};
pub use two_view::{
    Degeneracy, FocalEstimate, NoGeometry, Pinhole, TwoView, TwoViewModel, TwoViewOptions, fundamental_eight_point,
    fundamental_seven_point, homography_direct, two_view,
};
