//! Sparse symmetric matrices of 6 x 6 blocks: order of elimination, Cholesky factor, the inverse at the factor's places.
//!
//! Our own, since libraries choose their kernels by the machine at hand, and then the last bits are not the same everywhere; and since the
//! statistics need the factor's inner structure.

mod block;
mod cholesky;
mod dense;
mod dissection;
mod inverse;
mod ordering;
mod pattern;

pub(super) use block::{Block6, N, subtract_product3};
pub(super) use cholesky::{Factor, Refused};
pub(super) use dense::{DenseFactor, inverse_of_dense};
pub(super) use inverse::{Inverse, inverse};
pub(super) use pattern::{Pattern, SparseMatrix};
