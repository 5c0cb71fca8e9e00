//! Input that is refused: what it is, what was got, what is allowed.

use super::failure::Failure;
use super::input::{DescribedBy, Input, Location, PointName};
use crate::json::number;
use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// Why an input is refused. Its text says what was refused, what was got, and what is allowed.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Refusal as "refusal" {
        // General.
        Value { input: Input, #[serde(with = "number")] value: f64, location: Location, low: f64, high: f64 },
        Parameter { input: Input, #[serde(with = "number")] value: f64, field: String, location: Location, low: f64, high: f64 },
        Index { input: Input, index: usize, count: usize },
        Below { input: Input, index: usize, count: usize },
        IndexAs { input: Input, index: usize, location: Location, last: usize },
        NothingAs { input: Input, index: usize, location: Location },
        Count { input: Input, got: usize, wanted: usize },
        Bytes { input: Input, bytes: usize, each: usize },
        Numbers { input: Input, numbers: usize, each: usize },
        InEdit { edit: usize, refusal: Box<Refusal> },

        // Cameras and fiducial marks.
        MarkCoordinate { coordinate: String, #[serde(with = "number")] value: f64, mark: usize, limit: f64 },
        MarksAgain { first: usize, second: usize },
        Panorama,
        MarkOutside { #[serde(with = "number")] col: f64, #[serde(with = "number")] row: f64, width: usize, height: usize },
        MarksSigma0 { #[serde(with = "number")] sigma0_mm: f64, most_mm: f64 },
        LoneOrigin { origin: String },
        OneCamera,
        OneFocalLength,
        NoCameras,
        EmptyPattern { camera: usize },
        UnusedPatterns { patterns: String, names: String },

        // The model of a block.
        ImageName { name: String, image: usize },
        ImageNameAgain { name: String, first: usize, second: usize },
        CopyOfImage { name: String },
        CameraOfImage { camera: usize, name: String, cameras: usize },
        PointNumbers { position: String, rmse_px: String, point: usize },
        Confidence { point: usize },
        ImageOfPoint { image: usize, point: usize, images: usize },
        RayOutside { point: usize, #[serde(with = "number")] x_px: f64, #[serde(with = "number")] y_px: f64, name: String, width_px: u32, height_px: u32 },
        TwoRays { point: usize, name: String },
        Rotation { rotation: String, name: String },
        ImagePosition { position: String, name: String },
        Origin { #[serde(with = "number")] longitude_deg: f64, #[serde(with = "number")] latitude_deg: f64, #[serde(with = "number")] height_m: f64 },
        OtherCoordinates { point: String },
        NoHeight { point: String },
        MeasuredImage { image: usize, point: String, images: usize },
        MeasuredOutside { #[serde(with = "number")] x_px: f64, #[serde(with = "number")] y_px: f64, point: String, name: String, width_px: u32, height_px: u32 },
        MeasuredTwice { point: String, name: String },

        // Points and their descriptors.
        MaskSize { width: usize, height: usize, image_width: usize, image_height: usize },
        RasterOrder,
        DescribedPoint { #[serde(with = "number")] x: f64, #[serde(with = "number")] y: f64, #[serde(with = "number")] scale_px: f64, width: usize, height: usize },
        NoMoments { described: DescribedBy, points: usize },
        NoGradients { described: DescribedBy, points: usize },

        // Matching.
        NeighboursOfOthers { rows: String, among: usize, left: usize, right: usize },
        LeftPoint { index: usize, count: usize },
        GuideMatrix { #[serde(with = "number")] value: f64 },
        DescribedPositions { input: Input, positions: usize, descriptors: usize },
        DescribedPoints { input: Input, points: usize, descriptors: usize },
        DescribedBytes { input: Input, positions: usize, bytes: usize, each: usize },
        FarPosition { input: Input, #[serde(with = "number")] x: f64, #[serde(with = "number")] y: f64 },
        LeftRows { first: usize, end: usize, left: usize },
        PieceLengths { left: usize, right: usize },
        PieceDescriptor { index: u32 },
        PieceStart,
        NextPiece { row: usize, right: usize, next_row: usize, of_right: usize },
        OffsetField { columns: usize, rows: usize, offsets: usize, #[serde(with = "number")] spacing_px: f64 },
        MatchPosition { position: String, index: usize },

        // Orientation.
        SharedErrors { effects: usize, observations: usize },
        OrientedObservations { observations: usize, oriented: usize },
        ObservationWeight { #[serde(with = "number")] weight: f64, observation: usize },
        PhotoCoordinates { #[serde(with = "number")] value_mm: f64, observation: usize, largest_mm: f64, focal_lengths: f64 },

        // Tie points.
        PlaceOfImage { position: String, image: u32 },
        SimilarImage { other: u32, similarity: String, image: usize, images: usize },
        PairOfImages { images: [u32; 2], count: usize },
        PairAgain { images: [u32; 2] },
        ManyFeatures { features: u64, most: u32 },
        ManyMatches { most: i32 },
        MatchedFeatures { features: [u32; 2], strength: String, index: usize, images: [u32; 2], left: u32, right: u32 },
        FeaturesOfImages { input: Input, images: usize, wanted: usize },
        NoFeature { feature: u32, image: u32 },
        NoTiePoint { point: usize, points: usize },
        FeatureOutside { position: String, image: usize, width_px: u32, height_px: u32 },
        LostFeature { feature: u32, image: u32 },
        RayNumbers { position: String, #[serde(with = "number")] scale_px: f64 },
        RayDirection { #[serde(with = "number")] direction_rad: f64 },
        RayPlace { position: String, width: usize, height: usize },
        WindowValues { values: usize, windows: usize, side: usize },
        WindowHalvings { halvings: u32, most: u32 },
        WindowOrder,

        // Adjustment and reconstruction.
        RotationAs { rotation: String, location: Location },
        AxisDirection { direction: String, location: Location },
        PriorAgain { camera: usize },
        ControlAgain { point: usize },
        RayAgain { image: usize, point: usize },
        MixedPositions { geographic: usize, local: usize, placing: usize },
        NoModel { model: usize, models: usize },
        NoIntersection { rays: usize, point_name: PointName, largest_px: f64, least_angle_deg: f64 },
        CovarianceImage { image: usize },
        CovariancePoint { point: usize },

        // Edits.
        NoObservation { location: Location, point_name: PointName },
        RejectedPoint { point_name: PointName },
        NewPointImages { images: usize, observations: usize },
        MeasuredPlace { #[serde(with = "number")] x_px: f64, #[serde(with = "number")] y_px: f64, location: Location, width_px: u32, height_px: u32 },
        UnknownPoint { point_name: PointName },
        ImageNotOriented { location: Location },
        BlockNotOriented,

        // Exchange formats and tables.
        FeatureNumbers { numbers: String, feature: usize },
        FeatureDescriptor { numbers: usize, feature: usize, needed: usize },
        OwnSystem,
        NameWithBlanks { format: String, name: String },
        NameOfNoFile { format: String, name: String },
        LongName { format: String, name: String, bytes: usize, most: usize },
        NoRecords { input: Input, words: String },
        NoColumn { input: Input, column: String, names: String, columns: String },
        ColumnAgain { input: Input, column: String, columns: String },
        NoValue { input: Input, column: String, line: usize },
        NoNumber { input: Input, word: String, column: String, line: usize },
        ControlColumn { column: String, names: String },
        ControlErrorColumn { column: String },
        ControlNumber { word: String, column: String, line: usize },
        ControlName { name: String, line: usize },
        ControlErrors { errors: String, line: usize },
        ControlUse { word: String, line: usize },
        ReservedName { name: String, begins: String },
        MeasuredNumbers { x: String, y: String, line: usize },
        MeasuredNames { line: usize },
        MeasuredAgain { point: String, image: String, line: usize },

        // Coordinate reference systems.
        UnknownCrs { crs: String },
        CrsText { crs: String, reason: String, projections: String },
        GeocentricCrs { crs: String },
        CrsAxes { crs: String },
        NoDatumShift { crs: String, name: String },
        CrsArea { crs: String, #[serde(with = "number")] longitude_deg: f64, #[serde(with = "number")] latitude_deg: f64, areas: String },
        CrsPlace { #[serde(with = "number")] x: f64, #[serde(with = "number")] y: f64, crs: String, degrees: bool },
        OutsideCrs { #[serde(with = "number")] longitude_deg: f64, #[serde(with = "number")] latitude_deg: f64, crs: String },
        ControlPlace { point: String, #[serde(with = "number")] x: f64, #[serde(with = "number")] y: f64, crs: String, degrees: bool },
        ControlDegrees { point: String, #[serde(with = "number")] x: f64, #[serde(with = "number")] y: f64, crs: String },
        ControlElsewhere { point: String, #[serde(with = "number")] distance_km: f64, crs: String, #[serde(with = "number")] most_km: f64, swapped: bool, zone: Option<u32>, likely: Option<String> },
        GeoidOfEllipsoid { crs: String, #[serde(with = "number")] geoid_m: f64 },

        // The run of a block.
        MeasuredBeyond { #[serde(with = "number")] x_px: f64, #[serde(with = "number")] y_px: f64, point: String, name: String },
        MeasuredUnknown { point: String },
        FewControlPoints { seen: usize, placing: usize, checks: bool, images: Vec<String>, needed: usize },
        JobInputs { inputs: usize },
        MaskOfImage { name: String, width: usize, height: usize, image_width: usize, image_height: usize },
        FileNameAgain { name: String },
        FileName { name: String },
        CoarseDescriptors { bytes: usize, each: usize },
        TwoMasks { first: String, second: String },
        RefinedObservations { first: u32, end: u32, windows: usize },
        UnknownJob { job: u32 },
        FewImages { read: usize, given: usize, first: Option<String>, failure: Option<Failure> },
        ChosenFeature { feature: u32, features: usize },

        // The ground: orthophotos, heights, mosaics.
        LinkPosition { position: String, link: usize, width_px: u32, height_px: u32 },
        LinkPlace { place: String, link: usize },
        WorldFile { text: String },
        Georeference { numbers: String },
        Degrees,
        HeightCount { heights: usize, width: usize, height: usize },
        HeightRange { #[serde(with = "number")] low: f64, #[serde(with = "number")] high: f64 },
        NoHeightModel,
        HeightsWithoutPlace,
        TruncatedHeights { width: usize, height: usize, bytes: usize },
        ManyHeights { width: usize, height: usize },
        HeightSamples,
        GridWord { name: String },
        GridLacks { name: String },
        GridSize { #[serde(with = "number")] columns: f64, #[serde(with = "number")] rows: f64, #[serde(with = "number")] cell: f64 },
        GridHeight { word: String },
        PictureWithoutPlace { format: String },
        OrthophotoSystem { described: Option<String> },
        OrthophotoUnit { code: u16 },
        NothingAboveGround,
        MosaicPixel { #[serde(with = "number")] gsd: f64, #[serde(with = "number")] least: f64, #[serde(with = "number")] megapixels: f64 },
        MosaicImage { image: usize },
        MosaicImageSize { width: usize, height: usize, width_px: u32, height_px: u32 },
        EmptyMosaic,
        MapInDegrees { crs: String },
        OutsideMap { crs: String },
        HeightsSystem { heights: String, ground: String },
        NoHeightsThere,
        OneCoordinate,
        NearPlace { place: String, #[serde(with = "number")] within_m: f64, first: String, last: String },
        NearRadius { #[serde(with = "number")] within_m: f64, #[serde(with = "number")] least_px: f64 },
        CameraSize { width_px: usize, height_px: usize, width: usize, height: usize },
        GreyValues { width: usize, height: usize, values: usize },

        // Epipolar images.
        EpipolarName { name: String },
        EpipolarNames { name: String },
        EpipolarNotOriented { name: String },
        EpipolarNoPair,
        EpipolarBase { left: String, right: String },
        EpipolarAlongBase { left: String, right: String },
        EpipolarOverlap { left: String, right: String },
        EpipolarImageSize { name: String, width: usize, height: usize, width_px: usize, height_px: usize },

        // Simulated photos and their truth.
        PhotoPosition { position: String, width_px: u32, height_px: u32 },
        TruthOfOthers,
        TruthNotOriented { name: String },
        TruthDistortion { camera: usize },
        TruthSize { positions: usize, width: usize, height: usize },

        // Covariances of a finished block.
        CovariancesNotOriented,
        CovariancesUnsupported,
        CovarianceUnknowns { unknowns: usize, most: usize },
        CovarianceAgain { name: String },
        CovarianceName { name: String },

        // Maps of the expected accuracy.
        AccuracyImages { images: usize, most: usize },
        AccuracySigma { #[serde(with = "number")] sigma_px: f64 },
        AccuracyCell { #[serde(with = "number")] cell: f64, #[serde(with = "number")] least: f64, #[serde(with = "number")] most: f64 },

        // Projects.
        PairMatch { left: usize, right: Option<usize>, points: usize, others: usize },
        PairFound { found: usize, points: usize },
        PairPlace { #[serde(with = "number")] got: f64 },
        PairRejected { index: usize, matches: usize },
        ProjectConnection { images: [u32; 2], count: usize },
        ProjectEdits,
        ProjectImage { name: String, camera: usize, other: String, other_camera: usize },
        ProjectIndex { index: usize, images: usize, cameras: usize },
        ProjectCamera { camera: usize, cameras: usize },
        ProjectStrip { strip: usize, strips: usize },
        ProjectOrder,
        ProjectObservation { point: usize, image: usize, images: usize, points: usize },
    }
}
