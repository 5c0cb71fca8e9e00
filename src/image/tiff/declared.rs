//! What an image directory of a TIFF declares, and whether it is decoded.

use std::io::{Read, Seek};

use tiff::TiffError;
use tiff::decoder::{Decoder, Limits};

use super::directory::Directory;
use crate::image::layout::{DEFLATE_MOST, FileLayout, Format, damaged, truncated, undecodable};
use crate::source::FileSource;
use crate::{Damage, Error, Unsupported};

pub(super) mod tag {
    pub const SUBFILE_TYPE: u64 = 254;
    pub const WIDTH: u64 = 256;
    pub const HEIGHT: u64 = 257;
    pub const BITS: u64 = 258;
    pub const COMPRESSION: u64 = 259;
    pub const PHOTOMETRIC: u64 = 262;
    pub const FILL_ORDER: u64 = 266;
    pub const SAMPLES: u64 = 277;
    pub const ROWS_PER_STRIP: u64 = 278;
    pub const PLANAR: u64 = 284;
    pub const PREDICTOR: u64 = 317;
    pub const COLOUR_MAP: u64 = 320;
    pub const JPEG_TABLES: u64 = 347;
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

pub(super) const BLACK_IS_ZERO: u64 = 1;
pub(super) const RGB: u64 = 2;
pub(super) const PALETTE: u64 = 3;
pub(super) const YCBCR: u64 = 6;

const LZW: u64 = 5;
pub(super) const JPEG: u64 = 7;
pub(super) const DEFLATE: u64 = 8;
const PACK_BITS: u64 = 32773;
pub(super) const OLD_DEFLATE: u64 = 32946;

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
pub(in crate::image) struct TiffLayout {
    pub width: u64,
    pub height: u64,
    pub(super) bits: u64,
    pub(super) samples: u64,
    pub(super) photometric: u64,
    pub(super) compression: u64,
    pub(super) planar: bool,
    predictor: u64,
    /// Rows that the decoder is told of. It takes the lowest tiles of all planes but the first for whole ones: so they are.
    pub(super) decoded_height: u64,
}

impl TiffLayout {
    /// Reads the directory and refuses what is not decoded.
    pub fn read<S: FileSource>(source: S) -> Result<Self, Error> {
        Self::of(&checked_directory(source)?)
    }

    pub(super) fn of<S: FileSource>(directory: &Directory<S>) -> Result<Self, Error> {
        let layout = Self::unchecked(directory)?;
        layout.check_supported(directory)?;
        Ok(layout)
    }

    pub(super) fn unchecked<S: FileSource>(directory: &Directory<S>) -> Result<Self, Error> {
        let side = |tag, missing| directory.value(tag).ok_or_else(|| damaged(Format::Tiff, missing));
        let planar = directory.value(tag::PLANAR) == Some(2);
        let height = side(tag::HEIGHT, Damage::NoHeight)?;
        let tile_height = directory.value(tag::TILE_HEIGHT).filter(|rows| planar && *rows > 0);
        Ok(Self {
            decoded_height: tile_height.and_then(|rows| height.checked_next_multiple_of(rows)).unwrap_or(height),
            width: side(tag::WIDTH, Damage::NoWidth)?,
            height,
            bits: directory.value(tag::BITS).unwrap_or(1),
            samples: directory.value(tag::SAMPLES).unwrap_or(1),
            photometric: directory.value(tag::PHOTOMETRIC).unwrap_or(BLACK_IS_ZERO),
            compression: directory.value(tag::COMPRESSION).unwrap_or(1),
            planar,
            predictor: directory.value(tag::PREDICTOR).unwrap_or(1),
        })
    }

    /// JPEG of 8 bits, with the samples of a pixel together.
    fn check_jpeg(&self) -> Result<(), Error> {
        match (self.photometric, self.samples, self.bits, self.planar) {
            (BLACK_IS_ZERO, 1, 8, _) | (RGB | YCBCR, 3, 8, false) => Ok(()),
            (photometric, samples, bits, _) => Err(Unsupported::TiffColours { photometric, samples, bits }.into_error()),
        }
    }

    /// Whether the first three samples are red, green and blue.
    pub(super) fn is_colour(&self) -> bool {
        self.photometric == RGB
    }

    /// How many samples of a pixel are its grey value or its colours.
    pub(super) fn colours(&self) -> usize {
        if matches!(self.photometric, RGB | YCBCR) { 3 } else { 1 }
    }

    pub(super) fn has_samples_of(&self, other: &Self) -> bool {
        let kind = |layout: &Self| (layout.bits, layout.samples, layout.planar, layout.compression == JPEG);
        // JPEG keeps the colours of a picture in either way.
        kind(self) == kind(other) && (self.photometric == other.photometric || self.compression == JPEG)
    }

    /// What the limits ask for.
    pub fn file_layout(&self) -> FileLayout {
        let Self { width, height, .. } = *self;
        let samples_bytes = self.samples.saturating_mul(self.bits / 8);
        // Of JPEG grey or colours, and the working memory of one tile or strip.
        let bytes_per_pixel = if self.compression == JPEG { 8 } else { samples_bytes };
        let most = match self.compression {
            // A block of 8 x 8 px takes two bits.
            JPEG => 256 * bytes_per_pixel,
            // A code of 12 bits stands for up to 3,839 bytes.
            LZW => 2_560,
            PACK_BITS => 64,
            DEFLATE | OLD_DEFLATE => DEFLATE_MOST,
            _ => 1,
        };
        let least_bytes = width.saturating_mul(height).saturating_mul(bytes_per_pixel) / most;
        FileLayout { format: Format::Tiff, width, height, bytes_per_pixel, least_bytes }
    }

    fn check_supported<S: FileSource>(&self, directory: &Directory<S>) -> Result<(), Error> {
        match directory.value(tag::SAMPLE_FORMAT) {
            None | Some(1) => {}
            Some(3) => return Err(Unsupported::TiffFloats.into_error()),
            Some(_) => return Err(Unsupported::TiffSigned.into_error()),
        }
        if !matches!(self.bits, 8 | 16) {
            return Err(Unsupported::TiffBits { bits: self.bits }.into_error());
        }
        match (self.photometric, self.samples, self.bits) {
            _ if self.compression == JPEG => self.check_jpeg()?,
            (0 | BLACK_IS_ZERO, 1.., _) | (RGB, 3.., _) | (PALETTE, 1, 8) => {}
            (photometric, samples, bits) => return Err(Unsupported::TiffColours { photometric, samples, bits }.into_error()),
        }
        if !matches!(self.compression, 1 | LZW | JPEG | DEFLATE | OLD_DEFLATE | PACK_BITS) {
            return Err(Unsupported::TiffCompression { compression: self.compression }.into_error());
        }
        if [tag::TILE_WIDTH, tag::TILE_HEIGHT].iter().any(|&side| directory.value(side).is_some_and(|side| side > MAX_TILE_SIDE)) {
            return Err(Unsupported::TiffTileSide.into_error());
        }
        let tile_row_bytes = directory.value(tag::TILE_WIDTH).unwrap_or(0).saturating_mul(self.file_layout().bytes_per_pixel);
        if self.width.saturating_mul(self.decoded_height) > most_decoded(self.width.saturating_mul(self.height)) {
            return Err(Unsupported::TiffTileSide.into_error());
        }
        if tile_row_bytes > MAX_TILE_ROW_BYTES {
            return Err(Unsupported::TiffTileRow { bytes: tile_row_bytes }.into_error());
        }
        Ok(())
    }
}

/// Most pixels that are decoded of a picture of so many, with those of its tiles that lie beyond it.
pub(super) fn most_decoded(pixels: u64) -> u64 {
    pixels.saturating_mul(2).max(1 << 24)
}

/// The number of samples a pixel that the decoder gives.
pub(super) fn check_bands<R: Read + Seek>(decoder: &mut Decoder<R>, declared: &TiffLayout) -> Result<usize, Error> {
    let channels = decoder.colortype().map_err(decoder_error)?.num_samples();
    if u64::from(channels) < declared.samples && declared.predictor != 1 && !declared.planar {
        // The decoder leaves out the further bands before it undoes the prediction, which then mixes the bands.
        return Err(Unsupported::TiffBands { bands: declared.samples }.into_error());
    }
    Ok(usize::from(channels))
}

/// No limits: what an image needs is checked before.
pub(super) fn unlimited() -> Limits {
    Limits::unlimited()
}

/// The first directory of a file.
///
/// # Errors
/// [`Error::UnreadableImage`] where the file ends before it, or where it would cost much to read.
pub(crate) fn checked_directory<S: FileSource>(source: S) -> Result<Directory<S>, Error> {
    let directory = Directory::first(source).ok_or_else(|| truncated(Format::Tiff))?;
    check_counts(&directory)?;
    Ok(directory)
}

/// Refuses directories that cost much to read: the decoder holds what they say of strips and tiles, and the values of other tags.
pub(super) fn check_counts<S: FileSource>(directory: &Directory<S>) -> Result<(), Error> {
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

pub(crate) fn decoder_error(error: TiffError) -> Error {
    match error {
        TiffError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => truncated(Format::Tiff),
        TiffError::UnsupportedError(e) => Unsupported::TiffDecoder { words: e.to_string() }.into_error(),
        e => undecodable(Format::Tiff, e),
    }
}
