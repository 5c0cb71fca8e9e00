//! Tiles and strips that are JPEG files without their tables, which stand once for all.

use super::declared::{RGB, TiffLayout, tag};
use super::directory::Directory;
use super::grid::Grid;
use crate::image::jpeg;
use crate::image::layout::{Format, damaged};
use crate::image::luminance::Wanted;
use crate::source::FileSource;
use crate::{Damage, Error};

/// Rows of the largest block of a JPEG file.
const BLOCK: u64 = 32;
const START: [u8; 2] = [0xff, 0xd8];
const END: [u8; 2] = [0xff, 0xd9];
/// An Adobe segment that says: three components are red, green and blue.
const STORES_RGB: [u8; 16] = [0xff, 0xee, 0, 14, b'A', b'd', b'o', b'b', b'e', 0, 100, 0, 0, 0, 0, 0];

/// What the tiles or strips of a picture share.
pub(super) struct JpegChunks<S> {
    source: S,
    /// The tables as a beginning of each.
    start: Vec<u8>,
}

impl<S: FileSource> JpegChunks<S> {
    pub fn new(source: S, directory: &Directory<S>, layout: &TiffLayout) -> Self {
        let tables = directory.bytes(tag::JPEG_TABLES).unwrap_or_default();
        let body = tables.strip_prefix(&START).map(|body| body.strip_suffix(&END).unwrap_or(body));
        let colours: &[u8] = if layout.photometric == RGB { &STORES_RGB } else { &[] };
        let start = [&START, colours, body.unwrap_or_default()].concat();
        Self { source, start }
    }

    /// The bands of one.
    pub fn decode(&self, grid: &Grid, index: usize, wanted: Wanted) -> Result<Vec<Vec<u8>>, Error> {
        let contradicts = || damaged(Format::Tiff, Damage::OtherThanDirectory);
        let stream = grid.bytes(&self.source, index)?;
        let own = stream.strip_prefix(&START).ok_or_else(contradicts)?;
        let file = [&self.start, own].concat();
        let header = jpeg::read_header(&file)?;
        let ([width, height], [across, down]) = (grid.sides(index), grid.chunk.map(|side| side as u64));
        // Writers may count whole blocks of a strip.
        if header.width != across || header.height < height as u64 || header.height > down.next_multiple_of(BLOCK) {
            return Err(contradicts());
        }
        header.check_length(&file)?;
        let bands = jpeg::decode(&file, (header.width * header.height) as usize, wanted)?;
        let shown = |band: &Vec<u8>| band.chunks_exact(grid.chunk[0]).take(height).flat_map(|row| &row[..width]).copied().collect();
        Ok(bands.iter().map(shown).collect())
    }
}
