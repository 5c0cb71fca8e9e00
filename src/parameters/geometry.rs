//! The parameters of matching by descriptors and of two-view geometry.

use super::{FOCAL_PX, Parameter, ParameterKind, integer, parameter, real};

/// The parameters of matching by descriptors and of the geometry of two views, in the order of the pipeline.
pub const GEOMETRY_PARAMETERS: &[Parameter] = &[
    parameter(
        "nearest.ratio",
        "Ratio",
        "",
        real(0.0, 1.0),
        "A match is ambiguous unless its distance is below this share of that of the second nearest descriptor. Lower keeps fewer, surer matches.",
    ),
    parameter(
        "nearest.mutual",
        "Mutual",
        "",
        ParameterKind::Flag,
        "A match stands only where each of its two descriptors is the nearest of the other.",
    ),
    parameter(
        "nearest.largest_distance",
        "Largest distance",
        "",
        real(0.0, 3000.0),
        "Euclidean distance of two descriptors beyond which they never match. Empty: any distance.",
    ),
    parameter(
        "guided.radius_px",
        "Guided: distance",
        "px",
        real(0.0, 1000.0),
        "Once the geometry is known, candidates lie within this distance of the epipolar line, or of the place a plane gives.",
    ),
    parameter(
        "guided.ratio",
        "Guided: ratio",
        "",
        real(0.0, 1.0),
        "The ratio among the candidates near the epipolar line: it may be looser, since these are few.",
    ),
    parameter(
        "guided.largest_distance",
        "Guided: largest distance",
        "",
        real(0.0, 3000.0),
        "Euclidean distance of two descriptors beyond which they never match. Empty: any distance.",
    ),
    parameter(
        "geometry.focal_px",
        "Focal length",
        "px",
        real(*FOCAL_PX.start(), *FOCAL_PX.end()),
        "Of the camera. Empty: unknown, the same in both images, and estimated where the matches determine it.",
    ),
    parameter(
        "geometry.principal_px",
        "Principal point",
        "px",
        real(-1e6, 1e6),
        "Of the camera; the image's centre where nothing else is known.",
    ),
    parameter(
        "geometry.threshold_px",
        "Threshold",
        "px",
        real(0.001, 100.0),
        "Largest distance of a good match from the geometry. Empty: it follows from the precision of the matches.",
    ),
    parameter(
        "geometry.largest_threshold_px",
        "Largest threshold",
        "px",
        real(0.01, 100.0),
        "Bound of the threshold that follows from the matches. Raise it for coarse matches.",
    ),
    parameter(
        "geometry.confidence",
        "Confidence",
        "",
        real(0.5, 0.999999),
        "Probability of drawing at least one sample of good matches only. Higher draws more samples.",
    ),
    parameter("geometry.max_samples", "Most samples", "", integer(1.0, 1e6), "Bound of the time where few matches are good."),
    parameter("geometry.seed", "Seed", "", integer(0.0, 4294967295.0), "Start of the random numbers: the same seed gives the same result."),
];
