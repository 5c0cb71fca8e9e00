//! The tiles of a mosaic while images are laid on it: each is held from the first image that reaches it to the last one.

use super::samples::Samples;
use super::tiled_file::{TILE, TiledFile};
use crate::Error;
use std::collections::BTreeMap;
use std::io::{Seek, Write};
use std::ops::Range;

/// Columns and rows that an image may show.
pub(super) type Reach = [Range<usize>; 2];

/// Bytes of a pixel that waits: three colours, and a distance.
const BYTES: usize = 7;

/// The indices of the images that show anything, along the longer side of a mosaic of this size: so few tiles wait for more of them.
pub(super) fn order(reaches: &[Option<Reach>], size: [usize; 2]) -> Vec<usize> {
    let axis = usize::from(size[1] > size[0]);
    let shown = reaches.iter().enumerate().filter_map(|(k, reach)| reach.as_ref().filter(|reach| !is_empty(reach)).map(|reach| (k, reach)));
    let mut known: Vec<(usize, usize)> = shown.map(|(k, reach)| (reach[axis].start, k)).collect();
    known.sort_unstable();
    known.into_iter().map(|(_, index)| index).collect()
}

/// The bytes of the tiles that wait at once, at most, where images come in that order.
pub(super) fn most_waiting(reaches: &[Option<Reach>], size: [usize; 2]) -> usize {
    let across = size[0].div_ceil(TILE);
    let mut waits: BTreeMap<usize, [usize; 2]> = BTreeMap::new();
    for (turn, index) in order(reaches, size).into_iter().enumerate() {
        let [columns, rows] = reaches[index].clone().unwrap_or_default().map(|range| range.start / TILE..range.end.div_ceil(TILE));
        for tile in rows.flat_map(|row| columns.clone().map(move |column| row * across + column)) {
            waits.entry(tile).or_insert([turn, turn])[1] = turn;
        }
    }
    let mut changes = vec![0_isize; reaches.len() + 1];
    for [from, to] in waits.into_values() {
        (changes[from], changes[to + 1]) = (changes[from] + 1, changes[to + 1] - 1);
    }
    let at_once = changes.iter().scan(0, |sum, change| {
        *sum += change;
        Some(*sum)
    });
    at_once.max().unwrap_or(0).unsigned_abs() * TILE * TILE * BYTES
}

fn is_empty(reach: &Reach) -> bool {
    reach.iter().any(Range::is_empty)
}

/// What is known of the tiles.
pub(super) struct MosaicTiles {
    file: TiledFile,
    samples: Samples,
    /// How many images may still come for each.
    awaited: Vec<usize>,
    held: BTreeMap<usize, Tile>,
    is_empty: bool,
}

/// A tile that is held.
pub(super) struct Tile {
    /// The bytes of its pixels; 0 where nothing is shown yet.
    pub values: Vec<u8>,
    /// Square of the distance in plan of the projection centre that each was taken from.
    pub distance: Vec<f32>,
}

impl MosaicTiles {
    /// `reaches`: of the images that will come.
    pub fn new<'a>(file: TiledFile, samples: Samples, reaches: impl Iterator<Item = &'a Reach>) -> Self {
        let mut tiles = Self { awaited: vec![0; file.number()], file, samples, held: BTreeMap::new(), is_empty: true };
        for reach in reaches {
            tiles.reached(reach).into_iter().for_each(|(index, _)| tiles.awaited[index] += 1);
        }
        tiles
    }

    pub fn has_colours(&self) -> bool {
        self.samples == Samples::Bytes(3)
    }

    /// The tiles of which an image may show something, and which part of the picture that is.
    pub fn reached(&self, [columns, rows]: &Reach) -> Vec<(usize, Reach)> {
        let side = self.file.side();
        let within = |index: usize| {
            let [left, top] = self.file.corner(index);
            [columns.start.max(left)..columns.end.min(left + side), rows.start.max(top)..rows.end.min(top + side)]
        };
        (0..self.file.number()).map(|index| (index, within(index))).filter(|(_, reach)| !is_empty(reach)).collect()
    }

    /// The side of all, and the column and row at which one begins.
    pub fn place(&self, index: usize) -> (usize, [usize; 2]) {
        (self.file.side(), self.file.corner(index))
    }

    pub fn hold(&mut self, index: usize) -> &mut Tile {
        let pixels = self.file.side() * self.file.side();
        let bytes = self.samples.bytes();
        self.held.entry(index).or_insert_with(|| Tile { values: vec![0; pixels * bytes], distance: vec![f32::INFINITY; pixels] })
    }

    /// An image came, or will not: tiles that wait for none are written.
    pub fn came(&mut self, reach: &Reach, out: &mut impl Write) -> Result<(), Error> {
        for (index, _) in self.reached(reach) {
            self.awaited[index] = self.awaited[index].saturating_sub(1);
            if self.awaited[index] == 0 {
                self.write(index, out)?;
            }
        }
        Ok(())
    }

    fn write(&mut self, index: usize, out: &mut impl Write) -> Result<(), Error> {
        let Some(tile) = self.held.remove(&index) else { return Ok(()) };
        if tile.distance.iter().all(|distance| !distance.is_finite()) {
            return Ok(());
        }
        self.is_empty = false;
        self.file.write(index, tile.values, out)
    }

    /// Writes what is left; gives whether anything is shown.
    pub fn finish(mut self, out: &mut (impl Write + Seek)) -> Result<bool, Error> {
        while let Some(index) = self.held.keys().next().copied() {
            self.write(index, out)?;
        }
        let shows = !self.is_empty;
        self.file.finish(out)?;
        Ok(shows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Georeference;
    use std::io::Cursor;

    /// Images of 1,000 px side by side along a strip, each half over the next one.
    fn strip(images: usize) -> Vec<Option<Reach>> {
        (0..images).map(|k| Some([500 * k..500 * k + 1_000, 0..1_000])).collect()
    }

    #[test]
    fn tiles_wait_for_the_images_that_reach_them_and_no_longer() {
        let size = [500 * 21, 1_000];
        let reaches: Vec<Option<Reach>> = strip(20).into_iter().rev().collect();
        assert_eq!(order(&reaches, size), (0..20).rev().collect::<Vec<_>>());
        // What shows nothing is not waited for.
        let none = [Some([usize::MAX..usize::MAX, usize::MAX..usize::MAX]), None];
        assert_eq!((order(&none, size), most_waiting(&none, size)), (Vec::new(), 0));
        // Two rows of tiles, four columns of them at most.
        let most = most_waiting(&reaches, size) / (TILE * TILE * BYTES);
        assert!((6..=8).contains(&most), "{most} tiles");
        let mut out = Cursor::new(Vec::new());
        let file = TiledFile::begin(size, Samples::Bytes(1), Georeference::north_up([0.0, 0.0], 1.0), None, None, &mut out).unwrap();
        let mut tiles = MosaicTiles::new(file, Samples::Bytes(1), reaches.iter().flatten());
        let mut length = out.get_ref().len();
        for reach in reaches.iter().rev().flatten() {
            for (index, _) in tiles.reached(reach) {
                let tile = tiles.hold(index);
                (tile.values, tile.distance) = (vec![7; TILE * TILE], vec![1.0; TILE * TILE]);
            }
            assert!(tiles.held.len() <= most, "{} tiles", tiles.held.len());
            tiles.came(reach, &mut out).unwrap();
        }
        assert!(tiles.held.is_empty() && out.get_ref().len() > length);
        length = out.get_ref().len();
        assert!(tiles.finish(&mut out).unwrap() && out.get_ref().len() > length);
    }
}
