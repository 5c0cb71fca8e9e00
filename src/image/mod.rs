//! Grey images and colours: the raster, its view, decoding of files, reduction.

mod bands;
mod bicubic;
mod bmp;
mod decode;
mod foreign;
mod grey;
mod header;
mod jpeg;
mod kept;
mod layout;
mod luminance;
mod png;
mod pnm;
mod pyramid;
mod squares;
mod tiff;
mod webp;
mod write;

pub use bands::Bands;
pub(crate) use bicubic::Neighbours;
pub use decode::{DecodeLimits, Decoded, decode, decode_bands};
pub use grey::{GreyImage, GreyView};
pub(crate) use header::is_tiff;
pub use header::{Header, read_header, refused_kind};
pub(crate) use kept::Kept;
pub(crate) use luminance::Wanted;
pub use pyramid::{Reduced, halve, reduce_to};
pub(crate) use squares::each_position;
pub(crate) use tiff::{Chunks, Directory, Pixels, TiffRaster, checked_directory};
pub use write::{write_bands, write_png};
