//! Directions of gradients in eighths of a full turn, by a polynomial: the same bits on every machine, and four at once.

use crate::math::Lanes;

/// atan(t) · 4/π over [0, 1] is t times this polynomial of t², to 1.6e-5: least squares with weights for the largest deviation.
const ARCTANGENT: [f32; 5] = [1.273_055_6, -0.420_328_9, 0.228_406, -0.106_911_57, 0.025_778_85];

/// The directions of gradients, 0 to 8 for a full turn from x towards y; 0 for no gradient.
#[inline(always)]
pub(super) fn octants(gx: Lanes, gy: Lanes) -> Lanes {
    let (ax, ay) = (gx.abs(), gy.abs());
    let t = ax.min(ay) / ax.max(ay).max(Lanes::splat(1e-30));
    let square = t * t;
    let polynomial = ARCTANGENT.iter().rev().fold(Lanes::splat(0.0), |sum, c| sum * square + Lanes::splat(*c));
    let zero = Lanes::splat(0.0);
    let first = t * polynomial;
    let quadrant = ax.where_below(ay, Lanes::splat(2.0) - first, first);
    let half = gx.where_below(zero, Lanes::splat(4.0) - quadrant, quadrant);
    gy.where_below(zero, Lanes::splat(8.0) - half, half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn directions_of_a_full_turn() {
        for k in 0..1000 {
            let angle = (f64::from(k) + 0.5) * 2.0 * PI / 1000.0;
            let gradient = [libm::cos(angle), libm::sin(angle)].map(|g| Lanes::splat((g * 17.0) as f32));
            let found = f64::from(octants(gradient[0], gradient[1]).to_array()[3]);
            assert!((found - angle * 4.0 / PI).abs() < 2.5e-5, "{found} at {angle}");
        }
        assert_eq!(octants(Lanes::splat(0.0), Lanes::splat(0.0)).to_array(), [0.0; 4]);
        assert_eq!(octants(Lanes::splat(-2.0), Lanes::splat(0.0)).to_array(), [4.0; 4]);
    }
}
