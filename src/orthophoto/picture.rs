//! The pixels of an orthophoto: held whole, or read where they are needed.

use super::emptiness::outside;
use super::parts::Parts;
use super::patch::{Patch, halved, mask_of};
use crate::image::Wanted;
use crate::{Bands, Error, GreyImage, halve};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The pixels of an orthophoto.
#[derive(Debug, Clone)]
pub(super) enum Picture {
    Whole(Arc<Whole>),
    /// A large TIFF.
    Parts(Arc<Parts>),
}

/// All pixels in memory.
pub(super) struct Whole {
    grey: Levels,
    /// 0 where it shows nothing, 255 elsewhere; absent where it shows something everywhere.
    mask: Option<GreyImage>,
    colours: Colours,
}

impl std::fmt::Debug for Whole {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Whole({:?})", self.grey.image)
    }
}

/// The same in red, green and blue, decoded when it is first shown: what is measured is grey.
struct Colours {
    decode: Option<Box<DecodeColours>>,
    bands: OnceLock<Vec<Levels>>,
}

type DecodeColours = dyn Fn() -> Result<Bands, Error> + Send + Sync;

/// A band with what is left of it halved once, twice and so on, made when it is first shown.
struct Levels {
    image: GreyImage,
    reduced: Mutex<Vec<GreyImage>>,
}

impl Picture {
    /// Takes pixels, of which those of `nothing` show nothing where all about them do.
    pub fn whole(grey: GreyImage, nothing: &[bool]) -> Self {
        Self::Whole(Arc::new(Whole::new(grey, nothing, None)))
    }

    /// The same of a file that may have colours.
    pub fn coloured(grey: GreyImage, nothing: &[bool], decode: impl Fn() -> Result<Bands, Error> + Send + Sync + 'static) -> Self {
        Self::Whole(Arc::new(Whole::new(grey, nothing, Some(Box::new(decode)))))
    }

    /// Width and height.
    pub fn size(&self) -> [usize; 2] {
        match self {
            Self::Whole(whole) => whole.grey.size(),
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
            Self::Whole(whole) => cut(&whole.grey.image, first, size, halvings),
            Self::Parts(parts) => parts.part(first, size, halvings),
        }
    }

    /// About such a part, with what it does not show. Positions in it may be off by up to a pixel of it.
    pub fn patch(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Patch, Error> {
        match self {
            Self::Whole(whole) => {
                let mask = whole.mask.as_ref().map(|mask| cut(mask, first, size, halvings)).transpose()?;
                Ok(Patch { grey: cut(&whole.grey.image, first, size, halvings)?, mask, first })
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

    /// Red, green, blue and alpha of such a part, pixel by pixel: alpha is 0 where it shows nothing, 255 elsewhere. Grey where no colours can be had.
    pub fn colours(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Vec<u8>, Error> {
        let (bands, mask) = match self {
            Self::Whole(whole) => {
                let grey = whole.shown(first, size, halvings);
                let mask = grey.iter().map(|value| if *value == 0 { 0 } else { 255 }).collect();
                let colours = whole.colours(first, size, halvings);
                (Bands::of(size, if colours.is_empty() { vec![grey] } else { colours })?, Some(GreyImage::new(size[0], size[1], mask)?))
            }
            Self::Parts(parts) => parts.read_with_mask(first, size, halvings, Wanted::Colours)?,
        };
        let bands: Vec<&[u8]> = bands.images().iter().map(GreyImage::data).collect();
        let rgba = |k: usize| match mask.as_ref().is_none_or(|mask| mask.data()[k] != 0) {
            true => [0, 1, 2].map(|band| bands[band % bands.len()][k]).into_iter().chain([255]),
            false => [0; 3].into_iter().chain([0]),
        };
        Ok((0..size[0] * size[1]).flat_map(rgba).collect())
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
    fn new(grey: GreyImage, nothing: &[bool], decode: Option<Box<DecodeColours>>) -> Self {
        let [width, height] = [grey.width(), grey.height()];
        let mask = outside(nothing, width, height, 0).map(|outside| mask_of(width, height, outside));
        Self { grey: Levels::new(grey), mask, colours: Colours { decode, bands: OnceLock::new() } }
    }

    fn shown(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Vec<u8> {
        let side = |at: usize, most: usize| (((at as f64 + 0.5) * f64::from(1_u32 << halvings)) as usize).min(most - 1);
        let shows =
            |x: usize, y: usize| self.mask.as_ref().is_none_or(|mask| mask.view().at(side(x, mask.width()), side(y, mask.height())) != 0);
        self.grey.values(first, size, halvings, |x, y, value| if shows(x, y) { value.max(1) } else { 0 })
    }

    /// The bands of what it shows; none where it has no colours.
    fn colours(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Vec<Vec<u8>> {
        let Colours { decode: Some(decode), bands } = &self.colours else { return Vec::new() };
        let decoded = match (bands.get(), decode) {
            (Some(bands), _) => bands,
            // What could not be read once may be read later; its grey values are there meanwhile.
            (None, decode) => match decode() {
                Ok(of_file) if of_file.are_colours() => bands.get_or_init(|| of_file.into_images().into_iter().map(Levels::new).collect()),
                Ok(_) => bands.get_or_init(Vec::new),
                Err(_) => return Vec::new(),
            },
        };
        decoded.iter().map(|band| band.values(first, size, halvings, |_, _, value| value)).collect()
    }
}

impl Levels {
    fn new(image: GreyImage) -> Self {
        Self { image, reduced: Mutex::default() }
    }

    fn size(&self) -> [usize; 2] {
        [self.image.width(), self.image.height()]
    }

    /// What becomes of the values of a part of the image that was halved so many times; 0 beyond it.
    fn values(
        &self,
        [column, row]: [usize; 2],
        [width, height]: [usize; 2],
        halvings: u32,
        of: impl Fn(usize, usize, u8) -> u8,
    ) -> Vec<u8> {
        let halvings = halvings as usize;
        let mut reduced = self.reduced.lock().unwrap_or_else(PoisonError::into_inner);
        while reduced.len() < halvings {
            let next = halve(reduced.last().unwrap_or(&self.image).view());
            reduced.push(next);
        }
        let level = if halvings == 0 { &self.image } else { &reduced[halvings - 1] };
        let value = |x: usize, y: usize| if x < level.width() && y < level.height() { of(x, y, level.view().at(x, y)) } else { 0 };
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
