//! What an image file declares about itself.

use crate::{Damage, Error, ImageFault};

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
    /// Refuses a file that is too short for the size it declares, before memory is taken for that size.
    pub fn check_length(&self, bytes: &[u8]) -> Result<(), Error> {
        let Self { format, width, height, least_bytes, .. } = *self;
        if (bytes.len() as u64) < least_bytes {
            return Err(damaged(format, Damage::TooShort { width, height, least_bytes, bytes: bytes.len() }));
        }
        Ok(())
    }
}

/// The error for a file that ends before what it declares.
pub(super) fn truncated(format: Format) -> Error {
    damaged(format, Damage::Truncated)
}

/// The error for a file that contradicts its format.
pub(super) fn damaged(format: Format, damage: Damage) -> Error {
    Error::UnreadableImage { image_fault: ImageFault::Damaged { format: format.name().into(), damage } }
}

/// The same, as the library says it that decodes the format.
pub(super) fn undecodable(format: Format, words: impl std::fmt::Display) -> Error {
    damaged(format, Damage::Decoder { words: words.to_string() })
}

/// The bytes of a field at a place of the file, where the file reaches that far.
pub(super) fn field<const N: usize>(bytes: &[u8], at: usize) -> Option<[u8; N]> {
    bytes.get(at..)?.first_chunk().copied()
}
