//! The decoder of a checked stream.

use crate::image::layout::{Format, damaged, undecodable};
use crate::{Damage, Error};
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::{bytestream::ZCursor, colorspace::ColorSpace, options::DecoderOptions};

/// So many samples of a checked stream.
pub(super) fn decoded(stream: Vec<u8>, colours: ColorSpace, number: usize) -> Result<Vec<u8>, Error> {
    // Without the processor's own instructions the decoder computes the same everywhere; luma is not slower for it.
    let options = DecoderOptions::new_safe()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX))
        .jpeg_set_out_colorspace(colours);
    let samples = JpegDecoder::new_with_options(ZCursor::new(stream), options).decode().map_err(|e| undecodable(Format::Jpeg, e))?;
    if samples.len() != number {
        return Err(damaged(Format::Jpeg, Damage::OtherThanHeader));
    }
    Ok(samples)
}
