//! Standard errors of a placed image that hold where neighbouring links share their errors, as those of one roof or one window do.

use super::adjusting::PlacingCamera;
use crate::adjustment::{image_errors, linearise};
use crate::camera::CAMERA_PARAMETERS;
use crate::{AdjustmentResult, Camera, ObservationVerdict};
use nalgebra::{DMatrix, DVector};

/// Cells on the longer side of the image within which links may share errors.
const CELLS: f64 = 10.0;
const OF_IMAGE: usize = 6;

/// Standard deviations of errors that all links share, as shares of the root mean square of a residual: of a shift along both axes; at the
/// edge of the image, of what grows with x and with y along both axes; of what grows outwards, with the third power, and with the height of
/// the ground. What stands behind walls and trees is seen beside them, on the outer side of all: windows there are drawn outwards.
const SHARED: [f64; 8] = [0.1, 0.1, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3];

/// The shift of a position by a unit of each of these errors.
fn shifts(camera: &Camera, at: [f64; 2], height: f64) -> [[f64; 2]; SHARED.len()] {
    let half = 0.5 * f64::from(camera.width_px.max(camera.height_px));
    let [x, y] = [0, 1].map(|k| (at[k] - camera.principal_point_px[k]) / half);
    let cube = x * x + y * y;
    [[1.0, 0.0], [0.0, 1.0], [x, 0.0], [y, 0.0], [0.0, x], [0.0, y], [x * cube, y * cube], [x * height, y * height]]
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

/// Those of the adjustment, or those of the sums of residuals in cells where these are larger.
///
/// # Source
/// Liang & Zeger 1986, Longitudinal data analysis using generalized linear models (the covariance of clusters, enlarged by C / (C - 1)).
pub(super) fn total_errors(result: &AdjustmentResult, known: &PlacingCamera) -> TotalErrors {
    let image = &result.images[0];
    let own =
        TotalErrors { angles_deg: image.angle_errors_deg, position: image.position_errors, camera: result.cameras[0].standard_errors };
    let Some(clustered) = clustered(result, known) else { return own };
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

fn clustered(result: &AdjustmentResult, known: &PlacingCamera) -> Option<TotalErrors> {
    let (camera, pose) = (&result.block.cameras[0], &result.block.images[0].pose);
    let free: Vec<usize> = (0..CAMERA_PARAMETERS).filter(|k| result.cameras[0].standard_errors[*k].is_some()).collect();
    let unknowns = OF_IMAGE + free.len();
    let sigma0 = result.sigma0_px?;
    let side = f64::from(camera.width_px.max(camera.height_px)) / CELLS;
    let mut normal = DMatrix::<f64>::zeros(unknowns, unknowns);
    let mut fields = vec![DVector::<f64>::zeros(unknowns); SHARED.len()];
    let heights = Spread::of(result);
    let mut squares = Spread::default();
    let mut sums = std::collections::BTreeMap::new();
    let values = camera.values();
    for (ray, statistics) in result.block.rays.iter().zip(&result.rays) {
        if statistics.verdict != ObservationVerdict::Accepted {
            continue;
        }
        let line = linearise(&values, pose, &result.block.points[ray.point]);
        let cell = [ray.x_px, ray.y_px].map(|v| (v / side) as i64);
        let sum = sums.entry(cell).or_insert_with(|| DVector::<f64>::zeros(unknowns));
        let by_field = shifts(camera, [ray.x_px, ray.y_px], heights.standardised(result.block.points[ray.point][2]));
        for row in 0..2 {
            squares.add(statistics.residual_px[row]);
            let of_camera = free.iter().map(|k| line.by_camera[row][*k]);
            let a = DVector::from_iterator(unknowns, line.by_image[row].into_iter().chain(of_camera));
            normal += ray.weight * &a * a.transpose();
            *sum += ray.weight * statistics.residual_px[row] * &a;
            fields.iter_mut().zip(by_field).for_each(|(field, shift)| *field += ray.weight * shift[row] * &a);
        }
    }
    let cells = sums.len() as f64;
    if cells < 2.0 {
        return None;
    }
    let mut middle = DMatrix::<f64>::zeros(unknowns, unknowns);
    for sum in sums.values() {
        middle += cells / (cells - 1.0) * sum * sum.transpose();
    }
    let rms_px = squares.square_mean().sqrt();
    for (field, share) in fields.iter().zip(SHARED) {
        middle += share * rms_px * (share * rms_px) * field * field.transpose();
    }
    for (column, sigma) in free.iter().enumerate().filter_map(|(column, k)| Some((OF_IMAGE + column, known.prior().sigma[*k]?))) {
        let weight = sigma0 / sigma * (sigma0 / sigma);
        normal[(column, column)] += weight;
        middle[(column, column)] += weight * weight * sigma * sigma;
    }
    let inverse = normal.try_inverse()?;
    let covariance = &inverse * middle * &inverse;
    let of_image = std::array::from_fn(|k| covariance[(k / OF_IMAGE, k % OF_IMAGE)]);
    let (angles_deg, position) = image_errors(pose, &of_image, 1.0);
    let mut camera = [None; CAMERA_PARAMETERS];
    free.iter().enumerate().for_each(|(column, k)| camera[*k] = Some(covariance[(OF_IMAGE + column, OF_IMAGE + column)].max(0.0).sqrt()));
    Some(TotalErrors { angles_deg, position: Some(position), camera })
}
