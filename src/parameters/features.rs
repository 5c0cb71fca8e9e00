//! The parameters of multi-scale points and gradient descriptors.

use super::{Parameter, ParameterKind, choice, integer, parameter, real};

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
