//! Cameras whose principal points alone are known: calibrated where the matches determine the focal length.

use super::{calibrated, pure_rotation};
use crate::two_view::focal;
use crate::two_view::matches::{Found, Matches};
use crate::two_view::result::TwoView;
use crate::two_view::support::NEARLY_ALL;
use nalgebra::Matrix3;

/// The relative orientation of a pair with a base, from its fundamental matrix.
pub fn of_base(matches: &Matches, found: &Found<Matrix3<f64>>, principal: &[[f64; 2]; 2]) -> Option<TwoView> {
    let fundamental_px = matches.frame.fundamental_px(&found.model);
    let searched = focal::of_base(&matches.points_of(&found.inliers), principal, &fundamental_px, found.noise.sigma * matches.frame.px())?;
    let estimate = searched.estimate?;
    let own = Matches::new(matches.points, searched.best.frame, matches.options, matches.tolerance).ok()?;
    let pose = calibrated::polished(&own, searched.best.model);
    // It has fewer unknowns: what it cannot explain, as distortion, stands against it.
    let serves = NEARLY_ALL[1] * pose.inliers.len() >= NEARLY_ALL[0] * found.inliers.len();
    serves.then(|| TwoView { focal: Some(estimate), ..calibrated::result(&own, pose) })
}

/// The rotation of a pair without a base, from its map of a plane.
pub fn of_rotation(matches: &Matches, found: &Found<Matrix3<f64>>, principal: &[[f64; 2]; 2]) -> Option<TwoView> {
    let homography_px = matches.frame.homography_px(&found.model);
    let sigma_px = found.noise.sigma * matches.frame.px();
    let turned = focal::of_rotation(&matches.points_of(&found.inliers), principal, &homography_px, sigma_px)?;
    // At a narrow angle flat ground moves as if the camera had turned, whatever its focal length; only what does not move at all is surely
    // seen from one place.
    if turned.estimate.is_none() && !matches.explains(&matches.frame.homography_from_px(&Matrix3::identity()), found) {
        return None;
    }
    let (frame, rotation) = (turned.best.frame, turned.best.model);
    let own = matches.frame.homography_from_px(&frame.homography_px(&rotation));
    let serves = matches.explains(&own, found) && matches.is_as_good(&own, &found.model, found);
    serves.then(|| TwoView { focal: turned.estimate, ..pure_rotation::result(matches, frame, &rotation, &own) })
}
