//! What nalgebra lacks: real roots of polynomials, order statistics, seeded random numbers.

mod polynomial;
mod random;
mod statistics;

pub(crate) use polynomial::{MAX_DEGREE, real_roots};
pub(crate) use random::Random;
pub(crate) use statistics::{mad_within, median, smallest};
