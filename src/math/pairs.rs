//! Eight whole numbers of 16 bits at once, with the same operations natively and as WebAssembly's SIMD.

use super::Whole;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use std::arch::wasm32::*;

/// Eight numbers of 16 bits: four pairs.
#[derive(Clone, Copy)]
pub(crate) struct Pairs(Vector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type Vector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type Vector = wide::i16x8;

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
impl Pairs {
    #[inline(always)]
    pub fn load(values: &[i16; 8]) -> Self {
        // SAFETY: the array holds the 16 bytes that are read; the instruction needs no alignment.
        Self(unsafe { v128_load(values.as_ptr().cast()) })
    }

    /// The same pair four times.
    #[inline(always)]
    pub fn splat(pair: &[i16; 2]) -> Self {
        // SAFETY: the array holds the 4 bytes that are read; the instruction needs no alignment.
        Self(unsafe { v128_load32_splat(pair.as_ptr().cast()) })
    }

    /// For each pair a₀ b₀ + a₁ b₁.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Whole {
        Whole(i32x4_dot_i16x8(self.0, other.0))
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
impl Pairs {
    #[inline(always)]
    pub fn load(values: &[i16; 8]) -> Self {
        Self(Vector::new(*values))
    }

    /// The same pair four times.
    #[inline(always)]
    pub fn splat(&[a, b]: &[i16; 2]) -> Self {
        Self(Vector::new([a, b, a, b, a, b, a, b]))
    }

    /// For each pair a₀ b₀ + a₁ b₁.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Whole {
        Whole(self.0.dot(other.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Every operation against the same on single numbers.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn pairs_are_single_numbers() {
        let (a, b) = ([1, -2, 510, 510, 0, 7, -32_768, 3], [255, 255, 255, 255, 9, -4, 1, 2]);
        assert_eq!(Pairs::load(&a).dot(Pairs::load(&b)).to_array(), [-255, 260_100, -28, -32_762]);
        assert_eq!(Pairs::splat(&[2, -3]).dot(Pairs::load(&b)).to_array(), [-255, -255, 30, -4]);
    }
}
