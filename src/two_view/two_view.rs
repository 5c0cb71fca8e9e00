//! From matches to the geometry of their two images: the general one first, then whether the matches need it.

use super::chance::{Support, chance_of_agreeing};
use super::direct::check_points;
use super::focal;
use super::frame::{Frame, View, rows};
use super::fundamental::Fundamentals;
use super::homography::Homographies;
use super::options::{Cameras, TwoViewOptions};
use super::parallax::OffPlane;
use super::plane_pose::poses_of_plane;
use super::result::{Degeneracy, TwoView, TwoViewModel};
use super::rotation::{Rotations, near_focal};
use super::scale::{Conditions, LEAST_REDUNDANCY, Noise, NoiseLimits, noise, search_scale};
use super::support::{CALIBRATED, Tolerance, UNCALIBRATED};
use super::transfer::square_transfer;
use crate::{Cause, Error, Task};
use crate::math::{Candidate, Problem, Search, consensus};
use crate::orientation::{Field, Pose, Poses, Ray, square_distance};
use nalgebra::Matrix3;

/// Samples that tell whether half of the points of a general geometry lie in a plane.
const HALF_SAMPLES: usize = 150;
/// Samples that tell whether nearly all of them do.
const NEARLY_ALL_SAMPLES: usize = 25;
/// A map of a plane, or a relative orientation, takes the place of a fundamental matrix where it agrees with two of three of its matches.
const NEARLY_ALL: [usize; 2] = [2, 3];
/// Without cameras it does so, too, where it agrees with so many of them although it does not explain the others.
const DOMINANT: [usize; 2] = [5, 6];
/// Samples of two points off a plane.
const OFF_PLANE_SAMPLES: usize = 3000;

/// Most models through a minimal sample.
const MOST_POSES: usize = 10;
const MOST_FUNDAMENTALS: usize = 3;
/// Of a thousand pairs without overlap, one may be told to have a geometry.
const LARGEST_LOG_FALSE_ALARMS: f64 = -6.9;

/// By how much Σ d²/σ² rises where the freedom that the map of a plane has beyond a rotation is significant.
const SIGNIFICANT: f64 = 30.0;
/// What distortion that is left adds to the residuals of a rotation, as a share of the mean distance of the points from their centre.
const DISTORTED: f64 = 0.001;
/// Standard errors beyond which a residual counts no more.
const FARTHEST: f64 = 5.0;

/// Numbers of matches that differ by less than this fraction's inverse are equal.
const AS_MANY: usize = 50;

/// Times that a pose is refined by the matches that agree with it alone.
const POLISHINGS: usize = 2;

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
    match options.cameras()? {
        Cameras::Known(known) => {
            let [left, right] = known.map(|(unit, centre)| View { centre, unit });
            calibrated(&Matches::new(points, Frame { left, right }, options, CALIBRATED)?)
        }
        Cameras::Principal(principal) => {
            uncalibrated(&Matches::new(points, Frame::normalising(points), options, UNCALIBRATED)?, Some(principal))
        }
        Cameras::Unknown => uncalibrated(&Matches::new(points, Frame::normalising(points), options, UNCALIBRATED)?, None),
    }
}

/// The matches, in px and as coordinates.
pub(super) struct Matches<'a> {
    points: &'a [[f64; 4]],
    options: &'a TwoViewOptions,
    pub frame: Frame,
    rays: Vec<Ray>,
    pub limits: NoiseLimits,
    /// Mean distance of the points from their centre, in units of coordinates.
    extent: f64,
    tolerance: Tolerance,
}

/// A geometry, and the matches that agree with it.
pub(super) struct Found<M> {
    pub model: M,
    pub noise: Noise,
    pub inliers: Vec<usize>,
}

impl<'a> Matches<'a> {
    pub fn new(points: &'a [[f64; 4]], frame: Frame, options: &'a TwoViewOptions, tolerance: Tolerance) -> Result<Self, Error> {
        let mut different = points.to_vec();
        different.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        different.dedup();
        let needed = <Homographies as Problem>::SAMPLE + LEAST_REDUNDANCY;
        if different.len() < needed {
            return Err(Error::TooFew { what: "different matches for the geometry of two views", got: different.len(), needed });
        }
        let extent = Frame::normalising(points).px() / frame.px();
        Ok(Self { points, options, frame, rays: frame.rays(points), limits: options.limits(frame.px()), extent, tolerance })
    }

    pub fn field(&self) -> Field {
        Field::new(&self.rays, self.options.seed)
    }

    fn search(&self, most_samples: usize) -> Search {
        Search {
            seed: self.options.seed,
            missing: 1.0 - self.options.confidence,
            least_samples: 12,
            most_samples,
            margin: 1.0,
            scale: 0.5 * self.limits.largest_threshold,
        }
    }

    /// The matches whose square distance is within the threshold, which follows from the distances of all.
    pub fn agreeing<M>(&self, model: M, conditions: Conditions, square: impl Fn(&Ray) -> f64) -> Found<M> {
        let distances: Vec<f64> = self.rays.iter().map(|ray| square(ray).sqrt()).collect();
        let noise = noise(&distances, conditions, &self.limits);
        let inliers = (0..distances.len()).filter(|k| distances[*k] <= noise.threshold).collect();
        Found { model, noise, inliers }
    }

    /// Some of the matches by themselves.
    fn only(&self, indices: &[usize]) -> Vec<Ray> {
        indices.iter().map(|k| self.rays[*k]).collect()
    }

    pub fn points_of(&self, indices: &[usize]) -> Vec<[f64; 4]> {
        indices.iter().map(|k| self.points[*k]).collect()
    }

    /// Whether a homography (or a rotation) explains the matches that agree with a general geometry: those that deviate are no more than
    /// wrong matches along epipolar lines.
    fn explains<M>(&self, homography: &Matrix3<f64>, general: &Found<M>) -> bool {
        !self.tolerance.is_exceeded(&general.noise, self.off(homography, general).count())
    }

    fn off<'b, M>(&'b self, homography: &Matrix3<f64>, general: &'b Found<M>) -> impl Iterator<Item = usize> + use<'b, 'a, M> {
        let limit = self.tolerance.off(&general.noise, self.extent);
        let homography = *homography;
        general.inliers.iter().copied().filter(move |k| square_transfer(&homography, &self.rays[*k]) > limit * limit)
    }

    /// Whether a rotation fits the matches that agree with the map of a plane as well as that does, though it has fewer unknowns.
    fn is_as_good<M>(&self, rotation: &Matrix3<f64>, plane: &Matrix3<f64>, found: &Found<M>) -> bool {
        let largest = FARTHEST * FARTHEST * found.noise.sigma * found.noise.sigma;
        let sum = |map: &Matrix3<f64>| found.inliers.iter().map(|k| square_transfer(map, &self.rays[*k]).min(largest)).sum::<f64>();
        let excess = sum(rotation) - sum(plane);
        let distorted = DISTORTED * self.extent;
        excess <= SIGNIFICANT * found.noise.sigma * found.noise.sigma || excess <= found.inliers.len() as f64 * distorted * distorted
    }

    pub fn result<M>(&self, model: TwoViewModel, found: Found<M>) -> TwoView {
        let px = self.frame.px();
        TwoView {
            model,
            inliers: found.inliers,
            threshold_px: found.noise.threshold * px,
            sigma_px: found.noise.sigma * px,
            degenerate: None,
            homography: None,
            focal: None,
        }
    }

    /// Whether more matches agree than would with the best of all models if all were wrong. `models`: the most through one sample.
    fn is_supported<M>(&self, found: &Found<M>, sample: usize, models: usize, conditions: Conditions) -> bool {
        let chance = chance_of_agreeing(self.points, found.noise.threshold * self.frame.px(), conditions);
        let support = Support { count: self.points.len(), agreeing: found.inliers.len(), sample, models, chance };
        found.noise.is_supported(sample) && support.log_false_alarms() < LARGEST_LOG_FALSE_ALARMS
    }

    pub fn unsupported(&self, agreeing: usize) -> Error {
        Error::Degenerate { task: Task::TwoViewGeometry, cause: Cause::Chance { agreeing, matches: self.rays.len() } }
    }
}

fn calibrated(matches: &Matches) -> Result<TwoView, Error> {
    let field = matches.field();
    let scale = |distances: &mut [f64]| search_scale(distances, Conditions::One, &matches.limits);
    let poses = Poses { field: &field, scale: &scale };
    let best = consensus(&poses, None, &matches.search(matches.options.max_samples as usize)).ok_or_else(|| matches.unsupported(0))?;
    let found = polished(matches, best.model);
    if !matches.is_supported(&found, Poses::SAMPLE, MOST_POSES, Conditions::One) {
        return Err(matches.unsupported(found.inliers.len()));
    }
    let inner = Field::new(&matches.only(&found.inliers), matches.options.seed);
    let rotations = Rotations { field: &inner, limits: matches.limits };
    let search = matches.search(NEARLY_ALL_SAMPLES);
    if let Some(turned) = consensus(&rotations, None, &search) {
        if matches.explains(&turned.model, &found) {
            return Ok(of_rotation(matches, matches.frame, turned.model, &turned.model));
        }
        let largest_px = matches.limits.largest_threshold * matches.frame.px();
        if let Some((frame, rotation)) = near_focal(&matches.points_of(&found.inliers), &matches.frame, &turned.model, largest_px) {
            let own = matches.frame.homography_from_px(&frame.homography_px(&rotation));
            if matches.explains(&own, &found) {
                return Ok(of_rotation(matches, frame, rotation, &own));
            }
        }
    }
    let homographies = Homographies { field: &inner, limits: matches.limits };
    let Some(plane) = consensus(&homographies, None, &search).filter(|plane| matches.explains(&plane.model, &found)) else {
        return Ok(matches.result(of_pose(&matches.frame, &found.model), found));
    };
    let found = best_over_plane(matches, found, &plane.model);
    let flat = matches.explains(&plane.model, &found);
    let mut result = matches.result(of_pose(&matches.frame, &found.model), found);
    if flat {
        result.degenerate = Some(Degeneracy::Plane);
        result.homography = Some(rows(&matches.frame.homography_px(&plane.model)));
    }
    Ok(result)
}

/// A pose refined by the matches that agree with it alone, these in front of both cameras.
pub(super) fn polished(matches: &Matches, pose: Pose) -> Found<Pose> {
    let scale = |distances: &mut [f64]| search_scale(distances, Conditions::One, &matches.limits);
    let mut found = agreeing_with_pose(matches, pose);
    for _ in 0..POLISHINGS {
        let inner = Field::new(&matches.only(&found.inliers), matches.options.seed);
        let start = Candidate { model: found.model, scale: found.noise.sigma };
        found = agreeing_with_pose(matches, Poses { field: &inner, scale: &scale }.settled(&start, inner.rays.len()).model);
    }
    let (pose, behind) = (found.model, 5.0 * found.noise.sigma);
    found.inliers.retain(|k| pose.in_front(&matches.rays[*k], behind));
    found
}

/// Over a plane two poses fit: the one with more matches, or of equal ones that with the optical axes nearer to parallel.
fn best_over_plane(matches: &Matches, found: Found<Pose>, homography: &Matrix3<f64>) -> Found<Pose> {
    // A pose with the base reversed differs by what lies in front of it; the one nearer to what was found would be found again.
    let seen = |pose: &Pose| found.inliers.iter().filter(|k| pose.in_front(&matches.rays[**k], 0.0)).count();
    let apart = |pose: &Pose| 1.0 - (found.model.rotation.transpose() * pose.rotation).trace();
    let poses = poses_of_plane(homography);
    let facing = poses.chunks_exact(2).map(|pair| if seen(&pair[1]) > seen(&pair[0]) { pair[1] } else { pair[0] });
    let other = facing.reduce(|a, b| if apart(&b) > apart(&a) { b } else { a });
    let mut all = vec![found];
    all.extend(other.map(|pose| polished(matches, pose)));
    let most = all.iter().map(|found| found.inliers.len()).max().unwrap_or(0);
    let enough = most - most / AS_MANY;
    let parallel = |found: &Found<Pose>| found.model.rotation[(2, 2)];
    let best = all.into_iter().filter(|found| found.inliers.len() >= enough).reduce(|a, b| if parallel(&b) > parallel(&a) { b } else { a });
    best.expect("the one with most matches is among them")
}

fn agreeing_with_pose(matches: &Matches, pose: Pose) -> Found<Pose> {
    let essential = pose.essential();
    matches.agreeing(pose, Conditions::One, |ray| square_distance(&essential, *ray))
}

pub(super) fn of_pose(frame: &Frame, pose: &Pose) -> TwoViewModel {
    TwoViewModel::Calibrated {
        fundamental: rows(&frame.fundamental_px(&pose.essential())),
        rotation: rows(&pose.rotation),
        base: [pose.base.x, pose.base.y, pose.base.z],
    }
}

/// The result for photos from one place. `homography` is in the coordinates of the matches, `rotation` in those of `frame`.
fn of_rotation(matches: &Matches, frame: Frame, rotation: Matrix3<f64>, homography: &Matrix3<f64>) -> TwoView {
    let found = matches.agreeing((), Conditions::Two, |ray| square_transfer(homography, ray));
    let map = rows(&frame.homography_px(&rotation));
    let mut result = matches.result(TwoViewModel::Rotation { homography: map, rotation: rows(&rotation) }, found);
    (result.degenerate, result.homography) = (Some(Degeneracy::PureRotation), Some(map));
    result
}

fn uncalibrated(matches: &Matches, principal: Option<[[f64; 2]; 2]>) -> Result<TwoView, Error> {
    let field = matches.field();
    match general(matches, &field) {
        Some(found) => general_or_plane(matches, &field, found, principal),
        None => planar(matches, &field, principal),
    }
}

/// What the matches need of unknown cameras whose fundamental matrix is found: that, or the map of a plane that explains it.
pub(super) fn general_or_plane(
    matches: &Matches,
    field: &Field,
    found: Found<Matrix3<f64>>,
    principal: Option<[[f64; 2]; 2]>,
) -> Result<TwoView, Error> {
    let inner = Field::new(&matches.only(&found.inliers), matches.options.seed);
    let homographies = Homographies { field: &inner, limits: matches.limits };
    let Some(plane) = consensus(&homographies, None, &matches.search(HALF_SAMPLES)) else {
        return Ok(with_focal(matches, found, principal));
    };
    let found = beside_plane(matches, field, &plane.model, found);
    // Over low relief the map may come near all matches and yet agree with few. What lies off a map that does not explain the others is
    // relief, or strangers along the lines, which only many such matches tell from relief: without cameras, where no orientation is lost
    // with them, the map of nearly all is the surer answer.
    let explains = matches.explains(&plane.model, &found);
    let [part, of] = if explains { NEARLY_ALL } else { DOMINANT };
    if (explains || principal.is_none())
        && let Ok(flat) = planar(matches, field, principal)
        && of * flat.inliers.len() >= part * found.inliers.len()
    {
        return Ok(flat);
    }
    Ok(with_focal(matches, found, principal))
}

/// The fundamental matrix that more matches agree with than would by chance.
fn general(matches: &Matches, field: &Field) -> Option<Found<Matrix3<f64>>> {
    let fundamentals = Fundamentals { field, limits: matches.limits };
    let best = consensus(&fundamentals, None, &matches.search(matches.options.max_samples as usize))?;
    let found = of_fundamental(matches, field, &best);
    matches.is_supported(&found, Fundamentals::SAMPLE, MOST_FUNDAMENTALS, Conditions::One).then_some(found)
}

/// A fundamental matrix refined by all matches.
pub(super) fn of_fundamental(matches: &Matches, field: &Field, best: &Candidate<Matrix3<f64>>) -> Found<Matrix3<f64>> {
    let polished = super::refine::refined(&super::fundamental::Epipolar, field, best, &matches.limits, field.rays.len());
    let matrix = polished.unwrap_or(*best).model;
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

/// The general geometry of unknown cameras, calibrated where the matches determine the focal length.
fn with_focal(matches: &Matches, found: Found<Matrix3<f64>>, principal: Option<[[f64; 2]; 2]>) -> TwoView {
    let fundamental = matches.frame.fundamental_px(&found.model);
    let sigma_px = found.noise.sigma * matches.frame.px();
    let searched = principal.and_then(|p| focal::of_base(&matches.points_of(&found.inliers), &p, &fundamental, sigma_px));
    let calibrated = searched.and_then(|searched| {
        let estimate = searched.estimate?;
        let own = Matches::new(matches.points, searched.best.frame, matches.options, matches.tolerance).ok()?;
        let pose = polished(&own, searched.best.model);
        // It has fewer unknowns: what it cannot explain, as distortion, stands against it.
        let serves = NEARLY_ALL[1] * pose.inliers.len() >= NEARLY_ALL[0] * found.inliers.len();
        serves.then(|| TwoView { focal: Some(estimate), ..own.result(of_pose(&own.frame, &pose.model), pose) })
    });
    calibrated.unwrap_or_else(|| matches.result(TwoViewModel::Fundamental { fundamental: rows(&fundamental) }, found))
}

/// What is left where no fundamental matrix is determined: the map of a plane, or a rotation.
fn planar(matches: &Matches, field: &Field, principal: Option<[[f64; 2]; 2]>) -> Result<TwoView, Error> {
    let homographies = Homographies { field, limits: matches.limits };
    let best =
        consensus(&homographies, None, &matches.search(matches.options.max_samples as usize)).ok_or_else(|| matches.unsupported(0))?;
    let polished = super::refine::refined(&super::homography::Plane, field, &best, &matches.limits, field.rays.len());
    let matrix = polished.unwrap_or(best).model;
    let found = matches.agreeing(matrix, Conditions::Two, |ray| square_transfer(&matrix, ray));
    if !matches.is_supported(&found, Homographies::SAMPLE, 1, Conditions::Two) {
        return Err(matches.unsupported(found.inliers.len()));
    }
    let homography_px = matches.frame.homography_px(&matrix);
    let sigma_px = found.noise.sigma * matches.frame.px();
    let turned = principal.and_then(|p| focal::of_rotation(&matches.points_of(&found.inliers), &p, &homography_px, sigma_px));
    // At a narrow angle flat ground moves as if the camera had turned, whatever its focal length; only what does not move at all is surely
    // seen from one place.
    let unmoved = matches.explains(&matches.frame.homography_from_px(&Matrix3::identity()), &found);
    if let Some(turned) = turned.filter(|turned| turned.estimate.is_some() || unmoved) {
        let in_px = turned.best.frame.homography_px(&turned.best.model);
        let own = matches.frame.homography_from_px(&in_px);
        if matches.explains(&own, &found) && matches.is_as_good(&own, &matrix, &found) {
            let result = of_rotation(matches, turned.best.frame, turned.best.model, &own);
            return Ok(TwoView { focal: turned.estimate, ..result });
        }
    }
    let homography = rows(&homography_px);
    let mut result = matches.result(TwoViewModel::Homography { homography }, found);
    (result.degenerate, result.homography) = (Some(Degeneracy::Plane), Some(homography));
    Ok(result)
}
