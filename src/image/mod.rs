//! Grey images: the raster, its view, decoding of files, reduction.

mod decode;
mod grey;
mod header;
mod jpeg;
mod luminance;
mod png;
mod pnm;
mod pyramid;
mod tiff;
mod webp;
mod write;

pub use decode::{DecodeLimits, Decoded, Header, decode, read_header};
pub use grey::{GreyImage, GreyView};
pub use pyramid::{Reduced, halve, reduce_to};
pub use write::write_png;
