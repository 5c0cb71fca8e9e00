//! From a histogram to 128 bytes that do not change with contrast.

use super::histogram::LENGTH;
use crate::math::Lanes;

/// Largest value of a component before the last normalisation: single strong gradients, as of glare, count no more.
const CLIP: f32 = 0.2;

/// Unit length, clipped, unit length again; then the square roots of what sums to one. Zeros stay zeros.
///
/// # Source
/// Lowe 2004, section 6.1; Arandjelović & Zisserman 2012, Three things everyone should know, section 3.
pub(super) fn bytes(histogram: &[f32; LENGTH], roots: bool) -> [u8; LENGTH] {
    let over = |sum: f32| Lanes::splat(1.0 / sum.max(f32::MIN_POSITIVE));
    let mut values: [Lanes; LENGTH / 4] = std::array::from_fn(|k| Lanes::load(&histogram[4 * k..]));
    let (first, clip) = (over(total(values.map(|v| v * v)).sqrt()), Lanes::splat(CLIP));
    values = values.map(|v| (v * first).min(clip));
    let (most, half) = (Lanes::splat(512.0), Lanes::splat(0.5));
    if roots {
        let second = over(total(values));
        values = values.map(|v| (v * second).sqrt() * most + half);
    } else {
        let second = over(total(values.map(|v| v * v)).sqrt());
        values = values.map(|v| v * second * most + half);
    }
    let mut bytes = [0; LENGTH];
    bytes.chunks_exact_mut(4).zip(values).for_each(|(to, four)| to.copy_from_slice(&four.to_array().map(|v| v as u8)));
    bytes
}

/// The sum of all numbers, of which every fourth are summed first.
#[inline(always)]
fn total(values: [Lanes; LENGTH / 4]) -> f32 {
    let [a, b, c, d] = values.into_iter().fold(Lanes::splat(0.0), |sum, four| sum + four).to_array();
    (a + b) + (c + d)
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
