//! Four whole numbers of 32 bits at once, with the same operations natively and as WebAssembly's SIMD.

use super::Lanes;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use std::arch::wasm32::*;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
use wide::bytemuck::cast;

/// Four whole numbers, or four pairs of 16 bits: the first of a pair is the lower half.
#[derive(Clone, Copy)]
pub(crate) struct Whole(pub(super) Vector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type Vector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type Vector = wide::i32x4;

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
impl Whole {
    #[inline(always)]
    pub fn load(values: &[i32; 4]) -> Self {
        // SAFETY: the array holds the 16 bytes that are read; the instruction needs no alignment.
        Self(unsafe { v128_load(values.as_ptr().cast()) })
    }

    #[inline(always)]
    pub fn splat(value: i32) -> Self {
        Self(i32x4_splat(value))
    }

    /// Numbers without their decimals; what is beyond 32 bits becomes the nearest that is not, and NaN 0.
    #[inline(always)]
    pub fn truncated(numbers: Lanes) -> Self {
        Self(i32x4_trunc_sat_f32x4(numbers.0))
    }

    #[inline(always)]
    pub fn to_lanes(self) -> Lanes {
        Lanes(f32x4_convert_i32x4(self.0))
    }

    #[inline(always)]
    pub fn to_array(self) -> [i32; 4] {
        [i32x4_extract_lane::<0>(self.0), i32x4_extract_lane::<1>(self.0), i32x4_extract_lane::<2>(self.0), i32x4_extract_lane::<3>(self.0)]
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

    /// Not below `least` nor above `most`.
    #[inline(always)]
    pub fn clamp(self, least: Self, most: Self) -> Self {
        Self(i32x4_min(i32x4_max(self.0, least.0), most.0))
    }

    /// The pairs of values that begin at four places.
    ///
    /// # Panics
    /// Where there are fewer values.
    #[inline(always)]
    pub fn pairs(values: &[i16], places: [usize; 4]) -> Self {
        let pair = |place: usize| values[place..][..2].as_ptr().cast::<u32>();
        // SAFETY: each slice holds the 4 bytes that are read; the instructions need no alignment.
        unsafe {
            let first = v128_load32_zero(pair(places[0]));
            let second = v128_load32_lane::<1>(first, pair(places[1]));
            let third = v128_load32_lane::<2>(second, pair(places[2]));
            Self(v128_load32_lane::<3>(third, pair(places[3])))
        }
    }

    /// The sum of the numbers of each of the four, as one.
    #[inline(always)]
    pub fn lane_sums([a, b, c, d]: [Self; 4]) -> Self {
        let pairs = |a: Self, b: Self| i32x4_add(i32x4_shuffle::<0, 4, 1, 5>(a.0, b.0), i32x4_shuffle::<2, 6, 3, 7>(a.0, b.0));
        let (ab, cd) = (pairs(a, b), pairs(c, d));
        Self(i32x4_add(i32x4_shuffle::<0, 1, 4, 5>(ab, cd), i32x4_shuffle::<2, 3, 6, 7>(ab, cd)))
    }

    /// Of pairs: the sum of the products of their numbers with those of the other's.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Self {
        Self(i32x4_dot_i16x8(self.0, other.0))
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
impl Whole {
    #[inline(always)]
    pub fn load(values: &[i32; 4]) -> Self {
        Self(Vector::new(*values))
    }

    #[inline(always)]
    pub fn splat(value: i32) -> Self {
        Self(Vector::splat(value))
    }

    /// Numbers without their decimals; what is beyond 32 bits becomes the nearest that is not, and NaN 0.
    #[inline(always)]
    pub fn truncated(numbers: Lanes) -> Self {
        Self(Vector::new(numbers.0.map(|v| v as i32)))
    }

    #[inline(always)]
    pub fn to_lanes(self) -> Lanes {
        Lanes(self.to_array().map(|v| v as f32))
    }

    #[inline(always)]
    pub fn to_array(self) -> [i32; 4] {
        self.0.to_array()
    }

    /// The larger one of each two.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    /// All bits of a number set where it exceeds the other one, else none.
    #[inline(always)]
    pub fn exceeds(self, other: Self) -> Self {
        Self(self.0.simd_gt(other.0))
    }

    #[inline(always)]
    pub fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether any bit is set.
    #[inline(always)]
    pub fn any(self) -> bool {
        self.0 != Vector::ZERO
    }

    /// Not below `least` nor above `most`.
    #[inline(always)]
    pub fn clamp(self, least: Self, most: Self) -> Self {
        Self(self.0.max(least.0).min(most.0))
    }

    /// The pairs of values that begin at four places.
    ///
    /// # Panics
    /// Where there are fewer values.
    #[inline(always)]
    pub fn pairs(values: &[i16], places: [usize; 4]) -> Self {
        let half = |value: i16| i32::from(value as u16);
        Self(Vector::new(places.map(|place| half(values[place]) | (half(values[place + 1]) << 16))))
    }

    /// The sum of the numbers of each of the four, as one.
    #[inline(always)]
    pub fn lane_sums(four: [Self; 4]) -> Self {
        let [a, b, c, d] = Vector::transpose(four.map(|one| one.0));
        Self(a + b + c + d)
    }

    /// Of pairs: the sum of the products of their numbers with those of the other's.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Self {
        let halves = |four: Self| cast::<Vector, wide::i16x8>(four.0);
        Self(halves(self).dot(halves(other)))
    }
}

// What is beyond 32 bits is cut off.
vector_operator!(Whole, Add, add, i32x4_add, |a, b| a + b);
vector_operator!(Whole, Sub, sub, i32x4_sub, |a, b| a - b);
vector_operator!(Whole, Mul, mul, i32x4_mul, |a, b| a * b);

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Every operation against the same on single numbers.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn whole_lanes_are_single_numbers() {
        let numbers = [[1.9f32, -2.9, 0.0, 1e10], [f32::NAN, -1e10, 32_767.5, -7.0], [3.0, 4.0, -5.5, 65_536.0]];
        for a in numbers {
            let x = Whole::truncated(Lanes::new(a));
            let whole = a.map(|v| v as i32);
            assert_eq!(x.to_array(), whole);
            assert_eq!(x.to_lanes().to_array(), whole.map(|v| v as f32));
            assert_eq!(x.clamp(Whole::splat(-3), Whole::splat(9)).to_array(), whole.map(|v| v.clamp(-3, 9)));
            for b in numbers {
                let y = Whole::truncated(Lanes::new(b));
                let each = |of: &dyn Fn(i32, i32) -> i32| std::array::from_fn::<i32, 4, _>(|k| of(whole[k], b[k] as i32));
                assert_eq!((x + y).to_array(), each(&i32::wrapping_add));
                assert_eq!((x - y).to_array(), each(&i32::wrapping_sub));
                assert_eq!((x * y).to_array(), each(&i32::wrapping_mul));
            }
        }
        let rows: [[i32; 4]; 4] = [[1, -2, 3, i32::MAX], [i32::MIN + 1, 0, -7, 40_000], [5, 5, -5, 1 << 30], [0, -1, 2, -(1 << 29)]];
        for a in rows {
            for b in rows {
                let (x, y) = (Whole::load(&a), Whole::load(&b));
                let each = |by: fn(i32, i32) -> i32| std::array::from_fn::<i32, 4, _>(|k| by(a[k], b[k]));
                assert_eq!((x + y).to_array(), each(i32::wrapping_add));
                assert_eq!(x.max(y).to_array(), each(i32::max));
                assert_eq!(x.exceeds(y).to_array(), each(|a, b| if a > b { -1 } else { 0 }));
                assert_eq!(x.or(y).to_array(), each(|a, b| a | b));
                assert_eq!(x.exceeds(y).any(), (0..4).any(|k| a[k] > b[k]));
            }
        }
        assert_eq!(
            Whole::lane_sums(rows.map(|row| Whole::load(&row))).to_array(),
            rows.map(|row| row.into_iter().fold(0, i32::wrapping_add))
        );
        let values = [5i16, -7, 32_767, -32_768, 100, 3, 9];
        let (a, b) = (Whole::pairs(&values, [0, 1, 2, 5]), Whole::pairs(&values, [3, 2, 1, 0]));
        let product =
            |p: usize, q: usize| i32::from(values[p]) * i32::from(values[q]) + i32::from(values[p + 1]) * i32::from(values[q + 1]);
        assert_eq!(a.dot(b).to_array(), [product(0, 3), product(1, 2), product(2, 1), product(5, 0)]);
        assert_eq!(a.dot(Whole::splat(1)).to_array(), [5, -7, 32_767, 3]);
        assert_eq!(a.dot(Whole::splat(1 << 16)).to_array(), [-7, 32_767, -32_768, 9]);
    }
}
