//! What calls are given beside settings, declared as settings are: the command and the documents read name, range, unit and help from here.

use super::parameter::{Parameter, ParameterKind, check};
use crate::Error;
use std::ops::RangeInclusive;

/// Focal lengths of cameras in px.
pub(crate) const FOCAL_PX: RangeInclusive<f64> = 1.0..=1e7;
/// Focal lengths of photos in mm.
const FOCAL_MM: RangeInclusive<f64> = 1e-3..=1e5;
/// Lengths in any unit: a base, the side of a pixel or of a cell. What a block allows of these follows from its extent.
pub(crate) const LENGTH: RangeInclusive<f64> = 1e-9..=1e9;
/// Heights of level ground in any unit.
const HEIGHT: RangeInclusive<f64> = -20_000.0..=20_000.0;
/// Standard errors of image coordinates in px.
pub(crate) const SIGMA_PX: RangeInclusive<f64> = 1e-9..=1e3;

/// The values of calls by the names of their arguments.
pub const CALL_PARAMETERS: &[Parameter] = &[
    Parameter {
        unit: "px",
        absent: "that of the camera",
        ..real(
            "focal_px",
            "Focal length of both photos",
            &FOCAL_PX,
            "The focal length of both photos, in place of a camera: the principal point in the middle, no distortion. A pixel is then taken to be 0.001 mm.",
        )
    },
    Parameter {
        unit: "mm",
        ..real("focal_mm", "Focal length", &FOCAL_MM, "The focal length (principal distance) of measured photo coordinates; required.")
    },
    Parameter {
        absent: "1: the base is the unit",
        ..real("base_length", "Length of the base", &LENGTH, "The length of the base in the unit that the object points get.")
    },
    Parameter {
        named: "level",
        absent: "0; of a mosaic that of its tie points",
        ..real("heights", "Level ground", &HEIGHT, "The height of level ground, where there is no height model.")
    },
    Parameter { absent: "that of the images", ..real("gsd", "Pixel of a mosaic", &LENGTH, "The side of a pixel, in units of the block.") },
    Parameter {
        absent: "an eightieth of the longer side of the block",
        ..real("cell", "Cell of a map of accuracy", &LENGTH, "The side of a cell, in units of the block.")
    },
    Parameter {
        unit: "px",
        absent: "σ₀ of the block",
        named: "point-sigma-px",
        ..real("sigma_px", "New points", &SIGMA_PX, "The standard error of an image coordinate of the points that would be measured.")
    },
    Parameter {
        unit: "m",
        absent: "none",
        named: "orthophoto",
        ..real(
            "gsd_m",
            "Orthophoto of a simulated block",
            &LENGTH,
            "Also writes orthophoto.tif and heights.tif of all that the photos show, with pixels of this side.",
        )
    },
    Parameter {
        kind: ParameterKind::Integer { min: 1.0, max: 256.0, odd: false },
        absent: "one for each processor, up to 16",
        ..real("workers", "Threads", &LENGTH, "The number of threads: the result is the same for any.")
    },
];

const fn real(key: &'static str, label: &'static str, allowed: &RangeInclusive<f64>, help: &'static str) -> Parameter {
    let kind = ParameterKind::Real { min: *allowed.start(), max: *allowed.end() };
    Parameter { key, section: "Values of calls", label, unit: "", kind, help, absent: "", acts: "", named: "" }
}

/// Rejects a value outside the range of the argument of that name.
pub(crate) fn check_call(key: &'static str, value: f64) -> Result<(), Error> {
    check(CALL_PARAMETERS, key, value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_of_a_call_is_held_to_its_declared_range() {
        for parameter in CALL_PARAMETERS {
            let (ParameterKind::Real { min, max } | ParameterKind::Integer { min, max, .. }) = parameter.kind else {
                panic!("{parameter:?}")
            };
            for value in [min, max] {
                check_call(parameter.key, value).unwrap();
            }
            for value in [min - 1.0, max * 2.0, f64::NAN] {
                let refused = check_call(parameter.key, value).unwrap_err().to_string();
                assert!(refused.starts_with(parameter.key) && refused.ends_with(&parameter.allowed().to_string()), "{refused}");
            }
            assert!(CALL_PARAMETERS.iter().filter(|other| other.key == parameter.key).count() == 1, "{}", parameter.key);
        }
    }
}
