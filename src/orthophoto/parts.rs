//! A large orthophoto, read where it is needed: small parts of the picture, or of the smaller pictures of it that its file holds (overviews).

use super::emptiness::{SEEN_FROM, outside};
use super::patch::{Patch, halved};
use crate::image::{Pixels, TiffRaster, Wanted};
use crate::{Bands, Error, FileSource, GreyImage};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// A part that is asked for has at most so many pixels.
const MOST_READ: usize = 100_000_000;
/// Where no overview is as small as is asked for, one of at most so many pixels is made.
const MOST_MADE: usize = 25_000_000;
/// Sides of the pieces in which it is made, at least, in px of the picture.
const PIECE: usize = 4096;
/// Whether a place shows something is found for squares of so many px at a time, of which so many are kept.
const CELL: usize = 256;
const MOST_CELLS: usize = 1024;

/// A large orthophoto.
pub(super) struct Parts {
    raster: TiffRaster<Arc<dyn FileSource>>,
    /// In grey, and in colours.
    made: [OnceLock<Made>; 2],
    cells: Mutex<HashMap<[usize; 2], Option<Arc<GreyImage>>>>,
}

/// A smaller picture of the whole.
struct Made {
    halvings: u32,
    size: [usize; 2],
    pixels: Pixels,
}

impl std::fmt::Debug for Parts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [width, height] = self.size();
        write!(f, "Parts({width} x {height})")
    }
}

impl Parts {
    pub fn new(raster: TiffRaster<Arc<dyn FileSource>>) -> Self {
        Self { raster, made: Default::default(), cells: Mutex::default() }
    }

    pub fn size(&self) -> [usize; 2] {
        self.raster.size()
    }

    /// As [`Picture::part`](super::picture::Picture::part).
    pub fn part(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<GreyImage, Error> {
        let [first, size] = [first, size].map(|px| px.map(|px| px >> halvings));
        let [width, height] = size.map(|side| side.max(1));
        let pixels = self.level(halvings, true, Wanted::Grey)?.read(first, [width, height], halvings, Wanted::Grey)?;
        Bands::of([width, height], pixels.bands).map(Bands::into_first)
    }

    /// As [`Picture::patch`](super::picture::Picture::patch).
    pub fn patch(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Patch, Error> {
        let last = [0, 1].map(|axis| first[axis].saturating_add(size[axis]));
        let [first, last] = [first, last].map(|px| px.map(|px| px >> halvings));
        let size = [0, 1].map(|axis| (last[axis] - first[axis]).max(1));
        let (bands, mask) = self.level(halvings, false, Wanted::Grey)?.read_with_mask(first, size, halvings, Wanted::Grey)?;
        let grey = bands.into_first();
        Ok(Patch { grey, mask, first: first.map(|px| px << halvings) })
    }

    /// As [`Picture::shown`](super::picture::Picture::shown).
    pub fn shown(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Vec<u8>, Error> {
        let (bands, mask) = self.read_with_mask(first, size, halvings, Wanted::Grey)?;
        let shows = |k: usize| mask.as_ref().is_none_or(|mask| mask.data()[k] != 0);
        Ok(bands.into_first().data().iter().enumerate().map(|(k, value)| if shows(k) { (*value).max(1) } else { 0 }).collect())
    }

    /// The bands of such a part, and what it does not show.
    pub fn read_with_mask(
        &self,
        first: [usize; 2],
        size: [usize; 2],
        halvings: u32,
        wanted: Wanted,
    ) -> Result<(Bands, Option<GreyImage>), Error> {
        self.level(halvings, false, wanted)?.read_with_mask(first, size, halvings, wanted)
    }

    /// Whether the picture shows something at a column and row; where it cannot be read it shows nothing.
    pub fn shows(&self, [column, row]: [usize; 2]) -> bool {
        let key = [column / CELL, row / CELL];
        let cells = || self.cells.lock().unwrap_or_else(PoisonError::into_inner);
        let known = cells().get(&key).cloned();
        let mask = match known {
            Some(mask) => mask,
            None => {
                let read = Level::OfFile(&self.raster, 0).read_with_mask(key.map(|k| k * CELL), [CELL, CELL], 0, Wanted::Grey);
                let Ok((_, mask)) = read else { return false };
                let mask = mask.map(Arc::new);
                let mut cells = cells();
                if cells.len() >= MOST_CELLS {
                    cells.clear();
                }
                cells.insert(key, mask.clone());
                mask
            }
        };
        mask.is_none_or(|mask| mask.view().at(column % CELL, row % CELL) != 0)
    }

    /// The picture to read where it is wanted halved so many times: not smaller than that, and not much larger.
    fn level(&self, halvings: u32, exact: bool, wanted: Wanted) -> Result<Level<'_>, Error> {
        let of_file = self.raster.level(halvings, exact);
        let made = made_halvings(self.size());
        if of_file + 1 >= halvings || halvings < made {
            return Ok(Level::OfFile(&self.raster, of_file));
        }
        // What could not be read once may be read later.
        let held = &self.made[usize::from(wanted == Wanted::Colours)];
        let made = match held.get() {
            Some(made) => made,
            None => {
                let new = self.make(made, wanted)?;
                held.get_or_init(|| new)
            }
        };
        Ok(Level::Made(made))
    }

    fn make(&self, halvings: u32, wanted: Wanted) -> Result<Made, Error> {
        let size = self.size().map(|side| side >> halvings);
        let level = Level::OfFile(&self.raster, self.raster.level(halvings, true));
        Ok(Made { halvings, size, pixels: level.read([0, 0], size, halvings, wanted)? })
    }
}

/// How often a picture of this size is halved where a smaller one is made of it.
fn made_halvings([width, height]: [usize; 2]) -> u32 {
    (0..32).find(|k| (width >> k).saturating_mul(height >> k) <= MOST_MADE).unwrap_or(0)
}

/// A picture from which parts are read.
enum Level<'a> {
    /// Halved so many times.
    OfFile(&'a TiffRaster<Arc<dyn FileSource>>, u32),
    Made(&'a Made),
}

impl Level<'_> {
    fn halvings(&self) -> u32 {
        match self {
            Self::OfFile(_, halvings) => *halvings,
            Self::Made(made) => made.halvings,
        }
    }

    fn bands(&self, wanted: Wanted) -> usize {
        match self {
            Self::OfFile(raster, _) => raster.bands(wanted),
            Self::Made(made) => made.pixels.bands.len(),
        }
    }

    fn size(&self) -> [usize; 2] {
        match self {
            Self::OfFile(raster, halvings) => raster.size_of(*halvings),
            Self::Made(made) => made.size,
        }
    }

    /// Whether there is anything of a part; it shows nothing else.
    fn holds_any(&self, first: [usize; 2], size: [usize; 2]) -> bool {
        match self {
            Self::OfFile(raster, halvings) => raster.holds_any(*halvings, first, size),
            Self::Made(_) => true,
        }
    }

    fn own(&self, first: [usize; 2], size: [usize; 2], wanted: Wanted) -> Result<Pixels, Error> {
        match self {
            Self::OfFile(raster, halvings) => raster.read(*halvings, first, size, wanted),
            Self::Made(made) => Ok(made.read(first, size)),
        }
    }

    /// A part, in pixels of the picture that was halved so many times. What is to be halved for it is read piece by piece: it may be all of a large file.
    fn read(&self, first: [usize; 2], [width, height]: [usize; 2], halvings: u32, wanted: Wanted) -> Result<Pixels, Error> {
        if width.saturating_mul(height) > MOST_READ {
            let [megapixels, max_megapixels] = [width as f64 * height as f64, MOST_READ as f64].map(|px| px / 1e6);
            return Err(Error::TooManyPixels { width: width as u64, height: height as u64, megapixels, max_megapixels });
        }
        let further = halvings.saturating_sub(self.halvings());
        if further == 0 {
            return self.own(first, [width, height], wanted);
        }
        let mut pixels = Pixels::nothing(self.bands(wanted), width * height);
        if self.size().iter().any(|side| side >> further == 0) {
            return Ok(pixels);
        }
        let side = (PIECE >> further).max(1);
        for (top, left) in (0..height).step_by(side).flat_map(|top| (0..width).step_by(side).map(move |left| (top, left))) {
            let [columns, rows] = [(width - left).min(side), (height - top).min(side)];
            let piece = [columns << further, rows << further];
            let from = [(first[0] + left) << further, (first[1] + top) << further];
            // Most of a sparse picture is of nothing, halved as before.
            if !self.holds_any(from, piece) {
                continue;
            }
            let own = self.own(from, piece, wanted)?;
            if own.nothing.iter().all(|nothing| *nothing) && own.bands.iter().flatten().all(|value| *value == 0) {
                continue;
            }
            // What shows nothing in all of its pixels is white in the mean.
            let nothing = own.nothing.into_iter().map(|nothing| if nothing { 255 } else { 0 }).collect();
            let reduced = |values: Vec<u8>| GreyImage::new(piece[0], piece[1], values).map(|image| halved(image, further));
            let (bands, nothing) = (own.bands.into_iter().map(reduced).collect::<Result<Vec<_>, _>>()?, reduced(nothing)?);
            for row in 0..rows {
                let to = (top + row) * width + left;
                for (band, own) in pixels.bands.iter_mut().zip(&bands) {
                    band[to..to + columns].copy_from_slice(own.view().row(row));
                }
                pixels.nothing[to..to + columns].iter_mut().zip(nothing.view().row(row)).for_each(|(to, value)| *to = *value == 255);
            }
        }
        Ok(pixels)
    }

    /// With a mask of what is shown: 0 where nothing is; absent where something is everywhere.
    fn read_with_mask(
        &self,
        first: [usize; 2],
        size: [usize; 2],
        halvings: u32,
        wanted: Wanted,
    ) -> Result<(Bands, Option<GreyImage>), Error> {
        let whole = self.size().map(|side| side >> halvings.saturating_sub(self.halvings()));
        let low = first.map(|px| px.saturating_sub(SEEN_FROM));
        let last = [0, 1].map(|axis| first[axis].saturating_add(size[axis]));
        let high = [0, 1].map(|axis| last[axis].saturating_add(SEEN_FROM).min(whole[axis]).max(low[axis].saturating_add(1)));
        let about = [0, 1].map(|axis| high[axis] - low[axis]);
        let pixels = self.read(low, about, halvings, wanted)?;
        let hidden = outside(&pixels.nothing, about[0], about[1], halvings);
        let place = |c: usize, r: usize| {
            let (c, r) = (first[0].saturating_add(c), first[1].saturating_add(r));
            (c < high[0] && r < high[1]).then(|| (r - low[1]) * about[0] + c - low[0])
        };
        let places: Vec<Option<usize>> = (0..size[0] * size[1]).map(|k| place(k % size[0], k / size[0])).collect();
        let of = |band: &Vec<u8>| places.iter().map(|place| place.map_or(0, |k| band[k])).collect();
        let bands = Bands::of(size, pixels.bands.iter().map(of).collect())?;
        if hidden.is_none() && (0..2).all(|axis| last[axis] <= whole[axis]) {
            return Ok((bands, None));
        }
        let shows = |k: usize| hidden.as_ref().is_none_or(|hidden| !hidden[k]);
        let mask = places.iter().map(|place| if place.is_some_and(shows) { 255 } else { 0 }).collect();
        Ok((bands, Some(GreyImage::new(size[0], size[1], mask)?)))
    }
}

impl Made {
    fn read(&self, [left, top]: [usize; 2], [width, height]: [usize; 2]) -> Pixels {
        let mut part = Pixels::nothing(self.pixels.bands.len(), width * height);
        let columns = width.min(self.size[0].saturating_sub(left));
        if columns == 0 {
            return part;
        }
        for row in 0..height.min(self.size[1].saturating_sub(top)) {
            let (from, to) = ((top + row) * self.size[0] + left, row * width);
            for (band, own) in part.bands.iter_mut().zip(&self.pixels.bands) {
                band[to..to + columns].copy_from_slice(&own[from..from + columns]);
            }
            part.nothing[to..to + columns].copy_from_slice(&self.pixels.nothing[from..from + columns]);
        }
        part
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthophoto::picture::Picture;
    use tiff::encoder::{TiffEncoder, colortype::Gray8};
    use tiff::tags::Tag;

    /// A TIFF in strips with an overview beside it, which is the picture halved once; of odd sides one pixel wider and higher, as writers have it.
    fn with_overview(grey: &GreyImage) -> Vec<u8> {
        let mut file = std::io::Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        let half = halved(grey.clone(), 1);
        let [width, height] = [grey.width().div_ceil(2), grey.height().div_ceil(2)];
        let at = |c: usize, r: usize| half.view().at(c.min(half.width() - 1), r.min(half.height() - 1));
        let half = GreyImage::from_fn(width, height, at).unwrap();
        for (is_overview, picture) in [(0_u32, grey), (1, &half)] {
            let mut image = encoder.new_image::<Gray8>(picture.width() as u32, picture.height() as u32).unwrap();
            image.encoder().write_tag(Tag::NewSubfileType, is_overview).unwrap();
            image.rows_per_strip(16).unwrap();
            image.write_data(picture.data()).unwrap();
        }
        file.into_inner()
    }

    #[test]
    fn parts_are_those_of_the_whole_picture_whatever_its_sides() {
        for [width, height] in [[404, 302], [403, 301]] {
            let value = |c: usize, r: usize| if c + r < 120 { 0 } else { 20 + ((c / 9 * 31 + r / 7 * 17) % 200) as u8 };
            let grey = GreyImage::from_fn(width, height, value).unwrap();
            let source: Arc<dyn FileSource> = Arc::new(with_overview(&grey));
            let parts = Parts::new(TiffRaster::open(source, None, 1 << 20).unwrap().unwrap());
            // An overview that is one pixel wider than half of the picture drifts off it: good for a look, not for places.
            let levels = [true, false].map(|exact| parts.level(1, exact, Wanted::Grey).unwrap().halvings());
            assert_eq!(levels, if width == 404 { [1, 1] } else { [0, 1] });
            let nothing: Vec<bool> = grey.data().iter().map(|value| *value == 0).collect();
            let whole = Picture::whole(grey, &nothing);
            for halvings in 0..4 {
                for first in [[0, 0], [48, 32], [160, 96], [320, 240]] {
                    let [own, same] = [parts.part(first, [90, 70], halvings), whole.part(first, [90, 70], halvings)].map(Result::unwrap);
                    assert_eq!((own.width(), own.data()), (same.width(), same.data()), "from {first:?} on, halved {halvings} times");
                }
                let patch = parts.patch([50, 33], [100, 80], halvings).unwrap();
                assert!((0..2).all(|k| patch.first[k] <= [50, 33][k] && [50, 33][k] - patch.first[k] < 1 << halvings));
                assert_eq!(
                    patch.grey.data(),
                    whole.part(patch.first, [patch.grey.width() << halvings, patch.grey.height() << halvings], halvings).unwrap().data()
                );
                let [own, same] = [parts.shown([3, 5], [20, 15], halvings), whole.shown([3, 5], [20, 15], halvings)].map(Result::unwrap);
                let differing = own.iter().zip(&same).filter(|(a, b)| a != b).count();
                // The outside is found in the halved picture, not halved.
                assert!(differing <= if halvings == 0 { 0 } else { 40 }, "{differing} px, halved {halvings} times");
            }
            for at in [[60.5, 55.5], [70.5, 62.5], [3.5, 3.5], [402.5, 300.5]] {
                assert_eq!(parts.shows(at.map(|v| v as usize)), whole.shows(at), "at {at:?}");
            }
            // What was halved away is not there.
            assert!(parts.shown([0, 0], [2, 2], 16).unwrap().iter().all(|value| *value == 0));
            assert!(parts.shown([usize::MAX - 3, 0], [2, 2], 0).unwrap().iter().all(|value| *value == 0));
        }
    }

    /// A TIFF of one directory without its strips of nothing but 0, as sparse ones leave them out.
    fn without_empty_strips(mut file: Vec<u8>) -> (Vec<u8>, usize) {
        let four = |file: &[u8], at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        let directory = four(&file, 4);
        let entry = |file: &[u8], tag: u16| {
            let number = usize::from(file[directory]);
            let entries = (0..number).map(|k| directory + 2 + 12 * k);
            let at = entries.into_iter().find(|at| file[*at..at + 2] == tag.to_le_bytes()).unwrap();
            (four(file, at + 4), four(file, at + 8))
        };
        let ((number, offsets), (_, lengths)) = (entry(&file, 273), entry(&file, 279));
        let mut held = 0;
        for k in 0..number {
            let [from, length] = [offsets, lengths].map(|of| four(&file, of + 4 * k));
            if file[from..from + length].iter().all(|byte| *byte == 0) {
                [offsets, lengths].iter().for_each(|of| file[of + 4 * k..of + 4 * k + 4].fill(0));
            } else {
                held += 1;
            }
        }
        (file, held)
    }

    #[test]
    fn of_a_sparse_picture_no_more_is_decoded_and_halved_than_its_file_holds() {
        let grey =
            GreyImage::from_fn(
                3000,
                12_000,
                |c, r| if (600..2500).contains(&r) { 20 + ((c / 9 * 31 + r / 7 * 17) % 200) as u8 } else { 0 },
            );
        let mut file = std::io::Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        let mut image = encoder.new_image::<Gray8>(3000, 12_000).unwrap();
        image.rows_per_strip(256).unwrap();
        image.write_data(grey.unwrap().data()).unwrap();
        let full = file.into_inner();
        let (sparse, held) = without_empty_strips(full.clone());
        assert_eq!(held, 8);
        let read = |file: Vec<u8>| {
            let source: Arc<dyn FileSource> = Arc::new(file);
            let parts = Parts::new(TiffRaster::open(source, None, 1 << 20).unwrap().unwrap());
            let patch = parts.patch([0, 0], [3000, 12_000], 2).unwrap();
            (patch.grey, patch.mask, parts.raster.number_kept())
        };
        let (grey, mask, decoded) = read(sparse);
        // With those of its piece: 4096 rows.
        assert_eq!(decoded, 16);
        let whole = read(full);
        assert!(grey == whole.0 && mask == whole.1);
    }

    #[test]
    fn pictures_that_no_number_of_32_bits_counts_are_halved_enough() {
        assert_eq!(made_halvings([65_536, 65_536]), 4);
        assert_eq!(made_halvings([5_000, 5_000]), 0);
    }
}
