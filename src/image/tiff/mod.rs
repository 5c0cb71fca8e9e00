//! TIFF files: the first image, 8 or 16 bits a sample.

mod directory;

use std::borrow::Cow;
use std::io::Cursor;

use tiff::TiffError;
use tiff::decoder::{Decoder, DecodingResult, Limits};

pub(crate) use self::directory::Directory;
use super::layout::{DEFLATE_MOST, FileLayout, Format, damaged, truncated, undecodable};
use super::luminance::{SampleLayout, grey_of_u8, grey_of_u16};
use crate::{Damage, Error, Unsupported};

mod tag {
    pub const WIDTH: u64 = 256;
    pub const HEIGHT: u64 = 257;
    pub const BITS: u64 = 258;
    pub const COMPRESSION: u64 = 259;
    pub const PHOTOMETRIC: u64 = 262;
    pub const SAMPLES: u64 = 277;
    pub const ROWS_PER_STRIP: u64 = 278;
    pub const PLANAR: u64 = 284;
    pub const PREDICTOR: u64 = 317;
    pub const COLOUR_MAP: u64 = 320;
    pub const TILE_WIDTH: u64 = 322;
    pub const TILE_HEIGHT: u64 = 323;
    pub const SAMPLE_FORMAT: u64 = 339;

    /// Offsets and lengths of strips and of tiles.
    pub const OF_CHUNKS: [u64; 4] = [273, 279, 324, 325];
    pub const EXTRA_SAMPLES: u64 = 338;
    pub const CHROMA_SUBSAMPLING: u64 = 530;
    /// What else the decoder reads, all of its values.
    pub const DECODED: [u64; 14] = [
        WIDTH,
        HEIGHT,
        BITS,
        COMPRESSION,
        PHOTOMETRIC,
        SAMPLES,
        ROWS_PER_STRIP,
        PLANAR,
        PREDICTOR,
        TILE_WIDTH,
        TILE_HEIGHT,
        EXTRA_SAMPLES,
        SAMPLE_FORMAT,
        CHROMA_SUBSAMPLING,
    ];
}

const BLACK_IS_ZERO: u64 = 1;
const RGB: u64 = 2;
const PALETTE: u64 = 3;

const LZW: u64 = 5;
const DEFLATE: u64 = 8;
const PACK_BITS: u64 = 32773;
const OLD_DEFLATE: u64 = 32946;

/// Some hundreds of tags are registered.
const MOST_TAGS: usize = 4_096;
/// Most values of a tag: the decoder holds each in 32 bytes.
const MOST_VALUES: u64 = 1 << 16;
/// 250 MP in the smallest tiles, those of 16 x 16 px, are fewer.
const MOST_CHUNKS: u64 = 1_000_000;

/// Longest side of a tile.
const MAX_TILE_SIDE: u64 = 1 << 16;
/// A row of a tile is held in memory.
const MAX_TILE_ROW_BYTES: u64 = 1 << 24;

/// What the first image directory declares.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TiffLayout {
    pub width: u64,
    pub height: u64,
    bits: u64,
    samples: u64,
    photometric: u64,
    compression: u64,
    planar: bool,
    predictor: u64,
}

impl TiffLayout {
    /// Reads the directory and refuses what is not decoded.
    pub fn read(bytes: &[u8]) -> Result<Self, Error> {
        let directory = checked_directory(bytes)?;
        let side = |tag, missing| directory.value(tag).ok_or_else(|| damaged(Format::Tiff, missing));
        let layout = Self {
            width: side(tag::WIDTH, Damage::NoWidth)?,
            height: side(tag::HEIGHT, Damage::NoHeight)?,
            bits: directory.value(tag::BITS).unwrap_or(1),
            samples: directory.value(tag::SAMPLES).unwrap_or(1),
            photometric: directory.value(tag::PHOTOMETRIC).unwrap_or(BLACK_IS_ZERO),
            compression: directory.value(tag::COMPRESSION).unwrap_or(1),
            planar: directory.value(tag::PLANAR) == Some(2),
            predictor: directory.value(tag::PREDICTOR).unwrap_or(1),
        };
        layout.check_supported(&directory)?;
        Ok(layout)
    }

    /// What the limits ask for.
    pub fn file_layout(&self) -> FileLayout {
        let Self { width, height, .. } = *self;
        let bytes_per_pixel = self.samples.saturating_mul(self.bits / 8);
        let most = match self.compression {
            // A code of 12 bits stands for up to 3,839 bytes.
            LZW => 2_560,
            PACK_BITS => 64,
            DEFLATE | OLD_DEFLATE => DEFLATE_MOST,
            _ => 1,
        };
        let least_bytes = width.saturating_mul(height).saturating_mul(bytes_per_pixel) / most;
        FileLayout { format: Format::Tiff, width, height, bytes_per_pixel, least_bytes }
    }

    fn check_supported(&self, directory: &Directory<'_>) -> Result<(), Error> {
        match directory.value(tag::SAMPLE_FORMAT) {
            None | Some(1) => {}
            Some(3) => return Err(Unsupported::TiffFloats.into_error()),
            Some(_) => return Err(Unsupported::TiffSigned.into_error()),
        }
        if !matches!(self.bits, 8 | 16) {
            return Err(Unsupported::TiffBits { bits: self.bits }.into_error());
        }
        match (self.photometric, self.samples, self.bits) {
            (0 | BLACK_IS_ZERO, 1.., _) | (RGB, 3.., _) | (PALETTE, 1, 8) => {}
            (photometric, samples, bits) => return Err(Unsupported::TiffColours { photometric, samples, bits }.into_error()),
        }
        if !matches!(self.compression, 1 | LZW | DEFLATE | OLD_DEFLATE | PACK_BITS) {
            return Err(Unsupported::TiffCompression { compression: self.compression }.into_error());
        }
        if [tag::TILE_WIDTH, tag::TILE_HEIGHT].iter().any(|&side| directory.value(side).is_some_and(|side| side > MAX_TILE_SIDE)) {
            return Err(Unsupported::TiffTileSide.into_error());
        }
        let tile_row_bytes = directory.value(tag::TILE_WIDTH).unwrap_or(0).saturating_mul(self.file_layout().bytes_per_pixel);
        if tile_row_bytes > MAX_TILE_ROW_BYTES {
            return Err(Unsupported::TiffTileRow { bytes: tile_row_bytes }.into_error());
        }
        Ok(())
    }
}

/// Decodes to grey; gives the bits of a stored sample as well.
pub(super) fn decode(bytes: &[u8], pixels: usize) -> Result<(Vec<u8>, u8), Error> {
    let declared = TiffLayout::read(bytes)?;
    let greys = if declared.photometric == PALETTE { Some(palette_greys(bytes)?) } else { None };
    let (samples, channels) = read_samples(&as_the_decoder_reads(bytes, &declared), &declared)?;
    let plane_stride = (declared.planar && channels > 1).then_some(pixels);
    let layout = SampleLayout { channels, colour: declared.photometric == RGB, plane_stride };
    let expected = pixels.checked_mul(channels);
    match samples {
        DecodingResult::U8(samples) if Some(samples.len()) == expected => {
            let mut grey = grey_of_u8(samples, pixels, layout);
            if let Some(greys) = greys {
                grey.iter_mut().for_each(|v| *v = greys[usize::from(*v)]);
            }
            Ok((grey, 8))
        }
        DecodingResult::U16(samples) if Some(samples.len()) == expected => Ok((grey_of_u16(&samples, pixels, layout), 16)),
        _ => Err(damaged(Format::Tiff, Damage::OtherThanDirectory)),
    }
}

/// All samples of the first image and the number of samples a pixel.
fn read_samples(bytes: &[u8], declared: &TiffLayout) -> Result<(DecodingResult, usize), Error> {
    // What the image needs is checked already.
    let mut decoder = Decoder::new(Cursor::new(bytes)).map_err(decoder_error)?.with_limits(Limits::unlimited());
    let (width, height) = decoder.dimensions().map_err(decoder_error)?;
    if (u64::from(width), u64::from(height)) != (declared.width, declared.height) {
        return Err(damaged(Format::Tiff, Damage::TwoDirectorySizes));
    }
    let channels = decoder.colortype().map_err(decoder_error)?.num_samples();
    if u64::from(channels) < declared.samples && declared.predictor != 1 && !declared.planar {
        // The decoder leaves out the further bands before it undoes the prediction, which then mixes the bands.
        return Err(Unsupported::TiffBands { bands: declared.samples }.into_error());
    }
    let mut samples = DecodingResult::U8(Vec::new());
    decoder.read_image_to_buffer(&mut samples).map_err(decoder_error)?;
    Ok((samples, usize::from(channels)))
}

/// The first directory of a file.
///
/// # Errors
/// [`Error::UnreadableImage`] where the file ends before it, or where it would cost much to read.
pub(crate) fn checked_directory(bytes: &[u8]) -> Result<Directory<'_>, Error> {
    let directory = Directory::first(bytes).ok_or_else(|| truncated(Format::Tiff))?;
    check_counts(&directory)?;
    Ok(directory)
}

/// Refuses directories that cost much to read: the decoder holds what they say of strips and tiles, and the values of other tags.
fn check_counts(directory: &Directory<'_>) -> Result<(), Error> {
    if directory.entries > MOST_TAGS {
        return Err(damaged(Format::Tiff, Damage::ManyTags { tags: directory.entries, most: MOST_TAGS }));
    }
    for (tag, count) in directory.counts() {
        let most = match tag {
            _ if tag::OF_CHUNKS.contains(&tag) => MOST_CHUNKS,
            _ if tag::DECODED.contains(&tag) => MOST_VALUES,
            _ => continue,
        };
        if count > most {
            return Err(damaged(Format::Tiff, Damage::ManyValues { tag, values: count, most }));
        }
    }
    Ok(())
}

/// The grey value of each palette index; the colour map holds 16-bit red, then green, then blue.
fn palette_greys(bytes: &[u8]) -> Result<Vec<u8>, Error> {
    let map = Directory::first(bytes).and_then(|directory| directory.shorts(tag::COLOUR_MAP, 768));
    let map = map.ok_or_else(|| damaged(Format::Tiff, Damage::ColourMap))?;
    Ok(grey_of_u16(&map, 256, SampleLayout { channels: 3, colour: true, plane_stride: Some(256) }))
}

/// The file with two declarations put in the words of the decoder.
///
/// It takes palette indices for what they are only if they are called grey, and a strip of more rows than the image has, as
/// writers declare for 'all rows', overflows where addresses have 32 bits.
fn as_the_decoder_reads<'a>(bytes: &'a [u8], declared: &TiffLayout) -> Cow<'a, [u8]> {
    let Some(directory) = Directory::first(bytes) else {
        return bytes.into();
    };
    let palette = (declared.photometric == PALETTE).then_some((tag::PHOTOMETRIC, BLACK_IS_ZERO));
    let mut file = with_rows_of_image(bytes);
    if let Some((at, encoded)) = palette.and_then(|(tag, value)| directory.encoded(tag, value)) {
        file.to_mut()[at..at + encoded.len()].copy_from_slice(&encoded);
    }
    file
}

/// The file with no more rows a strip than the image has.
pub(crate) fn with_rows_of_image(bytes: &[u8]) -> Cow<'_, [u8]> {
    let mut file = Cow::from(bytes);
    let Some(directory) = Directory::first(bytes) else { return file };
    let height = directory.value(tag::HEIGHT).unwrap_or(0);
    let more = directory.value(tag::ROWS_PER_STRIP).filter(|&rows| rows > height);
    if let Some((at, encoded)) = more.and_then(|_| directory.encoded(tag::ROWS_PER_STRIP, height)) {
        file.to_mut()[at..at + encoded.len()].copy_from_slice(&encoded);
    }
    file
}

pub(crate) fn decoder_error(error: TiffError) -> Error {
    match error {
        TiffError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => truncated(Format::Tiff),
        TiffError::UnsupportedError(e) => Unsupported::TiffDecoder { words: e.to_string() }.into_error(),
        e => undecodable(Format::Tiff, e),
    }
}
