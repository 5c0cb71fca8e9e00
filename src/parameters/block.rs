//! The parameters of a block's multi-ray points and of simulated features.

use super::{Parameter, choice, integer, parameter, real};

/// The parameters of a block's pairs and multi-ray points.
pub const BLOCK_PARAMETERS: &[Parameter] = &[
    parameter(
        "pairs.rule",
        "Pairs",
        "",
        choice(&["all", "near", "sequence", "alike"]),
        "Which pairs are tried: all; images near each other by their positions; images that follow each other by name; images that look alike. By itself: all of up to 30 images, of more the near ones where every image has a position, else those alike.",
    ),
    parameter("pairs.near", "Near images", "", integer(1.0, 1000.0), "With how many of its nearest ones each image is tried."),
    parameter("pairs.sequence", "Following images", "", integer(1.0, 1000.0), "With how many of those after it each image is tried."),
    parameter("pairs.alike", "Similar images", "", integer(1.0, 1000.0), "With how many of the most similar ones each image is tried."),
    parameter(
        "pairs.least_matches",
        "Least matches",
        "",
        integer(8.0, 10000.0),
        "A pair is connected by so many matches that agree with one geometry.",
    ),
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
    parameter("block_flight.features", "Features an image", "", integer(1.0, 100000.0), "On average, where no photos are taken."),
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
    parameter("block_flight.receiver_m", "Receiver", "m", real(0.0, 100.0), "Standard deviation of a recorded position's coordinate."),
    parameter(
        "block_flight.buildings",
        "Buildings",
        "km⁻²",
        real(0.0, 20000.0),
        "Of a photographed scene; fewer stand where there are fewer lots.",
    ),
    parameter("block_flight.trees", "Trees", "km⁻²", real(0.0, 20000.0), "Of a photographed scene."),
    parameter("block_flight.seed", "Seed", "", integer(0.0, 4294967295.0), "The same seed gives the same block."),
];
