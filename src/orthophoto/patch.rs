//! Parts of pictures.

use crate::{GreyImage, halve};

/// A part of a picture.
pub(super) struct Patch {
    pub grey: GreyImage,
    /// 0 where it shows nothing; absent where it shows something everywhere.
    pub mask: Option<GreyImage>,
    /// The column and row of the picture at which it begins.
    pub first: [usize; 2],
}

/// An image halved so many times.
pub(super) fn halved(image: GreyImage, halvings: u32) -> GreyImage {
    (0..halvings).fold(image, |image, _| halve(image.view()))
}

/// 0 where nothing is shown.
pub(super) fn mask_of(width: usize, height: usize, outside: Vec<bool>) -> GreyImage {
    let data = outside.into_iter().map(|nothing| if nothing { 0 } else { 255 }).collect();
    GreyImage::new(width, height, data).expect("one value a pixel")
}
