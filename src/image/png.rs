//! PNG files.

use std::io::Cursor;

use png::{BitDepth, Decoder, DecodingError, Limits, Transformations};

use super::layout::{DEFLATE_MOST, FileLayout, Format, damaged, field, truncated, undecodable};
use super::luminance::{SampleLayout, Wanted, bands_of_u8, bands_of_u16};
use crate::{Damage, Error};

/// Reads the IHDR chunk, which the format puts first.
pub(super) fn read_header(bytes: &[u8]) -> Option<FileLayout> {
    let [width, height] = [16, 20].map(|at| field(bytes, at).map(u32::from_be_bytes));
    let (width, height) = (u64::from(width?), u64::from(height?));
    let [depth, colour_type] = field(bytes, 24)?;
    let samples = match colour_type {
        2 => 3,
        4 => 2,
        6 => 4,
        _ => 1,
    };
    // A row begins with the kind of its filter.
    let row = 1 + (width * samples * u64::from(depth)).div_ceil(8);
    // A tRNS chunk may add alpha to each colour type that has none.
    let channels = if colour_type == 0 { 2 } else { 4 };
    let bytes_per_pixel = channels * if depth == 16 { 2 } else { 1 };
    Some(FileLayout { format: Format::Png, width, height, bytes_per_pixel, least_bytes: row.saturating_mul(height) / DEFLATE_MOST })
}

/// Decodes to bands; gives the bits of a stored sample as well. Profiles and texts, which may inflate to gigabytes, are passed over.
pub(super) fn decode(bytes: &[u8], pixels: usize, wanted: Wanted) -> Result<(Vec<Vec<u8>>, u8), Error> {
    // The decoder counts what it holds beside the image: the EXIF, in a block that grows by doubling, and a row of at most 8 bytes a pixel.
    let limits = Limits { bytes: bytes.len().saturating_mul(2).saturating_add(pixels.saturating_mul(8)).saturating_add(1 << 16) };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(decoder_error)?;
    let (colour, depth) = reader.output_color_type();
    let size = reader.output_buffer_size().ok_or_else(|| damaged(Format::Png, Damage::BeyondAddresses))?;
    let mut samples = vec![0; size];
    reader.next_frame(&mut samples).map_err(decoder_error)?;
    let layout = SampleLayout::interleaved(colour.samples());
    if depth != BitDepth::Sixteen {
        return Ok((bands_of_u8(samples, pixels, layout, wanted), 8));
    }
    let (samples, _) = samples.as_chunks_mut::<2>();
    samples.iter_mut().for_each(|sample| *sample = u16::from_be_bytes(*sample).to_ne_bytes());
    Ok((bands_of_u16(samples, pixels, layout, wanted), 16))
}

fn decoder_error(error: DecodingError) -> Error {
    match error {
        DecodingError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => truncated(Format::Png),
        e => undecodable(Format::Png, e),
    }
}
