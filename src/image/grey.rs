//! The grey raster on which everything is measured.

use crate::error::refuse;
use crate::{Error, Refusal};

/// Grey values 0..255, row by row from the top-left pixel. It owns its pixels.
#[derive(Clone, PartialEq, Eq)]
pub struct GreyImage {
    width: usize,
    height: usize,
    data: Vec<u8>,
}

impl GreyImage {
    /// Takes row-major grey values.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where `data` is not `width` x `height` values, or a side is 0.
    pub fn new(width: usize, height: usize, data: Vec<u8>) -> Result<Self, Error> {
        GreyView::new(width, height, &data)?;
        Ok(Self { width, height, data })
    }

    /// Makes an image from a function of column and row.
    pub fn from_fn(width: usize, height: usize, grey: impl Fn(usize, usize) -> u8) -> Result<Self, Error> {
        let data = (0..height).flat_map(|row| (0..width).map(move |col| (col, row))).map(|(col, row)| grey(col, row)).collect();
        Self::new(width, height, data)
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn height(&self) -> usize {
        self.height
    }

    /// The grey values, row by row.
    pub fn data(&self) -> &[u8] {
        &self.data
    }

    pub fn view(&self) -> GreyView<'_> {
        GreyView { width: self.width, height: self.height, data: &self.data }
    }
}

impl std::fmt::Debug for GreyImage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "GreyImage({} x {})", self.width, self.height)
    }
}

/// Borrowed grey values 0..255, row by row from the top-left pixel, without gaps.
///
/// Pixel positions are whole columns and rows; image coordinates put the centre of the top-left pixel at (0.5, 0.5).
#[derive(Clone, Copy)]
pub struct GreyView<'a> {
    width: usize,
    height: usize,
    data: &'a [u8],
}

impl<'a> GreyView<'a> {
    /// Looks at row-major grey values.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where `data` is not `width` x `height` values, or a side is 0.
    pub fn new(width: usize, height: usize, data: &'a [u8]) -> Result<Self, Error> {
        if width == 0 || height == 0 || width.checked_mul(height) != Some(data.len()) {
            return refuse(Refusal::GreyValues { width, height, values: data.len() });
        }
        Ok(Self { width, height, data })
    }

    pub fn width(self) -> usize {
        self.width
    }

    pub fn height(self) -> usize {
        self.height
    }

    pub fn data(self) -> &'a [u8] {
        self.data
    }

    /// A copy that owns its pixels.
    pub fn to_image(self) -> GreyImage {
        GreyImage { width: self.width, height: self.height, data: self.data.to_vec() }
    }

    /// One row of grey values.
    pub fn row(self, row: usize) -> &'a [u8] {
        &self.data[row * self.width..][..self.width]
    }

    /// The grey value of a pixel.
    pub fn at(self, col: usize, row: usize) -> u8 {
        self.data[row * self.width + col]
    }
}
