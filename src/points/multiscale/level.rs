//! A blurred image of the scale space as it is kept: grey values in 128ths.

use crate::math::Lanes;

/// Units of a level's values in one grey value.
pub(super) const UNITS: f32 = 128.0;

/// Grey values in units of 1/128, which leaves none of 16 bits unused, row by row; rows are filled up to a multiple of 8 values.
pub(crate) struct Level {
    width: usize,
    height: usize,
    stride: usize,
    data: Vec<i16>,
}

impl Level {
    pub(super) fn new(width: usize, height: usize) -> Self {
        let stride = width.next_multiple_of(8);
        // Four values from any pixel on can be read.
        Self { width, height, stride, data: vec![0; stride * height + 4] }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn height(&self) -> usize {
        self.height
    }

    /// Values from one row to the next.
    pub fn stride(&self) -> usize {
        self.stride
    }

    /// All rows and four values more.
    pub fn data(&self) -> &[i16] {
        &self.data
    }

    /// Takes a row of grey values, as many as the stride.
    pub(super) fn set_row(&mut self, row: usize, grey: &[f32]) {
        let line = &mut self.data[row * self.stride..][..self.stride];
        let (units, half) = (Lanes::splat(UNITS), Lanes::splat(0.5));
        for (to, from) in line.chunks_exact_mut(8).zip(grey.chunks_exact(8)) {
            let round = |four: &[f32]| Lanes::load(four) * units + half;
            Lanes::store_whole(round(from), round(&from[4..]), to);
        }
    }
}
