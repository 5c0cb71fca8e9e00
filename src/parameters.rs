//! Every tunable with its label, unit, range and help: the page, the command and the checks read them from here.

use crate::Error;
use serde::Serialize;

/// What values a parameter takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ParameterKind {
    /// Whole numbers from `min` to `max`; odd ones only where `odd`.
    Integer { min: f64, max: f64, odd: bool },
    /// Numbers from `min` to `max`, both included.
    Real { min: f64, max: f64 },
    /// One of these words.
    Choice { values: &'static [&'static str] },
    /// Yes or no.
    Flag,
}

/// One tunable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parameter {
    /// Its place in the settings, as [`PairSettings`](crate::PairSettings): `group.field`.
    pub key: &'static str,
    pub label: &'static str,
    /// Empty where it has none.
    pub unit: &'static str,
    #[serde(flatten)]
    pub kind: ParameterKind,
    /// What it does and what to try.
    pub help: &'static str,
}

const fn parameter(key: &'static str, label: &'static str, unit: &'static str, kind: ParameterKind, help: &'static str) -> Parameter {
    Parameter { key, label, unit, kind, help }
}

const fn integer(min: f64, max: f64) -> ParameterKind {
    ParameterKind::Integer { min, max, odd: false }
}

const fn odd(min: f64, max: f64) -> ParameterKind {
    ParameterKind::Integer { min, max, odd: true }
}

const fn real(min: f64, max: f64) -> ParameterKind {
    ParameterKind::Real { min, max }
}

const fn choice(values: &'static [&'static str]) -> ParameterKind {
    ParameterKind::Choice { values }
}

/// All tunables, in the order of the pipeline.
pub const PARAMETERS: &[Parameter] = &[
    parameter(
        "points.operator",
        "Operator",
        "",
        choice(&["ground2", "ground1", "forstner", "moravec"]),
        "The interest operator. Ground 2 is the paper's choice: contrast to the neighbours, then roundness.",
    ),
    parameter(
        "points.threshold",
        "Threshold",
        "",
        real(0.0, 1e9),
        "Ground: least grey difference (paper: 40). Förstner: factor of the mean weight (0.5 to 1.5). Moravec: sum of squared grey differences. Higher finds fewer points. Empty: the operator's default, lowered where it would leave less than 5 % of the pixels as candidates.",
    ),
    parameter(
        "points.fraction",
        "Fraction of candidates",
        "",
        real(0.000001, 1.0),
        "In place of a threshold: the share of all pixels that become candidates, set for each image (paper: 0.148). It survives a change of contrast.",
    ),
    parameter(
        "points.roundness",
        "Roundness q",
        "",
        real(0.0, 1.0),
        "Least roundness of the error ellipse: 1 is a corner or spot, 0 an edge (ground 2: 0.32 to 0.5, Förstner: 0.5 to 0.75).",
    ),
    parameter(
        "points.operator_window",
        "Operator window",
        "px",
        integer(2.0, 31.0),
        "Side of the operator's window: Moravec 4 or 8, Förstner 5 or 7. The ground operators always use 3.",
    ),
    parameter(
        "points.tiled",
        "Windows side by side",
        "",
        ParameterKind::Flag,
        "Moravec: windows side by side, as first published, in place of one at each pixel.",
    ),
    parameter(
        "points.suppression_window",
        "Suppression window",
        "px",
        odd(1.0, 255.0),
        "A point falls if a greater value lies in this window around it (paper: 3). 1 suppresses nothing; larger windows leave fewer, better spread points.",
    ),
    parameter(
        "points.ties",
        "Equal values",
        "",
        choice(&["keep", "first"]),
        "Whether all of several equal values in the suppression window survive, or the first in raster order.",
    ),
    parameter("window.side", "Moment window", "px", odd(3.0, 63.0), "Side of the window whose moments describe a point (paper: 11)."),
    parameter(
        "window.shape",
        "Window shape",
        "",
        choice(&["square", "circle"]),
        "A circular window does not change when the image is rotated; a square one does.",
    ),
    parameter(
        "window.brightness",
        "Brightness",
        "",
        choice(&["sum", "range", "unit"]),
        "How grey values become weights: sum and range do not change with gain and offset; unit is grey / 255.",
    ),
    parameter(
        "matching.strategy",
        "Strategy",
        "",
        choice(&["moments", "invariants", "correlation", "least-squares"]),
        "Moments and invariants compare interest points of both images; invariants also where these are rotated. Correlation and least squares compare grey values and find a place between pixels.",
    ),
    parameter(
        "matching.refine",
        "Refinement",
        "",
        choice(&["none", "least-squares"]),
        "Least squares matching moves each right position to a hundredth of a pixel and refuses what does not fit.",
    ),
    parameter(
        "matching.epipolar",
        "Along epipolar lines",
        "",
        ParameterKind::Flag,
        "Once the pair is oriented, matches again near the epipolar lines, until nothing changes. Needs a camera.",
    ),
    parameter(
        "matching.denominator",
        "Denominator",
        "",
        choice(&["maxabs", "floor"]),
        "What a difference is divided by: the larger magnitude, or at least the median magnitude over all points, which keeps small moments from dominating.",
    ),
    parameter(
        "matching.search",
        "Search window",
        "px",
        odd(1.0, 1023.0),
        "Side of the window, around the expected position, in which right points are candidates (paper: 25).",
    ),
    parameter(
        "matching.max_measure",
        "Largest measure",
        "",
        real(0.0, 14.0),
        "A best candidate whose measure is not below this is refused (paper: 3).",
    ),
    parameter(
        "matching.ambiguity",
        "Ambiguity ratio",
        "",
        real(0.0, 1.0),
        "Refused as ambiguous when the best measure exceeds this share of the second best. 1 switches the rule off.",
    ),
    parameter(
        "matching.parallax_neighbours",
        "Parallax neighbours",
        "",
        integer(0.0, 100.0),
        "How many nearest matches give the expected y-parallax. 0 switches the rule off.",
    ),
    parameter(
        "matching.parallax_tolerance",
        "Parallax tolerance",
        "px",
        real(0.0, 1000.0),
        "Least deviation from the neighbours' median y-parallax that is refused; where the neighbours scatter more, 3 times their scatter.",
    ),
    parameter(
        "matching.template",
        "Correlation window",
        "px",
        odd(5.0, 63.0),
        "Side of the window whose grey values are compared by correlation and least squares matching.",
    ),
    parameter(
        "matching.min_correlation",
        "Least correlation",
        "",
        real(-1.0, 1.0),
        "A match by grey values with a lower correlation coefficient is refused.",
    ),
    parameter(
        "matching.left_right",
        "Left-right check",
        "",
        ParameterKind::Flag,
        "Correlation: the window found must correlate best with the left point it came from.",
    ),
    parameter(
        "matching.max_standard_error",
        "Largest standard error",
        "px",
        real(0.001, 10.0),
        "Least squares matching: a match whose right position is less precise is refused, as on an edge along which it can slide.",
    ),
    parameter(
        "orientation.method",
        "Method",
        "",
        choice(&["rigorous", "determinant"]),
        "Rigorous: all four photo coordinates are observed. Determinant: the textbook form with unweighted determinants.",
    ),
    parameter(
        "orientation.robust",
        "Robust",
        "",
        ParameterKind::Flag,
        "Start from the consensus of minimal samples and reject gross errors. Without it one blunder can carry the solution away.",
    ),
    parameter(
        "orientation.alpha0",
        "Significance α₀",
        "",
        real(0.000001, 0.2),
        "Data snooping: the share of good matches that is rejected by mistake. 0.001 rejects beyond 3.29 standard errors (Baarda).",
    ),
    parameter(
        "orientation.beta0",
        "Power β₀",
        "",
        real(0.5, 0.999),
        "The probability with which a blunder of the minimal detectable size is found; it sets that size.",
    ),
    parameter(
        "orientation.weighting",
        "Robust weights",
        "",
        choice(&["none", "huber", "danish"]),
        "Weighs matches with large residuals down, beside the rejection.",
    ),
    parameter(
        "orientation.sigma0_mm",
        "σ₀ a priori",
        "mm",
        real(0.0000001, 100.0),
        "Standard error of a photo coordinate that is known beforehand: standard errors and tests use it, and a global test compares it with the residuals. Matches are rejected by it, or by the estimated one where that is larger. Empty: estimated.",
    ),
    parameter(
        "orientation.seed",
        "Seed",
        "",
        integer(0.0, 4294967295.0),
        "Start of the random numbers of the consensus: the same seed gives the same result.",
    ),
    parameter(
        "orientation.base_mm",
        "Photo base",
        "mm",
        real(-1e6, 1e6),
        "Length b of the base at photo scale; it scales by and bz only. Empty: the median x-parallax of the matches.",
    ),
];

/// The parameters of multi-scale points and their gradient descriptors.
pub const FEATURE_PARAMETERS: &[Parameter] = &[
    parameter(
        "multiscale.number",
        "Number of points",
        "",
        integer(1.0, 1000000.0),
        "Multi-scale points: most points of an image. They are distributed over it, so that dull regions keep their share.",
    ),
    parameter(
        "multiscale.levels",
        "Levels an octave",
        "",
        integer(1.0, 8.0),
        "Multi-scale points: steps of the pyramid in which points are sought while the scale doubles.",
    ),
    parameter(
        "multiscale.contrast",
        "Least contrast",
        "grey values",
        real(0.0, 255.0),
        "Multi-scale points: least contrast of a point to its surroundings. Lower finds more, noisier points.",
    ),
    parameter(
        "multiscale.roundness",
        "Roundness q",
        "",
        real(0.0, 1.0),
        "Multi-scale points: least roundness of the error ellipse at the point's scale: 1 is a corner or spot, 0 an edge.",
    ),
    parameter(
        "multiscale.cells",
        "Cells",
        "",
        integer(1.0, 256.0),
        "Multi-scale points: cells on the image's longer side; each has an equal share of the points. 1 keeps the best of the whole image.",
    ),
    parameter(
        "multiscale.position",
        "Position",
        "",
        choice(&["quadratic", "forstner"]),
        "Multi-scale points: the maximum of a quadratic through the responses, or the corner or circle's centre by least squares (Förstner).",
    ),
    parameter(
        "gradient.upright",
        "Upright",
        "",
        ParameterKind::Flag,
        "Gradient descriptors: no dominant direction is sought. Better and faster where the images are not rotated against each other.",
    ),
    parameter(
        "gradient.orientations",
        "Most directions",
        "",
        integer(1.0, 4.0),
        "Gradient descriptors: a point with several dominant directions gets a descriptor for each, up to this many.",
    ),
    parameter(
        "gradient.cell",
        "Cell",
        "scales",
        real(0.5, 20.0),
        "Gradient descriptors: side of one of the 4 x 4 cells in scales of the point. Larger ones tell more points apart and stand less relief.",
    ),
    parameter(
        "gradient.roots",
        "Square roots",
        "",
        ParameterKind::Flag,
        "Gradient descriptors: compares square roots of the histograms, so that strong gradients do not outweigh the others.",
    ),
];

/// The parameters of a simulated flight, in the order in which a panel shows them.
pub const FLIGHT_PARAMETERS: &[Parameter] = &[
    parameter(
        "flight.seed",
        "Seed",
        "",
        integer(0.0, 4294967295.0),
        "Everything random follows from it: the same seed gives the same pair.",
    ),
    parameter("flight.focal_mm", "Principal distance", "mm", real(10.0, 1000.0), "Of the camera."),
    parameter("flight.principal_x_mm", "Principal point x", "mm", real(-1.0, 1.0), "In the system of the fiducial marks."),
    parameter("flight.principal_y_mm", "Principal point y", "mm", real(-1.0, 1.0), "In the system of the fiducial marks."),
    parameter(
        "flight.distortion",
        "Radial distortion k₁",
        "mm⁻²",
        real(-0.000001, 0.000001),
        "Corrected coordinates are measured ones times 1 + k₁ r². 0.0000001 moves a corner of the frame by some 0.3 mm.",
    ),
    parameter("flight.pixel_mm", "Pixel", "mm", real(0.005, 1.0), "Side of a pixel of the scan."),
    parameter(
        "flight.width_px",
        "Columns",
        "px",
        integer(16.0, 4000.0),
        "Of the patches that are cut from the scans; the overlap limits it.",
    ),
    parameter("flight.height_px", "Rows", "px", integer(16.0, 4000.0), "Of the patches; the frame limits it."),
    parameter("flight.flying_height_m", "Flying height", "m", real(50.0, 5000.0), "Of the left photo above the mean ground."),
    parameter("flight.base_mm", "Photo base", "mm", real(0.0, 200.0), "Base component b at photo scale; the frame has 230 mm."),
    parameter("flight.omega_deg", "ω", "°", real(-10.0, 10.0), "Rotation of the right photo about x, against the left one."),
    parameter("flight.phi_deg", "φ", "°", real(-10.0, 10.0), "Rotation of the right photo about y."),
    parameter("flight.kappa_deg", "κ", "°", real(-10.0, 10.0), "Rotation of the right photo about z."),
    parameter("flight.by_mm", "by", "mm", real(-20.0, 20.0), "Base component across the flight, at photo scale."),
    parameter("flight.bz_mm", "bz", "mm", real(-20.0, 20.0), "Base component upwards, at photo scale."),
    parameter("flight.left_omega_deg", "Left ω", "°", real(-10.0, 10.0), "Tilt of the left photo against the ground."),
    parameter("flight.left_phi_deg", "Left φ", "°", real(-10.0, 10.0), "Tilt of the left photo against the ground."),
    parameter("flight.left_kappa_deg", "Left κ", "°", real(-10.0, 10.0), "Turn of the left photo against the flight line."),
    parameter("flight.relief_m", "Relief", "m", real(0.0, 500.0), "Range of the terrain's heights, up to a tenth of the flying height."),
    parameter("flight.buildings", "Buildings", "", integer(0.0, 50000.0), "Fewer stand where there are fewer lots."),
    parameter("flight.lowest_building_m", "Lowest building", "m", real(2.0, 500.0), "Height of the lowest eaves above ground."),
    parameter(
        "flight.highest_building_m",
        "Highest building",
        "m",
        real(2.0, 500.0),
        "Height of the highest eaves, up to a tenth of the flying height.",
    ),
    parameter("flight.trees", "Trees", "", integer(0.0, 50000.0), "A few less stand, since none grows in a house, a street or the river."),
    parameter(
        "flight.river_m",
        "River",
        "m",
        real(0.0, 200.0),
        "Width of a river through the town; its surface looks different in each exposure. 0: none.",
    ),
    parameter(
        "flight.driven_m",
        "Cars drive",
        "m",
        real(0.0, 100.0),
        "Way that cars in the lanes drive between the exposures. 0: they stand.",
    ),
    parameter(
        "flight.psf_px",
        "Point spread",
        "px",
        real(0.0, 1.0),
        "Standard deviation of the lens's point spread; the pixel's own square comes on top.",
    ),
    parameter(
        "flight.right_blur_px",
        "Blur of the right image",
        "px",
        real(0.0, 1.0),
        "Standard deviation of a blur beside the point spread.",
    ),
    parameter("flight.noise_grey", "Noise", "grey values", real(0.0, 50.0), "Standard deviation of independent noise in both images."),
    parameter(
        "flight.grain_grey",
        "Film grain",
        "grey values",
        real(0.0, 50.0),
        "Standard deviation of noise that neighbouring pixels share.",
    ),
    parameter("flight.grain_px", "Grain size", "px", real(0.3, 5.0), "Standard deviation of the grain's spread."),
    parameter(
        "flight.gain",
        "Gain",
        "",
        real(0.1, 10.0),
        "Grey values of the right image: those of the scene times the gain, plus the offset.",
    ),
    parameter("flight.offset_grey", "Offset", "grey values", real(-200.0, 200.0), "Of the right image."),
    parameter("flight.haze", "Haze", "", real(0.0, 0.9), "Share of the light that is haze of a uniform grey of 190 in both images."),
    parameter("flight.fiducial_noise_px", "Fiducial noise", "px", real(0.0, 10.0), "Standard deviation of a measured fiducial coordinate."),
];

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
        real(1.0, 1e7),
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

/// The parameters of a block's multi-ray points.
pub const BLOCK_PARAMETERS: &[Parameter] = &[
    parameter(
        "block.conflicts",
        "Conflicts",
        "",
        choice(&["resolve", "drop"]),
        "What is done where matches give a point two rays in one image: the least probable ones are cut, or the point is left out.",
    ),
    parameter(
        "block.impure",
        "Impure points",
        "",
        real(0.0, 0.5),
        "Share of points that may be expected to have a ray which does not belong to them. Matches that third images confirm too little are left out: more gives more points of two rays where the overlap is small.",
    ),
    parameter("block.min_rays", "Least rays", "", integer(2.0, 100.0), "Points seen in fewer images are left out."),
    parameter(
        "block.expected_right",
        "Expected right matches",
        "",
        real(0.01, 0.9999),
        "Share of right matches that is taken where no third image tells, as in a block of two images.",
    ),
    parameter(
        "selection.per_image",
        "Points an image",
        "",
        integer(1.0, 10000.0),
        "How many of its points an image keeps, spread evenly; more where its connections need them.",
    ),
    parameter(
        "selection.per_connection",
        "Points a connection",
        "",
        integer(0.0, 1000.0),
        "How many common points two overlapping images keep, or all where they have fewer.",
    ),
];

/// The parameters of a simulated block.
pub const BLOCK_FLIGHT_PARAMETERS: &[Parameter] = &[
    parameter(
        "block_flight.view",
        "View",
        "",
        choice(&["nadir", "oblique", "two-heights"]),
        "Straight down; one camera down and four tilted by 45°; or straight down with every other strip at 1.5 times the height.",
    ),
    parameter("block_flight.strips", "Strips", "", integer(1.0, 1000.0), "Flown side by side."),
    parameter(
        "block_flight.exposures",
        "Exposures a strip",
        "",
        integer(1.0, 1000.0),
        "Each by one camera, or by five in an oblique block.",
    ),
    parameter("block_flight.forward_overlap", "Forward overlap", "", real(0.0, 0.95), "Of photos that follow one another in a strip."),
    parameter("block_flight.side_overlap", "Side overlap", "", real(0.0, 0.95), "Of neighbouring strips."),
    parameter("block_flight.width_px", "Columns", "px", integer(16.0, 100000.0), "Across the flight."),
    parameter("block_flight.height_px", "Rows", "px", integer(16.0, 100000.0), "Along the flight."),
    parameter("block_flight.pixel_mm", "Pixel", "mm", real(0.0005, 1.0), "Side of a pixel; the principal distances are 85 mm and 65 mm."),
    parameter("block_flight.flying_height_m", "Flying height", "m", real(10.0, 10000.0), "Above the mean ground."),
    parameter("block_flight.relief_m", "Relief", "m", real(0.0, 1000.0), "Range of the ground's heights."),
    parameter("block_flight.features", "Features an image", "", integer(1.0, 100000.0), "On average."),
    parameter("block_flight.clutter", "Lone features", "", real(0.0, 0.9), "Share of the features that no other image shows."),
    parameter(
        "block_flight.matched",
        "Matched",
        "",
        real(0.0, 1.0),
        "Probability that a feature which two images show is matched between them.",
    ),
    parameter("block_flight.wrong", "Wrong matches", "", real(0.0, 1.0), "Share of the matches that join different places."),
    parameter(
        "block_flight.repeated",
        "Repeated structures",
        "",
        real(0.0, 1.0),
        "Share of the wrong matches that join the same two places in every pair of images.",
    ),
    parameter("block_flight.noise_px", "Noise", "px", real(0.0, 10.0), "Standard deviation of a feature's coordinate."),
    parameter("block_flight.seed", "Seed", "", integer(0.0, 4294967295.0), "The same seed gives the same block."),
];

/// All tunables of a bundle adjustment, by their fields in [`BundleOptions`](crate::BundleOptions).
pub const BUNDLE_PARAMETERS: &[Parameter] = &[
    parameter(
        "bundle.datum",
        "Datum",
        "",
        choice(&["free", "gps", "control", "gps_and_control"]),
        "What says where the block lies: its approximate values (free network), GPS positions, control points.",
    ),
    parameter(
        "bundle.loss",
        "Robust loss",
        "",
        choice(&["squares", "huber", "cauchy"]),
        "How large residuals are weighted down until the gross errors are found.",
    ),
    parameter("bundle.snooping", "Data snooping", "", ParameterKind::Flag, "Rejects gross errors by the tests of their residuals."),
    parameter(
        "bundle.alpha0",
        "Significance α₀",
        "",
        real(1e-6, 0.1),
        "Probability with which data snooping rejects a good coordinate: 0.001 rejects beyond 3.29 standard errors.",
    ),
    parameter(
        "bundle.sigma0_px",
        "σ₀ a priori",
        "px",
        real(1e-6, 1000.0),
        "Standard error of an image coordinate of weight 1 that is known before; without it the residuals tell.",
    ),
    parameter(
        "bundle.calibration_limit_px",
        "Limit of self-calibration",
        "px",
        real(0.01, 1000.0),
        "A camera parameter is fixed where its standard error moves a ray at the edge of the image by more than this.",
    ),
    parameter("bundle.max_iterations", "Iterations", "", integer(1.0, 10000.0), "That one adjustment may take."),
    parameter(
        "bundle.statistics",
        "Statistics",
        "",
        ParameterKind::Flag,
        "Standard errors, redundancies and tests; they take about as long as the adjustment.",
    ),
];

/// All tunables of a simulated block, by their fields in [`NetworkFlight`](crate::NetworkFlight).
pub const NETWORK_PARAMETERS: &[Parameter] = &[
    parameter("network.kind", "Kind", "", choice(&["nadir", "oblique", "two_heights"]), "How the images look down."),
    parameter("network.strips", "Strips", "", integer(1.0, 1000.0), "Parallel flight lines."),
    parameter("network.stations", "Stations", "", integer(1.0, 1000.0), "Exposures of a strip."),
    parameter("network.flying_height_m", "Flying height", "m", real(1.0, 100000.0), "Above the mean ground."),
    parameter("network.relief_m", "Relief", "m", real(0.0, 50000.0), "Range of the ground's heights, up to half the flying height."),
    parameter("network.width_px", "Columns", "px", integer(16.0, 100000.0), "Of an image; across the strip."),
    parameter("network.height_px", "Rows", "px", integer(16.0, 100000.0), "Of an image; along the strip."),
    parameter("network.focal_px", "Focal length", "px", real(10.0, 1e6), "Of the camera that looks down."),
    parameter("network.end_lap", "End lap", "", real(0.0, 0.95), "Share of an image that the next of the strip shows."),
    parameter("network.side_lap", "Side lap", "", real(0.0, 0.95), "Share of an image that the next strip shows."),
    parameter("network.points_per_image", "Points", "", real(1.0, 1e5), "Ground points in the area of one image."),
    parameter("network.noise_px", "Noise", "px", real(0.0, 100.0), "Standard deviation of an image coordinate."),
    parameter("network.gross_share", "Gross errors", "", real(0.0, 0.9), "Share of the rays that are wrong."),
    parameter("network.gross_px", "Size of gross errors", "px", real(0.0, 10000.0), "Largest in each coordinate."),
    parameter("network.gps_sigma_m", "GPS noise", "m", real(0.0, 1000.0), "Standard deviation of a GPS coordinate; 0: no GPS."),
    parameter("network.control_points", "Control points", "", integer(0.0, 100000.0), "Spread over the block."),
    parameter("network.control_sigma_m", "Control noise", "m", real(1e-6, 1000.0), "Standard deviation of a surveyed coordinate."),
    parameter("network.approximate_m", "Approximations", "m", real(0.0, 20000.0), "Standard deviation of what is known before."),
    parameter("network.seed", "Seed", "", integer(0.0, 4294967295.0), "Start of the random numbers."),
];

/// Finds a parameter by its key.
pub(crate) fn parameter_of(key: &str) -> &'static Parameter {
    let mut all = PARAMETERS.iter().chain(FEATURE_PARAMETERS).chain(GEOMETRY_PARAMETERS).chain(BLOCK_PARAMETERS).chain(BUNDLE_PARAMETERS);
    all.find(|p| p.key == key).unwrap_or_else(|| unreachable!("no parameter {key}"))
}

/// Refuses a number outside the range of its parameter.
pub(crate) fn check(key: &'static str, value: f64) -> Result<(), Error> {
    check_by(parameter_of(key), value)
}

/// As [`check`], for a parameter at hand.
pub(crate) fn check_by(parameter: &'static Parameter, value: f64) -> Result<(), Error> {
    let (within, allowed) = match parameter.kind {
        ParameterKind::Integer { min, max, odd } => {
            let whole = value.fract() == 0.0 && value >= min && value <= max;
            (whole && (!odd || value % 2.0 == 1.0), format!("{}whole numbers from {min} to {max}", if odd { "odd " } else { "" }))
        }
        ParameterKind::Real { min, max } => (value >= min && value <= max, format!("{min} to {max}")),
        ParameterKind::Choice { .. } | ParameterKind::Flag => unreachable!("{} is no number", parameter.key),
    };
    if within { Ok(()) } else { Err(refuse(parameter.key, value, allowed)) }
}

/// The error of an option outside its range.
pub(crate) fn refuse(field: &'static str, got: impl ToString, allowed: impl Into<String>) -> Error {
    Error::InvalidOption { field, got: got.to_string(), allowed: allowed.into() }
}
