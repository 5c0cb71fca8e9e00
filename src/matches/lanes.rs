//! Four numbers of 32 bits at once, with the same operations natively and as WebAssembly's SIMD.
//!
//! Each operation is that of IEEE 754 on each lane, so that both give the same bits.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use std::arch::wasm32::*;

/// Four numbers.
#[derive(Clone, Copy)]
pub(super) struct Lanes(Vector);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type Vector = v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type Vector = [f32; 4];

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
    pub fn load(values: &[f32]) -> Self {
        let four: &[f32; 4] = values[..4].try_into().expect("the length is 4");
        // SAFETY: the array holds the 16 bytes that are read; the instruction needs no alignment.
        Self(unsafe { v128_load(four.as_ptr().cast()) })
    }

    pub fn to_array(self) -> [f32; 4] {
        [f32x4_extract_lane::<0>(self.0), f32x4_extract_lane::<1>(self.0), f32x4_extract_lane::<2>(self.0), f32x4_extract_lane::<3>(self.0)]
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
    pub fn load(values: &[f32]) -> Self {
        Self(values[..4].try_into().expect("the length is 4"))
    }

    pub fn to_array(self) -> [f32; 4] {
        self.0
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

/// One operator, of both kinds of vectors.
macro_rules! operator {
    ($name:ident, $method:ident, $simd:ident, $sign:tt) => {
        impl std::ops::$name for Lanes {
            type Output = Self;

            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            fn $method(self, other: Self) -> Self {
                Self($simd(self.0, other.0))
            }

            #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
            fn $method(self, other: Self) -> Self {
                Self(std::array::from_fn(|k| self.0[k] $sign other.0[k]))
            }
        }
    };
}

operator!(Add, add, f32x4_add, +);
operator!(Sub, sub, f32x4_sub, -);
operator!(Mul, mul, f32x4_mul, *);

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
        for a in rows {
            assert_eq!(bits(Lanes::load(&a).floor().to_array()), bits(a.map(f32::floor)));
            for b in rows {
                let (x, y) = (Lanes::new(a), Lanes::load(&b));
                assert_eq!(bits((x + y).to_array()), bits(std::array::from_fn(|k| a[k] + b[k])));
                assert_eq!(bits((x - y).to_array()), bits(std::array::from_fn(|k| a[k] - b[k])));
                assert_eq!(bits((x * y).to_array()), bits(std::array::from_fn(|k| a[k] * b[k])));
                assert_eq!(x.lane::<2>().to_array(), [a[2]; 4]);
            }
        }
        let columns = Lanes::transpose(rows.map(Lanes::new)).map(Lanes::to_array);
        assert_eq!(columns, std::array::from_fn(|c| rows.map(|row| row[c])));
        assert_eq!(Lanes::splat(7.0).to_array(), [7.0; 4]);
    }
}
