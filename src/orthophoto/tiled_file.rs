//! GeoTIFF files that are written tile by tile, in any order: none is in memory as a whole. Pictures get smaller ones of themselves (overviews), so that
//! a large one is looked at as a whole without all of it being read.

use super::samples::{Samples, mean_of_shown};
use super::tiff_field::Field;
use crate::Georeference;
use crate::georeferenced::{
    KEYS, LINEAR_UNIT, MODEL_TYPE, NO_DATA, PIXEL_SCALE, PROJECTED, PROJECTED_SYSTEM, RASTER_TYPE, TIE_POINTS, TRANSFORMATION, unit_code,
};
use crate::{Document, Error};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::collections::BTreeMap;
use std::io::{self, Seek, SeekFrom, Write};

/// Side of a tile; pictures that are smaller have one of the next multiple of 16 px.
pub(super) const TILE: usize = 512;
/// Pictures of more bytes, which have a third more with their overviews, are BigTIFF, whose places have 64 bits.
const MOST_BYTES: u64 = 3_000_000_000;
const PIXEL_IS_AREA: u16 = 1;

/// A file that is being written. Tiles are packed by Deflate as they come; its directories come last.
pub(super) struct TiledFile {
    side: usize,
    samples: Samples,
    georeference: Georeference,
    epsg: Option<u16>,
    unit_m: Option<f64>,
    is_big: bool,
    /// The picture, and the same halved once, twice and so on until it is one tile.
    levels: Vec<Level>,
    /// What is written so far, in bytes.
    length: u64,
}

/// The picture, or an overview.
struct Level {
    size: [usize; 2],
    /// Tiles in a row.
    across: usize,
    /// The place of each tile in the file, and its length; absent where it is not written yet.
    tiles: Vec<Option<[u64; 2]>>,
    /// Tiles of which parts are there, and how many parts are not.
    begun: BTreeMap<usize, (Vec<u8>, usize)>,
}

impl Level {
    fn new(size: [usize; 2], side: usize) -> Self {
        let [across, down] = size.map(|length| length.div_ceil(side));
        Self { size, across, tiles: vec![None; across * down], begun: BTreeMap::new() }
    }
}

impl TiledFile {
    /// Begins a file of a picture of this size. `epsg`: the code of its system, where that is known; `unit_m`: the unit of eastings and northings in m.
    ///
    /// # Errors
    /// [`Error::NotWritten`], as of all that follows.
    pub fn begin(
        size: [usize; 2],
        samples: Samples,
        georeference: Georeference,
        epsg: Option<u16>,
        unit_m: Option<f64>,
        out: &mut impl Write,
    ) -> Result<Self, Error> {
        let side = size[0].max(size[1]).next_multiple_of(16).min(TILE);
        let is_big = size[0] as u64 * size[1] as u64 * samples.bytes() as u64 > MOST_BYTES;
        let next = |size: &[usize; 2]| match samples {
            Samples::Bytes(_) if size[0].max(size[1]) > side => Some(size.map(|length| length.div_ceil(2))),
            _ => None,
        };
        let levels = std::iter::successors(Some(size), next).map(|size| Level::new(size, side)).collect();
        let mut file = Self { side, samples, georeference, epsg, unit_m, is_big, levels, length: 0 };
        let head = file.head(0);
        file.append(&head, out)?;
        Ok(file)
    }

    /// How many tiles it has, row by row.
    pub fn number(&self) -> usize {
        self.levels[0].tiles.len()
    }

    /// Side of a tile in px; those at the right and lower edge reach beyond the picture.
    pub fn side(&self) -> usize {
        self.side
    }

    /// The column and row at which a tile begins.
    pub fn corner(&self, index: usize) -> [usize; 2] {
        let Level { across, .. } = self.levels[0];
        [index % across * self.side, index / across * self.side]
    }

    /// Writes a tile: the bytes of all of its pixels, row by row.
    pub fn write(&mut self, index: usize, values: Vec<u8>, out: &mut impl Write) -> Result<(), Error> {
        self.write_of(0, index, values, out)
    }

    /// Writes a tile of a level, and what is complete by it of the next ones.
    fn write_of(&mut self, level: usize, index: usize, values: Vec<u8>, out: &mut impl Write) -> Result<(), Error> {
        let complete = self.halved_into(level, index, &values);
        self.pack(level, index, values, out)?;
        match complete {
            Some((index, values)) => self.write_of(level + 1, index, values, out),
            None => Ok(()),
        }
    }

    /// Lays a tile, halved, into that of the next level of which it is a quarter; gives that where it is complete.
    fn halved_into(&mut self, level: usize, index: usize, values: &[u8]) -> Option<(usize, Vec<u8>)> {
        let (side, bytes) = (self.side, self.samples.bytes());
        let [own, next] = self.levels.get_mut(level..level + 2)? else { return None };
        let [column, row] = [index % own.across, index / own.across];
        let above = row / 2 * next.across + column / 2;
        let down = own.tiles.len() / own.across;
        let parts = || (own.across - column / 2 * 2).min(2) * (down - row / 2 * 2).min(2);
        let (tile, missing) = next.begun.entry(above).or_insert_with(|| (vec![0; side * side * bytes], parts()));
        let half = side / 2;
        for y in 0..half {
            for x in 0..half {
                let pixels = [0, 1, side, side + 1].map(|step| &values[(2 * y * side + 2 * x + step) * bytes..][..bytes]);
                let at = ((row % 2 * half + y) * side + column % 2 * half + x) * bytes;
                mean_of_shown(pixels, &mut tile[at..at + bytes]);
            }
        }
        *missing -= 1;
        if *missing > 0 { None } else { next.begun.remove(&above).map(|(tile, _)| (above, tile)) }
    }

    fn pack(&mut self, level: usize, index: usize, mut values: Vec<u8>, out: &mut impl Write) -> Result<(), Error> {
        if let Samples::Bytes(bands) = self.samples {
            // Differences of neighbours pack better.
            for row in values.chunks_exact_mut(self.side * bands) {
                (bands..row.len()).rev().for_each(|k| row[k] = row[k].wrapping_sub(row[k - bands]));
            }
        }
        let mut packer = ZlibEncoder::new(Vec::new(), Compression::default());
        let packed = packer.write_all(&values).and_then(|()| packer.finish()).map_err(not_written)?;
        self.levels[level].tiles[index] = Some([self.length, packed.len() as u64]);
        self.append(&packed, out)
    }

    /// Writes the directories and, at the beginning of the file, where the first one stands. Tiles that were not written show nothing.
    pub fn finish(mut self, out: &mut (impl Write + Seek)) -> Result<(), Error> {
        for level in 1..self.levels.len() {
            while let Some((index, (values, _))) = self.levels[level].begun.pop_first() {
                self.write_of(level, index, values, out)?;
            }
        }
        let mut nothing = None;
        for (level, index) in self.unwritten() {
            let place = match nothing {
                Some(place) => place,
                None => {
                    self.pack(level, index, self.samples.nothing(self.side * self.side), out)?;
                    self.levels[level].tiles[index]
                }
            };
            (nothing, self.levels[level].tiles[index]) = (Some(place), place);
        }
        let first = self.length;
        for level in 0..self.levels.len() {
            let at = self.length;
            let length = self.directory(level, at, 0).len() as u64;
            let next = if level + 1 < self.levels.len() { at + length } else { 0 };
            let directory = self.directory(level, at, next);
            self.append(&directory, out)?;
        }
        out.seek(SeekFrom::Start(0)).and_then(|_| out.write_all(&self.head(first))).map_err(not_written)
    }

    /// Levels and numbers of the tiles that are not written yet.
    fn unwritten(&self) -> Vec<(usize, usize)> {
        let of = |(level, own): (usize, &Level)| {
            let unwritten = own.tiles.iter().enumerate().filter(|(_, tile)| tile.is_none());
            unwritten.map(|(index, _)| (level, index)).collect::<Vec<_>>()
        };
        self.levels.iter().enumerate().flat_map(of).collect()
    }

    /// Appends bytes, and one more where their number is odd: what a TIFF points to begins at even places.
    fn append(&mut self, bytes: &[u8], out: &mut impl Write) -> Result<(), Error> {
        let odd = bytes.len() % 2;
        out.write_all(bytes).and_then(|()| out.write_all(&[0][..odd])).map_err(not_written)?;
        self.length += (bytes.len() + odd) as u64;
        Ok(())
    }

    /// The first bytes of the file, whose directory stands there.
    fn head(&self, directory: u64) -> Vec<u8> {
        if self.is_big {
            [&b"II\x2b\0\x08\0\0\0"[..], &directory.to_le_bytes()].concat()
        } else {
            [&b"II\x2a\0"[..], &(directory as u32).to_le_bytes()].concat()
        }
    }

    /// The directory of a level, which stands there, followed by the values for which its entries have no room; and where the next one stands.
    fn directory(&self, level: usize, at: u64, next: u64) -> Vec<u8> {
        let fields = self.fields(level);
        let places = |number: u64, big: usize, small: usize| {
            if self.is_big { number.to_le_bytes()[..big].to_vec() } else { number.to_le_bytes()[..small].to_vec() }
        };
        let room = if self.is_big { 8 } else { 4 };
        let entry = if self.is_big { 20 } else { 12 };
        let mut entries = places(fields.len() as u64, 8, 2);
        let first = at + (entries.len() + entry * fields.len() + room) as u64;
        let mut values = Vec::new();
        for (tag, field) in &fields {
            let (kind, number, mut bytes) = field.encoded();
            entries.extend((*tag as u16).to_le_bytes());
            entries.extend(kind.to_le_bytes());
            entries.extend(places(number as u64, 8, 4));
            if bytes.len() <= room {
                bytes.resize(room, 0);
                entries.extend(bytes);
            } else {
                entries.extend(places(first + values.len() as u64, 8, 4));
                bytes.resize(bytes.len().next_multiple_of(2), 0);
                values.extend(bytes);
            }
        }
        entries.extend(places(next, 8, 4));
        entries.extend(values);
        entries
    }

    /// The tags of a level with their values, in the order of their numbers. Where it lies stands with the picture itself.
    fn fields(&self, level: usize) -> Vec<(u64, Field)> {
        let Level { size, tiles, .. } = &self.levels[level];
        let [width, height] = size.map(|side| Field::Longs(vec![side as u32]));
        let short = |value: u16| Field::Shorts(vec![value]);
        let (bands, bits, photometric, predictor, format, no_data) = match self.samples {
            Samples::Bytes(bands) => (bands, 8, if bands == 3 { 2 } else { 1 }, 2, 1, "0"),
            Samples::Float => (1, 32, 1, 1, 3, "nan"),
        };
        let side = || Field::Longs(vec![self.side as u32]);
        let [places, lengths] = [0, 1].map(|k| {
            let numbers = tiles.iter().map(|tile| tile.map_or(0, |tile| tile[k]));
            if self.is_big { Field::Places(numbers.collect()) } else { Field::Longs(numbers.map(|number| number as u32).collect()) }
        });
        let mut fields = vec![
            (254, Field::Longs(vec![u32::from(level > 0)])),
            (256, width),
            (257, height),
            (258, Field::Shorts(vec![bits; bands])),
            (259, short(8)),
            (262, short(photometric)),
            (277, short(bands as u16)),
            (284, short(1)),
            (317, short(predictor)),
            (322, side()),
            (323, side()),
            (324, places),
            (325, lengths),
            (339, Field::Shorts(vec![format; bands])),
        ];
        if level > 0 {
            fields.push((NO_DATA, Field::Text(no_data)));
            return fields;
        }
        let Georeference { origin: [x, y], by_column: [a, d], by_row: [b, e] } = self.georeference;
        if b == 0.0 && d == 0.0 && a > 0.0 && e < 0.0 {
            fields.push((PIXEL_SCALE, Field::Doubles(vec![a, -e, 0.0])));
            fields.push((TIE_POINTS, Field::Doubles(vec![0.0, 0.0, 0.0, x, y, 0.0])));
        } else {
            let matrix = vec![a, b, 0.0, x, d, e, 0.0, y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
            fields.push((TRANSFORMATION, Field::Doubles(matrix)));
        }
        let mut keys: Vec<[u16; 4]> = vec![[MODEL_TYPE, 0, 1, PROJECTED], [RASTER_TYPE, 0, 1, PIXEL_IS_AREA]];
        keys.extend(self.epsg.map(|code| [PROJECTED_SYSTEM, 0, 1, code]));
        keys.extend(self.unit_m.and_then(unit_code).map(|code| [LINEAR_UNIT, 0, 1, code]));
        let head = [1, 1, 0, keys.len() as u16];
        fields.push((KEYS, Field::Shorts([&[head], keys.as_slice()].concat().concat())));
        fields.push((NO_DATA, Field::Text(no_data)));
        fields
    }
}

fn not_written(_: io::Error) -> Error {
    Error::NotWritten { document: Document::GeoTiff }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::{TiffRaster, Wanted};
    use crate::{DecodeLimits, Heights, Orthophoto};
    use std::io::Cursor;

    #[test]
    fn a_file_in_feet_says_so() {
        let georeference = Georeference::north_up([1_404_913.0, 18_172_674.0], 3.0);
        for (unit_m, wanted) in [(1200.0 / 3937.0, Some(1200.0 / 3937.0)), (0.3048, Some(0.3048)), (1.0, None)] {
            let mut out = Cursor::new(Vec::new());
            let mut file = TiledFile::begin([16, 16], Samples::Bytes(1), georeference, None, Some(unit_m), &mut out).unwrap();
            file.write(0, vec![7; 256], &mut out).unwrap();
            file.finish(&mut out).unwrap();
            let tags = crate::georeferenced::GeoTags::read(&out.into_inner()[..]).unwrap();
            assert_eq!(tags.system.unit_m, wanted, "{unit_m}");
        }
    }

    #[test]
    fn tiles_come_in_any_order_and_those_that_do_not_come_show_nothing() {
        let georeference = Georeference::north_up([355_000.5, 5_800_000.25], 0.2);
        for is_big in [false, true] {
            let mut out = Cursor::new(Vec::new());
            let mut file = TiledFile::begin([1_300, 700], Samples::Bytes(3), georeference, Some(25_833), None, &mut out).unwrap();
            if is_big {
                (out, file.is_big, file.length) = (Cursor::new(Vec::new()), true, 0);
                let head = file.head(0);
                file.append(&head, &mut out).unwrap();
            }
            assert_eq!((file.number(), file.side()), (6, 512));
            let colour = |x: usize, y: usize| [1 + (x / 7 % 250) as u8, 1 + (y / 5 % 250) as u8, 1 + ((x + y) / 9 % 250) as u8];
            for index in [4, 0, 5, 1] {
                let [left, top] = file.corner(index);
                let values = (0..512 * 512).flat_map(|k| colour(left + k % 512, top + k / 512)).collect();
                file.write(index, values, &mut out).unwrap();
            }
            file.finish(&mut out).unwrap();
            let bytes = out.into_inner();
            assert_eq!(&bytes[2..4], if is_big { b"\x2b\0" } else { b"\x2a\0" });
            let read = Orthophoto::read(&bytes, None, Heights::Level(0.0), &DecodeLimits::default()).unwrap();
            assert_eq!((read.size(), read.georeference, read.epsg), ([1_300, 700], georeference, Some(25_833)));
            // Beside what shows nothing an edge is left out.
            for [x, y] in [[0, 0], [511, 400], [512, 400], [600, 511], [600, 512], [1_299, 699]] {
                assert_eq!(read.colours([x, y], [1, 1], 0).unwrap()[..3], colour(x, y), "at {x} {y}");
            }
            assert_eq!([[1_200.5, 300.5], [200.5, 600.5]].map(|at| read.shows(at)), [false, false]);
            // It holds itself halved once and twice, to one tile.
            let raster = TiffRaster::open(bytes.as_slice(), Some(0.0), 1 << 20).unwrap().unwrap();
            assert_eq!([1, 2, 3].map(|halvings| raster.level(halvings, false)), [1, 2, 2]);
            assert_eq!([1, 2].map(|halvings| raster.size_of(halvings)), [[650, 350], [325, 175]]);
            for (halvings, [x, y]) in [(1, [10, 20]), (1, [400, 250]), (2, [100, 90]), (2, [240, 160])] {
                let pixel = raster.read(halvings, [x, y], [1, 1], Wanted::Colours).unwrap();
                let middle = (1 << halvings) / 2;
                let expected = colour((x << halvings) + middle, (y << halvings) + middle);
                let off = pixel.bands.iter().zip(expected).map(|(band, value)| band[0].abs_diff(value)).max();
                assert!(off <= Some(1) && !pixel.nothing[0], "{:?} for {expected:?} at {x} {y}", pixel.bands);
            }
            assert!(raster.read(2, [300, 40], [1, 1], Wanted::Grey).unwrap().nothing[0]);
        }
    }
}
