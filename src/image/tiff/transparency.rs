//! A picture of one bit that says where another one shows something (a transparency mask).

use super::declared::{DEFLATE, OLD_DEFLATE, TiffLayout, tag};
use super::directory::Directory;
use super::grid::Grid;
use crate::Error;
use crate::image::layout::{Format, truncated};
use crate::source::FileSource;
use flate2::read::ZlibDecoder;
use std::io::Read;

const NONE: u64 = 1;

/// Where it is in the file.
#[derive(Clone)]
pub(super) struct Transparency<S> {
    source: S,
    pub grid: Grid,
    is_packed: bool,
}

impl<S: FileSource + Clone> Transparency<S> {
    /// Absent where it is packed otherwise than any writer packs it.
    pub fn of(source: &S, directory: &Directory<S>, most_px: usize) -> Option<Self> {
        let value = |tag: u64| directory.value(tag).unwrap_or(1);
        let [compression, predictor] = [tag::COMPRESSION, tag::PREDICTOR].map(value);
        let is_one_bit = [tag::BITS, tag::SAMPLES, tag::FILL_ORDER].iter().all(|tag| value(*tag) == 1);
        if !is_one_bit || predictor != 1 || !matches!(compression, NONE | DEFLATE | OLD_DEFLATE) {
            return None;
        }
        let grid = Grid::of(directory, &TiffLayout::unchecked(directory).ok()?, most_px, false).ok()??;
        Some(Self { source: source.clone(), grid, is_packed: compression != NONE })
    }

    /// Which pixels of a tile or strip show nothing.
    pub fn nothing(&self, index: usize) -> Result<Vec<bool>, Error> {
        let [width, height] = self.grid.sides(index);
        if !self.grid.holds(index) {
            return Ok(vec![true; width * height]);
        }
        // Rows begin with a byte of their own.
        let stride = self.grid.chunk[0].div_ceil(8);
        let mut bits = self.grid.bytes(&self.source, index)?;
        if self.is_packed {
            let mut all = Vec::new();
            let most = (stride * self.grid.chunk[1]) as u64;
            ZlibDecoder::new(&bits[..]).take(most).read_to_end(&mut all).map_err(|_| truncated(Format::Tiff))?;
            bits = all;
        }
        if bits.len() < stride * height {
            return Err(truncated(Format::Tiff));
        }
        let is_set = |column: usize, row: usize| bits[row * stride + column / 8] << (column % 8) & 0x80 != 0;
        Ok((0..width * height).map(|k| !is_set(k % width, k / width)).collect())
    }
}
