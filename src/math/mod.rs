//! What nalgebra lacks: quantiles, real roots of polynomials, order statistics, seeded random numbers, consensus; places on the earth.

#[macro_use]
mod operator;

mod consensus;
mod distribution;
mod geodesy;
mod lanes;
mod null_space;
mod pairs;
mod polynomial;
mod random;
mod rays;
mod statistics;
mod student;
mod two;
mod vector;
mod whole;

pub(crate) use consensus::{BLOCK, Candidate, Problem, Search, consensus};
pub(crate) use distribution::{
    chi_square_quantile, normal_density, normal_median_within, normal_outside, normal_quantile, normal_spread_within,
};
pub use geodesy::{geographic_from_local, local_from_geographic};
pub(crate) use geodesy::{median_longitude, turn};
pub(crate) use lanes::Lanes;
pub(crate) use null_space::null_space;
pub(crate) use pairs::Pairs;
pub(crate) use polynomial::{MAX_DEGREE, real_roots};
pub(crate) use random::Random;
pub(crate) use rays::nearest_to_rays;
pub(crate) use statistics::{MEDIAN_BY_MEAN, MEDIAN_LENGTH, median, scatter, smallest, weighted_median};
pub(crate) use student::{detectable_shift, f_limit, joint_limit, ln_choices, ln_f_above, student_limit, tau_limit, variance_left};
pub(crate) use two::Two;
pub(crate) use vector::{cross, dot3, minus};
pub(crate) use whole::Whole;
