//! Which positions agree with the others of their strip: an error that the positions of a strip share is none of a single one.

use super::robust_similarity::{MEDIANS, SIGMAS};
use super::systematic::SystematicErrors;
use crate::math::{dot3, median};

/// Fewer positions of a strip show no trend.
const LEAST_POSITIONS: usize = 4;

/// How far a position lies from where a similarity has it, with the standard error of its length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Misfit {
    pub off: [f64; 3],
    pub sigma: f64,
}

/// Whether each position is near enough to the trend of its strip: to the line on which most of them lie. An image without a position agrees.
///
/// # Source
/// Theil 1950, A rank-invariant method of linear and polynomial regression analysis; Sen 1968 (median of slopes).
pub(super) fn near_trends(systematic: &SystematicErrors, misfits: &[Option<Misfit>]) -> Vec<bool> {
    let mut left: Vec<Option<[f64; 3]>> = misfits.iter().map(|misfit| misfit.map(|misfit| misfit.off)).collect();
    for strip in &systematic.strips {
        let known: Vec<(usize, f64, [f64; 3])> =
            strip.images.iter().zip(&strip.places).filter_map(|(image, place)| Some((*image, *place, misfits[*image]?.off))).collect();
        if known.len() < LEAST_POSITIONS {
            continue;
        }
        for k in 0..3 {
            let values: Vec<(f64, f64)> = known.iter().map(|(_, place, off)| (*place, off[k])).collect();
            let (slope, middle) = trend(&values);
            for (image, place, off) in &known {
                if let Some(left) = &mut left[*image] {
                    left[k] = off[k] - middle - slope * place;
                }
            }
        }
    }
    let distances: Vec<Option<f64>> = left.iter().map(|left| left.map(|left| dot3(&left, &left).sqrt())).collect();
    let middle = median(&mut distances.iter().flatten().copied().collect::<Vec<_>>()).unwrap_or(0.0);
    let agrees = |(distance, misfit): (&Option<f64>, &Option<Misfit>)| match (distance, misfit) {
        (Some(distance), Some(misfit)) => *distance <= (MEDIANS * middle).max(SIGMAS * misfit.sigma),
        _ => true,
    };
    distances.iter().zip(misfits).map(agrees).collect()
}

/// Slope and value at 0 of the line by the medians of values at places.
fn trend(values: &[(f64, f64)]) -> (f64, f64) {
    let pairs = values.iter().enumerate().flat_map(|(k, first)| values[k + 1..].iter().map(move |second| (first, second)));
    let slopes = pairs.filter(|(first, second)| first.0 != second.0).map(|(first, second)| (second.1 - first.1) / (second.0 - first.0));
    let slope = median(&mut slopes.collect::<Vec<_>>()).unwrap_or(0.0);
    let left = values.iter().map(|(place, value)| value - slope * place);
    (slope, median(&mut left.collect::<Vec<_>>()).unwrap_or(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_by_medians_ignores_a_wrong_value() {
        let mut values: Vec<(f64, f64)> = (0..9).map(|k| (f64::from(k), 2.0 + 0.5 * f64::from(k))).collect();
        values[3].1 = 100.0;
        let (slope, middle) = trend(&values);
        assert!((slope - 0.5).abs() < 1e-12 && (middle - 2.0).abs() < 1e-12);
        assert_eq!(trend(&[(1.0, 3.0), (1.0, 5.0)]), (0.0, 4.0));
    }
}
