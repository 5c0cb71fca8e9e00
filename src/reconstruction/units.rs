//! Whether the surveyed points of a block are in metres: by positions that were recorded in another system.

use super::frame::Frame;
use super::result::ReconstructedModel;
use super::warning::{BlockWarning, LengthUnit};
use crate::math::median;
use crate::model::{BlockDescription, ObservedPosition};

/// Lengths that differ by less are taken as the same: ln 1.2.
const LARGEST_LOG: f64 = 0.182;
/// They differ where they do so by this many times what the errors of recorded positions do to half of the distances.
const SIGMAS: f64 = 3.0;
/// Where half of the distances are known worse than to this share, recorded positions tell nothing of lengths.
const LARGEST_SHARE: f64 = 0.25;
/// Distances that are compared at least.
const LEAST_DISTANCES: usize = 3;
/// Images between which distances are compared, about.
const COMPARED: usize = 200;
/// Numbers of a unit in a metre.
const UNITS: [(f64, LengthUnit); 5] = [
    (1000.0, LengthUnit::Millimetres),
    (100.0, LengthUnit::Centimetres),
    (39.37, LengthUnit::Inches),
    (3.281, LengthUnit::Feet),
    (0.001, LengthUnit::Kilometres),
];
/// A ratio within this of a unit's is taken for it: the logarithm of 1.15.
const NEAR_UNIT_LOG: f64 = 0.14;
/// Surveyed points within a degree are near each other; heights do not come as small.
const LARGEST_EXTENT_DEG: f64 = 1.0;
const LEAST_HEIGHT: f64 = 10.0;

/// What speaks against metres.
pub(super) fn of_units(model: &ReconstructedModel, description: &BlockDescription, frame: &Frame) -> Vec<BlockWarning> {
    let ratio = ratio_of_lengths(model, frame).filter(|_| model.in_system);
    let unit = |ratio: f64| UNITS.iter().find(|(per_metre, _)| libm::log(ratio / per_metre).abs() < NEAR_UNIT_LOG).map(|(_, unit)| *unit);
    let scale = ratio.map(|ratio| BlockWarning::Scale { ratio, unit: unit(ratio) });
    let degrees = ((!model.in_system || ratio.is_some()) && look_like_degrees(description)).then_some(BlockWarning::Degrees);
    scale.into_iter().chain(degrees).collect()
}

/// How many times as long distances between images are as those between their recorded positions: the median, where it says that lengths
/// differ.
fn ratio_of_lengths(model: &ReconstructedModel, frame: &Frame) -> Option<f64> {
    let images = model.images.iter().zip(&model.adjusted.block.images);
    let known: Vec<_> = images.filter_map(|(image, adjusted)| Some((adjusted.pose.position, frame.recorded[*image]?))).collect();
    let some: Vec<_> = known.iter().step_by(known.len().div_ceil(COMPARED).max(1)).collect();
    let (mut logs, mut shares) = (Vec::new(), Vec::new());
    for (index, (at, recorded)) in some.iter().enumerate() {
        for (other_at, other) in &some[index + 1..] {
            let (mut adjusted, mut observed, mut variance) = (0.0, 0.0, 0.0);
            for k in 0..3 {
                let (Some(sigma), Some(other_sigma)) = (recorded.sigma[k], other.sigma[k]) else { continue };
                let (d, e) = (at[k] - other_at[k], recorded.position[k] - other.position[k]);
                adjusted += d * d;
                observed += e * e;
                // Of the length by its components, times its square.
                variance += e * e * (sigma * sigma + other_sigma * other_sigma);
            }
            if adjusted > 0.0 && observed > 0.0 {
                logs.push(0.5 * libm::log(adjusted / observed));
                shares.push(variance.sqrt() / observed);
            }
        }
    }
    if logs.len() < LEAST_DISTANCES {
        return None;
    }
    let (log, share) = (median(&mut logs)?, median(&mut shares)?);
    (share <= LARGEST_SHARE && log.abs() > LARGEST_LOG.max(SIGMAS * share)).then(|| libm::exp(log))
}

/// Whether x and y could be degrees beside heights in metres.
fn look_like_degrees(description: &BlockDescription) -> bool {
    let local = |position: &ObservedPosition| match *position {
        ObservedPosition::Local { position, .. } => Some(position),
        ObservedPosition::Geographic { .. } => None,
    };
    let places: Vec<[f64; 3]> = description.control.iter().filter_map(|control| local(&control.position)).collect();
    let largest = |k: usize| places.iter().map(|p| p[k].abs()).fold(0.0, f64::max);
    let reach = |k: usize| places.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| [low.min(p[k]), high.max(p[k])]);
    let extent = |k: usize| reach(k)[1] - reach(k)[0];
    // In either order.
    let (one, other) = (largest(0).min(largest(1)), largest(0).max(largest(1)));
    !places.is_empty()
        && one <= 90.0
        && other <= 180.0
        && extent(0).max(extent(1)) <= LARGEST_EXTENT_DEG
        && median(&mut places.iter().map(|p| p[2].abs()).collect::<Vec<_>>()).is_some_and(|height| height >= LEAST_HEIGHT)
}
