//! Adjusts until the set of accepted rays and of estimated camera parameters does not change any more: robust first, then by least squares.
//!
//! `course` is what changes from round to round. `rays` and `positions` reject observations, `lost` brings points back, `parameters` fixes what of the cameras is not
//! determined, `systematic` what of the errors of positions is not or is zero; `rounds` puts these checks in their order.

mod course;
mod lost;
mod parameters;
mod positions;
mod rays;
mod rounds;
mod systematic;

pub(super) use rounds::{Settled, settle};
