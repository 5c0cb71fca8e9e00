//! Which ray of a point the others are matched to.

use super::windows::WindowedObservation;
use crate::math::median;
use std::cmp::Reverse;

/// Steps of scale within which contrast decides, in octaves.
const STEP_OCTAVES: f64 = 0.25;

/// The rays in the order in which they are tried: those of middling scale first, so that the others are little enlarged or reduced; of these
/// the one with the highest contrast.
pub(super) fn references(rays: &[WindowedObservation<'_>], window: usize) -> Vec<usize> {
    let octaves: Vec<f64> = rays.iter().map(|ray| libm::log2(ray.place.scale_px)).collect();
    let middle = median(&mut octaves.clone()).unwrap_or(0.0);
    let rank = |index: &usize| {
        let steps = libm::round((octaves[*index] - middle).abs() / STEP_OCTAVES) as u64;
        (steps, Reverse(contrast(&rays[*index], window)), *index)
    };
    let mut order: Vec<usize> = (0..rays.len()).collect();
    order.sort_by_cached_key(rank);
    order
}

/// n²·variance of the n grey values that are matched in the image itself; 0 where they leave it.
fn contrast(ray: &WindowedObservation<'_>, window: usize) -> u64 {
    let Some(own) = ray.window(0) else { return 0 };
    let place = own.place(ray.place.position).map(|v| v as usize);
    let reach = window / 2;
    let inside = |at: usize, length: usize| at >= reach && at + reach < length;
    if !(inside(place[0], own.grey.width()) && inside(place[1], own.grey.height())) {
        return 0;
    }
    let (mut sum, mut squares) = (0u64, 0u64);
    for row in place[1] - reach..=place[1] + reach {
        for grey in &own.grey.row(row)[place[0] - reach..=place[0] + reach] {
            sum += u64::from(*grey);
            squares += u64::from(*grey) * u64::from(*grey);
        }
    }
    squares * (window * window) as u64 - sum * sum
}
