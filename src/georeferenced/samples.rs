//! The numbers of a TIFF that is no picture: heights of the ground, or of a geoid.

use crate::error::refuse;
use crate::image::{tiff_error, with_rows_of_image};
use crate::{Error, Refusal};
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult, Limits};

/// Most values that a byte of a TIFF stands for.
const MOST_PACKED: usize = 2560;
/// Most values of a grid.
pub(crate) const MOST_VALUES: usize = 100_000_000;

/// Width, height and the numbers of the first image, row by row; `file` was checked by [`checked_directory`](crate::image::checked_directory).
///
/// # Errors
/// [`Error::InvalidInput`] for a truncated file, too many numbers and samples of another kind; [`Error::UnreadableImage`] for a damaged one.
pub(crate) fn numbers_of_tiff(file: &[u8]) -> Result<(usize, usize, Vec<f32>), Error> {
    let file = &*with_rows_of_image(file);
    // What the numbers need is checked below.
    let mut decoder = Decoder::new(Cursor::new(file)).map_err(tiff_error)?.with_limits(Limits::unlimited());
    let (width, height) = decoder.dimensions().map_err(tiff_error)?;
    let [width, height] = [width, height].map(|side| side as usize);
    // No compression that is read packs more.
    if width.saturating_mul(height) / MOST_PACKED > file.len() {
        return refuse(Refusal::TruncatedHeights { width, height, bytes: file.len() });
    }
    if width.saturating_mul(height) > MOST_VALUES {
        return refuse(Refusal::ManyHeights { width, height });
    }
    let values: Vec<f32> = match decoder.read_image().map_err(tiff_error)? {
        DecodingResult::F32(values) => values,
        DecodingResult::F64(values) => values.into_iter().map(|v| v as f32).collect(),
        DecodingResult::I16(values) => values.into_iter().map(f32::from).collect(),
        DecodingResult::U16(values) => values.into_iter().map(f32::from).collect(),
        DecodingResult::U8(values) => values.into_iter().map(f32::from).collect(),
        DecodingResult::I32(values) => values.into_iter().map(|v| v as f32).collect(),
        _ => {
            return refuse(Refusal::HeightSamples);
        }
    };
    Ok((width, height, values))
}
