//! Where in an image a point lies: cells of an even grid, nine groups of which are the von Gruber positions.

use super::{FeatureObservation, TiePoints};
use crate::error::refuse;
use crate::{Error, Refusal};

/// Where the features of an image are.
#[derive(Debug, Clone, Copy)]
pub struct ImageFeatures<'a> {
    pub width_px: u32,
    pub height_px: u32,
    /// `[x, y]` in px, the centre of the top-left pixel at (0.5, 0.5).
    pub positions: &'a [[f32; 2]],
}

/// The cell of an even grid in which a position in px lies, row by row.
pub(super) fn cell(at: [f64; 2], size_px: [u32; 2], side: usize) -> usize {
    let [col, row] = [0, 1].map(|axis| ((at[axis] / f64::from(size_px[axis]) * side as f64) as usize).min(side - 1));
    row * side + col
}

/// Which of the nine von Gruber positions of an image of this width and height a position in px belongs to, row by row.
pub(crate) fn von_gruber_position(at: [f64; 2], size_px: [u32; 2]) -> usize {
    cell(at, size_px, 3)
}

/// Cells of the grids of all images, and how many selected points each holds.
pub(super) struct Cells<'a> {
    images: &'a [ImageFeatures<'a>],
    side: usize,
    counts: Vec<u16>,
}

impl<'a> Cells<'a> {
    /// About as many cells as an image is to have points; a multiple of 3 a side, so that each von Gruber place has as many.
    pub(super) fn new(images: &'a [ImageFeatures<'a>], per_image: usize) -> Self {
        let side = 3 * ((per_image as f64).sqrt() / 3.0).round().clamp(1.0, 10.0) as usize;
        Self { images, side, counts: vec![0; images.len() * side * side] }
    }

    /// The cell of a ray among those of all images.
    pub(super) fn of(&self, ray: &FeatureObservation) -> usize {
        let image = &self.images[ray.image as usize];
        let [x, y] = image.positions[ray.feature as usize];
        let at = [x, y].map(f64::from);
        ray.image as usize * self.side * self.side + cell(at, [image.width_px, image.height_px], self.side)
    }

    pub(super) fn count(&self, ray: &FeatureObservation) -> u16 {
        self.counts[self.of(ray)]
    }

    pub(super) fn add(&mut self, ray: &FeatureObservation) {
        let cell = self.of(ray);
        self.counts[cell] = self.counts[cell].saturating_add(1);
    }

    /// How many of the nine von Gruber places of an image hold a selected point.
    pub(super) fn filled_places(&self, image: usize) -> u32 {
        let third = self.side / 3;
        let filled = |place: &usize| {
            let (row, col) = (place / 3 * third, place % 3 * third);
            (row..row + third).any(|r| (col..col + third).any(|c| self.counts[(image * self.side + r) * self.side + c] > 0))
        };
        (0..9).filter(filled).count() as u32
    }
}

/// Refuses rays whose images or features do not exist, and features that lie outside their images.
pub(crate) fn check(points: &TiePoints, images: &[ImageFeatures<'_>]) -> Result<(), Error> {
    for (index, image) in images.iter().enumerate() {
        let inside = |[x, y]: &[f32; 2]| (0.0..=image.width_px as f32).contains(x) && (0.0..=image.height_px as f32).contains(y);
        if let Some(at) = image.positions.iter().find(|at| !inside(at)) {
            let (position, width_px, height_px) = (format!("{at:?}"), image.width_px, image.height_px);
            return refuse(Refusal::FeatureOutside { position, image: index, width_px, height_px });
        }
    }
    let missing =
        |ray: &&FeatureObservation| images.get(ray.image as usize).is_none_or(|image| ray.feature as usize >= image.positions.len());
    match points.iter().flatten().find(missing) {
        Some(ray) => refuse(Refusal::LostFeature { feature: ray.feature, image: ray.image }),
        None => Ok(()),
    }
}
