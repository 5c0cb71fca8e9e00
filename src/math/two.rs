//! Two numbers of 64 bits at once, with the same operations natively and as WebAssembly's SIMD.
//!
//! Each operation is that of IEEE 754 on each lane, so that each lane has the bits that it would have alone. Divisions and roots, of which
//! geometry has many, take the time of one.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use std::arch::wasm32::*;

/// Two numbers.
#[derive(Clone, Copy)]
pub(crate) struct Two(Vector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type Vector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type Vector = wide::f64x2;

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
impl Two {
    #[inline(always)]
    pub fn new([a, b]: [f64; 2]) -> Self {
        Self(f64x2(a, b))
    }

    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self(f64x2_splat(value))
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; 2] {
        [f64x2_extract_lane::<0>(self.0), f64x2_extract_lane::<1>(self.0)]
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self(f64x2_sqrt(self.0))
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(f64x2_abs(self.0))
    }

    /// The larger of each pair; none may be NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(f64x2_pmax(self.0, other.0))
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
impl Two {
    #[inline(always)]
    pub fn new(values: [f64; 2]) -> Self {
        Self(Vector::new(values))
    }

    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Self(Vector::splat(value))
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; 2] {
        self.0.to_array()
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// The larger of each pair; none may be NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(self.0.fast_max(other.0))
    }
}

vector_operator!(Two, Add, add, f64x2_add, |a, b| a + b);
vector_operator!(Two, Sub, sub, f64x2_sub, |a, b| a - b);
vector_operator!(Two, Mul, mul, f64x2_mul, |a, b| a * b);
vector_operator!(Two, Div, div, f64x2_div, |a, b| a / b);

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    #[test]
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    fn each_lane_has_the_bits_that_it_has_alone() {
        let (a, b) = ([0.1, 1e300], [-3.7, 7e-5]);
        let both = |of: fn(Two, Two) -> Two| of(Two::new(a), Two::new(b)).to_array().map(f64::to_bits);
        let alone = |of: fn(f64, f64) -> f64| [0, 1].map(|k| of(a[k], b[k]).to_bits());
        assert_eq!(both(|a, b| a + b), alone(|a, b| a + b));
        assert_eq!(both(|a, b| a - b), alone(|a, b| a - b));
        assert_eq!(both(|a, b| a * b), alone(|a, b| a * b));
        assert_eq!(both(|a, b| a / b), alone(|a, b| a / b));
        assert_eq!(both(|a, b| a.max(b)), alone(f64::max));
        assert_eq!(both(|a, _| a.sqrt()), alone(|a, _| a.sqrt()));
        assert_eq!(both(|_, b| b.abs()), alone(|_, b| b.abs()));
        assert_eq!(Two::splat(0.3).to_array(), [0.3; 2]);
    }
}
