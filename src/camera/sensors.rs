//! Sizes of sensors by maker and model.

/// Width and height in mm of the sensor of a camera; `None` where it is not listed.
pub(super) fn sensor_mm(_make: &str, _model: &str) -> Option<[f64; 2]> {
    None
}
