//! The two moments of a flight.

/// When a photo is taken: between the two, cars drive and water moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::simulate) enum Moment {
    First,
    Second,
}
