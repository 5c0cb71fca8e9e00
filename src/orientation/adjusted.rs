//! What an adjustment gives.

use super::coplanarity::RelativePose;
use super::normals::Matrix5;

/// The adjusted pose and what its precision follows from. Lengths are in units of the focal length.
#[derive(Debug, Clone)]
pub(super) struct Adjusted {
    pub pose: RelativePose,
    /// N⁻¹ of the turns and the shifts of the base, for a photo coordinate of weight 1.
    pub cofactors: Matrix5,
    /// Cofactors of the estimate: N⁻¹, or more where it is another than least squares of all good observations.
    pub precision: Matrix5,
    /// What the estimate makes of a change of the weighted residuals: N⁻¹, or more where residuals are cut or weighted down.
    pub sensitivity: Matrix5,
    /// Standard error of a photo coordinate of weight 1; 0 without redundancy.
    pub sigma: f64,
    /// What a rejection has left of the variance of good observations: σ² and the precision are divided by it already. 1 without a rejection.
    pub variance_left: f64,
    pub iterations: usize,
    /// Size of the last step relative to [`step_tolerance`](super::adjustment::step_tolerance).
    pub last_step: f64,
}

impl Adjusted {
    /// Turns the base into its opposite. Of its two tangents the first turns too and the second does not, while both shifts do: the second
    /// shift changes sign.
    pub fn reverse_base(&mut self) {
        self.pose.base = -self.pose.base;
        for k in 0..4 {
            for matrix in [&mut self.cofactors, &mut self.precision, &mut self.sensitivity] {
                matrix[(k, 4)] = -matrix[(k, 4)];
                matrix[(4, k)] = -matrix[(4, k)];
            }
        }
    }
}
