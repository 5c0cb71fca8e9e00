//! What nalgebra lacks: quantiles, real roots of polynomials, order statistics, seeded random numbers, consensus.

mod consensus;
mod distribution;
mod lanes;
mod null_space;
mod polynomial;
mod random;
mod statistics;

pub(crate) use consensus::{BLOCK, Candidate, Problem, Search, consensus};
pub(crate) use distribution::{chi_square_quantile, normal_density, normal_median_within, normal_quantile, normal_spread_within};
pub(crate) use lanes::Lanes;
pub(crate) use null_space::null_space;
pub(crate) use polynomial::{MAX_DEGREE, real_roots};
pub(crate) use random::Random;
pub(crate) use statistics::{median, smallest};
