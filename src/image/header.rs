//! What the first bytes of an image file declare, read without decoding.

use super::tiff::TiffLayout;
use super::{jpeg, png, pnm, webp};
use crate::Error;

/// The formats that are decoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Jpeg,
    Png,
    Tiff,
    Bmp,
    Pnm,
    WebP,
}

impl Format {
    pub const ALL: &'static str = "JPEG, PNG, TIFF, BMP, PNM (PBM, PGM, PPM, PAM), WebP";

    pub fn name(self) -> &'static str {
        match self {
            Format::Jpeg => "JPEG",
            Format::Png => "PNG",
            Format::Tiff => "TIFF",
            Format::Bmp => "BMP",
            Format::Pnm => "PNM",
            Format::WebP => "WebP",
        }
    }

    /// The format that the first bytes name.
    fn of(bytes: &[u8]) -> Result<Self, Error> {
        match bytes {
            [0xff, 0xd8, ..] => Ok(Format::Jpeg),
            [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => Ok(Format::Png),
            [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => Ok(Format::Tiff),
            [b'B', b'M', ..] => Ok(Format::Bmp),
            [b'P', b'1'..=b'7', b' ' | b'\t' | b'\r' | b'\n' | b'#', ..] => Ok(Format::Pnm),
            [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Ok(Format::WebP),
            [] => Err(Error::UnreadableImage { reason: "the file is empty".into() }),
            _ => Err(Error::UnsupportedImage { what: "this kind of file".into(), allowed: Format::ALL }),
        }
    }
}

/// Deflate writes at most 258 bytes with two bits, and ends of blocks beside them.
pub(super) const DEFLATE_MOST: u64 = 1032;

/// What a file declares about itself: enough to refuse it before anything is decoded.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FileLayout {
    pub format: Format,
    pub width: u64,
    pub height: u64,
    /// Most bytes a pixel of the decoder's output and of its working memory.
    pub bytes_per_pixel: u64,
    /// Fewest bytes into which the format packs an image of this size, be it as smooth as can be.
    pub least_bytes: u64,
}

impl FileLayout {
    /// Reads the layout; sides are at least 1 px.
    pub fn read(bytes: &[u8]) -> Result<Self, Error> {
        let format = Format::of(bytes)?;
        let layout = match format {
            Format::Jpeg => jpeg::read_header(bytes)?,
            Format::Png => png::read_header(bytes).ok_or_else(|| truncated(format))?,
            Format::Tiff => TiffLayout::read(bytes)?.file_layout(),
            Format::Bmp => bmp(bytes).ok_or_else(|| truncated(format))?,
            Format::Pnm => pnm::read_header(bytes)?,
            Format::WebP => webp::read_header(bytes)?,
        };
        let Self { width, height, .. } = layout;
        if width == 0 || height == 0 {
            return Err(damaged(format, format!("it declares {width} x {height} px; a side has at least 1 px")));
        }
        Ok(layout)
    }

    /// Refuses a file that is too short for the size it declares, before memory is taken for that size.
    pub fn check_length(&self, bytes: &[u8]) -> Result<(), Error> {
        let Self { format, width, height, least_bytes, .. } = *self;
        if (bytes.len() as u64) < least_bytes {
            let length = bytes.len();
            let reason = format!("it is truncated: {width} x {height} px take at least {least_bytes} bytes, and the file has {length}");
            return Err(damaged(format, reason));
        }
        Ok(())
    }
}

/// The error for a file that ends before what it declares.
pub(super) fn truncated(format: Format) -> Error {
    damaged(format, "the file ends before its image does: it is truncated")
}

/// The error for a file that contradicts its format.
pub(super) fn damaged(format: Format, reason: impl std::fmt::Display) -> Error {
    Error::UnreadableImage { reason: format!("{}: {reason}", format.name()) }
}

/// The bytes of a field at a place of the file, where the file reaches that far.
pub(super) fn field<const N: usize>(bytes: &[u8], at: usize) -> Option<[u8; N]> {
    bytes.get(at..)?.first_chunk().copied()
}

/// Reads the core header of a BMP or one of the longer ones.
fn bmp(bytes: &[u8]) -> Option<FileLayout> {
    let short = |at| field(bytes, at).map(|b| u64::from(u16::from_le_bytes(b)));
    let (width, height, bits, compression) = if u32::from_le_bytes(field(bytes, 14)?) == 12 {
        (short(18)?, short(20)?, short(24)?, 0)
    } else {
        // A negative height declares rows from top to bottom. A negative width is invalid: its magnitude is checked like any.
        let [width, height] = [18, 22].map(|at| field(bytes, at).map(|b| u64::from(i32::from_le_bytes(b).unsigned_abs())));
        (width?, height?, short(28)?, u32::from_le_bytes(field(bytes, 30)?))
    };
    let least_bytes = match compression {
        // Runs of two bytes hold up to 255 px. That more is left out by jumps is allowed, but nobody writes photographs like that.
        1 | 2 => width * height * 2 / 255,
        // Rows fill whole words, the last one perhaps not.
        _ => ((width * bits).div_ceil(32) * 4).saturating_mul(height.saturating_sub(1)),
    };
    Some(FileLayout { format: Format::Bmp, width, height, bytes_per_pixel: 4, least_bytes })
}
