//! The pixels of an orthophoto: held whole, or read where they are needed.

use super::emptiness::outside;
use super::parts::Parts;
use super::patch::{Patch, halved, mask_of};
use crate::{Error, GreyImage, halve};
use std::sync::{Arc, Mutex, PoisonError};

/// The pixels of an orthophoto.
#[derive(Debug, Clone)]
pub(super) enum Picture {
    Whole(Arc<Whole>),
    /// A large TIFF.
    Parts(Arc<Parts>),
}

/// All pixels in memory.
#[derive(Debug)]
pub(super) struct Whole {
    grey: GreyImage,
    /// 0 where it shows nothing, 255 elsewhere; absent where it shows something everywhere.
    mask: Option<GreyImage>,
    /// Halved once, twice and so on, made when it is first shown.
    reduced: Mutex<Vec<GreyImage>>,
}

impl Picture {
    /// Takes pixels, of which those of `nothing` show nothing where all about them do.
    pub fn whole(grey: GreyImage, nothing: &[bool]) -> Self {
        let [width, height] = [grey.width(), grey.height()];
        let mask = outside(nothing, width, height, 0).map(|outside| mask_of(width, height, outside));
        Self::Whole(Arc::new(Whole { grey, mask, reduced: Mutex::default() }))
    }

    /// Width and height.
    pub fn size(&self) -> [usize; 2] {
        match self {
            Self::Whole(whole) => [whole.grey.width(), whole.grey.height()],
            Self::Parts(parts) => parts.size(),
        }
    }

    /// A column and row from which on a part can be halved so many times, at most so far before these as a pixel of it is large.
    pub fn aligned(&self, first: [usize; 2], halvings: u32) -> [usize; 2] {
        match self {
            Self::Whole(_) => first,
            Self::Parts(_) => first.map(|at| at >> halvings << halvings),
        }
    }

    /// The part from a column and row on, [`aligned`](Self::aligned), halved so many times; 0 beyond the picture.
    pub fn part(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<GreyImage, Error> {
        match self {
            Self::Whole(whole) => cut(&whole.grey, first, size, halvings),
            Self::Parts(parts) => parts.part(first, size, halvings),
        }
    }

    /// About such a part, with what it does not show. Positions in it may be off by up to a pixel of it.
    pub fn patch(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Patch, Error> {
        match self {
            Self::Whole(whole) => {
                let mask = whole.mask.as_ref().map(|mask| cut(mask, first, size, halvings)).transpose()?;
                Ok(Patch { grey: cut(&whole.grey, first, size, halvings)?, mask, first })
            }
            Self::Parts(parts) => parts.patch(first, size, halvings),
        }
    }

    /// Grey values of a part of the picture that was halved so many times, from a column and row of that on: 0 where it shows nothing, 1 or more elsewhere.
    pub fn shown(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Vec<u8>, Error> {
        match self {
            Self::Whole(whole) => Ok(whole.shown(first, size, halvings)),
            Self::Parts(parts) => parts.shown(first, size, halvings),
        }
    }

    /// Whether it shows something at a position in px.
    pub fn shows(&self, [x, y]: [f64; 2]) -> bool {
        let [width, height] = self.size().map(|side| side as f64);
        if !(x >= 0.0 && y >= 0.0 && x < width && y < height) {
            return false;
        }
        match self {
            Self::Whole(whole) => whole.mask.as_ref().is_none_or(|mask| mask.view().at(x as usize, y as usize) != 0),
            Self::Parts(parts) => parts.shows([x as usize, y as usize]),
        }
    }
}

impl Whole {
    fn shown(&self, [column, row]: [usize; 2], [width, height]: [usize; 2], halvings: u32) -> Vec<u8> {
        let halvings = halvings as usize;
        let mut reduced = self.reduced.lock().unwrap_or_else(PoisonError::into_inner);
        while reduced.len() < halvings {
            let next = halve(reduced.last().unwrap_or(&self.grey).view());
            reduced.push(next);
        }
        let level = if halvings == 0 { &self.grey } else { &reduced[halvings - 1] };
        let side = |at: usize, most: usize| (((at as f64 + 0.5) * f64::from(1_u32 << halvings)) as usize).min(most - 1);
        let shows =
            |x: usize, y: usize| self.mask.as_ref().is_none_or(|mask| mask.view().at(side(x, mask.width()), side(y, mask.height())) != 0);
        let value = |x: usize, y: usize| {
            if x < level.width() && y < level.height() && shows(x, y) { level.view().at(x, y).max(1) } else { 0 }
        };
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        places.map(|(x, y)| value(column.saturating_add(x), row.saturating_add(y))).collect()
    }
}

/// A part of an image, halved so many times.
fn cut(image: &GreyImage, [column, row]: [usize; 2], [width, height]: [usize; 2], halvings: u32) -> Result<GreyImage, Error> {
    let view = image.view();
    let grey = |c: usize, r: usize| {
        let (c, r) = (column + c, row + r);
        if c < view.width() && r < view.height() { view.at(c, r) } else { 0 }
    };
    Ok(halved(GreyImage::from_fn(width, height, grey)?, halvings))
}
