//! Which systematic errors GNSS positions may have.

use crate::catalogue::choices;

choices! {
    /// Errors that GNSS positions share.
    pub enum GnssErrors {
        /// None.
        None = "none",
        /// One offset of all positions.
        Offset = "offset",
        /// An offset of each strip of the flight.
        StripOffsets = "strip-offsets",
        /// An offset of each strip, and a drift that grows along it.
        StripDrifts = "strip-drifts",
    }
}
