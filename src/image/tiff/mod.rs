//! TIFF files: the first image, 8 or 16 bits a sample.

mod chunks;
mod corrected;
mod declared;
mod directory;
mod grid;
mod jpeg_chunk;
mod raster;
mod transparency;

use tiff::decoder::{Decoder, DecodingResult};

pub(crate) use self::chunks::Chunks;
use self::corrected::Corrected;
pub(super) use self::declared::TiffLayout;
use self::declared::{BLACK_IS_ZERO, JPEG, PALETTE, RGB, check_bands, most_decoded, tag, unlimited};
pub(crate) use self::declared::{checked_directory, decoder_error};
pub(crate) use self::directory::Directory;
pub(crate) use self::raster::{Pixels, TiffRaster};
use super::layout::{Format, damaged};
use super::luminance::{SampleLayout, Wanted, bands_of_u8, bands_of_u16};
use crate::source::{FileSource, SourceReader};
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
    let (samples, channels) = read_samples(as_the_decoder_reads(bytes, &declared), &declared)?;
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
fn read_samples(file: impl FileSource, declared: &TiffLayout) -> Result<(DecodingResult, usize), Error> {
    // What the image needs is checked already.
    let mut decoder = Decoder::new(SourceReader::new(file)).map_err(decoder_error)?.with_limits(unlimited());
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

/// It takes palette indices for what they are only if they are called grey, and the lowest tiles of planes for whole ones.
fn as_the_decoder_reads<'a>(bytes: &'a [u8], declared: &TiffLayout) -> Corrected<&'a [u8]> {
    let mut file = Corrected::rows_of_image(bytes);
    if declared.photometric == PALETTE {
        file.set(tag::PHOTOMETRIC, BLACK_IS_ZERO);
    }
    if declared.decoded_height != declared.height {
        file.set(tag::HEIGHT, declared.decoded_height);
    }
    file
}
