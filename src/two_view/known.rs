//! The geometry of two views refined from one that is known, without a new search for it.

use super::direct::check_points;
use super::frame::{Frame, View, rows};
use super::fundamental::Fundamentals;
use super::homography::{Homographies, Plane};
use super::options::{Cameras, TwoViewOptions};
use super::refine::refined;
use super::result::{TwoView, TwoViewModel};
use super::rotation::{Rotations, Turn, near_focal};
use super::scale::{Conditions, search_scale};
use super::support::{CALIBRATED, UNCALIBRATED};
use super::transfer::square_transfer;
use super::two_view::{Found, Matches, general_or_plane, of_fundamental, of_pose, polished};
use crate::Error;
use crate::math::{Candidate, Problem};
use crate::orientation::{Pose, Poses};
use nalgebra::{Matrix3, Vector3};

/// As [`two_view`](crate::two_view), for matches whose geometry is `known` from others: at a small share of its price.
///
/// What the first matches told of a plane, a rotation and the focal length stays: matches that were found along epipolar lines agree with
/// any geometry of these lines. A fundamental matrix of few first matches may turn out to be the map of a plane, or to determine the focal length.
///
/// # Errors
/// As [`two_view`](crate::two_view).
pub(crate) fn two_view_from(points: &[[f64; 4]], options: &TwoViewOptions, known: &TwoView) -> Result<TwoView, Error> {
    options.check()?;
    check_points(points)?;
    let cameras = options.cameras()?;
    let tolerance = if matches!(cameras, Cameras::Known(_)) { CALIBRATED } else { UNCALIBRATED };
    let matches = |frame: Frame| Matches::new(points, frame, options, tolerance);
    let own = frame_of(&cameras, known);
    match (&known.model, own) {
        (TwoViewModel::Calibrated { rotation, base, .. }, Some(frame)) => {
            let pose = Pose { rotation: matrix(rotation), base: Vector3::from_column_slice(base) };
            of_known_pose(&matches(frame)?, &pose, known)
        }
        (TwoViewModel::Rotation { homography, rotation }, Some(frame)) => {
            of_known_rotation(&matches(frame)?, &matrix(homography), &matrix(rotation), known)
        }
        (TwoViewModel::Homography { homography } | TwoViewModel::Rotation { homography, .. }, _) => {
            of_known_map(&matches(Frame::normalising(points))?, &matrix(homography), known)
        }
        (TwoViewModel::Fundamental { fundamental } | TwoViewModel::Calibrated { fundamental, .. }, _) => {
            let principal = if let Cameras::Principal(principal) = cameras { Some(principal) } else { None };
            of_known_lines(&matches(Frame::normalising(points))?, &matrix(fundamental), known, principal)
        }
    }
}

fn matrix(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

/// The calibrated views; `None` where no focal length is known.
fn frame_of(cameras: &Cameras, known: &TwoView) -> Option<Frame> {
    let [left, right] = match (cameras, &known.focal) {
        (Cameras::Known(views), _) => views.map(|(unit, centre)| View { centre, unit }),
        (Cameras::Principal(principal), Some(focal)) => principal.map(|centre| View { centre, unit: focal.focal_px }),
        _ => return None,
    };
    Some(Frame { left, right })
}

fn of_known_pose(matches: &Matches, pose: &Pose, known: &TwoView) -> Result<TwoView, Error> {
    let scale = |distances: &mut [f64]| search_scale(distances, Conditions::One, &matches.limits);
    let field = matches.field();
    let poses = Poses { field: &field, scale: &scale };
    // Of few first matches the pose may be off by more than the threshold: those that do not agree with it yet draw it, too.
    let start = Candidate { model: *pose, scale: 0.5 * matches.limits.largest_threshold };
    let found = polished(matches, poses.improved(&start, field.rays.len()).model);
    supported(matches, Poses::SAMPLE, &found)?;
    Ok(as_known(matches.result(of_pose(&matches.frame, &found.model), found), known))
}

fn of_known_lines(
    matches: &Matches,
    fundamental_px: &Matrix3<f64>,
    known: &TwoView,
    principal: Option<[[f64; 2]; 2]>,
) -> Result<TwoView, Error> {
    let model = matches.frame.fundamental_from_px(fundamental_px);
    let start = Candidate { model, scale: known.sigma_px / matches.frame.px() };
    let field = matches.field();
    let found = of_fundamental(matches, &field, &start);
    supported(matches, Fundamentals::SAMPLE, &found)?;
    general_or_plane(matches, &field, found, principal)
}

fn of_known_map(matches: &Matches, homography_px: &Matrix3<f64>, known: &TwoView) -> Result<TwoView, Error> {
    let model = matches.frame.homography_from_px(homography_px);
    let start = Candidate { model, scale: known.sigma_px / matches.frame.px() };
    let field = matches.field();
    let map = refined(&Plane, &field, &start, &matches.limits, field.rays.len()).unwrap_or(start).model;
    let found = matches.agreeing(map, Conditions::Two, |ray| square_transfer(&map, ray));
    supported(matches, Homographies::SAMPLE, &found)?;
    let homography = rows(&matches.frame.homography_px(&map));
    let mut result = matches.result(TwoViewModel::Homography { homography }, found);
    (result.degenerate, result.homography) = (known.degenerate, Some(homography));
    // The map of a rotation whose focal length is not known stays one.
    if let TwoViewModel::Rotation { rotation, .. } = known.model {
        result.model = TwoViewModel::Rotation { homography, rotation };
    }
    Ok(result)
}

fn of_known_rotation(matches: &Matches, homography_px: &Matrix3<f64>, rotation: &Matrix3<f64>, known: &TwoView) -> Result<TwoView, Error> {
    let from_one_place = matches.frame.homography_from_px(homography_px);
    let agreeing = matches.agreeing((), Conditions::Two, |ray| square_transfer(&from_one_place, ray));
    let inner = matches.points_of(&agreeing.inliers);
    // The focal length was that of the cameras, or near it.
    let is_exact = (matches.frame.homography_px(rotation) - homography_px).amax() < SAME_MAP;
    let (frame, rotation) = if is_exact {
        let field = matches.field();
        let start = Candidate { model: *rotation, scale: agreeing.noise.sigma };
        (matches.frame, refined(&Turn, &field, &start, &matches.limits, field.rays.len()).map_or(*rotation, |found| found.model))
    } else {
        let largest_px = matches.limits.largest_threshold * matches.frame.px();
        near_focal(&inner, &matches.frame, rotation, largest_px).unwrap_or((matches.frame, *rotation))
    };
    let map = frame.homography_px(&rotation);
    let own = matches.frame.homography_from_px(&map);
    let found = matches.agreeing((), Conditions::Two, |ray| square_transfer(&own, ray));
    supported(matches, Rotations::SAMPLE, &found)?;
    let mut result = matches.result(TwoViewModel::Rotation { homography: rows(&map), rotation: rows(&rotation) }, found);
    (result.degenerate, result.homography, result.focal) = (known.degenerate, Some(rows(&map)), known.focal);
    Ok(result)
}

/// Maps of norm 1 that differ by less are the same but for rounding.
const SAME_MAP: f64 = 1e-9;

fn supported<M>(matches: &Matches, sample: usize, found: &Found<M>) -> Result<(), Error> {
    if found.noise.is_supported(sample) { Ok(()) } else { Err(matches.unsupported(found.inliers.len())) }
}

fn as_known(found: TwoView, known: &TwoView) -> TwoView {
    TwoView { degenerate: known.degenerate, homography: known.homography, focal: known.focal, ..found }
}
