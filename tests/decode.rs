//! Decoding of image files: values, limits, hostile input, EXIF. That wasm gives the same is tested in `decode_everywhere.rs`.

#[path = "decode/counted.rs"]
mod counted;
#[path = "decode/headers.rs"]
mod headers;
#[path = "decode/jpeg_writer.rs"]
mod jpeg_writer;
#[path = "decode/samples.rs"]
mod samples;
#[path = "decode/tiff_pictures.rs"]
mod tiff_pictures;
#[path = "decode/tiff_writer.rs"]
mod tiff_writer;

#[path = "decode/exif.rs"]
mod exif;
#[path = "decode/foreign.rs"]
mod foreign;
#[path = "decode/formats.rs"]
mod formats;
#[path = "decode/ground_files.rs"]
mod ground_files;
#[path = "decode/hostile.rs"]
mod hostile;
#[path = "decode/jpeg.rs"]
mod jpeg;
#[path = "decode/limits.rs"]
mod limits;
#[path = "decode/parts.rs"]
mod parts;
#[path = "decode/photographs.rs"]
mod photographs;
#[path = "decode/xmp.rs"]
mod xmp;

use tiepoint::{DecodeLimits, Decoded, Error};

/// Decodes within limits that small files never reach.
fn decode(file: &[u8]) -> Result<Decoded, Error> {
    tiepoint::decode(file, &DecodeLimits::default())
}
