//! The tiles or strips of a TIFF that is no picture, decoded one by one.

use super::corrected::Corrected;
use super::declared::{TiffLayout, checked_directory, decoder_error, unlimited};
use super::grid::{Grid, Piece};
use crate::Error;
use crate::image::layout::{Format, truncated};
use crate::source::{FileSource, SourceReader};
use std::sync::{Mutex, PoisonError};
use tiff::decoder::{Decoder, DecodingResult};

/// Most values that a byte of a TIFF stands for.
const MOST_PACKED: u64 = 2560;

/// The tiles or strips of the first image of a file, of one sample a pixel.
pub(crate) struct Chunks<S: FileSource> {
    grid: Grid,
    /// Of a sample.
    pub bits: u8,
    decoder: Mutex<Decoder<SourceReader<Corrected<S>>>>,
}

impl<S: FileSource + Clone> Chunks<S> {
    /// Absent for more than one sample a pixel.
    ///
    /// # Errors
    /// [`Error::UnreadableImage`] for a damaged or truncated file, and [`Error::UnsupportedImage`].
    pub fn open(source: S) -> Result<Option<Self>, Error> {
        let source = Corrected::rows_of_image(source);
        let directory = checked_directory(source.clone())?;
        // What a tile or strip needs is checked where it is decoded.
        let mut decoder = Decoder::new(SourceReader::new(source)).map_err(decoder_error)?.with_limits(unlimited());
        let samples = decoder.colortype().map_err(decoder_error)?;
        if samples.num_samples() != 1 {
            return Ok(None);
        }
        let grid = Grid::of(&directory, &TiffLayout::unchecked(&directory)?, usize::MAX, false)?;
        Ok(grid.map(|grid| Self { grid, bits: samples.bit_depth(), decoder: Mutex::new(decoder) }))
    }

    /// Width and height of the image.
    pub fn size(&self) -> [usize; 2] {
        self.grid.size
    }

    /// How many values the largest one has.
    pub fn most_values(&self) -> usize {
        let [columns, rows] = self.grid.chunk;
        columns.min(self.grid.size[0]).saturating_mul(rows.min(self.grid.size[1]))
    }

    /// All of them, with where they meet the image.
    pub fn pieces(&self) -> impl Iterator<Item = Piece> {
        self.grid.pieces([0, 0], self.grid.size)
    }

    /// The number of that of a pixel within the image, and the place of the pixel in it.
    pub fn place(&self, column: usize, row: usize) -> (usize, usize) {
        let [columns, rows] = self.grid.chunk;
        let index = row / rows * self.grid.across + column / columns;
        (index, row % rows * self.grid.sides(index)[0] + column % columns)
    }

    /// How many values one has within the image.
    pub fn values(&self, index: usize) -> usize {
        let [width, height] = self.grid.sides(index);
        width * height
    }

    /// Whether the file holds one.
    pub fn holds(&self, index: usize) -> bool {
        self.grid.holds(index)
    }

    /// The values of one within the image, row by row. Absent where the file leaves it out.
    ///
    /// # Errors
    /// [`Error::UnreadableImage`] for a damaged one.
    pub fn decoded(&self, index: usize) -> Result<Option<DecodingResult>, Error> {
        if !self.grid.holds(index) {
            return Ok(None);
        }
        if self.values(index) as u64 / MOST_PACKED > self.grid.length(index) {
            return Err(truncated(Format::Tiff));
        }
        let mut decoder = self.decoder.lock().unwrap_or_else(PoisonError::into_inner);
        decoder.read_chunk(index as u32).map(Some).map_err(decoder_error)
    }
}
