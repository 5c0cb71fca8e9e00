//! Parts of an image in which no points are wanted.

use crate::error::refuse;
use crate::{Error, GreyView, Refusal};

/// Which pixels points may lie in: those that are not 0 in a mask of the image's size.
#[derive(Clone, Copy)]
pub(super) struct Mask<'a>(Option<GreyView<'a>>);

impl<'a> Mask<'a> {
    /// Refuses a mask of another size than the image's.
    pub(super) fn new(mask: Option<GreyView<'a>>, image: GreyView<'_>) -> Result<Self, Error> {
        let (width, height) = (image.width(), image.height());
        match mask.filter(|mask| (mask.width(), mask.height()) != (width, height)) {
            None => Ok(Self(mask)),
            Some(mask) => {
                refuse(Refusal::MaskSize { width: mask.width(), height: mask.height(), image_width: width, image_height: height })
            }
        }
    }

    /// Whether a point at this position in px may stay.
    pub(super) fn allows(&self, x: f64, y: f64) -> bool {
        let pixel = |v: f64, length: usize| (v.max(0.0) as usize).min(length - 1);
        self.0.is_none_or(|mask| mask.at(pixel(x, mask.width()), pixel(y, mask.height())) != 0)
    }
}
