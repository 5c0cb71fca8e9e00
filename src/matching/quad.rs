//! Four whole numbers of 32 bits at once, with the same operations natively and as WebAssembly's SIMD.
//!
//! Whole numbers have one result in any order, so that both give the same bits.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use std::arch::wasm32::*;

/// Four numbers.
#[derive(Clone, Copy)]
pub(super) struct Quad(Vector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type Vector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type Vector = [i32; 4];

/// Eight numbers of 16 bits: four pairs.
#[derive(Clone, Copy)]
pub(super) struct Pairs(PairVector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type PairVector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type PairVector = [i16; 8];

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
    pub fn dot(self, other: Self) -> Quad {
        Quad(i32x4_dot_i16x8(self.0, other.0))
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
impl Pairs {
    #[inline(always)]
    pub fn load(values: &[i16; 8]) -> Self {
        Self(*values)
    }

    /// The same pair four times.
    #[inline(always)]
    pub fn splat(&[a, b]: &[i16; 2]) -> Self {
        Self([a, b, a, b, a, b, a, b])
    }

    /// For each pair a₀ b₀ + a₁ b₁.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Quad {
        let product = |k: usize| i32::from(self.0[k]) * i32::from(other.0[k]);
        Quad(std::array::from_fn(|k| product(2 * k) + product(2 * k + 1)))
    }
}

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
impl Quad {
    #[inline(always)]
    pub fn load(values: &[i32; 4]) -> Self {
        // SAFETY: the array holds the 16 bytes that are read; the instruction needs no alignment.
        Self(unsafe { v128_load(values.as_ptr().cast()) })
    }

    #[inline(always)]
    pub fn splat(value: i32) -> Self {
        Self(i32x4_splat(value))
    }

    #[inline(always)]
    pub fn to_array(self) -> [i32; 4] {
        [i32x4_extract_lane::<0>(self.0), i32x4_extract_lane::<1>(self.0), i32x4_extract_lane::<2>(self.0), i32x4_extract_lane::<3>(self.0)]
    }

    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        Self(i32x4_add(self.0, other.0))
    }

    /// The larger one of each two.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(i32x4_max(self.0, other.0))
    }

    /// All bits of a number set where it exceeds the other one, else none.
    #[inline(always)]
    pub fn exceeds(self, other: Self) -> Self {
        Self(i32x4_gt(self.0, other.0))
    }

    #[inline(always)]
    pub fn or(self, other: Self) -> Self {
        Self(v128_or(self.0, other.0))
    }

    /// Whether any bit is set.
    #[inline(always)]
    pub fn any(self) -> bool {
        v128_any_true(self.0)
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
impl Quad {
    #[inline(always)]
    fn zip(self, other: Self, by: impl Fn(i32, i32) -> i32) -> Self {
        Self(std::array::from_fn(|k| by(self.0[k], other.0[k])))
    }

    #[inline(always)]
    pub fn load(values: &[i32; 4]) -> Self {
        Self(*values)
    }

    #[inline(always)]
    pub fn splat(value: i32) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    pub fn to_array(self) -> [i32; 4] {
        self.0
    }

    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        self.zip(other, i32::wrapping_add)
    }

    /// The larger one of each two.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip(other, i32::max)
    }

    /// All bits of a number set where it exceeds the other one, else none.
    #[inline(always)]
    pub fn exceeds(self, other: Self) -> Self {
        self.zip(other, |a, b| -i32::from(a > b))
    }

    #[inline(always)]
    pub fn or(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }

    /// Whether any bit is set.
    #[inline(always)]
    pub fn any(self) -> bool {
        self.0 != [0; 4]
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
    fn quads_are_single_numbers() {
        let rows: [[i32; 4]; 4] = [[1, -2, 3, i32::MAX], [i32::MIN + 1, 0, -7, 40_000], [5, 5, -5, 1 << 30], [0, -1, 2, -(1 << 29)]];
        for a in rows {
            for b in rows {
                let (x, y) = (Quad::load(&a), Quad::load(&b));
                let each = |by: fn(i32, i32) -> i32| std::array::from_fn::<i32, 4, _>(|k| by(a[k], b[k]));
                assert_eq!(x.plus(y).to_array(), each(i32::wrapping_add));
                assert_eq!(x.max(y).to_array(), each(i32::max));
                assert_eq!(x.exceeds(y).to_array(), each(|a, b| if a > b { -1 } else { 0 }));
                assert_eq!(x.or(y).to_array(), each(|a, b| a | b));
                assert_eq!(x.exceeds(y).any(), (0..4).any(|k| a[k] > b[k]));
            }
        }
        assert_eq!(Quad::splat(-9).to_array(), [-9; 4]);
        let (a, b) = ([1, -2, 510, 510, 0, 7, -32_768, 3], [255, 255, 255, 255, 9, -4, 1, 2]);
        assert_eq!(Pairs::load(&a).dot(Pairs::load(&b)).to_array(), [-255, 260_100, -28, -32_762]);
        assert_eq!(Pairs::splat(&[2, -3]).dot(Pairs::load(&b)).to_array(), [-255, -255, 30, -4]);
    }
}
