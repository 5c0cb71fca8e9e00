//! What the place of an image is worth, by its figures.

use super::adjusting::PlacingCamera;
use super::outcome::{LinkUse, Placement, PlacingVerdict, PlacingWeakness};
use super::relief::HeightFactor;
use crate::CameraParameter;
use crate::camera::apart_from_known;
use crate::math::student_limit;

/// Links below which an orientation is weak.
const LEAST_LINKS: usize = 30;
/// Cells of the image with a link, as a share, below which it is weak: a third of the image may lie beside the orthophoto.
const LEAST_COVERAGE: f64 = 0.25;
/// Check links as far off as gross errors, as a share, above which it is weak; and how many of them chance may bring.
const MOST_BEYOND: f64 = 0.3;
const BEYOND_BY_CHANCE: f64 = 3.0;
/// Half of the 95 % interval of a coordinate of the projection centre, as a share of the height above ground, above which it is not known.
const MOST_WIDTH: f64 = 0.05;
/// Root mean square length of the residuals above which links are no good ones, in px.
const USUAL_RMSE_PX: f64 = 3.0;

/// The heights are not those of the ground where the factor that the links ask for is beyond these, and so many standard errors from 1; and where more than
/// this share of the image is displaced.
const USUAL_FACTOR: [f64; 2] = [0.75, 1.33];
const FACTOR_APART: f64 = 4.0;
const MOST_DISPLACED: f64 = 0.1;

/// `known`: the camera before the image was placed.
pub(super) fn verdict(placement: &Placement, known: &PlacingCamera) -> PlacingVerdict {
    let links = placement.links.iter().filter(|link| link.role == LinkUse::Used).count();
    match weakness(placement, known, links) {
        Some(placing_weakness) => PlacingVerdict::Weak { links, placing_weakness },
        None => {
            let half_width_m = half_widths(placement).into_iter().fold(0.0, f64::max);
            PlacingVerdict::Placed { links, sigma0_px: placement.sigma0_px.unwrap_or(0.0), half_width_m }
        }
    }
}

/// Of the 95 % intervals of X₀, Y₀, Z₀.
fn half_widths(placement: &Placement) -> [f64; 3] {
    let limit = student_limit(0.05, placement.degrees_of_freedom);
    placement.position_errors_m.map_or([f64::INFINITY; 3], |errors| errors.map(|error| limit * error))
}

fn weakness(placement: &Placement, known: &PlacingCamera, links: usize) -> Option<PlacingWeakness> {
    if links < LEAST_LINKS {
        return Some(PlacingWeakness::FewLinks { links, needed: LEAST_LINKS });
    }
    if placement.coverage < LEAST_COVERAGE {
        return Some(PlacingWeakness::Coverage { share: placement.coverage, needed: LEAST_COVERAGE });
    }
    if let Some(checks) = placement.checks.filter(|c| c.beyond as f64 > BEYOND_BY_CHANCE + MOST_BEYOND * c.number as f64) {
        return Some(PlacingWeakness::Checks { beyond: checks.beyond, checks: checks.number });
    }
    let rejected = placement.links.iter().filter(|link| link.role == LinkUse::Rejected).count();
    if rejected > links {
        return Some(PlacingWeakness::Rejected { rejected, links: rejected + links });
    }
    if let Some(contradiction) = of_heights(placement) {
        return Some(contradiction);
    }
    // A camera that is another one makes heights wrong whose intervals may be wide, too.
    if let Some(contradiction) = contradiction(placement, known) {
        return Some(contradiction);
    }
    let (height_m, [x, y, z]) = (placement.above_ground_m, half_widths(placement));
    if !(z <= MOST_WIDTH * height_m) {
        return Some(PlacingWeakness::Height { height_m, half_width_m: z });
    }
    if !(x.max(y) <= MOST_WIDTH * height_m) {
        return Some(PlacingWeakness::Plan { height_m, half_width_m: x.max(y) });
    }
    let rmse_px = placement.rmse_px;
    (rmse_px > USUAL_RMSE_PX).then_some(PlacingWeakness::Noise { rmse_px, usual_px: USUAL_RMSE_PX })
}

/// What the image says against the heights.
fn of_heights(placement: &Placement) -> Option<PlacingWeakness> {
    let [low, high] = USUAL_FACTOR;
    let is_wrong = |HeightFactor { factor, standard_error }: &HeightFactor| {
        !(low..=high).contains(factor) && (factor - 1.0).abs() > FACTOR_APART * standard_error
    };
    let factor = placement.relief.factor.filter(is_wrong).map(|wrong| {
        let HeightFactor { factor, standard_error } = wrong;
        PlacingWeakness::HeightFactor { factor, standard_error }
    });
    factor.or_else(|| {
        placement.relief.displaced.filter(|share| *share > MOST_DISPLACED).map(|displaced| PlacingWeakness::Relief { displaced })
    })
}

/// What of the focal length and the principal point contradicts most what was known. What nobody knew contradicts nothing.
pub(super) fn contradiction(placement: &Placement, known: &PlacingCamera) -> Option<PlacingWeakness> {
    if known.uncertainty.is_guess() {
        return None;
    }
    let prior = known.prior();
    let values = placement.camera.values();
    let estimated = (0..CameraParameter::ALL.len())
        .filter(|k| matches!(CameraParameter::ALL[*k], CameraParameter::Focal | CameraParameter::PrincipalX | CameraParameter::PrincipalY));
    let apart = estimated
        .filter_map(|k| apart_from_known(values[k] - prior.values[k], prior.sigma[k]?, known.camera.focal_px).map(|apart| (apart, k)));
    apart.max_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(apart, k)| PlacingWeakness::Camera {
        camera_parameter: CameraParameter::ALL[k],
        estimated_px: values[k],
        prior_px: prior.values[k],
        apart,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthophoto::{Link, LinkUse, Relief};
    use crate::{Camera, CameraUncertainty, Pose};

    fn placement(camera: Camera) -> Placement {
        let link = |k: usize| Link {
            at: [8.0 * (k % 100) as f64, 6.0 * k as f64],
            place: [0.0; 3],
            residual_px: Some([0.1, 0.1]),
            sigma_px: Some(0.2),
            role: LinkUse::Used,
            by_hand: false,
        };
        Placement {
            camera,
            camera_errors: [None; 8],
            pose: Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0, 0.0, 500.0] },
            angles_deg: [0.0; 3],
            angle_errors_deg: Some([0.01; 3]),
            position_errors_m: Some([0.1; 3]),
            above_ground_m: 500.0,
            gsd_m: 0.5,
            footprint: Vec::new(),
            sigma0_px: Some(0.2),
            rmse_px: 0.2,
            degrees_of_freedom: 190,
            coverage: 1.0,
            links: (0..100).map(link).collect(),
            checks: None,
            relief: Relief::default(),
            film: None,
        }
    }

    #[test]
    fn a_camera_that_contradicts_what_was_known_of_it_is_doubted_with_figures() {
        let camera = Camera::without_distortion(800, 600, 1000.0);
        let of = |estimated: Camera, uncertainty: CameraUncertainty| {
            verdict(&placement(estimated), &PlacingCamera { camera, uncertainty, decentring: None })
        };
        let longer = Camera { focal_px: 1120.0, ..camera };
        let PlacingVerdict::Weak { placing_weakness, .. } = of(longer, CameraUncertainty::EXIF) else { panic!("not doubted") };
        let PlacingWeakness::Camera { camera_parameter, estimated_px, prior_px, apart } = placing_weakness else {
            panic!("{placing_weakness}")
        };
        assert_eq!((camera_parameter, estimated_px, prior_px), (CameraParameter::Focal, 1120.0, 1000.0));
        assert!((apart - 0.12 / CameraUncertainty::EXIF.focal).abs() < 1e-9, "{apart}");
        // Of a principal point, which is farther off by its standard deviation.
        let off = 3.0 * CameraUncertainty::EXIF.principal_point * 1000.0;
        let shifted = Camera { principal_point_px: [400.0, 300.0 - off], ..longer };
        let said = of(shifted, CameraUncertainty::EXIF).to_string();
        assert!(said.contains("300.0 px") && said.contains("3.0 standard deviations"), "{said}");
        // Within what is known; of a camera that nobody knew; of one that is held; of one so well known that its difference does not matter.
        let placed =
            |estimated: Camera, uncertainty: CameraUncertainty| matches!(of(estimated, uncertainty), PlacingVerdict::Placed { .. });
        assert!(placed(Camera { focal_px: 1090.0, ..camera }, CameraUncertainty::EXIF));
        assert!(placed(longer, CameraUncertainty::ASSUMED) && placed(camera, CameraUncertainty::NONE));
        assert!(placed(Camera { focal_px: 1015.0, ..camera }, CameraUncertainty::GIVEN));
    }
}
