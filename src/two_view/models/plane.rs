//! The map of a plane: what is left of unknown cameras where no fundamental matrix is determined.

use super::unknown_focal;
use crate::Error;
use crate::math::Problem;
use crate::orientation::Field;
use crate::two_view::frame::rows;
use crate::two_view::homography::{Homographies, Plane};
use crate::two_view::matches::{Found, Matches};
use crate::two_view::result::{Degeneracy, TwoView, TwoViewModel};
use crate::two_view::scale::Conditions;
use crate::two_view::transfer::square_transfer;
use nalgebra::Matrix3;

/// The map that most matches agree with; with principal points a rotation, where it fits them as well.
pub fn search(matches: &Matches, field: &Field, principal: Option<[[f64; 2]; 2]>) -> Result<TwoView, Error> {
    let homographies = Homographies { field, limits: matches.limits };
    let best = matches.best(&homographies).ok_or_else(|| matches.unsupported(0))?;
    let found = agreeing_with_map(matches, matches.refined(&Plane, field, &best));
    if !matches.is_supported(&found, Homographies::SAMPLE, 1, Conditions::Two) {
        return Err(matches.unsupported(found.inliers.len()));
    }
    let turned = principal.and_then(|principal| unknown_focal::of_rotation(matches, &found, &principal));
    Ok(turned.unwrap_or_else(|| TwoView { degenerate: Some(Degeneracy::Plane), ..result(matches, found) }))
}

/// The map near one in px that other matches gave.
pub fn from_known(matches: &Matches, homography_px: &Matrix3<f64>, known: &TwoView) -> Result<TwoView, Error> {
    let start = matches.known(matches.frame.homography_from_px(homography_px), known);
    let found = agreeing_with_map(matches, matches.refined(&Plane, &matches.field(), &start));
    matches.check_known(&found, Homographies::SAMPLE)?;
    let mut result = TwoView { degenerate: known.degenerate, ..result(matches, found) };
    // The map of a rotation whose focal length is not known stays one.
    if let (TwoViewModel::Rotation { rotation, .. }, Some(homography)) = (known.model, result.homography) {
        result.model = TwoViewModel::Rotation { homography, rotation };
    }
    Ok(result)
}

pub fn result(matches: &Matches, found: Found<Matrix3<f64>>) -> TwoView {
    let homography = rows(&matches.frame.homography_px(&found.model));
    TwoView { homography: Some(homography), ..matches.result(TwoViewModel::Homography { homography }, found) }
}

fn agreeing_with_map(matches: &Matches, map: Matrix3<f64>) -> Found<Matrix3<f64>> {
    matches.agreeing(map, Conditions::Two, |ray| square_transfer(&map, ray))
}
