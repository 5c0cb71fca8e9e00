//! The models of two views, one a file. Each has a `search` among matches, `from_known` for a geometry that other matches gave, and the
//! `result` that it makes of what was found.

pub(super) mod calibrated;
pub(super) mod plane;
pub(super) mod pure_rotation;
pub(super) mod uncalibrated;
pub(super) mod unknown_focal;
