//! Four numbers of 32 bits at once, with the same operations natively and as WebAssembly's SIMD.
//!
//! Each operation is that of IEEE 754 on each lane, so that both give the same bits.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use std::arch::wasm32::*;

/// Four numbers.
#[derive(Clone, Copy)]
pub(crate) struct Lanes(pub(super) Vector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub(super) type Vector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
pub(super) type Vector = [f32; 4];

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
impl Lanes {
    pub fn new([a, b, c, d]: [f32; 4]) -> Self {
        Self(f32x4(a, b, c, d))
    }

    pub fn splat(value: f32) -> Self {
        Self(f32x4_splat(value))
    }

    /// The first four values.
    ///
    /// # Panics
    /// Where there are fewer.
    #[inline(always)]
    pub fn load(values: &[f32]) -> Self {
        let four: &[f32; 4] = values[..4].try_into().expect("the length is 4");
        // SAFETY: the array holds the 16 bytes that are read; the instruction needs no alignment.
        Self(unsafe { v128_load(four.as_ptr().cast()) })
    }

    /// The first four values, which are whole.
    ///
    /// # Panics
    /// Where there are fewer.
    #[inline(always)]
    pub fn load_whole(values: &[i16]) -> Self {
        let four: &[i16; 4] = values[..4].try_into().expect("the length is 4");
        // SAFETY: the array holds the 8 bytes that are read; the instruction needs no alignment.
        Self(f32x4_convert_i32x4(unsafe { i32x4_load_extend_i16x4(four.as_ptr()) }))
    }

    /// Writes the first four values.
    ///
    /// # Panics
    /// Where there is less room.
    #[inline(always)]
    pub fn store(self, values: &mut [f32]) {
        let four: &mut [f32; 4] = (&mut values[..4]).try_into().expect("the length is 4");
        // SAFETY: the array holds the 16 bytes that are written; the instruction needs no alignment.
        unsafe { v128_store(four.as_mut_ptr().cast(), self.0) };
    }

    pub fn to_array(self) -> [f32; 4] {
        [f32x4_extract_lane::<0>(self.0), f32x4_extract_lane::<1>(self.0), f32x4_extract_lane::<2>(self.0), f32x4_extract_lane::<3>(self.0)]
    }

    /// Without their decimals, eight numbers as whole ones of 16 bits; what is beyond these becomes the nearest of them.
    #[inline(always)]
    pub fn store_whole(low: Self, high: Self, values: &mut [i16]) {
        let eight: &mut [i16; 8] = (&mut values[..8]).try_into().expect("the length is 8");
        let whole = i16x8_narrow_i32x4(i32x4_trunc_sat_f32x4(low.0), i32x4_trunc_sat_f32x4(high.0));
        // SAFETY: the array holds the 16 bytes that are written; the instruction needs no alignment.
        unsafe { v128_store(eight.as_mut_ptr().cast(), whole) };
    }

    pub fn sqrt(self) -> Self {
        Self(f32x4_sqrt(self.0))
    }

    pub fn abs(self) -> Self {
        Self(f32x4_abs(self.0))
    }

    /// The larger of each pair; none may be NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(f32x4_pmax(self.0, other.0))
    }

    /// The smaller of each pair; none may be NaN.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self(f32x4_pmin(self.0, other.0))
    }

    /// Bit k is set where lane k is greater than or equal to that of the other.
    #[inline(always)]
    pub fn not_below(self, other: Self) -> u8 {
        i32x4_bitmask(f32x4_ge(self.0, other.0))
    }

    /// In each lane, `then` where this is below `limit`, else `otherwise`.
    #[inline(always)]
    pub fn where_below(self, limit: Self, then: Self, otherwise: Self) -> Self {
        Self(v128_bitselect(then.0, otherwise.0, f32x4_lt(self.0, limit.0)))
    }

    pub fn floor(self) -> Self {
        Self(f32x4_floor(self.0))
    }

    /// Lane `K` in all lanes.
    pub fn lane<const K: usize>(self) -> Self {
        Self::splat(f32x4_extract_lane::<K>(self.0))
    }

    /// The columns of the matrix that has these rows.
    pub fn transpose([a, b, c, d]: [Self; 4]) -> [Self; 4] {
        let (ab, cd) = (i32x4_shuffle::<0, 4, 1, 5>(a.0, b.0), i32x4_shuffle::<0, 4, 1, 5>(c.0, d.0));
        let (ab2, cd2) = (i32x4_shuffle::<2, 6, 3, 7>(a.0, b.0), i32x4_shuffle::<2, 6, 3, 7>(c.0, d.0));
        [
            Self(i32x4_shuffle::<0, 1, 4, 5>(ab, cd)),
            Self(i32x4_shuffle::<2, 3, 6, 7>(ab, cd)),
            Self(i32x4_shuffle::<0, 1, 4, 5>(ab2, cd2)),
            Self(i32x4_shuffle::<2, 3, 6, 7>(ab2, cd2)),
        ]
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
impl Lanes {
    pub fn new(values: [f32; 4]) -> Self {
        Self(values)
    }

    pub fn splat(value: f32) -> Self {
        Self([value; 4])
    }

    /// The first four values.
    ///
    /// # Panics
    /// Where there are fewer.
    #[inline(always)]
    pub fn load(values: &[f32]) -> Self {
        Self(values[..4].try_into().expect("the length is 4"))
    }

    /// The first four values, which are whole.
    ///
    /// # Panics
    /// Where there are fewer.
    #[inline(always)]
    pub fn load_whole(values: &[i16]) -> Self {
        Self(std::array::from_fn(|k| f32::from(values[..4][k])))
    }

    /// Writes the first four values.
    ///
    /// # Panics
    /// Where there is less room.
    #[inline(always)]
    pub fn store(self, values: &mut [f32]) {
        values[..4].copy_from_slice(&self.0);
    }

    pub fn to_array(self) -> [f32; 4] {
        self.0
    }

    /// Without their decimals, eight numbers as whole ones of 16 bits; what is beyond these becomes the nearest of them.
    #[inline(always)]
    pub fn store_whole(low: Self, high: Self, values: &mut [i16]) {
        values[..4].copy_from_slice(&low.0.map(|v| v as i16));
        values[4..8].copy_from_slice(&high.0.map(|v| v as i16));
    }

    pub fn sqrt(self) -> Self {
        Self(self.0.map(f32::sqrt))
    }

    pub fn abs(self) -> Self {
        Self(self.0.map(f32::abs))
    }

    /// The larger of each pair; none may be NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| if self.0[k] < other.0[k] { other.0[k] } else { self.0[k] }))
    }

    /// The smaller of each pair; none may be NaN.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| if other.0[k] < self.0[k] { other.0[k] } else { self.0[k] }))
    }

    /// Bit k is set where lane k is greater than or equal to that of the other.
    #[inline(always)]
    pub fn not_below(self, other: Self) -> u8 {
        (0..4).fold(0, |bits, k| bits | (u8::from(self.0[k] >= other.0[k]) << k))
    }

    /// In each lane, `then` where this is below `limit`, else `otherwise`.
    #[inline(always)]
    pub fn where_below(self, limit: Self, then: Self, otherwise: Self) -> Self {
        Self(std::array::from_fn(|k| if self.0[k] < limit.0[k] { then.0[k] } else { otherwise.0[k] }))
    }

    pub fn floor(self) -> Self {
        Self(self.0.map(libm::floorf))
    }

    /// Lane `K` in all lanes.
    pub fn lane<const K: usize>(self) -> Self {
        Self([self.0[K]; 4])
    }

    /// The columns of the matrix that has these rows.
    pub fn transpose(rows: [Self; 4]) -> [Self; 4] {
        std::array::from_fn(|k| Self(rows.map(|row| row.0[k])))
    }
}

vector_operator!(Lanes, Add, add, f32x4_add, |a, b| std::array::from_fn(|k| a[k] + b[k]));
vector_operator!(Lanes, Sub, sub, f32x4_sub, |a, b| std::array::from_fn(|k| a[k] - b[k]));
vector_operator!(Lanes, Mul, mul, f32x4_mul, |a, b| std::array::from_fn(|k| a[k] * b[k]));
vector_operator!(Lanes, Div, div, f32x4_div, |a, b| std::array::from_fn(|k| a[k] / b[k]));

#[cfg(test)]
mod tests {
    use super::*;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Every operation against the same on single numbers, bit by bit.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn lanes_are_single_numbers() {
        let rows: [[f32; 4]; 4] =
            [[1.5, -2.25, 1e-8, 3e7], [0.1, 0.2, -0.3, 77.7], [-1e-3, 9.999, 4.0, -0.5], [12.0, 255.0, 1.0 / 3.0, 1e-30]];
        let bits = |values: [f32; 4]| values.map(f32::to_bits);
        let each = |of: &dyn Fn(usize) -> f32| bits(std::array::from_fn(of));
        for a in rows {
            let x = Lanes::load(&a);
            assert_eq!(bits(x.abs().sqrt().to_array()), each(&|k| a[k].abs().sqrt()));
            assert_eq!(bits(x.floor().to_array()), each(&|k| a[k].floor()));
            assert_eq!(x.lane::<2>().to_array(), [a[2]; 4]);
            let mut stored = [0.0; 5];
            x.store(&mut stored);
            assert_eq!(stored, [a[0], a[1], a[2], a[3], 0.0]);
            for b in rows {
                let y = Lanes::new(b);
                assert_eq!(bits((x + y).to_array()), each(&|k| a[k] + b[k]));
                assert_eq!(bits((x - y).to_array()), each(&|k| a[k] - b[k]));
                assert_eq!(bits((x * y).to_array()), each(&|k| a[k] * b[k]));
                assert_eq!(bits((x / y).to_array()), each(&|k| a[k] / b[k]));
                assert_eq!(bits(x.max(y).to_array()), each(&|k| a[k].max(b[k])));
                assert_eq!(bits(x.min(y).to_array()), each(&|k| a[k].min(b[k])));
                assert_eq!(x.not_below(y), (0..4).map(|k| u8::from(a[k] >= b[k]) << k).sum::<u8>());
                assert_eq!(bits(x.where_below(y, x, Lanes::splat(7.0)).to_array()), each(&|k| if a[k] < b[k] { a[k] } else { 7.0 }));
                let mut whole = [0; 8];
                Lanes::store_whole(x, y, &mut whole);
                assert_eq!(whole, std::array::from_fn(|k| [a, b][k / 4][k % 4] as i16));
                assert_eq!(Lanes::load_whole(&whole).to_array(), std::array::from_fn(|k| f32::from(whole[k])));
            }
        }
        let columns = Lanes::transpose(rows.map(Lanes::new)).map(Lanes::to_array);
        assert_eq!(columns, std::array::from_fn(|c| rows.map(|row| row[c])));
        assert_eq!(Lanes::splat(7.0).to_array(), [7.0; 4]);
    }
}
