//! Cameras that are known: the relative orientation.

use super::pure_rotation;
use crate::Error;
use crate::math::{Candidate, Problem, consensus};
use crate::orientation::{Field, Poses, RelativePose, poses_of_plane, square_distance};
use crate::two_view::frame::rows;
use crate::two_view::homography::Homographies;
use crate::two_view::matches::{Found, Matches};
use crate::two_view::result::{Degeneracy, TwoView, TwoViewModel};
use crate::two_view::scale::Conditions;
use crate::two_view::support::NEARLY_ALL_SAMPLES;
use nalgebra::Matrix3;

/// Most poses through a minimal sample.
const MOST_POSES: usize = 10;

/// Numbers of matches that differ by less than this fraction's inverse are equal.
const AS_MANY: usize = 50;
/// Times that a pose is refined by the matches that agree with it alone.
const POLISHINGS: usize = 2;

/// The pose that most matches agree with; where they need no more than a rotation, that.
pub fn search(matches: &Matches) -> Result<TwoView, Error> {
    let (field, scale) = (matches.field(), matches.scale());
    let best = matches.best(&Poses { field: &field, scale: &scale }).ok_or_else(|| matches.unsupported(0))?;
    let found = polished(matches, best.model);
    if !matches.is_supported(&found, Poses::SAMPLE, MOST_POSES, Conditions::One) {
        return Err(matches.unsupported(found.inliers.len()));
    }
    let inner = matches.only(&found.inliers);
    Ok(pure_rotation::search(matches, &inner, &found).unwrap_or_else(|| over_plane_or_relief(matches, &inner, found)))
}

/// The pose near one that other matches gave.
pub fn from_known(matches: &Matches, pose: &RelativePose, known: &TwoView) -> Result<TwoView, Error> {
    let (field, scale) = (matches.field(), matches.scale());
    // Of few first matches the pose may be off by more than the threshold: those that do not agree with it yet draw it, too.
    let start = Candidate { model: *pose, scale: 0.5 * matches.limits.largest_threshold };
    let poses = Poses { field: &field, scale: &scale };
    let found = polished(matches, poses.improved(&start, field.rays.len()).model);
    matches.check_known(&found, Poses::SAMPLE)?;
    Ok(TwoView { degenerate: known.degenerate, homography: known.homography, focal: known.focal, ..result(matches, found) })
}

pub fn result(matches: &Matches, found: Found<RelativePose>) -> TwoView {
    let RelativePose { rotation, base } = found.model;
    let fundamental = rows(&matches.frame.fundamental_px(&found.model.essential()));
    let model = TwoViewModel::Calibrated { fundamental, rotation: rows(&rotation), base: [base.x, base.y, base.z] };
    matches.result(model, found)
}

/// A pose with what the plane of its points says, where they lie in one. `inner`: the matches that agree with it.
fn over_plane_or_relief(matches: &Matches, inner: &Field, found: Found<RelativePose>) -> TwoView {
    let homographies = Homographies { field: inner, limits: matches.limits };
    let plane = consensus(&homographies, None, &matches.search(NEARLY_ALL_SAMPLES)).map(|plane| plane.model);
    let Some(plane) = plane.filter(|plane| matches.explains(plane, &found)) else { return result(matches, found) };
    let found = best_over_plane(matches, found, &plane);
    let is_flat = matches.explains(&plane, &found);
    let mut result = result(matches, found);
    if is_flat {
        result.degenerate = Some(Degeneracy::Plane);
        result.homography = Some(rows(&matches.frame.homography_px(&plane)));
    }
    result
}

/// A pose refined by the matches that agree with it alone, these in front of both cameras.
pub fn polished(matches: &Matches, pose: RelativePose) -> Found<RelativePose> {
    let scale = matches.scale();
    let mut found = agreeing_with_pose(matches, pose);
    for _ in 0..POLISHINGS {
        let inner = matches.only(&found.inliers);
        let start = Candidate { model: found.model, scale: found.noise.sigma };
        found = agreeing_with_pose(matches, Poses { field: &inner, scale: &scale }.settled(&start, inner.rays.len()).model);
    }
    let (pose, behind) = (found.model, 5.0 * found.noise.sigma);
    found.inliers.retain(|k| pose.in_front(&matches.rays[*k], behind));
    found
}

/// Over a plane two poses fit: the one with more matches, or of equal ones that with the optical axes nearer to parallel.
fn best_over_plane(matches: &Matches, found: Found<RelativePose>, homography: &Matrix3<f64>) -> Found<RelativePose> {
    // A pose with the base reversed differs by what lies in front of it; the one nearer to what was found would be found again.
    let seen = |pose: &RelativePose| found.inliers.iter().filter(|k| pose.in_front(&matches.rays[**k], 0.0)).count();
    let apart = |pose: &RelativePose| 1.0 - (found.model.rotation.transpose() * pose.rotation).trace();
    let poses = poses_of_plane(homography);
    let facing = poses.chunks_exact(2).map(|pair| if seen(&pair[1]) > seen(&pair[0]) { pair[1] } else { pair[0] });
    let other = facing.reduce(|a, b| if apart(&b) > apart(&a) { b } else { a });
    let mut all = vec![found];
    all.extend(other.map(|pose| polished(matches, pose)));
    let most = all.iter().map(|found| found.inliers.len()).max().unwrap_or(0);
    let enough = most - most / AS_MANY;
    let parallel = |found: &Found<RelativePose>| found.model.rotation[(2, 2)];
    let best = all.into_iter().filter(|found| found.inliers.len() >= enough).reduce(|a, b| if parallel(&b) > parallel(&a) { b } else { a });
    best.expect("the one with most matches is among them")
}

fn agreeing_with_pose(matches: &Matches, pose: RelativePose) -> Found<RelativePose> {
    let essential = pose.essential();
    matches.agreeing(pose, Conditions::One, |ray| square_distance(&essential, *ray))
}
