//! An image in the bands that its file has.

use super::grey::{GreyImage, GreyView};
use super::luminance::luma;
use crate::error::refuse;
use crate::{Error, Refusal};

/// An image in one band of grey values, or in three of red, green and blue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bands(Vec<GreyImage>);

impl From<GreyImage> for Bands {
    fn from(grey: GreyImage) -> Self {
        Self(vec![grey])
    }
}

impl Bands {
    /// Takes red, green and blue.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for bands of different sizes.
    pub fn colours(bands: [GreyImage; 3]) -> Result<Self, Error> {
        let [width, height] = [bands[0].width(), bands[0].height()];
        if let Some(other) = bands.iter().find(|band| [band.width(), band.height()] != [width, height]) {
            return refuse(Refusal::GreyValues { width, height, values: other.data().len() });
        }
        Ok(Self(bands.into()))
    }

    /// Of one band or of three, each `width` x `height` values.
    pub(crate) fn of([width, height]: [usize; 2], values: Vec<Vec<u8>>) -> Result<Self, Error> {
        values.into_iter().map(|band| GreyImage::new(width, height, band)).collect::<Result<_, _>>().map(Self)
    }

    pub fn width(&self) -> usize {
        self.0[0].width()
    }

    pub fn height(&self) -> usize {
        self.0[0].height()
    }

    /// Whether it has red, green and blue.
    pub fn are_colours(&self) -> bool {
        self.0.len() == 3
    }

    /// The grey values, or red, green and blue.
    pub fn images(&self) -> &[GreyImage] {
        &self.0
    }

    /// Its grey values, or the luma of its colours.
    pub fn to_grey(&self) -> GreyImage {
        let [red, green, blue] = self.0.as_slice() else { return self.0[0].clone() };
        let luma = |c: usize, r: usize| luma([red, green, blue].map(|band| band.view().at(c, r).into())) as u8;
        GreyImage::from_fn(self.width(), self.height(), luma).expect("as large as its bands")
    }

    /// The grey values, or red.
    pub(crate) fn into_first(mut self) -> GreyImage {
        self.0.swap_remove(0)
    }

    pub(crate) fn into_images(self) -> Vec<GreyImage> {
        self.0
    }

    pub(crate) fn views(&self) -> Vec<GreyView<'_>> {
        self.0.iter().map(GreyImage::view).collect()
    }

    /// The same of each band.
    pub(crate) fn map(&self, of: impl Fn(GreyView<'_>) -> GreyImage) -> Self {
        Self(self.0.iter().map(|band| of(band.view())).collect())
    }
}
