//! The orientation of one image by its links: a bundle adjustment of a single image, in which each place is a control point.

use super::links::Found;
use super::options::PlacingOptions;
use crate::adjustment::linearise;
use crate::camera::CameraUncertainty;
use crate::{
    AdjustmentOptions, AdjustmentResult, Block, BlockImage, BlockObservation, Camera, CameraPrior, ControlPoint, Datum, Error,
    FreeParameters, Pose, adjust_block,
};

/// A camera as it is known before its image is placed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacingCamera {
    pub camera: Camera,
    /// All zero: it is calibrated, and nothing of it is estimated.
    pub uncertainty: CameraUncertainty,
    /// Standard deviation of its decentring terms p1 and p2, where they are known by themselves, as of a camera that was estimated; absent: as the
    /// uncertainty has it.
    pub decentring: Option<f64>,
}

/// Standard errors of the places of links, in m.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlaceErrors {
    pub plan: f64,
    pub height: f64,
    /// Whether one level stands for all heights: what differs from it does so over whole hills.
    pub is_level: bool,
}

impl PlaceErrors {
    /// By the options, for an orthophoto of this side of a pixel.
    pub fn new(options: &PlacingOptions, gsd: f64, has_model: bool) -> Self {
        let usual = if has_model { gsd } else { 10.0 * gsd };
        Self { plan: options.place_sigma_px * gsd, height: options.height_sigma_m.unwrap_or(usual), is_level: !has_model }
    }
}

const LEAST_WEIGHT: f64 = 1e-6;
/// Places are held by this share of their standard error.
const HELD: f64 = 1e-3;
/// A parameter is estimated however badly the links determine it: what is known of it holds it.
const NO_LIMIT_PX: f64 = 1000.0;

impl PlacingCamera {
    /// Of k₂, too: an image over level ground gives its tilt by it.
    pub(super) fn prior(&self) -> CameraPrior {
        let uncertainty = self.uncertainty.without_traces();
        let mut prior = CameraPrior::of(0, &self.camera, uncertainty);
        let [.., k1, k2, _, p1, p2] = &mut prior.sigma;
        if let Some(decentring) = self.decentring {
            (*p1, *p2) = (Some(decentring), Some(decentring));
        }
        // Lenses whose k₁ is unknown differ as much in k₂. Of one that states k₂ both are known together, as well as k₁ alone.
        *k2 = k1.filter(|_| self.camera.radial[1] == 0.0);
        prior
    }

    /// What of it is estimated: what has a standard deviation.
    fn free(&self) -> FreeParameters {
        let [focal, principal_point, _, k1, k2, _, p1, _] = self.prior().sigma.map(|sigma| sigma.is_some());
        FreeParameters { focal, principal_point, radial: usize::from(k1) + usize::from(k2), tangential: p1 }
    }
}

/// The variance of a coordinate of a link in its image, of which the place has its part.
pub(super) fn variance_px2(link: &Found, camera: &Camera, pose: &Pose, errors: PlaceErrors) -> f64 {
    let height = errors.height * errors.height + link.height_spread * link.height_spread;
    let variances = [errors.plan * errors.plan, errors.plan * errors.plan, height];
    let by_place = linearise(&camera.values(), pose, &link.place).by_point;
    let of_place: f64 = by_place.iter().flatten().zip(variances.iter().cycle()).map(|(d, variance)| d * d * variance).sum();
    link.measured_px * link.measured_px + 0.5 * of_place
}

/// The mean of the weights that links of these variances would have in px: by it they are 1 in the mean, so that σ₀ is the standard error of a usual
/// coordinate.
pub(super) fn mean_weight(variances_px2: &[f64]) -> f64 {
    variances_px2.iter().map(|variance| 1.0 / variance).sum::<f64>() / variances_px2.len().max(1) as f64
}

/// Adjusts an image from an approximate camera and orientation. Rays of the result are the links in their order.
///
/// Each place has one ray, so that errors of places cannot be told from those of the image: both weigh the ray together, and σ₀ is what they
/// make of it.
pub(super) fn adjusted(
    links: &[Found],
    known: &PlacingCamera,
    (camera, pose): (Camera, Pose),
    errors: PlaceErrors,
) -> Result<AdjustmentResult, Error> {
    let variances: Vec<f64> = links.iter().map(|link| variance_px2(link, &camera, &pose, errors)).collect();
    let mean = mean_weight(&variances);
    let ray = |(point, link): (usize, &Found)| BlockObservation {
        image: 0,
        point,
        x_px: link.at[0],
        y_px: link.at[1],
        weight: (1.0 / (variances[point] * mean)).max(LEAST_WEIGHT),
        sigma_px: None,
    };
    let held = [HELD * errors.plan; 3];
    let block = Block {
        cameras: vec![Camera { free: known.free(), ..camera }],
        images: vec![BlockImage { camera: 0, pose, gnss: None, axis: None }],
        points: links.iter().map(|link| link.place).collect(),
        rays: links.iter().enumerate().map(ray).collect(),
        control: links.iter().enumerate().map(|(point, link)| ControlPoint { point, position: link.place, sigma: held }).collect(),
        camera_priors: vec![known.prior()],
    };
    adjust_block(&block, &AdjustmentOptions { datum: Datum::Control, calibration_limit_px: NO_LIMIT_PX, ..AdjustmentOptions::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_camera_states_of_its_lens_is_known_better_than_what_it_does_not() {
        let of = |radial, tangential, uncertainty| {
            let camera = Camera { radial, tangential, ..Camera::without_distortion(1000, 750, 900.0) };
            let known = PlacingCamera { camera, uncertainty, decentring: None };
            let [.., k1, k2, k3, p1, p2] = known.prior().sigma;
            ([k1, k2, k3, p1, p2], known.free())
        };
        let usual = of([0.0; 3], [0.0; 2], CameraUncertainty::EXIF);
        assert_eq!(usual, ([Some(0.05), Some(0.05), None, Some(0.003), Some(0.003)], FreeParameters { radial: 2, ..FreeParameters::ALL }));
        let stated = of([-0.1, 0.02, 0.0], [1e-4, 0.0], CameraUncertainty::GIVEN);
        assert_eq!(stated, ([Some(0.003), None, None, Some(1e-4), Some(1e-4)], FreeParameters { radial: 1, ..FreeParameters::ALL }));
        assert_eq!(of([0.0; 3], [0.0; 2], CameraUncertainty::NONE), ([None; 5], FreeParameters::default()));
    }
}
