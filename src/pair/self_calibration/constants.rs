//! The constants of the cameras: what is known of them before, and what they do to the rays.

use crate::camera::{CameraUncertainty, Interior};
use crate::orientation::{MODES, Ray};
use crate::pair::geometry::PairInterior;
use nalgebra::DVector;

/// Constants of a camera: the logarithm of the focal length, x and y of the principal point in focal lengths, k1 in units of the focal
/// length. They are changes from the camera as it was given.
pub const CAMERA: usize = 4;

/// Standard deviation of a focal length, as a share of it, up to which the constants of a camera stay as they were given.
const KNOWN_FOCAL: f64 = 0.1;

/// Whether the pair tells more of its cameras than is known. A focal length of EXIF is nearer the true one than what real pairs of flat ground
/// tell: the errors of their matches are not independent, nor those of their lenses what k1 describes.
pub fn tells_more(interior: &PairInterior) -> bool {
    [&interior.left, &interior.right].iter().any(|side| side.uncertainty.is_some_and(|known| known.focal > KNOWN_FOCAL))
}

/// Whether the cameras were given, and not only named by files: residuals that ask for others contradict who gave them.
pub fn is_calibrated(interior: &PairInterior) -> bool {
    let is_given = |side: &Interior| side.uncertainty.is_none_or(|known| known.focal <= CameraUncertainty::GIVEN.focal);
    is_given(&interior.left) && is_given(&interior.right)
}

/// Whether anything of the cameras is not known.
pub fn is_uncertain(interior: &PairInterior) -> bool {
    [&interior.left, &interior.right].iter().any(|side| side.uncertainty.is_some_and(|known| known != CameraUncertainty::NONE))
}

/// How many cameras are to be told: one where both photos are of the same, as far as is known.
pub fn cameras_of(given: &PairInterior) -> usize {
    if is_one_camera(given) { 1 } else { 2 }
}

/// Whether both photos are of one camera, as far as is known.
fn is_one_camera(PairInterior { left, right, .. }: &PairInterior) -> bool {
    let known =
        |side: &Interior| (side.parameters, side.principal_point_mm, side.radial_distortion, side.tangential_distortion, side.uncertainty);
    known(left) == known(right)
}

/// Prior standard deviations of the constants, those of the left camera first. A camera that is known without error beside one that is not has none that
/// matters.
pub fn priors_of_constants(given: &PairInterior, cameras: usize) -> Vec<f64> {
    const NONE: f64 = 1e-9;
    let sides = [&given.left, &given.right].map(|side| side.uncertainty.unwrap_or(CameraUncertainty::NONE));
    sides.iter().take(cameras).flat_map(|u| [u.focal, u.principal_point, u.principal_point, u.k1]).map(|v| v.max(NONE)).collect()
}

/// The same, and those of the modes, in focal lengths.
pub fn priors(given: &PairInterior, cameras: usize, of_modes: [f64; MODES]) -> DVector<f64> {
    DVector::from_iterator(cameras * CAMERA + MODES, priors_of_constants(given, cameras).into_iter().chain(of_modes))
}

/// The cameras with their constants changed.
pub fn with_constants(given: &PairInterior, values: &DVector<f64>, cameras: usize) -> PairInterior {
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
pub fn growth(values: &DVector<f64>, cameras: usize) -> f64 {
    libm::exp((0..cameras).map(|camera| values[camera * CAMERA]).sum::<f64>() / cameras as f64)
}

pub fn rays(positions: &[[f64; 4]], interior: &PairInterior) -> Vec<Ray> {
    let ray = |[xl, yl, xr, yr]: &[f64; 4]| {
        let (left, right) = (interior.left.photo_mm(*xl, *yl), interior.right.photo_mm(*xr, *yr));
        [left[0], left[1], right[0], right[1]].map(|v| v / interior.focal_mm)
    };
    positions.iter().map(ray).collect()
}

/// The change of the coordinates of all rays by each constant: differences, which hold for any distortion.
pub fn effects(positions: &[[f64; 4]], given: &PairInterior, values: &DVector<f64>, cameras: usize) -> Vec<Vec<[f64; 4]>> {
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
