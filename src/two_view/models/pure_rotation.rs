//! Views without a base: known cameras that only turned.

use crate::Error;
use crate::math::{Candidate, Problem, consensus};
use crate::orientation::{Field, RelativePose};
use crate::two_view::frame::{Frame, rows};
use crate::two_view::matches::{Found, Matches};
use crate::two_view::result::{Degeneracy, TwoView, TwoViewModel};
use crate::two_view::rotation::{Rotations, Turn, near_focal};
use crate::two_view::scale::Conditions;
use crate::two_view::support::NEARLY_ALL_SAMPLES;
use crate::two_view::transfer::square_transfer;
use nalgebra::Matrix3;

/// Maps of norm 1 that differ by less are the same but for rounding.
const SAME_MAP: f64 = 1e-9;

/// The rotation that explains the matches which agree with a pose, at the given focal length or near it. `inner`: these matches.
pub fn search(matches: &Matches, inner: &Field, found: &Found<RelativePose>) -> Option<TwoView> {
    let rotations = Rotations { field: inner, limits: matches.limits };
    let turned = consensus(&rotations, None, &matches.search(NEARLY_ALL_SAMPLES))?.model;
    if is_turn(matches, &turned, found) {
        return Some(result(matches, matches.frame, &turned, &turned));
    }
    let (frame, rotation) = near_focal(&matches.points_of(&found.inliers), &matches.frame, &turned, largest_px(matches))?;
    let own = matches.frame.homography_from_px(&frame.homography_px(&rotation));
    is_turn(matches, &own, found).then(|| result(matches, frame, &rotation, &own))
}

/// Whether the map of a rotation explains the matches that agree with a pose: most of them, however many of them may be wrong.
fn is_turn(matches: &Matches, map: &Matrix3<f64>, found: &Found<RelativePose>) -> bool {
    2 * matches.off(map, found).count() < found.inliers.len() && matches.explains(map, found)
}

/// The rotation near one that other matches gave, with its map between the images in px.
pub fn from_known(matches: &Matches, homography_px: &Matrix3<f64>, rotation: &Matrix3<f64>, known: &TwoView) -> Result<TwoView, Error> {
    let agreeing = agreeing_with_map(matches, &matches.frame.homography_from_px(homography_px));
    // The focal length was that of the cameras, or near it.
    let is_exact = (matches.frame.homography_px(rotation) - homography_px).amax() < SAME_MAP;
    let (frame, rotation) = if is_exact {
        let start = Candidate { model: *rotation, scale: agreeing.noise.sigma };
        (matches.frame, matches.refined(&Turn, &matches.field(), &start))
    } else {
        let inner = matches.points_of(&agreeing.inliers);
        near_focal(&inner, &matches.frame, rotation, largest_px(matches)).unwrap_or((matches.frame, *rotation))
    };
    let own = matches.frame.homography_from_px(&frame.homography_px(&rotation));
    matches.check_known(&agreeing_with_map(matches, &own), Rotations::SAMPLE)?;
    Ok(TwoView { degenerate: known.degenerate, focal: known.focal, ..result(matches, frame, &rotation, &own) })
}

/// `homography` is in the coordinates of the matches, `rotation` in those of `frame`.
pub fn result(matches: &Matches, frame: Frame, rotation: &Matrix3<f64>, homography: &Matrix3<f64>) -> TwoView {
    let map = rows(&frame.homography_px(rotation));
    let model = TwoViewModel::Rotation { homography: map, rotation: rows(rotation) };
    let found = agreeing_with_map(matches, homography);
    TwoView { degenerate: Some(Degeneracy::PureRotation), homography: Some(map), ..matches.result(model, found) }
}

fn agreeing_with_map(matches: &Matches, homography: &Matrix3<f64>) -> Found<()> {
    matches.agreeing((), Conditions::Two, |ray| square_transfer(homography, ray))
}

fn largest_px(matches: &Matches) -> f64 {
    matches.limits.largest_threshold * matches.frame.px()
}
