//! Which positions agree with the others of their strip: an error that the positions of a strip share is none of a single one.

use super::robust_similarity::{MEDIANS, SIGMAS};
use super::systematic::SystematicErrors;
use crate::math::{dot3, median};

/// Of more positions, only so many evenly spread ones are paired: the number of pairs grows with the square.
const MOST_PAIRED: usize = 1000;
/// Fewer positions of a strip show no trend.
const LEAST_POSITIONS: usize = 4;

/// How far a position lies from where a similarity has it, with the standard error of its length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Misfit {
    pub off: [f64; 3],
    pub sigma: f64,
}

/// Whether each position is near enough to the trend of its strip: to the line on which most of them lie, or to their median where no drifts are
/// estimated. An image without a position agrees.
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
            let (slope, middle) = if systematic.is_of_drifts() { trend(&values) } else { (0.0, middle_of(&values, 0.0)) };
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
    let paired: Vec<&(f64, f64)> = values.iter().step_by(values.len().div_ceil(MOST_PAIRED).max(1)).collect();
    let pairs = paired.iter().enumerate().flat_map(|(k, first)| paired[k + 1..].iter().map(move |second| (first, second)));
    let slopes = pairs.filter(|(first, second)| first.0 != second.0).map(|(first, second)| (second.1 - first.1) / (second.0 - first.0));
    let slope = median(&mut slopes.collect::<Vec<_>>()).unwrap_or(0.0);
    (slope, middle_of(values, slope))
}

/// The median of what a slope leaves of values at places.
fn middle_of(values: &[(f64, f64)], slope: f64) -> f64 {
    let left = values.iter().map(|(place, value)| value - slope * place);
    median(&mut left.collect::<Vec<_>>()).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adjustment::{Strip, SystematicError};

    #[test]
    fn a_line_by_medians_ignores_a_wrong_value() {
        let mut values: Vec<(f64, f64)> = (0..9).map(|k| (f64::from(k), 2.0 + 0.5 * f64::from(k))).collect();
        values[3].1 = 100.0;
        let (slope, middle) = trend(&values);
        assert!((slope - 0.5).abs() < 1e-12 && (middle - 2.0).abs() < 1e-12);
        assert_eq!(trend(&[(1.0, 3.0), (1.0, 5.0)]), (0.0, 4.0));
    }

    #[test]
    fn without_drifts_a_slope_is_none_of_a_strip() {
        let strip = Strip { images: (0..9).collect(), places: (0..9).map(|k| 0.125 * f64::from(k) - 0.5).collect() };
        let mut misfits = vec![Some(Misfit { off: [0.0; 3], sigma: 0.05 }); 30];
        misfits.iter_mut().flatten().zip(&strip.places).for_each(|(misfit, place)| misfit.off[0] = 5.0 + 2.0 * place);
        let far = |error: SystematicError| -> Vec<usize> {
            let mut systematic = SystematicErrors::default();
            (systematic.strips, systematic.errors) = (vec![strip.clone()], vec![error]);
            let near = near_trends(&systematic, &misfits);
            (0..30).filter(|image| !near[*image]).collect()
        };
        assert_eq!(far(SystematicError::StripOffset { strip: 0 }), [0, 1, 2, 6, 7, 8]);
        assert!(far(SystematicError::StripDrift { strip: 0 }).is_empty());
    }

    #[test]
    fn long_strips_are_thinned() {
        let mut values: Vec<(f64, f64)> = (0..5000).map(|k| (0.001 * f64::from(k), 2.0 + 0.0005 * f64::from(k))).collect();
        values.iter_mut().step_by(4).for_each(|(_, value)| *value += 100.0);
        let (slope, middle) = trend(&values);
        assert!((slope - 0.5).abs() < 1e-9 && (middle - 2.0).abs() < 1e-6, "{slope} {middle}");
    }
}
