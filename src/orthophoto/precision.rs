//! Standard errors of a placed image that hold where neighbouring links share their errors, as those of one roof or one window do.

use super::adjusting::{PlaceErrors, PlacingCamera};
use crate::adjustment::{image_errors, linearise};
use crate::camera::CAMERA_PARAMETERS;
use crate::{AdjustmentResult, BlockObservation, Camera, ObservationStatistics, ObservationVerdict};
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Cells on the longer side of the image within which links may share errors.
const CELLS: f64 = 10.0;
pub(super) const OF_IMAGE: usize = 6;

/// Standard deviations of errors that all links share, as shares of the root mean square of a residual: of a shift along both axes; at the
/// edge of the image, of what grows with x and with y along both axes; of what grows outwards, with the third power, and with the height of
/// the ground. What stands behind walls and trees is seen beside them, on the outer side of all: where the heights have neither, windows there are
/// drawn outwards.
const SHARED: [f64; 8] = [0.1, 0.1, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3];

/// The shift of a position by a unit of each of these errors.
fn shifts(camera: &Camera, at: [f64; 2], height: f64) -> [[f64; 2]; SHARED.len()] {
    let half = 0.5 * f64::from(camera.width_px.max(camera.height_px));
    let [x, y] = [0, 1].map(|k| (at[k] - camera.principal_point_px[k]) / half);
    let cube = x * x + y * y;
    [[1.0, 0.0], [0.0, 1.0], [x, 0.0], [y, 0.0], [0.0, x], [0.0, y], [x * cube, y * cube], [x * height, y * height]]
}

/// Heights are wrong by these together: over the whole image, along it, and as bowls and saddles are. Camera and orientation take their place in the
/// residuals, of which they leave the small ones.
const HILLS: usize = 6;
/// Standard deviation of each where one level stands for all heights, as so many times what the residuals still show; never more than the standard error of
/// the level.
const OF_RESIDUALS: f64 = 3.0;
/// Standard deviation of each where there is a height model, as a share of the standard error of its heights: of all together, and at the edge of the image
/// of what varies over it.
const OF_MODEL: [f64; HILLS] = [1.0, 0.7, 0.7, 0.7, 0.7, 0.7];

/// What hills add to the height of a place.
fn hills(camera: &Camera, at: [f64; 2]) -> [f64; HILLS] {
    let half = 0.5 * f64::from(camera.width_px.max(camera.height_px));
    let [x, y] = [0, 1].map(|k| (at[k] - camera.principal_point_px[k]) / half);
    [1.0, x, y, x * y, x * x, y * y]
}

/// Number, sum and sum of squares.
#[derive(Debug, Clone, Copy, Default)]
struct Spread([f64; 3]);

impl Spread {
    /// Of the heights of the links.
    fn of(result: &AdjustmentResult) -> Self {
        let mut spread = Self::default();
        result.block.rays.iter().for_each(|ray| spread.add(result.block.points[ray.point][2]));
        spread
    }

    fn add(&mut self, value: f64) {
        let Self([n, sum, squares]) = self;
        (*n, *sum, *squares) = (*n + 1.0, *sum + value, *squares + value * value);
    }

    fn square_mean(&self) -> f64 {
        self.0[2] / self.0[0].max(1.0)
    }

    /// The difference from the mean by the standard deviation; 0 where all are the same.
    fn standardised(&self, value: f64) -> f64 {
        let mean = self.0[1] / self.0[0].max(1.0);
        let deviation = (self.square_mean() - mean * mean).max(0.0).sqrt();
        if deviation > 1e-9 { (value - mean) / deviation } else { 0.0 }
    }
}

/// Standard errors of a placed image.
#[derive(Debug, Clone, Copy)]
pub(super) struct TotalErrors {
    pub angles_deg: Option<[f64; 3]>,
    pub position: Option<[f64; 3]>,
    pub camera: [Option<f64>; CAMERA_PARAMETERS],
}

/// Those of the adjustment, or where they are larger those of what neighbours share: the sums of residuals in cells, errors that all links share, and heights
/// that are wrong together. Where all links lie in one cell nothing tells these.
///
/// # Source
/// Liang & Zeger 1986, Longitudinal data analysis using generalized linear models (the covariance of clusters, enlarged by C / (C - 1)).
pub(super) fn total_errors(result: &AdjustmentResult, known: &PlacingCamera, errors: PlaceErrors) -> TotalErrors {
    let image = &result.images[0];
    let own =
        TotalErrors { angles_deg: image.angle_errors_deg, position: image.position_errors, camera: result.cameras[0].standard_errors };
    let Some(clustered) = clustered(result, known, errors) else { return own };
    let larger = |own: Option<[f64; 3]>, other: Option<[f64; 3]>| match (own, other) {
        (Some(own), Some(other)) => Some([0, 1, 2].map(|k| own[k].max(other[k]))),
        (own, other) => own.or(other),
    };
    TotalErrors {
        angles_deg: larger(own.angles_deg, clustered.angles_deg),
        position: larger(own.position, clustered.position),
        camera: std::array::from_fn(|k| Some(own.camera[k]?.max(clustered.camera[k].unwrap_or(0.0)))),
    }
}

/// An accepted observation, with the derivatives of its column and row.
pub(super) struct Row {
    pub at: [f64; 2],
    pub place: [f64; 3],
    pub weight: f64,
    pub residual_px: [f64; 2],
    /// By the unknowns of the image, then by what is estimated of the camera.
    pub by_unknowns: [DVector<f64>; 2],
    pub by_height: [f64; 2],
}

/// The parameters of the camera that an adjustment estimated.
pub(super) fn estimated(result: &AdjustmentResult) -> Vec<usize> {
    (0..CAMERA_PARAMETERS).filter(|k| result.cameras[0].standard_errors[*k].is_some()).collect()
}

/// `free`: of [`estimated`].
pub(super) fn accepted_rows(result: &AdjustmentResult, free: &[usize]) -> Vec<Row> {
    let (values, pose) = (result.block.cameras[0].values(), &result.block.images[0].pose);
    let accepted = result.block.rays.iter().zip(&result.rays).filter(|(_, statistics)| statistics.verdict == ObservationVerdict::Accepted);
    let row = |(ray, statistics): (&BlockObservation, &ObservationStatistics)| {
        let place = result.block.points[ray.point];
        let line = linearise(&values, pose, &place);
        let by_unknowns = [0, 1].map(|axis| {
            let of_camera = free.iter().map(|k| line.by_camera[axis][*k]);
            DVector::from_iterator(OF_IMAGE + free.len(), line.by_image[axis].into_iter().chain(of_camera))
        });
        let by_height = line.by_point.map(|by_point| by_point[2]);
        Row { at: [ray.x_px, ray.y_px], place, weight: ray.weight, residual_px: statistics.residual_px, by_unknowns, by_height }
    };
    accepted.map(row).collect()
}

/// What holds the unknowns of the camera: which, and its weight.
pub(super) fn prior_weights<'a>(free: &'a [usize], known: &PlacingCamera, sigma0: f64) -> impl Iterator<Item = (usize, f64)> + use<'a> {
    let sigma = known.prior().sigma;
    free.iter().enumerate().filter_map(move |(column, k)| {
        let weight = sigma0 / sigma[*k]? * (sigma0 / sigma[*k]?);
        Some((OF_IMAGE + column, weight))
    })
}

/// The squares of the sums in each cell of the image, which errors that its links share enlarge. Absent where all lie in one.
pub(super) fn in_cells(camera: &Camera, weighted: impl Iterator<Item = ([f64; 2], DVector<f64>)>, unknowns: usize) -> Option<DMatrix<f64>> {
    let side = f64::from(camera.width_px.max(camera.height_px)) / CELLS;
    let mut sums = BTreeMap::new();
    for (at, vector) in weighted {
        *sums.entry(at.map(|v| (v / side) as i64)).or_insert_with(|| DVector::<f64>::zeros(unknowns)) += vector;
    }
    let cells = sums.len() as f64;
    let middle =
        || sums.values().fold(DMatrix::zeros(unknowns, unknowns), |middle, sum| middle + cells / (cells - 1.0) * sum * sum.transpose());
    (cells >= 2.0).then(middle)
}

fn clustered(result: &AdjustmentResult, known: &PlacingCamera, errors: PlaceErrors) -> Option<TotalErrors> {
    let (camera, pose) = (&result.block.cameras[0], &result.block.images[0].pose);
    let free = estimated(result);
    let unknowns = OF_IMAGE + free.len();
    let sigma0 = result.sigma0_px?;
    let mut normal = DMatrix::<f64>::zeros(unknowns, unknowns);
    let mut fields = vec![DVector::<f64>::zeros(unknowns); SHARED.len()];
    let heights = Spread::of(result);
    let mut of_hills = vec![DVector::<f64>::zeros(unknowns); HILLS];
    let (mut squares, mut by_height) = (Spread::default(), Spread::default());
    let rows = accepted_rows(result, &free);
    for row in &rows {
        let by_field = shifts(camera, row.at, heights.standardised(row.place[2]));
        let by_hill = hills(camera, row.at);
        for (axis, a) in row.by_unknowns.iter().enumerate() {
            squares.add(row.residual_px[axis]);
            by_height.add(row.by_height[axis]);
            of_hills.iter_mut().zip(by_hill).for_each(|(field, hill)| *field += row.weight * row.by_height[axis] * hill * a);
            normal += row.weight * a * a.transpose();
            fields.iter_mut().zip(by_field).for_each(|(field, shift)| *field += row.weight * shift[axis] * a);
        }
    }
    let weighted = rows.iter().map(|row| {
        let one = |axis: usize| row.weight * row.residual_px[axis] * &row.by_unknowns[axis];
        (row.at, one(0) + one(1))
    });
    let mut middle = in_cells(camera, weighted, unknowns)?;
    let rms_px = squares.square_mean().sqrt();
    for (field, share) in fields.iter().zip(SHARED) {
        middle += share * rms_px * (share * rms_px) * field * field.transpose();
    }
    let of_hill = if errors.is_level {
        let shown = OF_RESIDUALS * rms_px / by_height.square_mean().sqrt();
        [shown.min(errors.height); HILLS]
    } else {
        OF_MODEL.map(|share| share * errors.height)
    };
    for (field, height) in of_hills.iter().zip(of_hill) {
        middle += height * height * field * field.transpose();
    }
    for (k, weight) in prior_weights(&free, known, sigma0) {
        normal[(k, k)] += weight;
        middle[(k, k)] += weight * sigma0 * sigma0;
    }
    let inverse = normal.try_inverse()?;
    let covariance = &inverse * middle * &inverse;
    let of_image = std::array::from_fn(|k| covariance[(k / OF_IMAGE, k % OF_IMAGE)]);
    let (angles_deg, position) = image_errors(pose, &of_image, 1.0);
    let mut camera = [None; CAMERA_PARAMETERS];
    free.iter().enumerate().for_each(|(column, k)| camera[*k] = Some(covariance[(OF_IMAGE + column, OF_IMAGE + column)].max(0.0).sqrt()));
    Some(TotalErrors { angles_deg, position: Some(position), camera })
}

#[cfg(test)]
mod tests {
    use super::super::adjusting::{PlaceErrors, adjusted};
    use super::super::links::Found;
    use super::super::rectify::Seen;
    use super::*;
    use crate::math::Random;
    use crate::{CameraUncertainty, PlacingOptions, Pose};

    const POSE: Pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0, 0.0, 500.0] };

    /// A model of the heights, with the standard error that is stated of it in m.
    type Model<'a> = (&'a dyn Fn(f64, f64) -> f64, f64);

    /// Of X, Y, Z, ω, φ, κ, of a photo over such ground by a camera that differs from what is known of it as its kind does; by a model, or on one level.
    fn errors_by_standard_errors(
        seed: u32,
        ground: fn(f64, f64) -> f64,
        uncertainty: CameraUncertainty,
        model: Option<Model<'_>>,
    ) -> [f64; 6] {
        let nominal = Camera::without_distortion(1000, 750, 1000.0);
        let mut random = Random::new(seed);
        let mut unit = || random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5;
        let mut normal = || (0..12).map(|_| unit()).sum::<f64>();
        let f = nominal.focal_px;
        let lens = Camera {
            focal_px: f * (1.0 + uncertainty.focal * normal()),
            principal_point_px: nominal.principal_point_px.map(|c| c + uncertainty.principal_point * f * normal()),
            radial: [uncertainty.k1 * normal(), uncertainty.k1 * normal(), 0.0],
            tangential: [0, 1].map(|_| uncertainty.decentring() * normal()),
            ..nominal
        };
        let seen = Seen::new(&lens, &POSE);
        let mut links = Vec::new();
        while links.len() < 500 {
            let [x, y] = [320.0 * normal() / 1.5, 240.0 * normal() / 1.5];
            let z = ground(x, y);
            let Some([column, row]) = seen.at(&[x, y, z]) else { continue };
            let at = [column + 0.4 * normal(), row + 0.4 * normal()];
            if lens.sees(at[0], at[1]) {
                links.push(Found {
                    at,
                    place: [x, y, model.map_or(0.0, |(height, _)| height(x, y))],
                    height_spread: 0.0,
                    measured_px: 0.3,
                });
            }
        }
        let known = PlacingCamera { camera: nominal, uncertainty, decentring: None };
        let options = PlacingOptions { height_sigma_m: model.map(|(_, sigma_m)| sigma_m), ..PlacingOptions::default() };
        let errors = PlaceErrors::new(&options, 0.5, model.is_some());
        let result = adjusted(&links, &known, (nominal, POSE), errors).unwrap();
        let total = total_errors(&result, &known, errors);
        let pose = result.block.images[0].pose;
        let (position, angles) = (total.position.unwrap(), total.angles_deg.unwrap());
        let own = pose.angles();
        std::array::from_fn(|k| match k {
            0..3 => (pose.position[k] - POSE.position[k]) / position[k],
            _ => own[k - 3].to_degrees() / angles[k - 3],
        })
    }

    /// Mean squares over so many photos.
    fn squares(of: impl Fn(u32) -> [f64; 6], photos: u32) -> [f64; 6] {
        let all: Vec<[f64; 6]> = (0..photos).map(of).collect();
        std::array::from_fn(|k| all.iter().map(|ratios| ratios[k] * ratios[k]).sum::<f64>() / all.len() as f64)
    }

    fn hills(x: f64, y: f64) -> f64 {
        10.0 * (libm::sin(x / 40.0) + libm::cos(y / 30.0))
    }

    #[test]
    fn standard_errors_hold_what_files_do_not_know_of_a_lens() {
        let [x, y, z, omega, phi, kappa] =
            squares(|seed| errors_by_standard_errors(seed, hills, CameraUncertainty::EXIF, Some((&hills, 0.05))), 24);
        for square in [x, y, omega, phi] {
            assert!((0.3..2.0).contains(&square), "{square}");
        }
        // They hold errors that these links have not: of what grows outwards and with the height.
        assert!(z < 1.0 && kappa < 1.0, "{z} {kappa}");
    }

    #[test]
    fn standard_errors_hold_heights_that_are_wrong_together_by_what_is_stated_of_them() {
        // In waves of 380 to 530 m, in a photo that shows 500 m, by 0.5 m as is stated: half of it all heights together.
        let of = |seed: u32| {
            let mut random = Random::new(seed + 1000);
            let mut unit = || random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5;
            let mut normal = || (0..12).map(|_| unit()).sum::<f64>();
            let [all, east, north, both] = std::array::from_fn(|_| normal());
            let model = move |x: f64, y: f64| {
                let waves = east * libm::sin(x / 80.0) + north * libm::cos(y / 60.0) + both * libm::sin((x + y) / 120.0);
                hills(x, y) + 0.5 * libm::sqrt(0.5) * all + 0.5 * libm::sqrt(1.0 / 3.0) * waves
            };
            errors_by_standard_errors(seed, hills, CameraUncertainty::NONE, Some((&model, 0.5)))
        };
        let all = squares(of, 40);
        assert!(all.iter().all(|square| *square < 1.5), "{all:?}");
        assert!(all.iter().sum::<f64>() > 0.2 * all.len() as f64, "{all:?}");
    }

    #[test]
    fn standard_errors_hold_hills_that_a_level_is_not_and_level_ground_stays_precise() {
        // A slope and a valley, which the image takes for its own tilt and height, and what is left for the residuals.
        let valley = |x: f64, y: f64| 6.0 * x / 300.0 - 5.0 * (y / 300.0) * (y / 300.0) + 2.0 * libm::sin(x / 25.0);
        let of = |ground| {
            let [x, y, _, omega, phi, _] = squares(|seed| errors_by_standard_errors(seed, ground, CameraUncertainty::EXIF, None), 8);
            [x, y, omega, phi]
        };
        for of_ground in [of(valley), of(|_, _| 0.0)] {
            assert!(of_ground.iter().all(|square| *square < 2.0), "{of_ground:?}");
        }
    }
}
