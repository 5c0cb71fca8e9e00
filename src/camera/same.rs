//! When constants of cameras are those of one camera, contradict each other, or are hardly those of any.

/// Constants that differ by less, as a share or in focal lengths, are of one camera.
///
/// Programs that save an image again write the numbers of its EXIF as other fractions, which differ by 1e-9 to 1e-6. A position in the image
/// hardly notices 1e-5: that is 0.04 px at the edge of 8,000.
const SAME: f64 = 1e-5;

/// Whether two numbers differ by no more than [`SAME`] of `unit`.
pub(crate) fn is_near(a: f64, b: f64, unit: f64) -> bool {
    (a - b).abs() <= SAME * unit.abs()
}

/// Focal lengths that are told in two ways, further apart than this, as a share, are not of one photo: more than rounding and the definitions
/// of equivalents make, less than the next zoom or a photo of half the size does.
pub(super) const MOST_CONTRADICTION: f64 = 0.2;

/// Focal lengths in longer sides of the image, between which those of cameras are.
pub(crate) const USUAL_FOCAL: [f64; 2] = [0.3, 20.0];

/// So many longer sides of the image from its middle a principal point may lie: in the half of a photo it is nearer.
pub(crate) const FARTHEST_PRINCIPAL: f64 = 0.5;

/// How far from the middle of an image a principal point lies, in its longer sides; absent where that is usual.
pub(crate) fn far_principal([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Option<f64> {
    let sides = libm::hypot(x - 0.5 * width, y - 0.5 * height) / width.max(height);
    (!(sides <= FARTHEST_PRINCIPAL)).then_some(sides)
}

/// Whether two focal lengths of one photo contradict each other.
pub(crate) fn contradict(one_px: f64, other_px: f64) -> bool {
    let ratio = one_px / other_px;
    !(1.0 / (1.0 + MOST_CONTRADICTION)..=1.0 + MOST_CONTRADICTION).contains(&ratio)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_principal_point_of_a_half_photo_is_usual_and_one_in_other_units_is_not() {
        assert_eq!((far_principal([300.0, 200.0], [600.0, 400.0]), far_principal([600.0, 200.0], [300.0, 400.0])), (None, Some(1.125)));
        // The right half of a photo of 600 px.
        assert_eq!(far_principal([0.0, 200.0], [300.0, 400.0]), None);
        assert!(far_principal([f64::NAN, 200.0], [300.0, 400.0]).is_some());
    }

    #[test]
    fn a_fifth_contradicts_and_rounding_does_not() {
        assert!(contradict(1210.0, 1000.0) && contradict(1000.0, 1210.0) && contradict(f64::NAN, 1000.0));
        assert!(!contradict(1190.0, 1000.0) && !contradict(1000.0, 1190.0) && !contradict(1000.0, 1000.0));
        assert!(is_near(4.5, 4.5 * (1.0 + 5e-9), 4.5) && !is_near(4.5, 4.5001, 4.5) && !is_near(f64::NAN, 4.5, 4.5));
    }
}
