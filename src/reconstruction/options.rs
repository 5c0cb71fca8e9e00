//! What the user chooses of the reconstruction of a block.

use crate::Error;
use crate::adjustment::{AdjustmentOptions, Datum};
use crate::catalogue::options;
use crate::tracks::SelectOptions;

/// A focal length that is fixed at a value from growth would hide its error: it is estimated where the block says anything of it.
const CALIBRATION_LIMIT_PX: f64 = 20.0;

options! {
    /// Options of [`reconstruct_block`](crate::reconstruct_block).
    pub struct ReconstructionOptions in "reconstruction" {
        section "Incremental orientation";

        /// What says where the block lies, in place of the datum of the adjustment.
        datum: Option<Datum> = None, "Datum", absent "the positions that suffice, or a free network";

        /// The observations per image by which the block is oriented and, where points are chosen, adjusted: more are more precise, fewer are
        /// faster.
        growing_rays: usize = 200, "Observations while it grows", 30..=10000;

        /// The minimum number of observations that agree on the orientation of an image: more orient fewer images, more certainly.
        least_rays: usize = 12, "Minimum observations", 6..=1000;

        /// The minimum angle between two rays of a point: a larger one ignores more points of uncertain depth.
        least_angle_deg: f64 = 1.5, "Minimum angle", in "°", 0.01..=45;

        /// The maximum residual of an observation while the block grows; it follows the residuals down from there.
        largest_residual_px: f64 = 8.0, "Maximum residual", in "px", 0.1..=1000;

        /// The standard error of a measured coordinate of a control point: higher gives it less weight beside tie points; measurements beyond
        /// five times as much do not fit.
        mark_sigma_px: f64 = 1.0, "Standard error of an image measurement", in "px", 0.01..=100;

        /// The maximum number of models that are given where the block falls apart, the largest first.
        most_models: usize = 10, "Maximum models", 1..=1000;

        /// The start of the random numbers: the same seed gives the same result.
        seed: u32 = 1, "Seed", 0..=4294967295.0;

        beside;

        /// Control points, the first so many of the description, that are rejected and named where they contradict the other observations; absent: all.
        tested_control: Option<usize> = None;

        /// How many tie points there were to choose from, as far as that is known: above these count the numbers by which texts name other points.
        found_points: usize = 0;

        /// The points that are given of the adjusted block; absent: all are adjusted and given.
        selection: Option<SelectOptions> = None;
        /// By default as [`AdjustmentOptions`] is, but that camera parameters are fixed beyond 20 px.
        adjustment: AdjustmentOptions = AdjustmentOptions { calibration_limit_px: CALIBRATION_LIMIT_PX, ..AdjustmentOptions::default() };
    }
}

impl ReconstructionOptions {
    /// Rejects values outside their ranges.
    pub(super) fn check(&self) -> Result<(), Error> {
        self.check_ranges()?;
        self.selection.as_ref().map_or(Ok(()), SelectOptions::check_ranges)?;
        self.adjustment.check_ranges()
    }
}
