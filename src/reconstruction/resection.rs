//! The orientation of an image by points that are known: consensus of three, then all that agree.

use super::net::{Net, residual};
use super::p3p::p3p;
use super::warning::UnorientedReason;
use crate::adjustment::linearise;
use crate::camera::Pose;
use crate::math::Random;
use nalgebra::{Matrix6, Vector6};

/// Rays by which samples are judged.
const JUDGES: usize = 256;
/// Samples at least and at most, and the probability of missing a good one.
const SAMPLES: [usize; 2] = [30, 1500];
const MISSING: f64 = 1e-4;
/// Steps of the refinement.
const REFINEMENTS: usize = 12;
/// Share of the rays that agree, at least.
const LEAST_SHARE: f64 = 0.2;
/// The rays that agree spread by this share of the longer side of the image, at least, in the direction in which they spread least.
const LEAST_SPREAD: f64 = 0.02;

/// A ray with the place of its point.
struct Known {
    at: [f64; 2],
    direction: [f64; 3],
    place: [f64; 3],
}

/// Orients an image by its rays to intersected points, those that agree being within `limit_px`; gives how many agree, too.
pub(super) fn resect(net: &Net<'_>, image: usize, limit_px: f64, least_rays: usize, seed: u32) -> Result<(Pose, usize), UnorientedReason> {
    let known = known_rays(net, image, seed);
    if known.len() < least_rays {
        return Err(UnorientedReason::TooFewPoints { points: known.len(), needed: least_rays });
    }
    let camera = net.camera(image);
    let disagreement = |agreeing: usize| UnorientedReason::NoAgreement { agreeing, points: known.len(), needed: least_rays };
    let agree =
        |pose: &Pose| known.iter().filter(|k| residual(camera, pose, &k.place, &k.at).is_some_and(|r| r <= limit_px)).collect::<Vec<_>>();
    let sampled = consensus(net, image, &known, limit_px, seed).ok_or_else(|| disagreement(0))?;
    let pose = refined(net, image, &known, sampled, limit_px / 3.0).unwrap_or(sampled);
    let agreeing = agree(&pose);
    if agreeing.len() < least_rays || (agreeing.len() as f64) < LEAST_SHARE * known.len() as f64 {
        return Err(disagreement(agreeing.len()));
    }
    if least_spread(&agreeing) < LEAST_SPREAD * net.longer_side_px[net.camera_of[image]] {
        return Err(UnorientedReason::Narrow { agreeing: agreeing.len() });
    }
    Ok((pose, agreeing.len()))
}

/// In random order, so that the first stand for all.
fn known_rays(net: &Net<'_>, image: usize, seed: u32) -> Vec<Known> {
    let known = |ray: &u32| {
        let ray = *ray as usize;
        let place = net.points[net.rays.point[ray] as usize]?;
        Some(Known { at: net.rays.at[ray], direction: net.in_photo(ray)?, place })
    };
    let mut all: Vec<Known> = net.rays.of_image(image).iter().filter_map(known).collect();
    Random::new(seed.wrapping_add(image as u32)).shuffle(&mut all);
    all
}

/// The pose of three rays that costs least: Σ ln(1 + r²/s²), in which gross errors hardly weigh.
///
/// # Source
/// Fischler & Bolles 1981, Random sample consensus.
fn consensus(net: &Net<'_>, image: usize, known: &[Known], limit_px: f64, seed: u32) -> Option<Pose> {
    let camera = net.camera(image);
    let judges = &known[..known.len().min(JUDGES)];
    let mut random = Random::new(seed.wrapping_add(image as u32).wrapping_mul(2_654_435_761));
    let weight = 9.0 / (limit_px * limit_px);
    let most = libm::log1p(1e3);
    let mut best: Option<(Pose, f64)> = None;
    let (mut drawn, mut needed) = (0, SAMPLES[1]);
    let mut sample = [0; 3];
    while drawn < needed {
        drawn += 1;
        random.draw(known.len(), &mut sample);
        for pose in p3p(&sample.map(|k| known[k].direction), &sample.map(|k| known[k].place)) {
            let lowest = best.map_or(f64::INFINITY, |(_, cost)| cost);
            let (mut cost, mut agreeing) = (0.0, 0);
            for judge in judges {
                match residual(camera, &pose, &judge.place, &judge.at) {
                    Some(r) => {
                        cost += libm::log1p(weight * r * r).min(most);
                        agreeing += usize::from(r <= limit_px);
                    }
                    None => cost += most,
                }
                if cost >= lowest {
                    break;
                }
            }
            if cost < lowest {
                best = Some((pose, cost));
                let share = agreeing as f64 / judges.len() as f64;
                let all_good = share * share * share;
                let enough = if all_good >= 1.0 { 0.0 } else { libm::log(MISSING) / libm::log1p(-all_good) };
                // No agreement at all: the quotient is infinite, and the most samples are drawn.
                needed = (enough.min(SAMPLES[1] as f64) as usize).clamp(SAMPLES[0], SAMPLES[1]);
            }
        }
    }
    best.map(|(pose, _)| pose)
}

/// Gauss-Newton steps with Cauchy's weights at the scale `scale_px`. `None` where the rays do not determine the pose.
fn refined(net: &Net<'_>, image: usize, known: &[Known], start: Pose, scale_px: f64) -> Option<Pose> {
    let camera = net.camera(image).values();
    let mut pose = start;
    for _ in 0..REFINEMENTS {
        let (mut normal, mut right) = (Matrix6::<f64>::zeros(), Vector6::<f64>::zeros());
        for ray in known {
            let line = linearise(&camera, &pose, &ray.place);
            let v = [ray.at[0] - line.at[0], ray.at[1] - line.at[1]];
            let square = v[0] * v[0] + v[1] * v[1];
            if !square.is_finite() || pose.to_photo(&ray.place)[2] >= 0.0 {
                continue;
            }
            let weight = 1.0 / (1.0 + square / (scale_px * scale_px));
            // Beyond three times the limit, a ray only pulls the wrong way.
            if square > 81.0 * scale_px * scale_px {
                continue;
            }
            for row in 0..2 {
                let a = Vector6::from(line.by_image[row]);
                normal += weight * a * a.transpose();
                right += weight * v[row] * a;
            }
        }
        let step = normal.cholesky()?.solve(&right);
        let step: [f64; 6] = step.into();
        if !step.iter().all(|v| v.is_finite()) {
            return None;
        }
        pose = pose.moved(&step);
    }
    Some(pose)
}

/// Standard deviation of the places in px in the direction in which it is least.
fn least_spread(known: &[&Known]) -> f64 {
    let n = known.len() as f64;
    let mean = [0, 1].map(|k| known.iter().map(|r| r.at[k]).sum::<f64>() / n);
    let moment = |i: usize, j: usize| known.iter().map(|r| (r.at[i] - mean[i]) * (r.at[j] - mean[j])).sum::<f64>() / n;
    let (a, b, c) = (moment(0, 0), moment(0, 1), moment(1, 1));
    let half = 0.5 * (a + c);
    (half - (0.25 * (a - c) * (a - c) + b * b).sqrt()).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Camera;
    use crate::reconstruction::options::ReconstructionOptions;
    use crate::reconstruction::rays::Rays;

    #[test]
    fn an_image_cut_from_the_edge_of_a_large_one_is_oriented() {
        let camera = Camera { principal_point_px: [6000.0, 400.0], ..Camera::without_distortion(12000, 800, 3000.0) };
        let at = |k: usize| [(k * 37 % 40) as f64 * 25.0 + 10.0, (k * 13 % 40) as f64 * 20.0 + 10.0];
        let place = |k: usize| {
            let ([col, row], depth) = (at(k), 500.0 + 40.0 * (k % 7) as f64);
            [depth * (col - 6000.0) / 3000.0, -depth * (row - 400.0) / 3000.0, 700.0 - depth]
        };
        let rays = Rays::new((0..40).map(|k| [(0, at(k))]), 1);
        let mut net = Net::new(&rays, &[0], &[1000.0], vec![camera], &ReconstructionOptions::default());
        (0..40).for_each(|k| net.points[k] = Some(place(k)));
        let (pose, agreeing) = resect(&net, 0, 1.0, 12, 1).unwrap();
        assert_eq!(agreeing, 40);
        assert!(pose.position.iter().zip([0.0, 0.0, 700.0]).all(|(a, b)| (a - b).abs() < 1e-3), "{:?}", pose.position);
    }
}
