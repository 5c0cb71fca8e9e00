//! The tiles or strips of a picture.

use super::declared::{TiffLayout, tag};
use super::directory::Directory;
use crate::image::layout::{Format, damaged, truncated, undecodable};
use crate::source::FileSource;
use crate::{Damage, Error};
use std::ops::Range;

/// No tile or strip of a picture that is read in parts has more bytes, packed or not.
const MOST_BYTES: u64 = 1 << 28;

/// How a picture is cut into tiles or strips, and where these are in the file.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    /// Of the picture, in px.
    pub size: [usize; 2],
    /// Of a tile; strips are as wide as the picture.
    pub chunk: [usize; 2],
    pub across: usize,
    offsets: Vec<u64>,
    lengths: Vec<u64>,
}

/// Where a tile or strip meets a part of the picture.
pub(crate) struct Piece {
    pub index: usize,
    /// The column and row of the picture at which the tile or strip begins, and how long its rows are within the picture.
    pub corner: [usize; 2],
    pub stride: usize,
    /// Columns and rows of the picture that both have.
    pub columns: Range<usize>,
    pub rows: Range<usize>,
}

impl Grid {
    /// As a directory says it. Absent where a tile or strip has more than `most_px`, or where its pixels take much memory. `by_library`: whether the library
    /// decodes them.
    pub fn of<S: FileSource>(
        directory: &Directory<S>,
        layout: &TiffLayout,
        most_px: usize,
        by_library: bool,
    ) -> Result<Option<Self>, Error> {
        let size = [layout.width, layout.height].map(|side| usize::try_from(side).unwrap_or(0));
        let tile = [tag::TILE_WIDTH, tag::TILE_HEIGHT].map(|tag| directory.value(tag).map(|side| side as usize));
        let [offsets_tag, lengths_tag] = tag::OF_CHUNKS.as_chunks::<2>().0[usize::from(tile[0].is_some())];
        let rows = directory.value(tag::ROWS_PER_STRIP).unwrap_or(layout.height);
        let chunk = match tile {
            [Some(width), Some(height)] => [width, height],
            _ => [size[0], usize::try_from(rows.min(layout.height)).unwrap_or(0)],
        };
        if chunk.contains(&0) || size.contains(&0) {
            return Err(damaged(Format::Tiff, Damage::OtherThanDirectory));
        }
        // Where addresses have 32 bits the library cannot read strips of more rows than the picture has.
        let is_beyond = by_library && tile[0].is_none() && rows > layout.height;
        let pixels = chunk[0].saturating_mul(chunk[1]);
        let bytes = (pixels as u64).saturating_mul(layout.samples).saturating_mul(layout.bits.div_ceil(8));
        if is_beyond || pixels > most_px || by_library && bytes > MOST_BYTES {
            return Ok(None);
        }
        let [offsets, lengths] = [offsets_tag, lengths_tag].map(|tag| directory.numbers(tag).unwrap_or_default());
        let across = size[0].div_ceil(chunk[0]);
        let grid = Self { size, chunk, across, offsets, lengths };
        let planes = if layout.planar { usize::try_from(layout.samples).unwrap_or(usize::MAX) } else { 1 };
        if grid.lengths.len() != grid.offsets.len() || grid.lengths.len() < grid.number().saturating_mul(planes) {
            return Err(damaged(Format::Tiff, Damage::OtherThanDirectory));
        }
        // A file that ends early is refused at once, not where somebody looks at its end.
        let ends = grid.offsets.iter().zip(&grid.lengths).map(|(offset, length)| offset.saturating_add(*length));
        if ends.max().is_some_and(|end| end > directory.length()) {
            return Err(truncated(Format::Tiff));
        }
        Ok(Some(grid))
    }

    /// How many tiles or strips the picture has, or each plane of it.
    pub fn number(&self) -> usize {
        self.across.saturating_mul(self.size[1].div_ceil(self.chunk[1]))
    }

    /// Whether the file holds one: those that are all of nothing may be left out.
    pub fn holds(&self, index: usize) -> bool {
        self.length(index) > 0
    }

    /// How many bytes of the file one has.
    pub fn length(&self, index: usize) -> u64 {
        self.lengths.get(index).copied().unwrap_or(0)
    }

    /// The bytes of one in the file.
    pub fn bytes<S: FileSource>(&self, source: &S, index: usize) -> Result<Vec<u8>, Error> {
        let (offset, length) = (self.offsets[index], self.lengths[index]);
        if length > MOST_BYTES || offset.checked_add(length).is_none_or(|end| end > source.length()) {
            return Err(truncated(Format::Tiff));
        }
        let mut bytes = vec![0; length as usize];
        // A file may be changed or taken away while it is open.
        source.read_at(offset, &mut bytes).map_err(|error| undecodable(Format::Tiff, error))?;
        Ok(bytes)
    }

    /// Sides of a tile or strip, without what reaches beyond the picture.
    pub fn sides(&self, index: usize) -> [usize; 2] {
        let corner = [index % self.across * self.chunk[0], index / self.across * self.chunk[1]];
        [0, 1].map(|axis| self.chunk[axis].min(self.size[axis].saturating_sub(corner[axis])))
    }

    /// The tiles or strips that a part of the picture meets.
    pub fn pieces(&self, first: [usize; 2], size: [usize; 2]) -> impl Iterator<Item = Piece> {
        let last = [0, 1].map(|axis| first[axis].saturating_add(size[axis]).min(self.size[axis]));
        let [columns, rows] = [0, 1].map(|axis| {
            let is_outside = first[axis] >= last[axis];
            if is_outside { 0..0 } else { first[axis] / self.chunk[axis]..last[axis].div_ceil(self.chunk[axis]) }
        });
        let (chunk, across, width) = (self.chunk, self.across, self.size[0]);
        rows.flat_map(move |down| columns.clone().map(move |along| [along, down])).map(move |[along, down]| {
            let corner = [along * chunk[0], down * chunk[1]];
            let [columns, rows] = [0, 1].map(|axis| first[axis].max(corner[axis])..last[axis].min(corner[axis] + chunk[axis]));
            Piece { index: down * across + along, corner, stride: chunk[0].min(width - corner[0]), columns, rows }
        })
    }
}

impl Piece {
    /// Row by row: from where in the tile or strip, to where in a part that begins at a column and row and has rows of so many px.
    pub fn rows_to(&self, first: [usize; 2], width: usize) -> impl Iterator<Item = (Range<usize>, Range<usize>)> {
        let (columns, corner, stride) = (self.columns.clone(), self.corner, self.stride);
        self.rows.clone().map(move |row| {
            let from = (row - corner[1]) * stride + columns.start - corner[0];
            let to = (row - first[1]) * width + columns.start - first[0];
            (from..from + columns.len(), to..to + columns.len())
        })
    }
}
