//! What is matched of an image that is placed.

use crate::GreyView;

/// An image of which all or a part is a photograph of the ground.
#[derive(Clone, Copy)]
pub(super) struct Photograph<'a> {
    pub grey: GreyView<'a>,
    /// Whether a position in px is of it, rather than of the border of a film or one of its marks.
    pub shows: &'a dyn Fn([f64; 2]) -> bool,
}

impl<'a> From<GreyView<'a>> for Photograph<'a> {
    fn from(grey: GreyView<'a>) -> Self {
        Self { grey, shows: &|_| true }
    }
}
