//! Matrices of points without gross errors, by their linear conditions.

use super::frame::{Frame, rows};
use super::fundamental::{eight_point, seven_point};
use super::homography::direct_linear;
use crate::error::refuse;
use crate::{Cause, Computation, Error, Few, Refusal};

/// The fundamental matrix of eight or more matches `[x left, y left, x right, y right]` in px, all of them good: qᵀ F p = 0, of norm 1. The
/// coordinates are normalised within.
///
/// # Errors
/// [`Error::TooFew`] below eight; [`Error::InvalidInput`] for positions that are none; [`Error::Degenerate`] for points of a plane.
///
/// # Source
/// Hartley 1997, In defense of the eight-point algorithm, IEEE PAMI 19(6).
pub fn fundamental_eight_point(points: &[[f64; 4]]) -> Result<[[f64; 3]; 3], Error> {
    let frame = frame_of(Few::MatchesForFundamentalMatrix, points, 8)?;
    let matrix = eight_point(&frame.rays(points))
        .ok_or(Error::Degenerate { computation: Computation::FundamentalMatrix, cause: Cause::SeveralMatrices })?;
    Ok(rows(&frame.fundamental_px(&matrix)))
}

/// Every fundamental matrix of seven matches: one or three, none where the conditions depend on each other. As [`fundamental_eight_point`].
///
/// # Errors
/// [`Error::InvalidInput`] for positions that are none.
///
/// # Source
/// Hartley 1994, Projective reconstruction and invariants from multiple images, IEEE PAMI 16(10).
pub fn fundamental_seven_point(points: &[[f64; 4]; 7]) -> Result<Vec<[[f64; 3]; 3]>, Error> {
    let frame = frame_of(Few::MatchesForFundamentalMatrix, points, 7)?;
    let rays = frame.rays(points);
    let found = seven_point(&std::array::from_fn(|k| rays[k]));
    Ok(found.iter().map(|matrix| rows(&frame.fundamental_px(matrix))).collect())
}

/// The homography of four or more matches, all of them good: q ~ H p, of norm 1. As [`fundamental_eight_point`].
///
/// # Errors
/// [`Error::TooFew`] below four; [`Error::InvalidInput`] for positions that are none; [`Error::Degenerate`] for points on a line.
///
/// # Source
/// Hartley & Zisserman 2004, Multiple View Geometry, 2nd ed., section 4.1.
pub fn homography_direct(points: &[[f64; 4]]) -> Result<[[f64; 3]; 3], Error> {
    let frame = frame_of(Few::MatchesForHomography, points, 4)?;
    let matrix = direct_linear(&frame.rays(points))
        .ok_or(Error::Degenerate { computation: Computation::Homography, cause: Cause::TooManyOnLine })?;
    Ok(rows(&frame.homography_px(&matrix)))
}

fn frame_of(few: Few, points: &[[f64; 4]], needed: usize) -> Result<Frame, Error> {
    if points.len() < needed {
        return Err(Error::TooFew { few, got: points.len(), needed });
    }
    check_points(points)?;
    Ok(Frame::normalising(points))
}

/// Refuses positions that are no positions in px.
pub(super) fn check_points(points: &[[f64; 4]]) -> Result<(), Error> {
    match points.iter().enumerate().find(|(_, p)| p.iter().any(|v| !(v.abs() <= 1e6))) {
        None => Ok(()),
        Some((index, p)) => refuse(Refusal::MatchPosition { position: format!("{p:?}"), index }),
    }
}
