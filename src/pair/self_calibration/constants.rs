//! The constants of the cameras: what is known of them before, and what they do to the rays.

use crate::camera::{CameraUncertainty, Interior, is_near};
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

/// Whether both photos are of one camera, as far as is known: to within what rounding in their files changes. Images that may be cropped may be so
/// each of its own.
fn is_one_camera(PairInterior { left, right, focal_mm, doubt, .. }: &PairInterior) -> bool {
    let near = |a: &[f64], b: &[f64], unit: f64| a.iter().zip(b).all(|(a, b)| is_near(*a, *b, unit));
    // Pixels in units of their side, all else in focal lengths.
    let rows = || left.parameters.iter().zip(&right.parameters);
    let pixels = rows().all(|(a, b)| near(&a[..2], &b[..2], left.pixel_mm()) && near(&a[2..], &b[2..], *focal_mm));
    let (f, f2) = (*focal_mm, focal_mm * focal_mm);
    let radial = [1.0 / f2, 1.0 / (f2 * f2), 1.0 / (f2 * f2 * f2)];
    let terms = left.radial_distortion.iter().zip(&right.radial_distortion).zip(radial);
    pixels
        && near(&left.principal_point_mm, &right.principal_point_mm, f)
        && terms.into_iter().all(|((a, b), unit)| is_near(*a, *b, unit))
        && near(&left.tangential_distortion, &right.tangential_distortion, 1.0 / f)
        && left.uncertainty == right.uncertainty
        && !doubt.is_some_and(|doubt| doubt.is_of_part())
}

/// The constants that two photos share which are not of one camera in all: the focal length and k1 of one lens, where the image of one was turned
/// or resized against that of the other. Their principal points lie elsewhere in either image.
const OF_LENS: [usize; 2] = [0, 3];

/// Standard deviation of the difference of a constant that two photos share, as a share of that of the constant.
const SHARED: f64 = 0.01;

/// Whether the cameras of two photos, which are not one, have one lens.
pub fn is_one_lens(given: &PairInterior) -> bool {
    let PairInterior { left, right, focal_mm, one_lens, .. } = given;
    let terms = left.radial_distortion.iter().zip(&right.radial_distortion);
    let is_near_term = |(power, (a, b)): (i32, (&f64, &f64))| is_near(*a, *b, focal_mm.powi(-2 * power));
    *one_lens && left.uncertainty == right.uncertainty && (1..).zip(terms).all(is_near_term)
}

/// The pairs of constants that are equal, each with the standard deviation of their difference.
pub fn shared_constants(given: &PairInterior, cameras: usize) -> Vec<([usize; 2], f64)> {
    if cameras == 1 || !is_one_lens(given) {
        return Vec::new();
    }
    let priors = priors_of_constants(given, cameras);
    OF_LENS.iter().map(|k| ([*k, k + CAMERA], SHARED * priors[*k])).collect()
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
        ..*given
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

/// The change of the coordinates of all rays by each constant.
pub fn effects(positions: &[[f64; 4]], given: &PairInterior, values: &DVector<f64>, cameras: usize) -> Vec<Vec<[f64; 4]>> {
    let by_constant = |k: usize| {
        differences(positions, |step| {
            let mut changed = values.clone();
            changed[k] += step;
            with_constants(given, &changed, cameras)
        })
    };
    (0..cameras * CAMERA).map(by_constant).collect()
}

/// The change of the coordinates of all rays by a change of the cameras, in its unit: differences, which hold for any distortion.
pub fn differences(positions: &[[f64; 4]], changed: impl Fn(f64) -> PairInterior) -> Vec<[f64; 4]> {
    const STEP: f64 = 1e-6;
    let difference = |(plus, minus): (&Ray, &Ray)| std::array::from_fn(|c| (plus[c] - minus[c]) / (2.0 * STEP));
    rays(positions, &changed(STEP)).iter().zip(&rays(positions, &changed(-STEP))).map(difference).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CameraMm;

    /// A photo of 1200 x 800 px by a camera of this focal length, at that of the left one.
    fn photo(focal_mm: f64, principal_x_mm: f64, k1: f64, uncertainty: CameraUncertainty) -> Interior {
        let camera = CameraMm {
            principal_point_mm: [principal_x_mm, 0.0],
            radial_distortion: [k1, 0.0, 0.0],
            uncertainty: Some(uncertainty),
            ..CameraMm::without_distortion(focal_mm, Some(0.004))
        };
        Interior::from_pixel_size(&camera, 1200, 800).unwrap().scaled(4.5 / focal_mm)
    }

    #[test]
    fn an_image_that_was_saved_again_is_of_one_camera_with_the_others() {
        let known = CameraUncertainty::EXIF;
        let left = photo(4.5, 0.01, 1e-3, known);
        let cameras =
            |right: Interior| cameras_of(&PairInterior { left, right, focal_mm: 4.5, doubt: None, one_lens: false, are_scans: false });
        assert_eq!(cameras(left), 1);
        assert_eq!(cameras(photo(4.5 * (1.0 + 5e-9), 0.01 + 1e-9, 1e-3 + 1e-10, known)), 1);
        assert_eq!(cameras(photo(4.5 * (1.0 - 2e-6), 0.01, 1e-3, known)), 1);
        for other in [
            photo(4.5 * 1.0001, 0.01, 1e-3, known),
            photo(4.5, 0.0105, 1e-3, known),
            photo(4.5, 0.01, 1.01e-3, known),
            photo(4.5, 0.01, 1e-3, CameraUncertainty::GIVEN),
        ] {
            assert_eq!(cameras(other), 2, "{other:?}");
        }
    }
}
