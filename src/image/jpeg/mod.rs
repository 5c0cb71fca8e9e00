//! JPEG files: the marker structure is checked here, the entropy-coded data by the decoder.
//!
//! The decoder gets a stream that is written anew from the checked segments. What it would not notice is noticed here: a file
//! that ends early, or scan data that do.

mod frame;
mod scan;
mod segments;
mod stream;

use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::{bytestream::ZCursor, colorspace::ColorSpace, options::DecoderOptions};

use self::frame::Frame;
use self::segments::{Segments, marker};
use self::stream::{CheckedStream, Output};
use super::layout::{FileLayout, Format, damaged, undecodable};
use super::luminance::{SampleLayout, Wanted, bands_of_u8};
use crate::{Damage, Error};

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
    let in_colours = wanted == Wanted::Colours && file.has_colours;
    let (colours, channels) = match file.output {
        Output::Rgb => (ColorSpace::RGB, 3),
        _ if in_colours => (ColorSpace::RGB, 3),
        Output::Luma => (ColorSpace::Luma, 1),
        Output::LumaAndChroma => (ColorSpace::YCbCr, 3),
    };
    // Without the processor's own instructions the decoder computes the same everywhere; luma is not slower for it.
    let options = DecoderOptions::new_safe()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX))
        .jpeg_set_out_colorspace(colours);
    let samples = JpegDecoder::new_with_options(ZCursor::new(file.bytes), options).decode().map_err(|e| undecodable(Format::Jpeg, e))?;
    if samples.len() != pixels * channels {
        return Err(damaged(Format::Jpeg, Damage::OtherThanHeader));
    }
    let layout = SampleLayout { channels, colour: colours == ColorSpace::RGB, plane_stride: None };
    Ok(bands_of_u8(samples, pixels, layout, wanted))
}
