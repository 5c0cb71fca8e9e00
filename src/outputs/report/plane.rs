//! The plane that a block is drawn in.

use super::subject::Subject;
use crate::{ErrorEllipse, Pose};

/// Two axes at right angles, each of length 1, in the system of the model.
pub(super) struct Plane([[f64; 3]; 2]);

impl Plane {
    /// X and Y of a georeferenced block; else the plane that its images look at: the system of a free network is any.
    pub fn of(subject: &Subject<'_>) -> Self {
        let level = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        if subject.model.is_none_or(|model| model.in_system) {
            return level;
        }
        let poses: Vec<&Pose> = subject.run.model.images.iter().filter_map(|image| image.pose.as_ref()).collect();
        let mean = |row: usize| [0, 1, 2].map(|k| poses.iter().map(|pose| pose.rotation[row][k]).sum::<f64>());
        let Some(up) = unit(mean(2)) else { return level };
        // To the right of the first image.
        let right = poses.first().map_or([1.0, 0.0, 0.0], |pose| pose.rotation[0]);
        let along = dot(right, up);
        match unit([0, 1, 2].map(|k| right[k] - along * up[k])) {
            Some(x) => Self([x, [up[1] * x[2] - up[2] * x[1], up[2] * x[0] - up[0] * x[2], up[0] * x[1] - up[1] * x[0]]]),
            None => level,
        }
    }

    pub fn place(&self, position: [f64; 3]) -> [f64; 2] {
        self.0.map(|axis| dot(axis, position))
    }

    /// The ellipse of a position by its standard errors and the correlations of the first two, of the first with the third, of the last two.
    pub fn ellipse(&self, errors: [f64; 3], correlations: [f64; 3]) -> ErrorEllipse {
        let [xy, xz, yz] = correlations;
        let matrix = [[1.0, xy, xz], [xy, 1.0, yz], [xz, yz, 1.0]];
        let covariance = |a: [f64; 3], b: [f64; 3]| {
            (0..9).map(|k| a[k / 3] * errors[k / 3] * matrix[k / 3][k % 3] * errors[k % 3] * b[k % 3]).sum::<f64>()
        };
        let [x, y] = self.0;
        ErrorEllipse::new(covariance(x, x), covariance(x, y), covariance(y, y))
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(vector, vector).sqrt();
    (length > 1e-6).then(|| vector.map(|value| value / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ellipses_follow_the_plane() {
        let level = Plane([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        let round = level.ellipse([3.0, 4.0, 9.0], [0.0; 3]);
        assert!(
            (round.semi_major - 4.0).abs() < 1e-12
                && (round.semi_minor - 3.0).abs() < 1e-12
                && (round.bearing_deg.abs() - 90.0).abs() < 1e-9
        );
        // Two coordinates that are one: a line at 45 degrees.
        let thin = level.ellipse([1.0, 1.0, 9.0], [1.0, 0.0, 0.0]);
        assert!(thin.semi_minor < 1e-6 && (thin.semi_major - 2.0_f64.sqrt()).abs() < 1e-12 && (thin.bearing_deg - 45.0).abs() < 1e-9);
        let upright = Plane([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        let seen = upright.ellipse([1.0, 2.0, 5.0], [0.0; 3]);
        assert!((seen.semi_major - 5.0).abs() < 1e-12 && (seen.semi_minor - 2.0).abs() < 1e-12);
        assert_eq!(upright.place([1.0, 2.0, 3.0]), [2.0, 3.0]);
    }
}
