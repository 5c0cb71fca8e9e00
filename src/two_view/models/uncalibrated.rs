//! Cameras that are not known: the fundamental matrix, or the map of a plane where that explains the matches.

use super::{plane, unknown_focal};
use crate::Error;
use crate::math::{Candidate, Problem, Search, consensus};
use crate::orientation::{Field, square_distance};
use crate::two_view::frame::rows;
use crate::two_view::fundamental::{Epipolar, Fundamentals};
use crate::two_view::homography::Homographies;
use crate::two_view::matches::{Found, Matches};
use crate::two_view::parallax::OffPlane;
use crate::two_view::result::{TwoView, TwoViewModel};
use crate::two_view::scale::Conditions;
use crate::two_view::support::NEARLY_ALL;
use nalgebra::Matrix3;

/// Most fundamental matrices through a minimal sample.
const MOST_FUNDAMENTALS: usize = 3;
/// Samples that tell whether half of the points of a general geometry lie in a plane.
const HALF_SAMPLES: usize = 150;
/// Without cameras it does so, too, where it agrees with so many of them although it does not explain the others.
const DOMINANT: [usize; 2] = [5, 6];
/// Samples of two points off a plane.
const OFF_PLANE_SAMPLES: usize = 3000;

/// The fundamental matrix that more matches agree with than would by chance; without one, the map of a plane.
pub fn search(matches: &Matches, principal: Option<[[f64; 2]; 2]>) -> Result<TwoView, Error> {
    let field = matches.field();
    let general = matches.best(&Fundamentals { field: &field, limits: matches.limits });
    let found = general.map(|best| of_fundamental(matches, &field, &best));
    match found.filter(|found| matches.is_supported(found, Fundamentals::SAMPLE, MOST_FUNDAMENTALS, Conditions::One)) {
        Some(found) => general_or_plane(matches, &field, found, principal),
        None => plane::search(matches, &field, principal),
    }
}

/// The fundamental matrix near one in px that other matches gave.
pub fn from_known(
    matches: &Matches,
    fundamental_px: &Matrix3<f64>,
    known: &TwoView,
    principal: Option<[[f64; 2]; 2]>,
) -> Result<TwoView, Error> {
    let start = matches.known(matches.frame.fundamental_from_px(fundamental_px), known);
    let field = matches.field();
    let found = of_fundamental(matches, &field, &start);
    matches.check_known(&found, Fundamentals::SAMPLE)?;
    general_or_plane(matches, &field, found, principal)
}

/// The relative orientation where the matches determine the focal length.
pub fn result(matches: &Matches, found: Found<Matrix3<f64>>, principal: Option<[[f64; 2]; 2]>) -> TwoView {
    principal.and_then(|principal| unknown_focal::of_base(matches, &found, &principal)).unwrap_or_else(|| {
        let fundamental = rows(&matches.frame.fundamental_px(&found.model));
        matches.result(TwoViewModel::Fundamental { fundamental }, found)
    })
}

/// What the matches need of unknown cameras whose fundamental matrix is found: that, or the map of a plane that explains it.
fn general_or_plane(
    matches: &Matches,
    field: &Field,
    found: Found<Matrix3<f64>>,
    principal: Option<[[f64; 2]; 2]>,
) -> Result<TwoView, Error> {
    let inner = matches.only(&found.inliers);
    let homographies = Homographies { field: &inner, limits: matches.limits };
    let Some(map) = consensus(&homographies, None, &matches.search(HALF_SAMPLES)) else {
        return Ok(result(matches, found, principal));
    };
    let found = beside_plane(matches, field, &map.model, found);
    // Over low relief the map may come near all matches and yet agree with few. What lies off a map that does not explain the others is
    // relief, or strangers along the lines, which only many such matches tell from relief: without cameras, where no orientation is lost
    // with them, the map of nearly all is the surer answer.
    let explains = matches.explains(&map.model, &found);
    let [part, of] = if explains { NEARLY_ALL } else { DOMINANT };
    if (explains || principal.is_none())
        && let Ok(flat) = plane::search(matches, field, principal)
        && of * flat.inliers.len() >= part * found.inliers.len()
    {
        return Ok(flat);
    }
    Ok(result(matches, found, principal))
}

/// A fundamental matrix refined by all matches.
fn of_fundamental(matches: &Matches, field: &Field, best: &Candidate<Matrix3<f64>>) -> Found<Matrix3<f64>> {
    let matrix = matches.refined(&Epipolar, field, best);
    matches.agreeing(matrix, Conditions::One, |ray| square_distance(&matrix, *ray))
}

/// Over a plane that holds half of the matches or more, samples hardly ever have enough points off it: these are looked for by themselves.
fn beside_plane(matches: &Matches, field: &Field, homography: &Matrix3<f64>, found: Found<Matrix3<f64>>) -> Found<Matrix3<f64>> {
    if 2 * matches.off(homography, &found).count() > found.inliers.len() {
        return found;
    }
    let Some(off) = OffPlane::new(field, matches.limits, *homography, matches.tolerance.off(&found.noise, matches.extent)) else {
        return found;
    };
    let search = Search { least_samples: OFF_PLANE_SAMPLES, ..matches.search(OFF_PLANE_SAMPLES) };
    let first = Candidate { model: found.model, scale: found.noise.sigma };
    match consensus(&off, Some(first), &search) {
        Some(better) if better.model != found.model => of_fundamental(matches, field, &better),
        _ => found,
    }
}
