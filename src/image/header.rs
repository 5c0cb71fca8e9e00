//! What the first bytes of an image file declare, read without decoding.

use super::layout::{FileLayout, Format, damaged, truncated};
use super::tiff::TiffLayout;
use super::{bmp, foreign, jpeg, png, pnm, webp};
use crate::source::FileSource;
use crate::{Damage, Error, FileKind, ImageFault, Unsupported};

/// What the first bytes of a file tell.
#[derive(Debug, Clone, PartialEq)]
pub struct Header {
    /// `JPEG`, `PNG`, `TIFF`, `BMP`, `PNM` or `WebP`.
    pub format: &'static str,
    pub width: u64,
    pub height: u64,
}

/// Reads format and size without decoding. A TIFF keeps them in its directory, wherever that lies; the others in their first bytes.
///
/// # Errors
/// [`Error::UnsupportedImage`] for what is not decoded as far as the header tells; [`Error::UnreadableImage`] for a header that is
/// cut off or contradicts itself, or a side of 0 px.
pub fn read_header(bytes: &[u8]) -> Result<Header, Error> {
    let FileLayout { format, width, height, .. } = read_layout(bytes)?;
    Ok(Header { format: format.name(), width, height })
}

/// Why a file is refused whose first bytes, or the ending of whose name where these say nothing, are those of a kind that is not decoded; absent for all others.
///
/// `start`: the first bytes of the file. 64 tell every kind but raw files that are TIFFs: these are told where their first directory is among the bytes, and
/// declares what is not decoded, or a preview. One whose first image is a picture that is decoded is none of these, whatever its name.
pub fn refused_kind(name: &str, start: &[u8]) -> Option<Error> {
    if start.is_empty() {
        return None;
    }
    let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase()).unwrap_or_default();
    let kind = match format_of(start) {
        Ok(Format::Tiff) => {
            let is_refused = matches!(TiffLayout::read(start), Err(Error::UnsupportedImage { .. }));
            let of_samples = || is_refused.then(|| foreign::raw_tiff(start).or_else(|| foreign::raw_by_ending(&ending))).flatten();
            foreign::raw_with_preview(start).or_else(of_samples)
        }
        Ok(_) => None,
        Err(_) => {
            let is_meant = |kind: &FileKind| *kind != FileKind::Archive || !foreign::is_zipped_document(&ending);
            foreign::by_content(start).filter(is_meant).or_else(|| foreign::by_ending(&ending))
        }
    };
    kind.map(foreign::refused)
}

/// Whether the first bytes of a file are those of a TIFF.
pub(crate) fn is_tiff(source: &dyn FileSource) -> bool {
    let mut start = [0; 4];
    source.read_at(0, &mut start).is_ok() && matches!(format_of(&start), Ok(Format::Tiff))
}

/// Reads the layout; sides are at least 1 px.
pub(super) fn read_layout(bytes: &[u8]) -> Result<FileLayout, Error> {
    let format = format_of(bytes)?;
    let layout = match format {
        Format::Jpeg => jpeg::read_header(bytes)?,
        Format::Png => png::read_header(bytes).ok_or_else(|| truncated(format))?,
        Format::Tiff => match foreign::raw_with_preview(bytes) {
            Some(raw) => return Err(foreign::refused(raw)),
            None => TiffLayout::read(bytes).map_err(|error| of_tiff(error, bytes))?.file_layout(),
        },
        Format::Bmp => bmp::read_header(bytes).ok_or_else(|| truncated(format))?,
        Format::Pnm => pnm::read_header(bytes)?,
        Format::WebP => webp::read_header(bytes)?,
    };
    let FileLayout { width, height, .. } = layout;
    if width == 0 || height == 0 {
        return Err(damaged(format, Damage::NoPixels { width, height }));
    }
    Ok(layout)
}

/// Why a TIFF is refused: what a raw file of a camera declares says less than that it is one.
fn of_tiff(error: Error, bytes: &[u8]) -> Error {
    match error {
        Error::UnsupportedImage { .. } => foreign::raw_tiff(bytes).map_or(error, foreign::refused),
        damaged => damaged,
    }
}

/// The format that the first bytes name.
fn format_of(bytes: &[u8]) -> Result<Format, Error> {
    match bytes {
        [0xff, 0xd8, ..] => Ok(Format::Jpeg),
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => Ok(Format::Png),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => Ok(Format::Tiff),
        [b'B', b'M', ..] => Ok(Format::Bmp),
        [b'P', b'1'..=b'7', b' ' | b'\t' | b'\r' | b'\n' | b'#', ..] => Ok(Format::Pnm),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Ok(Format::WebP),
        [] => Err(Error::UnreadableImage { image_fault: ImageFault::Empty }),
        _ => Err(foreign::by_content(bytes).map_or_else(|| Unsupported::File { formats: Format::ALL }.into_error(), foreign::refused)),
    }
}
