//! From matches to the geometry of their two images: which model is searched, by what is known of the cameras.

use super::direct::check_points;
use super::frame::{Frame, View, matrix};
use super::matches::Matches;
use super::models::{calibrated, plane, pure_rotation, uncalibrated};
use super::options::{Cameras, TwoViewOptions};
use super::result::{TwoView, TwoViewModel};
use super::support::{CALIBRATED, UNCALIBRATED};
use crate::Error;
use crate::orientation::RelativePose;
use nalgebra::Vector3;

/// Finds what relates two images by matches `[x left, y left, x right, y right]` in px, of which many may be wrong.
///
/// With both focal lengths it is the relative orientation (five points); with principal points alone the fundamental matrix and, where the
/// matches determine it, the focal length with the relative orientation; without cameras the fundamental matrix (seven points). Where the
/// matches need no more than a map of a plane, or a rotation, the result says so: see [`TwoView::degenerate`]; without cameras it is the map
/// of a plane that five of six of them agree with, too.
///
/// Good matches are those within a threshold. It follows from their own precision and from the number of wrong matches about it, up to
/// [`TwoViewOptions::largest_threshold_px`], or is given. Residuals see only what lies across the epipolar line.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for positions that are none, or one camera without the other; [`Error::TooFew`];
/// [`Error::Degenerate`] where no more matches agree on a geometry than would by chance.
///
/// # Source
/// Hartley & Zisserman 2004, Multiple View Geometry, 2nd ed.; Nistér 2004 (five points); Chum, Werner & Matas 2005 (dominant planes).
pub fn two_view(points: &[[f64; 4]], options: &TwoViewOptions) -> Result<TwoView, Error> {
    options.check()?;
    check_points(points)?;
    let cameras = options.cameras()?;
    match frame_of(&cameras, None) {
        Some(frame) => calibrated::search(&Matches::new(points, frame, options, CALIBRATED)?),
        None => uncalibrated::search(&Matches::new(points, Frame::normalising(points), options, UNCALIBRATED)?, cameras.principal()),
    }
}

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
    match (&known.model, frame_of(&cameras, Some(known))) {
        (TwoViewModel::Calibrated { rotation, base, .. }, Some(frame)) => {
            let pose = RelativePose { rotation: matrix(rotation), base: Vector3::from_column_slice(base) };
            calibrated::from_known(&matches(frame)?, &pose, known)
        }
        (TwoViewModel::Rotation { homography, rotation }, Some(frame)) => {
            pure_rotation::from_known(&matches(frame)?, &matrix(homography), &matrix(rotation), known)
        }
        (TwoViewModel::Homography { homography } | TwoViewModel::Rotation { homography, .. }, _) => {
            plane::from_known(&matches(Frame::normalising(points))?, &matrix(homography), known)
        }
        (TwoViewModel::Fundamental { fundamental } | TwoViewModel::Calibrated { fundamental, .. }, _) => {
            uncalibrated::from_known(&matches(Frame::normalising(points))?, &matrix(fundamental), known, cameras.principal())
        }
    }
}

/// The calibrated views; `None` where no focal length is known, neither given nor estimated from other matches.
fn frame_of(cameras: &Cameras, known: Option<&TwoView>) -> Option<Frame> {
    let [left, right] = match cameras {
        Cameras::Known(views) => views.map(|(unit, centre)| View { centre, unit }),
        Cameras::Principal(principal) => {
            let focal = known?.focal?;
            principal.map(|centre| View { centre, unit: focal.focal_px })
        }
        Cameras::Unknown => return None,
    };
    Some(Frame { left, right })
}
