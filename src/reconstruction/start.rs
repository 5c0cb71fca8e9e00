//! The two images that a model starts from.

use super::net::Net;
use super::rays::Rays;
use crate::camera::Pose;
use crate::math::{dot3, median, minus};
use crate::tracks::SharedPoints;
use crate::two_view::{Pinhole, TwoViewModel, TwoViewOptions, two_view};

/// Two images that are oriented to each other: the first at the origin, the second at a distance of 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct StartPair {
    pub images: [usize; 2],
    pub poses: [Pose; 2],
    score: f64,
}

/// Pairs that are oriented: those with most points in common, and as many spread over the others.
const TRIED: usize = 24;
/// Least number of points in common, and the least share of the largest number.
const LEAST_POINTS: u32 = 20;
const LEAST_SHARE: f64 = 0.25;
/// Points by which a pair is oriented.
const USED: usize = 250;
/// An angle between rays beyond which a larger one is no better.
const WIDE_DEG: f64 = 15.0;

/// The best pairs of images that are not oriented, the best first: many points that agree, seen at a wide angle.
pub(super) fn start_pairs(net: &Net<'_>, shared: &[SharedPoints], is_open: &[bool], seed: u32) -> Vec<StartPair> {
    let open = |pair: &&SharedPoints| pair.images.iter().all(|image| is_open[*image as usize]);
    let mut pairs: Vec<&SharedPoints> = shared.iter().filter(|pair| pair.points >= LEAST_POINTS).filter(open).collect();
    pairs.sort_by(|a, b| b.points.cmp(&a.points).then(a.images.cmp(&b.images)));
    let least = pairs.first().map_or(0.0, |pair| LEAST_SHARE * f64::from(pair.points));
    pairs.retain(|pair| f64::from(pair.points) >= least);
    let (first, rest) = pairs.split_at(pairs.len().min(TRIED));
    let spread = rest.iter().step_by(rest.len().div_ceil(TRIED).max(1));
    let mut found: Vec<StartPair> = first.iter().chain(spread).filter_map(|pair| orient(net, pair.images, seed)).collect();
    found.sort_by(|a, b| b.score.total_cmp(&a.score).then(a.images.cmp(&b.images)));
    found
}

/// The relative orientation of two images; `None` where there is none or no base.
fn orient(net: &Net<'_>, images: [u32; 2], seed: u32) -> Option<StartPair> {
    let images = images.map(|image| image as usize);
    let common = common_rays(net.rays, images);
    let step = common.len().div_ceil(USED).max(1);
    let directions: Vec<[[f64; 3]; 2]> =
        common.iter().step_by(step).filter_map(|pair| Some([net.in_photo(pair[0])?, net.in_photo(pair[1])?])).collect();
    let focal = images.map(|image| net.camera(image).focal_px);
    let at = |d: &[f64; 3], focal: f64| [-focal * d[0] / d[2], focal * d[1] / d[2]];
    let places: Vec<[f64; 4]> = (directions.iter())
        .map(|[a, b]| {
            let ([xl, yl], [xr, yr]) = (at(a, focal[0]), at(b, focal[1]));
            [xl, yl, xr, yr]
        })
        .collect();
    let [left, right] = focal.map(|focal| Some(Pinhole { focal_px: Some(focal), principal_px: [0.0; 2] }));
    let found = two_view(&places, &TwoViewOptions { left, right, seed, ..TwoViewOptions::default() }).ok()?;
    let TwoViewModel::Calibrated { rotation, base, .. } = found.model else { return None };
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let poses = [Pose { rotation: identity, position: [0.0; 3] }, Pose { rotation, position: base }];
    let mut angles: Vec<f64> = found.inliers.iter().map(|k| angle(&directions[*k], &rotation)).collect();
    let middle = median(&mut angles)?.to_degrees();
    let score = common.len() as f64 * found.inliers.len() as f64 / places.len() as f64 * (middle / WIDE_DEG).min(1.0);
    Some(StartPair { images, poses, score })
}

/// The angle at which two rays meet, by their directions in the two photos.
fn angle([a, b]: &[[f64; 3]; 2], rotation: &[[f64; 3]; 3]) -> f64 {
    let turned = [0, 1, 2].map(|k| rotation[0][k] * b[0] + rotation[1][k] * b[1] + rotation[2][k] * b[2]);
    let d = minus(a, &turned);
    2.0 * libm::asin((0.5 * dot3(&d, &d).sqrt()).min(1.0))
}

/// The rays of two images to the points that they have in common.
pub(super) fn common_rays(rays: &Rays, [a, b]: [usize; 2]) -> Vec<[usize; 2]> {
    let (a, b) = (rays.of_image(a), rays.of_image(b));
    let point = |ray: u32| rays.point[ray as usize];
    let (mut i, mut j, mut common) = (0, 0, Vec::new());
    while i < a.len() && j < b.len() {
        match point(a[i]).cmp(&point(b[j])) {
            std::cmp::Ordering::Less => i += 1,
            std::cmp::Ordering::Greater => j += 1,
            std::cmp::Ordering::Equal => {
                common.push([a[i] as usize, b[j] as usize]);
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    common
}
