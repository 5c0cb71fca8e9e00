//! Whether the heights are those of the ground that an image shows.
//!
//! Heights that all err alike, or like a slope, move and tilt the image, and no residual shows them. Others leave two traces: the points ask for larger
//! or smaller heights (of another unit, say), and whole regions of the image lie together elsewhere than the heights put them.

use super::adjusting::PlacingCamera;
use super::links::Found;
use super::precision::{OF_IMAGE, Row, accepted_rows, estimated, in_cells, prior_weights};
use super::rectify::Seen;
use crate::math::median;
use crate::{AdjustmentResult, Camera, Pose};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the image says of the heights of the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Relief {
    /// Absent where the ground has no relief by which it could be told.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factor: Option<HeightFactor>,
    /// The share of the cells of the image, of those with enough points, whose points lie together elsewhere than the heights put them. Absent where there
    /// are few such cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub displaced: Option<f64>,
}

/// By what the differences of the heights from their mean would have to be multiplied to fit the image best.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct HeightFactor {
    pub factor: f64,
    pub standard_error: f64,
}

/// Ground is level whose heights have a standard deviation of less than this share of the height above it.
const LEVEL: f64 = 1e-3;
/// Cells on the longer side of the image, and points in one, at least.
const CELLS: f64 = 10.0;
const LEAST_IN_CELL: usize = 6;
const LEAST_CELLS: usize = 10;
/// Points are displaced together where half of them lie within this of their median, and that so far off: in px of an image of 1200 on its longer side.
const DISPLACED_PX: f64 = 2.0;
const PX_OF_LONGER: f64 = 1200.0;

/// The factor of the heights, estimated beside all that the adjustment estimated.
///
/// # Source
/// Liang & Zeger 1986 for its standard error, as that of the image.
pub(super) fn height_factor(result: &AdjustmentResult, known: &PlacingCamera) -> Option<HeightFactor> {
    let sigma0 = result.sigma0_px?;
    let free = estimated(result);
    let rows = accepted_rows(result, &free);
    let mean = |value: &dyn Fn(&Row) -> f64| rows.iter().map(value).sum::<f64>() / rows.len().max(1) as f64;
    let middle = mean(&|row| row.place[2]);
    let deviation = mean(&|row| (row.place[2] - middle) * (row.place[2] - middle)).sqrt();
    let above = result.block.images[0].pose.position[2] - middle;
    if !(deviation > LEVEL * above.abs()) {
        return None;
    }
    // In units of their standard deviation, that the equations are of one size.
    let unknowns = OF_IMAGE + free.len() + 1;
    let last = unknowns - 1;
    let coefficients = |row: &Row, axis: usize| {
        let mut all = row.by_unknowns[axis].clone().resize_vertically(unknowns, 0.0);
        all[last] = row.by_height[axis] * (row.place[2] - middle) / deviation;
        all
    };
    let mut normal = DMatrix::<f64>::zeros(unknowns, unknowns);
    let mut right = DVector::<f64>::zeros(unknowns);
    for row in &rows {
        for axis in 0..2 {
            let a = coefficients(row, axis);
            normal += row.weight * &a * a.transpose();
            right += row.weight * row.residual_px[axis] * &a;
        }
    }
    for (k, weight) in prior_weights(&free, known, sigma0) {
        normal[(k, k)] += weight;
    }
    let inverse = normal.try_inverse()?;
    let solution = &inverse * right;
    let weighted = rows.iter().map(|row| {
        let one = |axis: usize| {
            let a = coefficients(row, axis);
            row.weight * (row.residual_px[axis] - a.dot(&solution)) * a
        };
        (row.at, one(0) + one(1))
    });
    let covariance = &inverse * in_cells(&result.block.cameras[0], weighted, unknowns)? * &inverse;
    let standard_error = covariance[(last, last)].max(0.0).sqrt() / deviation;
    Some(HeightFactor { factor: 1.0 + solution[last] / deviation, standard_error })
}

/// The share of cells whose links lie together elsewhere than an orientation and the heights put them.
pub(super) fn displaced(links: &[Found], camera: &Camera, pose: &Pose) -> Option<f64> {
    let seen = Seen::new(camera, pose);
    let longer = f64::from(camera.width_px.max(camera.height_px));
    let mut cells: BTreeMap<[i64; 2], Vec<[f64; 2]>> = BTreeMap::new();
    for link in links {
        let Some(at) = seen.at(&link.place) else { continue };
        let cell = link.at.map(|v| (CELLS * v / longer) as i64);
        cells.entry(cell).or_default().push([link.at[0] - at[0], link.at[1] - at[1]]);
    }
    let limit = DISPLACED_PX * (longer / PX_OF_LONGER).max(1.0);
    let is_displaced = |offsets: &[[f64; 2]]| {
        let middle = [0, 1].map(|k| median(&mut offsets.iter().map(|off| off[k]).collect::<Vec<f64>>()).unwrap_or(0.0));
        let near = offsets.iter().filter(|off| libm::hypot(off[0] - middle[0], off[1] - middle[1]) <= limit).count();
        libm::hypot(middle[0], middle[1]) > limit && 2 * near >= offsets.len()
    };
    let enough: Vec<&Vec<[f64; 2]>> = cells.values().filter(|offsets| offsets.len() >= LEAST_IN_CELL).collect();
    let number = enough.iter().filter(|offsets| is_displaced(offsets)).count();
    (enough.len() >= LEAST_CELLS).then(|| number as f64 / enough.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::orthophoto::adjusting::{PlaceErrors, adjusted};
    use crate::{CameraUncertainty, PlacingOptions};

    const POSE: Pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0, 0.0, 500.0] };

    fn camera() -> Camera {
        Camera::without_distortion(800, 600, 1000.0)
    }

    /// Links over hills so high, whose heights are so many times the true ones, measured to so many px at most.
    fn links(factor: f64, hills_m: f64, error_px: f64, seed: u32) -> Vec<Found> {
        let (mut random, camera) = (Random::new(seed), camera());
        let seen = Seen::new(&camera, &POSE);
        let mut unit = || random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5;
        let mut all = Vec::new();
        while all.len() < 600 {
            let [x, y] = [400.0 * unit(), 300.0 * unit()];
            let z = 0.5 * hills_m * (libm::sin(x / 40.0) + libm::cos(y / 30.0));
            let noise = [0, 1].map(|_| 2.0 * error_px * unit());
            let Some([column, row]) = seen.at(&[x, y, z]) else { continue };
            all.push(Found { at: [column + noise[0], row + noise[1]], place: [x, y, factor * z], height_spread: 0.0, measured_px: 0.3 });
        }
        all
    }

    fn estimated(links: &[Found], uncertainty: CameraUncertainty) -> Option<HeightFactor> {
        let known = PlacingCamera { camera: camera(), uncertainty, decentring: None };
        let errors = PlaceErrors::new(&PlacingOptions::default(), 0.5, true);
        height_factor(&adjusted(links, &known, (camera(), POSE), errors).unwrap(), &known)
    }

    #[test]
    fn heights_in_another_unit_are_told_by_the_factor_that_they_lack() {
        for (uncertainty, factor) in [(CameraUncertainty::NONE, 1.6), (CameraUncertainty::EXIF, 1.6), (CameraUncertainty::NONE, 0.6)] {
            let found = estimated(&links(factor, 6.0, 1.8, 1), uncertainty).unwrap();
            // Points that fit wrong heights best stay, and draw it towards 1.
            let apart = (found.factor - 1.0) / found.standard_error;
            assert!((found.factor - 1.0) * (1.0 / factor - 1.0) > 0.0 && apart.abs() > 4.0, "{factor}: {found:?}");
        }
        let little = estimated(&links(1.1, 6.0, 1.8, 2), CameraUncertainty::NONE).unwrap();
        assert!((little.factor - 1.0 / 1.1).abs() < 3.0 * little.standard_error && little.standard_error < 0.05, "{little:?}");
    }

    #[test]
    fn the_factor_of_right_heights_is_1_within_its_standard_error() {
        let beyond = (0..40).filter(|seed| {
            let found = estimated(&links(1.0, 20.0, 0.35, 100 + seed), CameraUncertainty::NONE).unwrap();
            (found.factor - 1.0).abs() > 2.0 * found.standard_error
        });
        assert!(beyond.count() <= 6);
        assert_eq!(estimated(&links(1.0, 0.0, 0.35, 1), CameraUncertainty::NONE), None, "level ground");
    }

    #[test]
    fn regions_that_lie_elsewhere_together_are_displaced_and_single_points_are_not() {
        let right = links(1.0, 20.0, 0.35, 1);
        assert_eq!(displaced(&right, &camera(), &POSE), Some(0.0));
        // A quarter of the image, each point of it by the same.
        let shifted = |is_wrong: &dyn Fn(usize, &Found) -> bool| -> Vec<Found> {
            let moved =
                |(k, link): (usize, &Found)| if is_wrong(k, link) { Found { at: [link.at[0] + 5.0, link.at[1]], ..*link } } else { *link };
            right.iter().enumerate().map(moved).collect()
        };
        let region = displaced(&shifted(&|_, link| link.at[0] < 195.0), &camera(), &POSE).unwrap();
        assert!((0.15..0.35).contains(&region), "{region}");
        // Of few points in a cell most may happen to be among them.
        let single = displaced(&shifted(&|k, _| k % 4 == 0), &camera(), &POSE).unwrap();
        assert!(single < 0.05, "{single}");
        assert_eq!(displaced(&right[..30], &camera(), &POSE), None, "few cells with enough points");
    }
}
