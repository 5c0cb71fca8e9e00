//! Image files to grey images, or to their colours, within limits that are checked in the header before anything is decoded.

use std::io::Cursor;

use image::codecs::{bmp::BmpDecoder, pnm::PnmDecoder, webp::WebPDecoder};
use image::{ColorType, ImageDecoder, ImageError};

use super::bands::Bands;
use super::grey::GreyImage;
use super::header::read_layout;
use super::layout::{FileLayout, Format, damaged, truncated, undecodable};
use super::luminance::{SampleLayout, Wanted, bands_of_u8, bands_of_u16};
use super::{jpeg, png, tiff};
use crate::camera::{DroneRecord, ExifCamera, ExifImage};
use crate::{Damage, Error, Unsupported};

/// What a file may ask for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecodeLimits {
    /// Largest number of pixels a file may declare.
    pub max_pixels: u64,
    /// Most memory that decoding may need, in bytes.
    pub max_memory_bytes: u64,
}

impl Default for DecodeLimits {
    fn default() -> Self {
        Self { max_pixels: 250_000_000, max_memory_bytes: 3 << 30 }
    }
}

/// A decoded file.
#[derive(Debug, Clone)]
pub struct Decoded {
    pub grey: GreyImage,
    pub format: &'static str,
    /// Bits a sample held in the file: 8 or 16.
    pub bits_per_sample: u8,
    /// The camera, where the file's EXIF or XMP names its focal length.
    pub camera: Option<ExifCamera>,
    /// What the drone recorded that took it.
    pub drone: Option<Box<DroneRecord>>,
}

/// Decodes a JPEG, PNG, TIFF, BMP, PNM or WebP file to grey values 0..255.
///
/// The pixel grid is the stored one: EXIF orientation is not applied, since coordinates are measured in the stored image. Grey is the
/// stored luma of a JPEG, else the luma of Rec. 601; alpha is ignored. Samples of 16 bits are stretched from the depth in use, 8 to 16
/// bits, to 0..255. Of a TIFF with several images, the first is taken. The result is the same to the last bit on every machine.
///
/// # Errors
/// [`Error::TooManyPixels`] and [`Error::TooMuchMemory`], from the header alone; [`Error::UnsupportedImage`] for formats and pixel types
/// that are not decoded, such as CMYK and floating point; [`Error::UnreadableImage`] for damaged and truncated files.
pub fn decode(bytes: &[u8], limits: &DecodeLimits) -> Result<Decoded, Error> {
    let layout = read_layout(bytes)?;
    let (bands, bits_per_sample) = decode_to(Wanted::Grey, &layout, bytes, limits)?;
    let ExifImage { camera, drone, .. } = ExifImage::read(bytes, layout.width, layout.height);
    let grey = bands.into_first();
    Ok(Decoded { grey, format: layout.format.name(), bits_per_sample, camera, drone })
}

/// Decodes the same files to red, green and blue, or to grey where they have no colours. Bands beyond these are left out, samples of 16 bits are
/// stretched as for grey, all colours alike.
///
/// # Errors
/// As [`decode`].
pub fn decode_bands(bytes: &[u8], limits: &DecodeLimits) -> Result<Bands, Error> {
    decode_to(Wanted::Colours, &read_layout(bytes)?, bytes, limits).map(|(bands, _)| bands)
}

/// Gives the bits of a stored sample as well.
fn decode_to(wanted: Wanted, layout: &FileLayout, bytes: &[u8], limits: &DecodeLimits) -> Result<(Bands, u8), Error> {
    check_limits(layout, bytes, limits, wanted)?;
    let pixels = (layout.width * layout.height) as usize;
    let (values, bits) = match layout.format {
        Format::Jpeg => (jpeg::decode(bytes, pixels, wanted)?, 8),
        Format::Tiff => tiff::decode(bytes, pixels, wanted)?,
        Format::Png => png::decode(bytes, pixels, wanted)?,
        Format::Bmp => decode_with(BmpDecoder::new(Cursor::new(bytes)), layout, limits, wanted)?,
        Format::Pnm => decode_with(PnmDecoder::new(Cursor::new(bytes)), layout, limits, wanted)?,
        Format::WebP => decode_with(WebPDecoder::new(Cursor::new(bytes)), layout, limits, wanted)?,
    };
    Ok((Bands::of([layout.width as usize, layout.height as usize], values)?, bits))
}

/// Refuses what the header declares too large, what is too short for that, or what the machine does not have.
fn check_limits(layout: &FileLayout, bytes: &[u8], limits: &DecodeLimits, wanted: Wanted) -> Result<(), Error> {
    let FileLayout { width, height, .. } = *layout;
    let pixels = width.saturating_mul(height);
    if pixels > limits.max_pixels {
        let [megapixels, max_megapixels] = [width as f64 * height as f64, limits.max_pixels as f64].map(|n| n / 1e6);
        return Err(Error::TooManyPixels { width, height, megapixels, max_megapixels });
    }
    // The decoder's output and working memory, and the grey values or colours; no single block is larger than addresses allow.
    let output = pixels.saturating_mul(layout.bytes_per_pixel);
    let bands = if wanted == Wanted::Colours { 3 } else { 1 };
    let needed = output.saturating_add(pixels.saturating_mul(bands));
    let largest_block = isize::MAX as u64;
    let mut allowed = if output > largest_block { largest_block } else { u64::MAX };
    allowed = allowed.min(limits.max_memory_bytes);
    if needed <= allowed {
        layout.check_length(bytes)?;
        allowed = reservable(needed);
    }
    if needed > allowed { Err(too_much(width, height, needed, allowed)) } else { Ok(()) }
}

fn too_much(width: u64, height: u64, needed: u64, allowed: u64) -> Error {
    Error::TooMuchMemory { width, height, needed_mb: needed.div_ceil(1 << 20), max_mb: allowed >> 20 }
}

impl GreyImage {
    /// Refuses an image of this width and height whose grey values, so many bytes, need more memory than can be had now.
    ///
    /// # Errors
    /// [`Error::TooMuchMemory`].
    pub fn check_memory([width, height]: [usize; 2], bytes: u64) -> Result<(), Error> {
        let largest_block = isize::MAX as u64;
        let allowed = if bytes > largest_block { largest_block } else { reservable(bytes) };
        if bytes > allowed { Err(too_much(width as u64, height as u64, bytes, allowed)) } else { Ok(()) }
    }
}

/// How much of this memory can be had now: it is reserved in blocks and given back, but not touched.
fn reservable(bytes: u64) -> u64 {
    const BLOCK: u64 = 256 << 20;
    let (mut blocks, mut reserved) = (Vec::new(), 0);
    while reserved < bytes {
        let mut block = Vec::<u8>::new();
        let length = BLOCK.min(bytes - reserved);
        if block.try_reserve_exact(length as usize).is_err() {
            break;
        }
        blocks.push(block);
        reserved += length;
    }
    // Otherwise the compiler may leave out memory that nobody looks at.
    std::hint::black_box(&blocks);
    reserved
}

fn image_limits(limits: &DecodeLimits) -> image::Limits {
    let mut image_limits = image::Limits::no_limits();
    image_limits.max_alloc = Some(limits.max_memory_bytes);
    image_limits
}

/// Decodes with a decoder of the crate `image`; gives the bands and the bits of a stored sample.
fn decode_with<D: ImageDecoder>(
    decoder: Result<D, ImageError>,
    layout: &FileLayout,
    limits: &DecodeLimits,
    wanted: Wanted,
) -> Result<(Vec<Vec<u8>>, u8), Error> {
    let format = layout.format;
    let error = |e| decoder_error(e, layout, limits);
    let mut decoder = decoder.map_err(error)?;
    decoder.set_limits(image_limits(limits)).map_err(error)?;
    let (width, height) = decoder.dimensions();
    if (u64::from(width), u64::from(height)) != (layout.width, layout.height) {
        return Err(damaged(format, Damage::TwoSizes));
    }
    let colour = decoder.color_type();
    let mut bytes = vec![0; decoder.total_bytes() as usize];
    decoder.read_image(&mut bytes).map_err(error)?;
    let samples = SampleLayout::interleaved(usize::from(colour.channel_count()));
    let pixels = width as usize * height as usize;
    match colour {
        ColorType::L8 | ColorType::La8 | ColorType::Rgb8 | ColorType::Rgba8 => Ok((bands_of_u8(bytes, pixels, samples, wanted), 8)),
        ColorType::L16 | ColorType::La16 | ColorType::Rgb16 | ColorType::Rgba16 => {
            Ok((bands_of_u16(bytes.as_chunks::<2>().0, pixels, samples, wanted), 16))
        }
        other => Err(Unsupported::Samples { format: format.name().into(), samples: format!("{other:?}") }.into_error()),
    }
}

fn decoder_error(error: ImageError, layout: &FileLayout, limits: &DecodeLimits) -> Error {
    let format = layout.format;
    match error {
        ImageError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => truncated(format),
        ImageError::Unsupported(e) => {
            Unsupported::Decoder { format: format.name().into(), words: e.to_string(), formats: Format::ALL }.into_error()
        }
        ImageError::Limits(_) => {
            let max_mb = limits.max_memory_bytes >> 20;
            Error::TooMuchMemory { width: layout.width, height: layout.height, needed_mb: max_mb + 1, max_mb }
        }
        e => undecodable(format, e),
    }
}
