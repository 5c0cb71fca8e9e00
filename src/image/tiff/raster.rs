//! A TIFF whose pixels are decoded where they are asked for: the picture itself, and smaller ones of it (overviews) that the file holds.

use std::sync::{Arc, Mutex, PoisonError};

use tiff::decoder::Decoder;

use super::declared::{JPEG, PALETTE, TiffLayout, YCBCR, check_bands, check_counts, checked_directory, decoder_error, tag, unlimited};
use super::directory::Directory;
use super::grid::Grid;
use super::jpeg_chunk::JpegChunks;
use super::transparency::Transparency;
use crate::image::kept::Kept;
use crate::image::layout::{Format, damaged};
use crate::image::luminance::{Depth, Sample, SampleLayout, Wanted, bands_of_u8, bands_up_to, luma};
use crate::source::{FileSource, SourceReader};
use crate::{Damage, Error};

/// Image directories that are looked at.
const MOST_DIRECTORIES: usize = 64;
/// Overviews are halved so many times at most.
const MOST_HALVINGS: u32 = 16;
/// Bytes of decoded tiles and strips that are kept: two of the longest strips in colours.
const KEPT_BYTES: usize = 128 << 20;
/// Which depth of 16 bits is in use is told by all samples of a picture of at most so many pixels, else by so many tiles or strips of the smallest one.
const ALL_LOOKED_AT: usize = 40_000_000;
const LOOKED_AT: usize = 64;
/// Tiles and strips that show nothing tell nothing, but are read all the same: so many at most.
const MOST_LOOKED_AT: usize = 1024;
/// Beginnings of overviews in what says of which kind an image is: bit 0 a smaller one, bit 2 a mask.
const SMALLER: u64 = 1;
const MASK: u64 = 4;
/// Values of what says what a further sample is: alpha, of premultiplied colour or not.
const ALPHA: [u16; 2] = [1, 2];

/// Grey values or colours, one band or three, with what shows nothing: what a mask of the file leaves out, or else alpha of 0, or the value that stands for nothing, or grey of 0 where the file names neither.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pixels {
    pub bands: Vec<Vec<u8>>,
    pub nothing: Vec<bool>,
}

/// A TIFF that is read in parts.
pub(crate) struct TiffRaster<S: FileSource> {
    levels: Vec<Level<S>>,
    samples: Samples,
    has_colours: bool,
    kept: Kept<Key, Pixels>,
}

/// The picture, or an overview.
struct Level<S: FileSource> {
    halvings: u32,
    grid: Grid,
    coding: Coding<S>,
    transparency: Option<Transparency<S>>,
}

enum Coding<S: FileSource> {
    /// By the library.
    Samples(Box<Mutex<Decoder<SourceReader<S>>>>),
    Jpeg(JpegChunks<S>),
}

/// What the samples of a pixel mean.
#[derive(Debug, Clone)]
struct Samples {
    colour: bool,
    /// Where they stand in planes: the planes of the file that are read, of which the last is alpha where there is any. Else none.
    planes: Vec<usize>,
    /// Which sample of those that are read is alpha.
    alpha: Option<usize>,
    /// The value that stands for nothing.
    no_data: Option<f64>,
    bits: u64,
    /// The 16-bit sample that becomes white.
    white: u32,
}

impl Pixels {
    /// So many that show nothing.
    pub fn nothing(bands: usize, pixels: usize) -> Self {
        Self { bands: vec![vec![0; pixels]; bands], nothing: vec![true; pixels] }
    }
}

/// What a tile or strip belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Of {
    Picture(Wanted),
    Transparency,
}

/// The picture's place among the levels, what is meant of it, and the number of the tile or strip.
type Key = (usize, Of, usize);

impl<S: FileSource + Clone> TiffRaster<S> {
    /// Reads its directories. Absent where it cannot be read in parts: a tile or strip has more than `most_px`, or colours come from a palette.
    ///
    /// # Errors
    /// [`Error::UnsupportedImage`] and [`Error::UnreadableImage`] for what is not decoded, or damaged.
    pub fn open(source: S, no_data: Option<f64>, most_px: usize) -> Result<Option<Self>, Error> {
        let first = checked_directory(source.clone())?;
        let layout = TiffLayout::of(&first)?;
        let TiffLayout { width, height, bits, .. } = layout;
        if width == 0 || height == 0 {
            return Err(damaged(Format::Tiff, Damage::NoPixels { width, height }));
        }
        if layout.photometric == PALETTE {
            return Ok(None);
        }
        let Some(whole) = Level::of(&source, &first, &layout, 0, 0, most_px)? else { return Ok(None) };
        let (mut planes, mut alpha) = (Vec::new(), alpha_of(&first, &layout));
        if layout.planar && layout.samples > 1 {
            alpha = alpha.filter(|alpha| (*alpha as u64) < layout.samples);
            planes = (0..layout.colours()).chain(alpha).collect();
            alpha = alpha.map(|_| layout.colours());
        }
        let white = (1_u64 << bits) - 1;
        let no_data = no_data.filter(|value| value.fract() == 0.0 && (0.0..=white as f64).contains(value));
        let samples = Samples { colour: layout.is_colour(), planes, alpha, no_data, bits, white: 0xffff };
        let has_colours = layout.is_colour() || layout.photometric == YCBCR;
        let mut raster = Self { levels: vec![whole], samples, has_colours, kept: Kept::new(KEPT_BYTES) };
        raster.add_overviews(&source, &first, &layout, most_px);
        if bits == 16 {
            raster.samples.white = raster.white()?;
        }
        Ok(Some(raster))
    }

    /// Those that can be read; what cannot is left out, since the picture itself has all of it.
    fn add_overviews(&mut self, source: &S, first: &Directory<S>, layout: &TiffLayout, most_px: usize) {
        let next = |directory: &Directory<S>| directory.next().filter(|next| check_counts(next).is_ok());
        let directories = std::iter::successors(next(first), next);
        let mut masks = Vec::new();
        for (k, directory) in directories.take(MOST_DIRECTORIES).enumerate() {
            let kind = directory.value(tag::SUBFILE_TYPE).unwrap_or(0);
            if kind & MASK != 0 {
                masks.extend(Transparency::of(source, &directory, most_px));
                continue;
            }
            let Ok(own) = TiffLayout::of(&directory) else { continue };
            let halvings = (1..=MOST_HALVINGS).find(|k| {
                let is_half = |whole: u64, side: u64| side > 0 && (side == whole >> k || side == whole.div_ceil(1 << k));
                is_half(layout.width, own.width) && is_half(layout.height, own.height)
            });
            let fits = kind & SMALLER != 0 && own.has_samples_of(layout);
            if let Some(halvings) = halvings.filter(|_| fits)
                && let Ok(Some(level)) = Level::of(source, &directory, &own, k + 1, halvings, most_px)
            {
                self.levels.push(level);
            }
        }
        for mask in masks {
            let own = self.levels.iter_mut().find(|level| level.grid.size == mask.grid.size);
            own.into_iter().for_each(|level| level.transparency = Some(mask.clone()));
        }
        // What an overview does not show is known as well as of the picture, or it is not used.
        if self.levels[0].transparency.is_some() {
            self.levels.retain(|level| level.transparency.is_some());
        }
        self.levels.sort_by_key(|level| level.halvings);
        self.levels.dedup_by_key(|level| level.halvings);
    }

    /// Width and height.
    pub fn size(&self) -> [usize; 2] {
        self.levels[0].grid.size
    }

    /// Width and height of the picture that was halved so many times, which is one of those of the file.
    pub fn size_of(&self, halvings: u32) -> [usize; 2] {
        self.level_of(halvings).1.grid.size
    }

    fn level_of(&self, halvings: u32) -> (usize, &Level<S>) {
        let index = self.levels.iter().position(|level| level.halvings == halvings).unwrap_or(0);
        (index, &self.levels[index])
    }

    /// How often the most reduced picture is halved that was not halved more often than this. `exact`: none whose columns or rows drift from those of
    /// the picture, as where a side is odd.
    pub fn level(&self, halvings: u32, exact: bool) -> u32 {
        let fits = |level: &&Level<S>| {
            let whole = (0..2).all(|axis| level.grid.size[axis] << level.halvings == self.size()[axis]);
            level.halvings <= halvings && (whole || !exact)
        };
        self.levels.iter().rev().find(fits).map_or(0, |level| level.halvings)
    }

    /// How many bands it has where so much is wanted of it.
    pub fn bands(&self, wanted: Wanted) -> usize {
        if self.has_colours && wanted == Wanted::Colours { 3 } else { 1 }
    }

    /// A part of the picture that was halved so many times, which is one of those of the file; beyond its edge nothing is shown.
    pub fn read(&self, halvings: u32, first: [usize; 2], [width, height]: [usize; 2], wanted: Wanted) -> Result<Pixels, Error> {
        let (index, level) = self.level_of(halvings);
        let mut pixels = Pixels::nothing(self.bands(wanted), width * height);
        for piece in level.grid.pieces(first, [width, height]) {
            let chunk = self.kept((index, Of::Picture(wanted), piece.index), || self.decoded(level, piece.index, wanted))?;
            for (from, to) in piece.rows_to(first, width) {
                for (band, own) in pixels.bands.iter_mut().zip(&chunk.bands) {
                    band[to.clone()].copy_from_slice(&own[from.clone()]);
                }
                pixels.nothing[to].copy_from_slice(&chunk.nothing[from]);
            }
        }
        let Some(transparency) = &level.transparency else { return Ok(pixels) };
        for piece in transparency.grid.pieces(first, [width, height]) {
            let mask = || transparency.nothing(piece.index).map(|nothing| Pixels { bands: Vec::new(), nothing });
            let chunk = self.kept((index, Of::Transparency, piece.index), mask)?;
            piece.rows_to(first, width).for_each(|(from, to)| pixels.nothing[to].copy_from_slice(&chunk.nothing[from]));
        }
        Ok(pixels)
    }

    fn kept(&self, key: Key, decode: impl FnOnce() -> Result<Pixels, Error>) -> Result<Arc<Pixels>, Error> {
        self.kept.part(key, |chunk| chunk.bands.iter().map(Vec::len).sum::<usize>() + chunk.nothing.len(), decode)
    }

    /// Whether the file holds anything of a part of the picture that was halved so many times: it may leave out what shows nothing.
    pub fn holds_any(&self, halvings: u32, first: [usize; 2], size: [usize; 2]) -> bool {
        let level = self.level_of(halvings).1;
        level.transparency.is_some() || level.grid.pieces(first, size).any(|piece| self.holds(level, piece.index))
    }

    /// How many tiles and strips are kept.
    #[cfg(test)]
    pub fn number_kept(&self) -> usize {
        self.kept.number()
    }

    /// Whether the file holds anything of a tile or strip.
    fn holds(&self, level: &Level<S>, index: usize) -> bool {
        self.samples.planes_or_all().any(|plane| level.grid.holds(plane * level.grid.number() + index))
    }

    fn decoded(&self, level: &Level<S>, index: usize, wanted: Wanted) -> Result<Pixels, Error> {
        let [width, height] = level.grid.sides(index);
        let pixels = width * height;
        if !self.holds(level, index) {
            return Ok(Pixels::nothing(self.bands(wanted), pixels));
        }
        let decoder = match &level.coding {
            Coding::Jpeg(chunks) => {
                let bands = chunks.decode(&level.grid, index, wanted)?;
                if bands.len() != self.bands(wanted) {
                    return Err(damaged(Format::Tiff, Damage::OtherThanDirectory));
                }
                // By luma: JPEG leaves the colours of black unequal.
                let nothing = match bands.as_slice() {
                    [red, green, blue] => {
                        let grey: Vec<u16> = (0..pixels).map(|k| luma([red[k], green[k], blue[k]].map(u16::from)) as u16).collect();
                        self.samples.nothing(&grey, &SampleLayout::interleaved(1), pixels)
                    }
                    _ => self.samples.nothing(&bands[0], &SampleLayout::interleaved(1), pixels),
                };
                return Ok(Pixels { bands, nothing });
            }
            Coding::Samples(decoder) => decoder,
        };
        let (bytes, layout) = self.samples_of(decoder, level, index)?;
        if self.samples.bits == 8 {
            let nothing = self.samples.nothing(&bytes, &layout, pixels);
            return Ok(Pixels { bands: bands_of_u8(bytes, pixels, layout, wanted), nothing });
        }
        let samples = bytes.as_chunks::<2>().0;
        let nothing = self.samples.nothing(samples, &layout, pixels);
        Ok(Pixels { bands: bands_up_to(self.samples.white, samples, pixels, layout, wanted), nothing })
    }

    /// The samples of a tile or strip, of 8 or of 16 bits, and how they lie there.
    fn samples_of(
        &self,
        decoder: &Mutex<Decoder<SourceReader<S>>>,
        level: &Level<S>,
        index: usize,
    ) -> Result<(Vec<u8>, SampleLayout), Error> {
        let mut decoder = decoder.lock().unwrap_or_else(PoisonError::into_inner);
        let [width, height] = level.grid.sides(index);
        let sample_bytes = (self.samples.bits / 8) as usize;
        let (colour, plane) = (self.samples.colour, width * height);
        let mut bytes = Vec::new();
        if self.samples.planes.is_empty() {
            let channels = usize::from(decoder.colortype().map_err(decoder_error)?.num_samples());
            read_onto(&mut bytes, &mut decoder, index, |length| length == plane * channels * sample_bytes)?;
            return Ok((bytes, SampleLayout { channels, colour, plane_stride: None }));
        }
        for (k, of_file) in self.samples.planes.iter().enumerate() {
            let index = of_file * level.grid.number() + index;
            if level.grid.holds(index) {
                // The library takes the lowest tiles of planes for whole ones.
                read_onto(&mut bytes, &mut decoder, index, |length| length >= plane * sample_bytes)?;
            }
            // In the machine's byte order, as the library gives samples.
            let missing = self.samples.no_data.unwrap_or(0.0) as u16;
            let missing = if sample_bytes == 1 { vec![missing as u8] } else { missing.to_ne_bytes().to_vec() };
            bytes.truncate((k + 1) * plane * sample_bytes);
            let lacking = (k + 1) * plane - bytes.len() / sample_bytes;
            bytes.extend(missing.repeat(lacking));
        }
        Ok((bytes, SampleLayout { channels: self.samples.planes.len(), colour, plane_stride: Some(plane) }))
    }

    /// The 16-bit sample that becomes white, by tiles or strips of the smallest picture.
    fn white(&self) -> Result<u32, Error> {
        let [width, height] = self.size();
        let is_small = width.saturating_mul(height) <= ALL_LOOKED_AT;
        let level = if is_small { &self.levels[0] } else { &self.levels[self.levels.len() - 1] };
        let Coding::Samples(decoder) = &level.coding else { return Ok(0xffff) };
        let number = level.grid.number();
        let (wanted, most) = if is_small { (number, number) } else { (LOOKED_AT, MOST_LOOKED_AT) };
        // All over the picture: no row or column of tiles alone.
        let step = (number * 5 / 8..).find(|step| greatest_common_divisor(*step, number) == 1).unwrap_or(1);
        let (mut depth, mut seen) = (Depth::default(), 0);
        for index in
            (0..number.min(most)).map(|k| (k as u64 * step as u64 % number as u64) as usize).filter(|index| self.holds(level, *index))
        {
            let (bytes, layout) = self.samples_of(decoder, level, index)?;
            let samples = bytes.as_chunks::<2>().0;
            let [width, height] = level.grid.sides(index);
            // The value that stands for nothing may be larger than any colour.
            let nothing = self.samples.nothing(samples, &layout, width * height);
            depth.see_but(samples, layout, &nothing);
            seen += usize::from(nothing.contains(&false));
            if seen >= wanted {
                break;
            }
        }
        Ok(depth.white())
    }
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

impl<S: FileSource + Clone> Level<S> {
    /// Of the directory of this number in the file. Absent where a tile or strip is larger than is read in parts.
    fn of(
        source: &S,
        directory: &Directory<S>,
        layout: &TiffLayout,
        number: usize,
        halvings: u32,
        most_px: usize,
    ) -> Result<Option<Self>, Error> {
        let Some(grid) = Grid::of(directory, layout, most_px, layout.compression != JPEG)? else { return Ok(None) };
        let coding = if layout.compression == JPEG {
            Coding::Jpeg(JpegChunks::new(source.clone(), directory, layout))
        } else {
            let mut decoder = Decoder::new(SourceReader::new(source.clone())).map_err(decoder_error)?.with_limits(unlimited());
            decoder.seek_to_image(number).map_err(decoder_error)?;
            check_bands(&mut decoder, layout)?;
            Coding::Samples(Box::new(Mutex::new(decoder)))
        };
        Ok(Some(Self { halvings, grid, coding, transparency: None }))
    }
}

/// Reads a tile or strip of the library onto others.
fn read_onto<S: FileSource>(
    bytes: &mut Vec<u8>,
    decoder: &mut Decoder<SourceReader<S>>,
    index: usize,
    is_right: impl FnOnce(usize) -> bool,
) -> Result<(), Error> {
    let length = decoder.image_chunk_buffer_layout(index as u32).map_err(decoder_error)?.len;
    if !is_right(length) {
        return Err(damaged(Format::Tiff, Damage::OtherThanDirectory));
    }
    let from = bytes.len();
    bytes.resize(from + length, 0);
    decoder.read_chunk_bytes(index as u32, &mut bytes[from..]).map_err(decoder_error)
}

/// Which sample is alpha.
fn alpha_of<S: FileSource>(directory: &Directory<S>, layout: &TiffLayout) -> Option<usize> {
    let further = directory.all_shorts(tag::EXTRA_SAMPLES)?;
    further.iter().position(|kind| ALPHA.contains(kind)).map(|k| layout.colours() + k)
}

impl Samples {
    /// The planes of the file that are read; the first one where the samples of a pixel stand together.
    fn planes_or_all(&self) -> impl Iterator<Item = usize> {
        self.planes.iter().copied().chain(self.planes.is_empty().then_some(0))
    }

    /// Which pixels show nothing.
    fn nothing<T: Sample>(&self, samples: &[T], layout: &SampleLayout, pixels: usize) -> Vec<bool> {
        let at = |pixel: usize, channel: usize| f64::from(samples[layout.place(pixel, channel)].value());
        let colours = if layout.colour { 3 } else { 1 };
        match (self.alpha.filter(|alpha| *alpha < layout.channels), self.no_data) {
            (Some(alpha), _) => (0..pixels).map(|pixel| at(pixel, alpha) == 0.0).collect(),
            (None, value) => {
                let value = value.unwrap_or(0.0);
                (0..pixels).map(|pixel| (0..colours).all(|channel| at(pixel, channel) == value)).collect()
            }
        }
    }
}
