//! JPEG files: the marker structure is checked here, the entropy-coded data by the decoder.
//!
//! The decoder gets a stream that is written anew from the checked segments. What it would not notice is noticed here: a file
//! that ends early, or scan data that do.

mod apart;
mod decoder;
mod frame;
mod scan;
mod segments;
mod stream;

use zune_jpeg::zune_core::colorspace::ColorSpace;

use self::decoder::decoded;
use self::frame::Frame;
use self::segments::{Segments, marker};
use self::stream::{CheckedStream, Output};
use super::layout::{FileLayout, Format, damaged};
use super::luminance::{SampleLayout, Wanted, bands_of_u8};
use crate::{Damage, Error, Unsupported};

/// Reads the layout from the frame header.
pub(super) fn read_header(bytes: &[u8]) -> Result<FileLayout, Error> {
    let mut segments = Segments::of(bytes);
    loop {
        let segment = segments.next()?;
        if segment.is_frame() {
            return Ok(Frame::read(&segment)?.layout());
        }
        if matches!(segment.marker, marker::SOS | marker::EOI) {
            return Err(damaged(Format::Jpeg, Damage::NoFrameHeader));
        }
    }
}

/// Decodes to grey, the stored luma or the luma of stored colour, or to colours.
pub(super) fn decode(bytes: &[u8], pixels: usize, wanted: Wanted) -> Result<Vec<Vec<u8>>, Error> {
    let file = CheckedStream::read(bytes)?;
    if file.output == Output::RgbApart {
        let Some(planes) = apart::stored(bytes)? else { return Err(Unsupported::JpegRgbApart.into_error()) };
        let layout = SampleLayout { channels: 3, colour: true, plane_stride: Some(pixels) };
        return Ok(bands_of_u8(planes.concat(), pixels, layout, wanted));
    }
    // Of scans of single components the checked stream has that of luma.
    if wanted == Wanted::Colours
        && !file.has_colours
        && let Some(bands) = apart::colours(bytes)?
    {
        return Ok(bands);
    }
    let in_colours = wanted == Wanted::Colours && file.has_colours;
    let (colours, channels) = match file.output {
        Output::Rgb | Output::RgbApart => (ColorSpace::RGB, 3),
        _ if in_colours => (ColorSpace::RGB, 3),
        Output::Luma => (ColorSpace::Luma, 1),
        Output::LumaAndChroma => (ColorSpace::YCbCr, 3),
    };
    let samples = decoded(file.bytes, colours, pixels * channels)?;
    let layout = SampleLayout { channels, colour: colours == ColorSpace::RGB, plane_stride: None };
    Ok(bands_of_u8(samples, pixels, layout, wanted))
}
