//! What a report is made of.

use crate::{ExifCamera, FiveParameters, GreyImage, Match, PairImage};

/// An image of the report.
#[derive(Debug, Clone)]
pub struct ReportImage {
    pub name: String,
    pub grey: GreyImage,
    pub exif: Option<ExifCamera>,
    /// As large as the image: points whose pixel is 0 in it are left out.
    pub mask: Option<GreyImage>,
}

impl ReportImage {
    /// The image as matching takes it.
    pub(super) fn pair_image(&self) -> PairImage<'_> {
        PairImage { grey: self.grey.view(), exif: self.exif.as_ref(), mask: self.mask.as_ref().map(GreyImage::view) }
    }

    /// How many of the image's pixels its mask leaves out.
    pub(super) fn left_out(&self) -> Option<usize> {
        self.mask.as_ref().map(|mask| mask.data().iter().filter(|value| **value == 0).count())
    }
}

/// The known answer of a simulated pair.
#[derive(Debug, Clone)]
pub struct ReportTruth {
    pub orientation: FiveParameters,
    /// The base that gives `by` and `bz` of the orientation their scale, in mm.
    pub base_mm: f64,
    /// As [`Sample::right_position`](crate::Sample::right_position).
    pub right_position: Vec<[f32; 2]>,
}

impl ReportTruth {
    /// The orientation with `by` and `bz` at the scale of another base; they are not finite where the true base is 0, which has no scale.
    pub(super) fn orientation_at(&self, base_mm: f64) -> FiveParameters {
        let scale = base_mm / self.base_mm;
        let FiveParameters { by_mm, bz_mm, .. } = self.orientation;
        FiveParameters { by_mm: scale * by_mm, bz_mm: scale * bz_mm, ..self.orientation }
    }
}

/// The matches of the run after edits by hand, in place of those that it finds.
#[derive(Debug, Clone, PartialEq)]
pub struct ReportEdits {
    /// Those that take part, positions in px.
    pub matches: Vec<Match>,
    /// Left positions in px of the points that were measured by hand beside those that the operator finds.
    pub added_px: Vec<[f64; 2]>,
    /// How many matches were rejected by hand.
    pub rejected: usize,
    /// How many matches have a place that was measured by hand.
    pub measured: usize,
}
