//! What nalgebra lacks: quantiles, real roots of polynomials, order statistics, seeded random numbers.

mod distribution;
mod lanes;
mod polynomial;
mod random;
mod statistics;

pub(crate) use distribution::{chi_square_quantile, normal_median_within, normal_quantile, normal_spread_within};
pub(crate) use lanes::Lanes;
pub(crate) use polynomial::{MAX_DEGREE, real_roots};
pub(crate) use random::Random;
pub(crate) use statistics::{median, smallest};
