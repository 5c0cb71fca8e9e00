//! The threshold that leaves a wanted fraction of the pixels as candidates.

/// How the candidates of an operator are chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Selection {
    /// Values strictly greater than this, in the operator's unit.
    Threshold(f64),
    /// The threshold that leaves the nearest possible share of all pixels, 0..1.
    Fraction(f64),
    /// This threshold, lowered where it would leave less than [`LEAST_FRACTION`] of all pixels: what suits an image of which nothing
    /// is known.
    Adaptive(f64),
}

/// The share of all pixels that are candidates at the least where the threshold may adapt. Smooth photographs, as of small cameras,
/// have next to no pixel that differs from its neighbours by the paper's 40 grey levels.
pub const LEAST_FRACTION: f64 = 0.05;

impl Selection {
    /// The threshold to apply, where `of_fraction` finds the one that leaves a fraction.
    pub(super) fn resolve(self, of_fraction: impl FnOnce(f64) -> f64) -> f64 {
        match self {
            Selection::Threshold(threshold) => threshold,
            Selection::Fraction(fraction) => of_fraction(fraction),
            Selection::Adaptive(threshold) => threshold.min(of_fraction(LEAST_FRACTION)),
        }
    }
}

/// The threshold of whole-numbered values up to 255 that leaves a share of `pixels` nearest to `fraction` (of two, the higher).
///
/// `histogram[v]` counts the pixels of value `v`.
pub(super) fn threshold_of_histogram(histogram: &[usize; 256], pixels: usize, fraction: f64) -> f64 {
    let wanted = fraction * pixels as f64;
    let mut above = 0;
    let mut best = (255, wanted);
    for threshold in (0..255).rev() {
        above += histogram[threshold + 1];
        let miss = (above as f64 - wanted).abs();
        if miss < best.1 {
            best = (threshold, miss);
        }
    }
    best.0 as f64
}

/// The threshold that leaves `fraction` of `pixels`, chosen among `values` (all the others are taken as 0). It reorders `values`.
pub(super) fn threshold_of_values(values: &mut [f32], pixels: usize, fraction: f64) -> f64 {
    let wanted = (fraction * pixels as f64).round() as usize;
    if wanted >= values.len() {
        return 0.0;
    }
    let (_, threshold, _) = values.select_nth_unstable_by(wanted, |a, b| b.total_cmp(a));
    f64::from(*threshold)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn histogram_threshold_leaves_the_nearest_share() {
        let mut histogram = [0; 256];
        (histogram[0], histogram[10], histogram[20], histogram[30]) = (70, 10, 10, 10);
        assert_eq!(threshold_of_histogram(&histogram, 100, 0.10), 29.0);
        assert_eq!(threshold_of_histogram(&histogram, 100, 0.19), 19.0);
        assert_eq!(threshold_of_histogram(&histogram, 100, 0.30), 9.0);
        // nothing is nearer to a vanishing share than nothing
        assert_eq!(threshold_of_histogram(&histogram, 100, 0.01), 255.0);
    }

    #[test]
    fn value_threshold_leaves_the_wanted_number() {
        let mut values: Vec<f32> = (0..1000u16).map(|v| f32::from((v * 7) % 1000)).collect();
        let threshold = threshold_of_values(&mut values, 1000, 0.25);
        assert_eq!(values.iter().filter(|v| f64::from(**v) > threshold).count(), 250);
        assert_eq!(threshold_of_values(&mut values, 10_000, 0.25), 0.0);
    }
}
