//! The parameters of a bundle adjustment and of simulated rays.

use super::{Parameter, ParameterKind, choice, integer, parameter, real};

/// All tunables of a bundle adjustment, by their fields in [`AdjustmentOptions`](crate::AdjustmentOptions).
pub const ADJUSTMENT_PARAMETERS: &[Parameter] = &[
    parameter(
        "adjustment.datum",
        "Datum",
        "",
        choice(&["free", "gnss", "control", "gnss_and_control"]),
        "What says where the block lies: its approximate values (free network), GNSS positions, control points.",
    ),
    parameter(
        "adjustment.loss",
        "Robust loss",
        "",
        choice(&["squares", "huber", "cauchy"]),
        "How large residuals are weighted down until the gross errors are found.",
    ),
    parameter("adjustment.snooping", "Data snooping", "", ParameterKind::Flag, "Rejects gross errors by the tests of their residuals."),
    parameter(
        "adjustment.alpha0",
        "Significance α₀",
        "",
        real(1e-6, 0.1),
        "Probability with which data snooping rejects a good coordinate: 0.001 rejects beyond 3.29 standard errors.",
    ),
    parameter(
        "adjustment.sigma0_px",
        "σ₀ a priori",
        "px",
        real(1e-6, 1000.0),
        "Standard error of an image coordinate of weight 1 that is known before; without it the residuals tell.",
    ),
    parameter(
        "adjustment.calibration_limit_px",
        "Limit of self-calibration",
        "px",
        real(0.01, 1000.0),
        "A camera parameter is fixed where its standard error moves a ray at the edge of the image by more than this.",
    ),
    parameter("adjustment.max_iterations", "Iterations", "", integer(1.0, 10000.0), "That one adjustment may take."),
    parameter(
        "adjustment.statistics",
        "Statistics",
        "",
        ParameterKind::Flag,
        "Standard errors, redundancies and tests; they take about as long as the adjustment.",
    ),
];

/// All tunables of the reconstruction of a block, by their fields in [`ReconstructionOptions`](crate::ReconstructionOptions).
pub const RECONSTRUCTION_PARAMETERS: &[Parameter] = &[
    parameter(
        "reconstruction.datum",
        "Datum",
        "",
        choice(&["free", "gnss", "control", "gnss_and_control"]),
        "What says where the block lies; without it, the observed positions that suffice.",
    ),
    parameter(
        "reconstruction.growing_rays",
        "Rays while it grows",
        "",
        integer(30.0, 10000.0),
        "Rays of an image by which the block is put together and adjusted: more are more precise, fewer are faster.",
    ),
    parameter("reconstruction.least_rays", "Least rays", "", integer(6.0, 1000.0), "That agree on the orientation of an image."),
    parameter(
        "reconstruction.least_angle_deg",
        "Least angle",
        "°",
        real(0.01, 45.0),
        "Between two rays of a point: points of smaller angles are left out.",
    ),
    parameter(
        "reconstruction.largest_residual_px",
        "Largest residual",
        "px",
        real(0.1, 1000.0),
        "Of a ray while the block grows; it follows the residuals down from there.",
    ),
    parameter(
        "reconstruction.mark_sigma_px",
        "Standard error of a mark",
        "px",
        real(0.01, 100.0),
        "Of a coordinate where an image shows a surveyed point: it weighs marks beside tie points; those beyond five times as much do not fit.",
    ),
    parameter(
        "reconstruction.most_models",
        "Most models",
        "",
        integer(1.0, 1000.0),
        "Given where the block falls apart, the largest first.",
    ),
    parameter("reconstruction.seed", "Seed", "", integer(0.0, 4294967295.0), "Start of the random numbers."),
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
    parameter("network.gnss_sigma_m", "GNSS noise", "m", real(0.0, 1000.0), "Standard deviation of a GNSS coordinate; 0: no GNSS."),
    parameter("network.control_points", "Control points", "", integer(0.0, 100000.0), "Spread over the block."),
    parameter("network.control_sigma_m", "Control noise", "m", real(1e-6, 1000.0), "Standard deviation of a surveyed coordinate."),
    parameter("network.approximate_m", "Approximations", "m", real(0.0, 20000.0), "Standard deviation of what is known before."),
    parameter("network.seed", "Seed", "", integer(0.0, 4294967295.0), "Start of the random numbers."),
];
