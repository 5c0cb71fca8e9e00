//! From a histogram to 128 bytes that do not change with contrast.

use super::histogram::LENGTH;

/// Largest value of a component before the last normalisation: single strong gradients, as of glare, count no more.
const CLIP: f32 = 0.2;

/// Unit length, clipped, unit length again; then the square roots of what sums to one. Zeros stay zeros.
///
/// # Source
/// Lowe 2004, section 6.1; Arandjelović & Zisserman 2012, Three things everyone should know, section 3.
pub(super) fn bytes(histogram: &[f32; LENGTH], roots: bool) -> [u8; LENGTH] {
    let length = |values: &[f32; LENGTH]| values.iter().map(|v| v * v).sum::<f32>().sqrt().max(f32::MIN_POSITIVE);
    let first = length(histogram);
    let clipped = histogram.map(|v| (v / first).min(CLIP));
    if roots {
        let sum = clipped.iter().sum::<f32>().max(f32::MIN_POSITIVE);
        return clipped.map(|v| ((v / sum).sqrt() * 512.0 + 0.5) as u8);
    }
    let second = length(&clipped);
    clipped.map(|v| (v / second * 512.0 + 0.5) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn histogram() -> [f32; LENGTH] {
        std::array::from_fn(|k| ((k * k * 7 + k * 13) % 97) as f32)
    }

    #[test]
    fn the_gain_does_not_matter() {
        for roots in [false, true] {
            let plain = bytes(&histogram(), roots);
            let brighter = bytes(&histogram().map(|v| v * 3.0), roots);
            assert!(plain.iter().zip(&brighter).all(|(a, b)| a.abs_diff(*b) <= 1));
            let length: f64 = plain.iter().map(|v| f64::from(*v) * f64::from(*v)).sum();
            assert!((libm::sqrt(length) - 512.0).abs() < 6.0, "{length}");
        }
    }

    #[test]
    fn one_strong_gradient_is_clipped_and_none_is_zero() {
        let mut strong = [1.0; LENGTH];
        strong[5] = 1e6;
        let clipped = bytes(&strong, false);
        assert_eq!((clipped[5], clipped[6]), (255, 0));
        assert_eq!(bytes(&[0.0; LENGTH], false), [0; LENGTH]);
        assert_eq!(bytes(&[0.0; LENGTH], true), [0; LENGTH]);
    }
}
