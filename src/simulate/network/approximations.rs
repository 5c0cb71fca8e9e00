//! What is known of a simulated block before its adjustment: control points, GNSS positions, approximate values.

use crate::camera::rotation_from_angles;
use crate::simulate::block::BlockFlight;
use crate::simulate::random::{Random, Stream};
use crate::{Block, ControlPoint, Pose, PositionPrior};

/// Makes control points of those that most images see, far from each other: the first, then always the one farthest from all so far.
pub(super) fn add_control(flight: &BlockFlight, truth: &mut Block) {
    let mut rays = vec![0; truth.points.len()];
    truth.rays.iter().for_each(|ray| rays[ray.point] += 1);
    let candidates: Vec<usize> = (0..truth.points.len()).filter(|p| rays[*p] >= 3).collect();
    let mut nearest = vec![f64::INFINITY; candidates.len()];
    for _ in 0..flight.control_points.min(candidates.len()) {
        let Some(best) = (0..candidates.len()).max_by(|a, b| nearest[*a].total_cmp(&nearest[*b]).then(b.cmp(a))) else { return };
        let position = truth.points[candidates[best]];
        truth.control.push(ControlPoint { point: candidates[best], position, sigma: [flight.control_sigma_m; 3] });
        for (distance, candidate) in nearest.iter_mut().zip(&candidates) {
            let other = truth.points[*candidate];
            *distance = distance.min((0..3).map(|k| (other[k] - position[k]) * (other[k] - position[k])).sum());
        }
    }
}

/// What is known before the adjustment: the truth with errors.
pub(super) fn approximate(flight: &BlockFlight, truth: &Block) -> Block {
    let mut random = Random::new(flight.seed, Stream::NetworkApproximations);
    let mut errors = |sigma: f64| {
        let (a, b) = (random.normal_pair(), random.normal_pair());
        [a.x * sigma, a.y * sigma, b.x * sigma]
    };
    let moved = |position: [f64; 3], by: [f64; 3]| [0, 1, 2].map(|k| position[k] + by[k]);
    let mut block = truth.clone();
    for image in &mut block.images {
        if flight.receiver_m > 0.0 {
            image.gnss = Some(PositionPrior {
                position: moved(image.pose.position, errors(flight.receiver_m)),
                sigma: [Some(flight.receiver_m); 3],
            });
        }
        let position = moved(image.pose.position, errors(flight.approximate_m));
        let [a, b, c] = errors(flight.approximate_m / flight.flying_height_m);
        image.pose = Pose::new(&(image.pose.matrix() * rotation_from_angles(a, b, c)), position);
    }
    block.points.iter_mut().for_each(|point| *point = moved(*point, errors(flight.approximate_m)));
    block.control.iter_mut().for_each(|control| control.position = moved(control.position, errors(flight.control_sigma_m)));
    block
}
