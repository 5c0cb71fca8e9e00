//! The cameras of a pair that nobody calibrated: their constants have prior standard deviations, which reach the total standard errors of
//! ω φ κ by bz. Where the focal length is hardly known, the constants enter the adjustment as unknowns with that prior information.
//!
//! By the inverse of a partitioned matrix, the covariance of the pose in the adjustment of all unknowns is that of the pose with
//! fixed cameras and what the covariance of the cameras adds to it.

use super::geometry::PairInterior;
use crate::camera::{CameraUncertainty, Interior};
use crate::orientation::{Ray, RelativePose};
use crate::{EstimatedCamera, SharedErrors};
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Unknowns of the pose; those of a camera: the logarithm of the focal length, x and y of the principal point in focal lengths, k1 in units
/// of the focal length; and those of the y-parallax that matches share over the image: 1, x, y, xy, x², y².
const POSE: usize = 5;
const CAMERA: usize = 4;
const MODES: usize = 6;

/// Prior standard deviation of each mode of the y-parallax, in standard errors of a coordinate: walls, roofs and the shape of a point's
/// surroundings give matches of one part of the image an error of the same sign.
const SHARED_PARALLAX: f64 = 0.15;

/// Standard deviation of a focal length, as a share of it, up to which the constants of a camera stay as they were given.
const KNOWN_FOCAL: f64 = 0.1;

/// Steps after which the adjustment ends, and the longest change of an unknown in one of them.
const MOST_STEPS: usize = 50;
const LONGEST_STEP: f64 = 0.2;
/// Prior standard deviations by which a value may differ from what was known before.
const MOST_UNLIKE: f64 = 3.0;
/// Halvings of a step that would make the agreement worse.
const MOST_HALVINGS: usize = 6;
/// A step is settled where it moves no unknown by more of its standard error.
const SETTLED: f64 = 0.01;
/// Standard errors beyond which the weight of a match falls, for an efficiency of 95 % with normal errors (Huber 1981, Robust Statistics).
const HUBER: f64 = 1.345;

/// The cameras of a pair as it calibrates them.
pub(super) struct SelfCalibration {
    pub interior: PairInterior,
    given: PairInterior,
    /// Of the constants and the modes.
    values: DVector<f64>,
    pose: RelativePose,
    /// Of the values: those of the left and the right camera, once where they are one camera, and of the modes.
    covariance: DMatrix<f64>,
    cameras: usize,
    /// Largest coordinate of a ray, by which those of the modes are divided.
    extent: f64,
}

/// Matches of one pair: positions in px, their weights, and the standard error of a coordinate of weight 1 in focal lengths.
pub(super) struct Measured<'a> {
    pub positions: &'a [[f64; 4]],
    pub weights: &'a [f64],
    pub sigma: f64,
    /// Side of a cell in which matches share errors, in focal lengths.
    pub neighbourhood: f64,
}

/// Whether the pair tells more of its cameras than is known. A focal length of EXIF is nearer the true one than what real pairs of flat ground
/// tell: the errors of their matches are not independent, nor those of their lenses what k1 describes.
pub(super) fn tells_more(interior: &PairInterior) -> bool {
    [&interior.left, &interior.right].iter().any(|side| side.uncertainty.is_some_and(|known| known.focal > KNOWN_FOCAL))
}

/// Whether anything of the cameras is not known.
pub(super) fn is_wanted(interior: &PairInterior) -> bool {
    interior.left.uncertainty.is_some() || interior.right.uncertainty.is_some()
}

/// Estimates what is not known of the cameras together with the pose, from a pose that was found with the cameras as given. `None` where
/// the adjustment does not settle.
pub(super) fn calibrated(given: &PairInterior, measured: &Measured<'_>, pose: RelativePose) -> Option<SelfCalibration> {
    let cameras = cameras_of(given);
    let constants = cameras * CAMERA;
    let shared = constants + MODES;
    let variance = measured.sigma * measured.sigma;
    let priors = priors(given, cameras, measured.sigma);
    let extent = extent(&rays(measured.positions, given));
    // What is minimised: Huber's function of the corrections of positions, and the prior information.
    let objective = |pose: &RelativePose, values: &DVector<f64>| {
        let interior = with_constants(given, values, cameras);
        let growth = growth(values, cameras);
        let rays = rays(measured.positions, &interior);
        let of_matches = rays.iter().zip(measured.weights).filter_map(|(ray, weight)| {
            let line = pose.linearise(&pose.tangents(), ray, &pose.project(ray).0)?;
            let shift: f64 = modes(ray, extent).iter().enumerate().map(|(k, mode)| mode * values[constants + k]).sum();
            let distance = growth * (line.misclosure + shift).abs() * weight.sqrt() / measured.sigma;
            Some(if distance < HUBER { distance * distance } else { HUBER * (2.0 * distance - HUBER) })
        });
        of_matches.sum::<f64>() + values.iter().zip(priors.iter()).map(|(value, prior)| (value / prior) * (value / prior)).sum::<f64>()
    };
    let (mut pose, mut values) = (pose, DVector::<f64>::zeros(shared));
    let mut best = objective(&pose, &values);
    for _ in 0..MOST_STEPS {
        let (interior, growth) = (with_constants(given, &values, cameras), growth(&values, cameras));
        let tangents = pose.tangents();
        let (mut normal, mut right) = (DMatrix::zeros(POSE + shared, POSE + shared), DVector::zeros(POSE + shared));
        let mut cells: BTreeMap<[i64; 2], DVector<f64>> = BTreeMap::new();
        let effects = effects(measured.positions, given, &values, cameras);
        for (index, (ray, weight)) in rays(measured.positions, &interior).iter().zip(measured.weights).enumerate() {
            let Some(line) = pose.linearise(&tangents, ray, &pose.project(ray).0) else { continue };
            let modes = modes(ray, extent);
            let misclosure = line.misclosure + modes.iter().enumerate().map(|(k, mode)| mode * values[constants + k]).sum::<f64>();
            let mut row = DVector::zeros(POSE + shared);
            row.rows_mut(0, POSE).copy_from(&line.by_unknowns);
            for (k, effect) in effects.iter().enumerate() {
                row[POSE + k] = (0..4).map(|c| line.by_coordinates[c] * effect[index][c]).sum();
            }
            for camera in 0..cameras {
                row[POSE + camera * CAMERA] += misclosure / cameras as f64;
            }
            row.rows_mut(POSE + constants, MODES).copy_from_slice(&modes);
            let (row, misclosure) = (row * growth, misclosure * growth);
            let distance = misclosure.abs() * weight.sqrt();
            let weight = weight * (HUBER * measured.sigma / distance.max(f64::MIN_POSITIVE)).min(1.0);
            normal.ger(weight, &row, &row, 1.0);
            right.axpy(-weight * misclosure, &row, 1.0);
            let cell = [ray[0], ray[1]].map(|v| libm::floor(v / measured.neighbourhood) as i64);
            *cells.entry(cell).or_insert_with(|| DVector::zeros(POSE + shared)) += row * (weight * misclosure);
        }
        for (k, prior) in priors.iter().enumerate() {
            let weight = variance / (prior * prior);
            normal[(POSE + k, POSE + k)] += weight;
            right[POSE + k] -= weight * values[k];
        }
        let cofactors = normal.cholesky()?.inverse();
        let whole = &cofactors * right;
        let moved = |step: &DVector<f64>| (pose.moved(&step.fixed_rows::<POSE>(0).into_owned()), &values + step.rows(POSE, shared));
        let mut step = &whole * (LONGEST_STEP / whole.amax()).min(1.0);
        let mut next = moved(&step);
        for _ in 0..MOST_HALVINGS {
            if objective(&next.0, &next.1) <= best {
                break;
            }
            step *= 0.5;
            next = moved(&step);
        }
        best = objective(&next.0, &next.1);
        (pose, values) = next;
        if (0..POSE + shared).all(|k| whole[k].abs() <= SETTLED * measured.sigma * cofactors[(k, k)].max(0.0).sqrt()) {
            // Neighbours share errors: what the sums over cells show beside the prior information, where it is more.
            let mut meat: DMatrix<f64> =
                cells.values().fold(DMatrix::zeros(POSE + shared, POSE + shared), |sum, s| sum + s * s.transpose());
            for (k, prior) in priors.iter().enumerate() {
                meat[(POSE + k, POSE + k)] += variance * variance / (prior * prior);
            }
            let by_cells = &cofactors * meat * &cofactors;
            let raised = |k: usize| (by_cells[(k, k)] / (variance * cofactors[(k, k)])).max(1.0).sqrt();
            let covariance = DMatrix::from_fn(shared, shared, |i, j| {
                let (i, j) = (POSE + i, POSE + j);
                variance * cofactors[(i, j)] * raised(i) * raised(j)
            });
            // A camera as unlike its prior as this explains something else, as gross errors or the shape of the ground.
            if values.iter().zip(priors.iter()).any(|(value, prior)| value.abs() > MOST_UNLIKE * prior) {
                return None;
            }
            let interior = with_constants(given, &values, cameras);
            return Some(SelfCalibration { interior, given: *given, values, pose, covariance, cameras, extent });
        }
    }
    None
}

impl SelfCalibration {
    /// The cameras as given, with their priors alone: where the matches cannot tell more.
    pub fn of_priors(given: &PairInterior, measured: &Measured<'_>, pose: RelativePose) -> Self {
        let cameras = cameras_of(given);
        let priors = priors(given, cameras, measured.sigma);
        let covariance = DMatrix::from_diagonal(&priors.component_mul(&priors));
        let extent = extent(&rays(measured.positions, given));
        Self { interior: *given, given: *given, values: DVector::zeros(priors.len()), pose, covariance, cameras, extent }
    }

    /// What the errors of the cameras, and those that matches share, do to the observations: along the principal axes of their covariance,
    /// which are independent.
    pub fn shared_errors(&self, positions: &[[f64; 4]]) -> Vec<SharedErrors> {
        let axes = self.covariance.clone().symmetric_eigen();
        let causes: Vec<DVector<f64>> =
            axes.eigenvalues.iter().zip(axes.eigenvectors.column_iter()).map(|(variance, axis)| axis * variance.max(0.0).sqrt()).collect();
        let focal_mm = self.interior.focal_mm;
        let by_constants = effects(positions, &self.given, &self.values, self.cameras);
        let rays = rays(positions, &self.interior);
        let of = |index: usize, cause: Option<&DVector<f64>>| -> [f64; 4] {
            let Some(cause) = cause else { return [0.0; 4] };
            let modes = self.modes_across(&rays[index]);
            let effects = by_constants.iter().map(|effect| effect[index]).chain(modes);
            effects
                .zip(cause.iter())
                .fold([0.0; 4], |sum, (effect, change)| std::array::from_fn(|c| sum[c] + focal_mm * effect[c] * change))
        };
        causes
            .chunks(3)
            .map(|three| SharedErrors {
                effects: (0..positions.len()).map(|index| std::array::from_fn(|k| of(index, three.get(k)))).collect(),
                covariance: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            })
            .collect()
    }

    /// The change of the coordinates of a ray by each mode, which lies across the epipolar line.
    fn modes_across(&self, ray: &Ray) -> [[f64; 4]; MODES] {
        let across = self.pose.linearise(&self.pose.tangents(), ray, ray).map_or([0.0; 4], |line| line.by_coordinates);
        modes(ray, self.extent).map(|mode| across.map(|v| mode * v))
    }

    /// What is known of the left and the right camera now.
    pub fn cameras(&self) -> [EstimatedCamera; 2] {
        let right = if self.cameras == 1 { 0 } else { CAMERA };
        [(&self.interior.left, 0), (&self.interior.right, right)].map(|(side, first)| {
            let error = |k: usize| self.covariance[(first + k, first + k)].max(0.0).sqrt();
            let focal_mm = self.interior.focal_mm;
            EstimatedCamera {
                focal_mm,
                focal_standard_error_mm: focal_mm * error(0),
                principal_point_mm: side.principal_point_mm,
                principal_point_standard_errors_mm: [focal_mm * error(1), focal_mm * error(2)],
                k1_per_mm2: side.radial_distortion[0],
                k1_standard_error_per_mm2: error(3) / (focal_mm * focal_mm),
            }
        })
    }
}

/// The modes of the y-parallax at a point of the left photo.
fn modes(ray: &Ray, extent: f64) -> [f64; MODES] {
    let [x, y] = [ray[0] / extent, ray[1] / extent];
    [1.0, x, y, x * y, x * x, y * y]
}

fn extent(rays: &[Ray]) -> f64 {
    rays.iter().flat_map(|ray| [ray[0].abs(), ray[1].abs()]).fold(f64::MIN_POSITIVE, f64::max)
}

/// How many cameras are to be told: one where both photos are of the same, as far as is known.
fn cameras_of(given: &PairInterior) -> usize {
    if is_one_camera(given) { 1 } else { 2 }
}

/// Whether both photos are of one camera, as far as is known.
fn is_one_camera(PairInterior { left, right, .. }: &PairInterior) -> bool {
    let known =
        |side: &Interior| (side.parameters, side.principal_point_mm, side.radial_distortion, side.tangential_distortion, side.uncertainty);
    known(left) == known(right)
}

/// Prior standard deviations of the constants and the modes. A camera that is calibrated beside one that is not has none that matters.
fn priors(given: &PairInterior, cameras: usize, sigma: f64) -> DVector<f64> {
    const CALIBRATED: f64 = 1e-9;
    let of = |side: &Interior| side.uncertainty.unwrap_or(CameraUncertainty { focal: 0.0, principal_point: 0.0, k1: 0.0 });
    let sides = [of(&given.left), of(&given.right)];
    let constants = sides.iter().take(cameras).flat_map(|u| [u.focal, u.principal_point, u.principal_point, u.k1]);
    let modes = std::iter::repeat_n(SHARED_PARALLAX * sigma, MODES);
    DVector::from_iterator(cameras * CAMERA + MODES, constants.map(|v| v.max(CALIBRATED)).chain(modes))
}

/// The cameras with their constants changed.
fn with_constants(given: &PairInterior, values: &DVector<f64>, cameras: usize) -> PairInterior {
    let right = if cameras == 1 { 0 } else { CAMERA };
    let changed = |side: &Interior, first: usize| {
        let focal_mm = given.focal_mm;
        let mut own = *side;
        own.principal_point_mm[0] += focal_mm * values[first + 1];
        own.principal_point_mm[1] += focal_mm * values[first + 2];
        own.radial_distortion[0] += values[first + 3] / (focal_mm * focal_mm);
        own
    };
    PairInterior {
        left: changed(&given.left, 0),
        // Both photos are taken to the focal length of the left one.
        right: changed(&given.right, right).scaled(libm::exp(values[0] - values[right])),
        focal_mm: given.focal_mm * libm::exp(values[0]),
    }
}

/// How much the focal lengths grew in the mean: corrections are of positions in the image, and in focal lengths they would shrink as these
/// grow.
fn growth(values: &DVector<f64>, cameras: usize) -> f64 {
    libm::exp((0..cameras).map(|camera| values[camera * CAMERA]).sum::<f64>() / cameras as f64)
}

fn rays(positions: &[[f64; 4]], interior: &PairInterior) -> Vec<Ray> {
    let ray = |[xl, yl, xr, yr]: &[f64; 4]| {
        let (left, right) = (interior.left.photo_mm(*xl, *yl), interior.right.photo_mm(*xr, *yr));
        [left[0], left[1], right[0], right[1]].map(|v| v / interior.focal_mm)
    };
    positions.iter().map(ray).collect()
}

/// The change of the coordinates of all rays by each constant: differences, which hold for any distortion.
fn effects(positions: &[[f64; 4]], given: &PairInterior, values: &DVector<f64>, cameras: usize) -> Vec<Vec<[f64; 4]>> {
    const STEP: f64 = 1e-6;
    let by_constant = |k: usize| {
        let at = |sign: f64| {
            let mut changed = values.clone();
            changed[k] += sign * STEP;
            rays(positions, &with_constants(given, &changed, cameras))
        };
        let difference = |(plus, minus): (&Ray, &Ray)| std::array::from_fn(|c| (plus[c] - minus[c]) / (2.0 * STEP));
        at(1.0).iter().zip(&at(-1.0)).map(difference).collect()
    };
    (0..cameras * CAMERA).map(by_constant).collect()
}
