//! TIFF files: the first image, 8 or 16 bits a sample.

mod declared;
mod directory;
mod grid;
mod jpeg_chunk;
mod raster;
mod transparency;

use std::borrow::Cow;
use std::io::Cursor;

use tiff::decoder::{Decoder, DecodingResult};

pub(super) use self::declared::TiffLayout;
use self::declared::{BLACK_IS_ZERO, JPEG, PALETTE, RGB, check_bands, most_decoded, tag, unlimited};
pub(crate) use self::declared::{checked_directory, decoder_error};
pub(crate) use self::directory::Directory;
pub(crate) use self::raster::{Pixels, TiffRaster};
use super::layout::{Format, damaged};
use super::luminance::{SampleLayout, Wanted, bands_of_u8, bands_of_u16};
use crate::{Damage, Error};

/// Decodes to bands; gives the bits of a stored sample as well.
pub(super) fn decode(bytes: &[u8], pixels: usize, wanted: Wanted) -> Result<(Vec<Vec<u8>>, u8), Error> {
    let declared = TiffLayout::read(bytes)?;
    if declared.compression == JPEG {
        let raster = TiffRaster::open(bytes, None, most_decoded(pixels as u64) as usize)?;
        let raster = raster.ok_or_else(|| damaged(Format::Tiff, Damage::OtherThanDirectory))?;
        return Ok((raster.read(0, [0, 0], raster.size(), wanted)?.bands, 8));
    }
    let palette = if declared.photometric == PALETTE { Some(palette_bands(bytes, wanted)?) } else { None };
    let (samples, channels) = read_samples(&as_the_decoder_reads(bytes, &declared), &declared)?;
    let decoded_pixels = (declared.width * declared.decoded_height) as usize;
    let plane_stride = (declared.planar && channels > 1).then_some(decoded_pixels);
    let layout = SampleLayout { channels, colour: declared.photometric == RGB, plane_stride };
    let expected = decoded_pixels.checked_mul(channels);
    match samples {
        DecodingResult::U8(samples) if Some(samples.len()) == expected => {
            let bands = cut(bands_of_u8(samples, decoded_pixels, layout, wanted), pixels);
            let Some(palette) = palette else { return Ok((bands, 8)) };
            let indices = &bands[0];
            Ok((palette.iter().map(|values| indices.iter().map(|index| values[usize::from(*index)]).collect()).collect(), 8))
        }
        DecodingResult::U16(samples) if Some(samples.len()) == expected => {
            Ok((cut(bands_of_u16(&samples, decoded_pixels, layout, wanted), pixels), 16))
        }
        _ => Err(damaged(Format::Tiff, Damage::OtherThanDirectory)),
    }
}

/// The first of so many pixels.
fn cut(mut bands: Vec<Vec<u8>>, pixels: usize) -> Vec<Vec<u8>> {
    bands.iter_mut().for_each(|band| band.truncate(pixels));
    bands
}

/// All samples of the first image and the number of samples a pixel.
fn read_samples(bytes: &[u8], declared: &TiffLayout) -> Result<(DecodingResult, usize), Error> {
    // What the image needs is checked already.
    let mut decoder = Decoder::new(Cursor::new(bytes)).map_err(decoder_error)?.with_limits(unlimited());
    let (width, height) = decoder.dimensions().map_err(decoder_error)?;
    if (u64::from(width), u64::from(height)) != (declared.width, declared.decoded_height) {
        return Err(damaged(Format::Tiff, Damage::TwoDirectorySizes));
    }
    let channels = check_bands(&mut decoder, declared)?;
    let mut samples = DecodingResult::U8(Vec::new());
    decoder.read_image_to_buffer(&mut samples).map_err(decoder_error)?;
    Ok((samples, channels))
}

/// The grey value or the colours of each palette index; the colour map holds 16-bit red, then green, then blue.
fn palette_bands(bytes: &[u8], wanted: Wanted) -> Result<Vec<Vec<u8>>, Error> {
    let map = Directory::first(bytes).and_then(|directory| directory.shorts(tag::COLOUR_MAP, 768));
    let map = map.ok_or_else(|| damaged(Format::Tiff, Damage::ColourMap))?;
    Ok(bands_of_u16(&map, 256, SampleLayout { channels: 3, colour: true, plane_stride: Some(256) }, wanted))
}

/// The file with some declarations put in the words of the decoder.
///
/// It takes palette indices for what they are only if they are called grey, the lowest tiles of planes for whole ones, and a strip of more rows than the image has, as
/// writers declare for 'all rows', overflows where addresses have 32 bits.
fn as_the_decoder_reads<'a>(bytes: &'a [u8], declared: &TiffLayout) -> Cow<'a, [u8]> {
    let Some(directory) = Directory::first(bytes) else {
        return bytes.into();
    };
    let palette = (declared.photometric == PALETTE).then_some((tag::PHOTOMETRIC, BLACK_IS_ZERO));
    let height = (declared.decoded_height != declared.height).then_some((tag::HEIGHT, declared.decoded_height));
    let mut file = with_rows_of_image(bytes);
    for (tag, value) in palette.into_iter().chain(height) {
        if let Some((at, encoded)) = directory.encoded(tag, value) {
            file.to_mut()[at..at + encoded.len()].copy_from_slice(&encoded);
        }
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
