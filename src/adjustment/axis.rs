//! Known directions of camera axes, by their weights.
//!
//! Symbols: d is the axis, the last row of M; n the known direction; the misclosure n - d has the length 2 sin(θ/2) of the angle θ between
//! them, which grows up to 180°. A small turn δ about the photo's axes changes d by δ₀ m₁ - δ₁ m₀, the other rows of M: these are at right
//! angles and of length 1, so that an axis adds its weight to the diagonal of both turns and nothing between them.

use super::block::{AxisPrior, Block};
use super::options::Datum;
use super::similarity::{Similarity, middle, scatter};
use super::sparse::{Block6, N};
use super::state::State;
use crate::camera::Pose;
use crate::math::{cross, dot3, minus};

/// A known direction of a camera axis with the weight of an angle across it, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WeightedAxis {
    direction: [f64; 3],
    weight: f64,
}

impl WeightedAxis {
    /// Observed angles of an axis: about itself it may turn.
    pub const OBSERVED: usize = 2;

    fn new(prior: &AxisPrior, sigma0: f64) -> Self {
        let root = sigma0 / prior.sigma_deg.to_radians();
        Self { direction: prior.direction, weight: root * root }
    }

    /// Weighted square of what the axis is off.
    pub fn square(&self, pose: &Pose) -> f64 {
        let off = minus(&self.direction, &pose.rotation[2]);
        self.weight * dot3(&off, &off)
    }

    /// Adds what it says of an image to the normal equations of that image.
    pub fn add_to_image(&self, pose: &Pose, diagonal: &mut Block6, scale: &mut [f64; N], right: &mut [f64]) {
        let [m0, m1, _] = &pose.rotation;
        let across = [dot3(m1, &self.direction), -dot3(m0, &self.direction)];
        for turn in 0..2 {
            diagonal[turn * N + turn] += self.weight;
            scale[turn] += self.weight;
            right[turn] += self.weight * across[turn];
        }
    }
}

/// The known axes of the images, for a standard error `sigma0` of a ray of weight 1; none without a datum to which they refer.
pub(super) fn observed_axes(block: &Block, datum: Datum, sigma0: f64) -> Vec<Option<WeightedAxis>> {
    let of_image = |axis: Option<AxisPrior>| axis.filter(|_| datum != Datum::Free).map(|prior| WeightedAxis::new(&prior, sigma0));
    block.images.iter().map(|image| of_image(image.axis)).collect()
}

/// The block, turned about the line through its images as the known axes would have it most: observed positions near a line leave this
/// turn open, and steps do not lead through half a turn.
pub(super) fn turned_to_axes(block: &Block, state: State) -> State {
    let known = || block.images.iter().zip(&state.images).filter_map(|(image, pose)| Some((image.axis?.direction, pose)));
    let centre = middle(state.images.iter().map(|pose| pose.position));
    let eigen = scatter(state.images.iter().map(|pose| pose.position), &centre).symmetric_eigen();
    let line: [f64; 3] = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned().into();
    let (mut sine, mut cosine) = (0.0, 0.0);
    for (direction, pose) in known() {
        let axis = &pose.rotation[2];
        sine += dot3(&line, &cross(axis, &direction));
        cosine += dot3(axis, &direction) - dot3(axis, &line) * dot3(&direction, &line);
    }
    if sine == 0.0 && cosine == 0.0 {
        return state;
    }
    let turn = nalgebra::Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(line.into()), libm::atan2(sine, cosine));
    let rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| turn[(i, j)]));
    Similarity { scale: 1.0, rotation, from: centre, to: centre }.state(&state)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    #[test]
    fn what_an_axis_adds_is_the_slope_of_its_square() {
        let prior = AxisPrior { direction: [0.0, 0.6, 0.8], sigma_deg: 2.0 };
        let axis = WeightedAxis::new(&prior, 0.3);
        for angles in [[0.3, -0.2, 1.1], [2.0, 0.4, -2.0]] {
            let pose = Pose::new(&rotation_from_angles(angles[0], angles[1], angles[2]), [1.0, 2.0, 3.0]);
            let (mut diagonal, mut scale, mut right) = ([0.0; 36], [0.0; N], [0.0; N]);
            axis.add_to_image(&pose, &mut diagonal, &mut scale, &mut right);
            for k in 0..N {
                let moved = |h: f64| {
                    let mut step = [0.0; N];
                    step[k] = h;
                    axis.square(&pose.moved(&step))
                };
                let slope = (moved(1e-5) - moved(-1e-5)) / 2e-5;
                assert!((slope + 2.0 * right[k]).abs() < 1e-5 * (1.0 + slope.abs()), "{angles:?} {k}: {slope} {}", right[k]);
            }
        }
    }

    #[test]
    fn the_square_counts_degrees_in_standard_errors() {
        let axis = WeightedAxis::new(&AxisPrior { direction: [0.0, 0.0, 1.0], sigma_deg: 2.0 }, 1.0);
        let pose = Pose::new(&rotation_from_angles(1_f64.to_radians(), 0.0, 0.0), [0.0; 3]);
        assert!((axis.square(&pose) - 0.25).abs() < 1e-4);
    }
}
