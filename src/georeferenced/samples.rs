//! The numbers of a TIFF that is no picture: heights of the ground, or of a geoid.

use super::geotiff::{NO_DATA, number_of};
use crate::error::refuse;
use crate::image::{Directory, tiff_error, with_rows_of_image};
use crate::{Error, Refusal};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::io::Cursor;
use std::sync::{Mutex, PoisonError};
use tiff::decoder::{Decoder, DecodingResult, Limits};

/// Most values that a byte of a TIFF stands for.
const MOST_PACKED: usize = 2560;
/// Most values of a grid.
pub(crate) const MOST_VALUES: usize = 100_000_000;
/// Of GDAL, in no standard: what it says of bands as XML.
const METADATA: u64 = 42112;

/// The numbers of the first image of a TIFF: what stands for nothing is no number, and what GDAL says of their scale and offset is applied. Tiles and
/// strips are decoded once they are asked for.
pub(crate) struct Numbers<'a> {
    /// Of the file.
    bytes: usize,
    size: [usize; 2],
    /// Of a tile or strip.
    chunk: [usize; 2],
    /// Of a number.
    bits: u8,
    meaning: Meaning,
    decoder: Mutex<Decoder<Cursor<Cow<'a, [u8]>>>>,
    kept: Mutex<BTreeMap<usize, Vec<f32>>>,
}

/// What the samples of a file mean.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Meaning {
    hole: Option<f32>,
    scale: f64,
    offset: f64,
}

impl<'a> Numbers<'a> {
    /// Of a file that was checked by [`checked_directory`](crate::image::checked_directory).
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a truncated file, too many numbers and more than one of a pixel; [`Error::UnreadableImage`] for a damaged one.
    pub fn open(file: &'a [u8]) -> Result<Self, Error> {
        let meaning = Directory::first(file).map_or(Meaning { hole: None, scale: 1.0, offset: 0.0 }, |directory| Meaning::of(&directory));
        let (bytes, file) = (file.len(), with_rows_of_image(file));
        // What the numbers need is checked below.
        let mut decoder = Decoder::new(Cursor::new(file)).map_err(tiff_error)?.with_limits(Limits::unlimited());
        let side = |side: u32| side as usize;
        let (width, height) = decoder.dimensions().map_err(tiff_error)?;
        let [width, height] = [width, height].map(side);
        // No compression that is read packs more.
        if width.saturating_mul(height) / MOST_PACKED > bytes {
            return refuse(Refusal::TruncatedHeights { width, height, bytes });
        }
        let (columns, rows) = decoder.chunk_dimensions();
        let chunk = [columns, rows].map(side);
        let colours = decoder.colortype().map_err(tiff_error)?;
        if colours.num_samples() != 1 || chunk.contains(&0) {
            return refuse(Refusal::HeightSamples);
        }
        let (decoder, kept) = (Mutex::new(decoder), Mutex::default());
        Ok(Self { bytes, size: [width, height], chunk, bits: colours.bit_depth(), meaning, decoder, kept })
    }

    /// Width and height.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Whether they are such as grey values are: of 8 bits, and taken as they stand.
    pub fn are_as_of_picture(&self) -> bool {
        self.bits <= 8 && self.meaning.scale == 1.0 && self.meaning.offset == 0.0
    }

    /// All of them, row by row.
    ///
    /// # Errors
    /// As [`at`](Self::at).
    pub fn all(&self) -> Result<Vec<f32>, Error> {
        let [width, height] = self.size;
        self.refuse_many(width, height)?;
        let mut decoder = self.decoder.lock().unwrap_or_else(PoisonError::into_inner);
        let values = decoder.read_image().map_err(tiff_error)?;
        self.meaning.taken(values)
    }

    /// The one of a pixel within the image.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for samples of another kind, and tiles and strips of too many; [`Error::UnreadableImage`] for damaged ones.
    pub fn at(&self, column: usize, row: usize) -> Result<f32, Error> {
        let [columns, rows] = self.chunk;
        let across = self.size[0].div_ceil(columns);
        let (left, index) = (column / columns, row / rows * across + column / columns);
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        let values = match kept.entry(index) {
            Entry::Occupied(kept) => kept.into_mut(),
            Entry::Vacant(place) => {
                self.refuse_many(columns, rows)?;
                let mut decoder = self.decoder.lock().unwrap_or_else(PoisonError::into_inner);
                place.insert(self.meaning.taken(decoder.read_chunk(index as u32).map_err(tiff_error)?)?)
            }
        };
        // Those at the right edge are cut off there.
        let stride = columns.min(self.size[0] - left * columns);
        let value = values.get(row % rows * stride + column % columns).copied();
        value.map_or_else(|| refuse(Refusal::TruncatedHeights { width: columns, height: rows, bytes: self.bytes }), Ok)
    }

    fn refuse_many(&self, width: usize, height: usize) -> Result<(), Error> {
        if width.saturating_mul(height) > MOST_VALUES {
            return refuse(Refusal::ManyHeights { width, height });
        }
        Ok(())
    }

    /// How many tiles and strips were decoded.
    #[cfg(test)]
    pub fn decoded(&self) -> usize {
        self.kept.lock().unwrap().len()
    }
}

impl Meaning {
    fn of<S: crate::FileSource>(directory: &Directory<S>) -> Self {
        let metadata = directory.text(METADATA).unwrap_or_default();
        let of_role = |role: &str, usual: f64| item(&metadata, role).filter(|value| value.is_finite()).unwrap_or(usual);
        let scale = Some(of_role("scale", 1.0)).filter(|scale| *scale != 0.0).unwrap_or(1.0);
        Self { hole: number_of(directory, NO_DATA).map(|value| value as f32), scale, offset: of_role("offset", 0.0) }
    }

    fn value(self, value: f32) -> f32 {
        match self {
            Self { hole: Some(hole), .. } if value == hole => f32::NAN,
            Self { scale: 1.0, offset: 0.0, .. } => value,
            Self { scale, offset, .. } => (scale * f64::from(value) + offset) as f32,
        }
    }

    fn taken(self, samples: DecodingResult) -> Result<Vec<f32>, Error> {
        let mut values: Vec<f32> = match samples {
            DecodingResult::F32(values) => values,
            DecodingResult::F64(values) => values.into_iter().map(|v| v as f32).collect(),
            DecodingResult::I16(values) => values.into_iter().map(f32::from).collect(),
            DecodingResult::U16(values) => values.into_iter().map(f32::from).collect(),
            DecodingResult::U8(values) => values.into_iter().map(f32::from).collect(),
            DecodingResult::I32(values) => values.into_iter().map(|v| v as f32).collect(),
            _ => return refuse(Refusal::HeightSamples),
        };
        values.iter_mut().for_each(|value| *value = self.value(*value));
        Ok(values)
    }
}

/// What GDAL says of the first band in the item of a role: `<Item name="SCALE" sample="0" role="scale">0.001</Item>`.
fn item(metadata: &str, role: &str) -> Option<f64> {
    metadata.split("<Item").skip(1).find_map(|item| {
        let (attributes, rest) = item.split_once('>')?;
        let has = |name: &str, value: &str| attributes.contains(&format!(" {name}=\"{value}\""));
        let is_of_first = has("sample", "0") || !attributes.contains(" sample=");
        let text = rest.split('<').next().filter(|_| has("role", role) && is_of_first)?;
        text.trim().parse().ok()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tiff::encoder::{TiffEncoder, colortype};
    use tiff::tags::Tag;

    const XML: &str = r#"<GDALMetadata>
  <Item name="area_of_use">World</Item>
  <Item name="OFFSET" sample="1" role="offset">7</Item>
  <Item name="SCALE" sample="0" role="scale">0.01</Item>
  <Item name="OFFSET" sample="0" role="offset">-100</Item>
</GDALMetadata>"#;

    /// Strips of two rows, with what GDAL says of them.
    fn file(metadata: &str) -> Vec<u8> {
        let mut out = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut out).unwrap();
        let mut image = encoder.new_image::<colortype::Gray16>(5, 7).unwrap();
        image.rows_per_strip(2).unwrap();
        image.encoder().write_tag(Tag::Unknown(METADATA as u16), metadata).unwrap();
        image.encoder().write_tag(Tag::Unknown(NO_DATA as u16), "65535").unwrap();
        let values: Vec<u16> = (0..35).map(|k| if k == 17 { 65_535 } else { 1000 * k }).collect();
        image.write_data(&values).unwrap();
        out.into_inner()
    }

    #[test]
    fn scale_and_offset_of_gdal_are_applied_and_holes_stay() {
        let scaled = file(XML);
        let numbers = Numbers::open(&scaled).unwrap();
        let all = numbers.all().unwrap();
        assert_eq!((numbers.size(), all.len()), ([5, 7], 35));
        for (k, value) in all.iter().enumerate() {
            assert!(if k == 17 { value.is_nan() } else { (value - (10.0 * k as f32 - 100.0)).abs() < 1e-4 }, "{k}: {value}");
        }
        let plain = file("<GDALMetadata></GDALMetadata>");
        assert_eq!(Numbers::open(&plain).unwrap().all().unwrap()[3], 3000.0);
        assert_eq!(
            [item(XML, "scale"), item(XML, "offset"), item(XML, "other"), item("<Item role=\"scale\"", "scale")],
            [Some(0.01), Some(-100.0), None, None]
        );
    }

    #[test]
    fn numbers_are_decoded_where_they_are_asked_for() {
        let file = file(XML);
        let numbers = Numbers::open(&file).unwrap();
        let all = numbers.all().unwrap();
        for (column, row, decoded) in [(4, 3, 1), (0, 2, 1), (2, 6, 2), (1, 0, 3)] {
            assert_eq!((numbers.at(column, row).unwrap(), numbers.decoded()), (all[5 * row + column], decoded), "{column} {row}");
        }
        assert!(numbers.at(2, 3).unwrap().is_nan());
    }
}
