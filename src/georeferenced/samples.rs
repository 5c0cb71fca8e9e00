//! The numbers of a TIFF that is no picture: heights of the ground, or of a geoid.

use super::geotiff::{NO_DATA, number_of};
use crate::error::refuse;
use crate::image::{Chunks, Directory, Kept};
use crate::{Error, FileSource, Refusal};
use std::sync::Arc;
use tiff::decoder::DecodingResult;

/// Most values that are held at once.
pub(crate) const MOST_VALUES: usize = 100_000_000;
/// Bytes of tiles and strips that are kept.
const KEPT_BYTES: usize = 128 << 20;
/// Of GDAL, in no standard: what it says of bands as XML.
const METADATA: u64 = 42112;

/// The numbers of the first image of a TIFF: what stands for nothing is no number, and what GDAL says of their scale and offset is applied. Tiles and
/// strips are decoded once they are asked for; those that the file leaves out are of nothing, or 0 where nothing stands for that.
pub(crate) struct Numbers<S: FileSource> {
    meaning: Meaning,
    chunks: Chunks<S>,
    kept: Kept<usize, Vec<f32>>,
}

/// What the samples of a file mean.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Meaning {
    hole: Option<f32>,
    scale: f64,
    offset: f64,
}

impl<S: FileSource + Clone> Numbers<S> {
    /// # Errors
    /// [`Error::InvalidInput`] for more than one number of a pixel; [`Error::UnreadableImage`] for a damaged or truncated file.
    pub fn open(file: S) -> Result<Self, Error> {
        let nothing = Meaning { hole: None, scale: 1.0, offset: 0.0 };
        let meaning = Directory::first(file.clone()).map_or(nothing, |directory| Meaning::of(&directory));
        match Chunks::open(file)? {
            Some(chunks) => Ok(Self { meaning, chunks, kept: Kept::new(KEPT_BYTES) }),
            None => refuse(Refusal::HeightSamples),
        }
    }

    /// Width and height.
    pub fn size(&self) -> [usize; 2] {
        self.chunks.size()
    }

    /// Whether they are such as grey values are: of 8 bits, and taken as they stand.
    pub fn are_as_of_picture(&self) -> bool {
        self.chunks.bits <= 8 && self.meaning.scale == 1.0 && self.meaning.offset == 0.0
    }

    /// Refuses those of which a tile or strip has more than this.
    ///
    /// # Errors
    /// [`Error::InvalidInput`].
    pub fn check_chunks(&self, most: usize) -> Result<(), Error> {
        if self.chunks.most_values() > most { refuse_many(self.size()) } else { Ok(()) }
    }

    /// All of them, row by row.
    ///
    /// # Errors
    /// As [`at`](Self::at), and [`Error::InvalidInput`] for too many.
    pub fn all(&self) -> Result<Vec<f32>, Error> {
        let [width, height] = self.size();
        let number = width.saturating_mul(height);
        if number > MOST_VALUES {
            return refuse_many([width, height]);
        }
        let mut all = vec![0.0; number];
        for piece in self.chunks.pieces() {
            let values = self.decoded(piece.index)?;
            piece.rows_to([0, 0], width).for_each(|(from, to)| all[to].copy_from_slice(&values[from]));
        }
        Ok(all)
    }

    /// The lowest and the highest of them, by tile or strip; infinite where one has none.
    pub fn ranges(&self) -> impl Iterator<Item = Result<[f32; 2], Error>> {
        self.chunks.pieces().map(|piece| match self.chunks.holds(piece.index) {
            true => self.decoded(piece.index).map(|values| range_of(&values)),
            false => Ok(range_of(&[self.meaning.of_missing()])),
        })
    }

    /// The one of a pixel within the image.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for samples of another kind, and tiles and strips of too many; [`Error::UnreadableImage`] for damaged ones.
    pub fn at(&self, column: usize, row: usize) -> Result<f32, Error> {
        let (index, place) = self.chunks.place(column, row);
        Ok(self.chunk(index)?[place])
    }

    /// Those of four pixels within the image, of which that is the first: row by row.
    ///
    /// # Errors
    /// As [`at`](Self::at).
    pub fn four_from(&self, column: usize, row: usize) -> Result<[f32; 4], Error> {
        let places = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[c, r]| self.chunks.place(column + c, row + r));
        let mut chunk = (places[0].0, self.chunk(places[0].0)?);
        let mut values = [0.0; 4];
        for (value, (index, place)) in values.iter_mut().zip(places) {
            if chunk.0 != index {
                chunk = (index, self.chunk(index)?);
            }
            *value = chunk.1[place];
        }
        Ok(values)
    }

    fn chunk(&self, index: usize) -> Result<Arc<Vec<f32>>, Error> {
        self.kept.part(index, |values| size_of_val(&values[..]), || self.decoded(index))
    }

    fn decoded(&self, index: usize) -> Result<Vec<f32>, Error> {
        self.check_chunks(MOST_VALUES)?;
        let number = self.chunks.values(index);
        let Some(samples) = self.chunks.decoded(index)? else { return Ok(vec![self.meaning.of_missing(); number]) };
        let values = self.meaning.taken(samples)?;
        if values.len() == number { Ok(values) } else { refuse(Refusal::HeightSamples) }
    }

    /// How many tiles and strips are kept.
    #[cfg(test)]
    pub fn decoded_now(&self) -> usize {
        self.kept.number()
    }
}

/// The error for more than are read.
pub(crate) fn refuse_many<T>([width, height]: [usize; 2]) -> Result<T, Error> {
    refuse(Refusal::ManyHeights { width, height })
}

/// The lowest and the highest of values; infinite where none is finite.
pub(crate) fn range_of(values: &[f32]) -> [f32; 2] {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    [finite().fold(f32::INFINITY, f32::min), finite().fold(f32::NEG_INFINITY, f32::max)]
}

impl Meaning {
    fn of<S: crate::FileSource>(directory: &Directory<S>) -> Self {
        let metadata = directory.text(METADATA).unwrap_or_default();
        let of_role = |role: &str, usual: f64| item(&metadata, role).filter(|value| value.is_finite()).unwrap_or(usual);
        let scale = Some(of_role("scale", 1.0)).filter(|scale| *scale != 0.0).unwrap_or(1.0);
        Self { hole: number_of(directory, NO_DATA).map(|value| value as f32), scale, offset: of_role("offset", 0.0) }
    }

    /// What a pixel is that the file leaves out.
    ///
    /// # Source
    /// GDAL, GTiff driver, `SPARSE_OK`.
    fn of_missing(self) -> f32 {
        self.value(self.hole.unwrap_or(0.0))
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
    use std::io::Cursor;
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
        let numbers = Numbers::open(&scaled[..]).unwrap();
        let all = numbers.all().unwrap();
        assert_eq!((numbers.size(), all.len()), ([5, 7], 35));
        for (k, value) in all.iter().enumerate() {
            assert!(if k == 17 { value.is_nan() } else { (value - (10.0 * k as f32 - 100.0)).abs() < 1e-4 }, "{k}: {value}");
        }
        let plain = file("<GDALMetadata></GDALMetadata>");
        assert_eq!(Numbers::open(&plain[..]).unwrap().all().unwrap()[3], 3000.0);
        assert_eq!(
            [item(XML, "scale"), item(XML, "offset"), item(XML, "other"), item("<Item role=\"scale\"", "scale")],
            [Some(0.01), Some(-100.0), None, None]
        );
    }

    #[test]
    fn numbers_are_decoded_where_they_are_asked_for() {
        let file = file(XML);
        let numbers = Numbers::open(&file[..]).unwrap();
        let all = numbers.all().unwrap();
        for (column, row, decoded) in [(4, 3, 1), (0, 2, 1), (2, 6, 2), (1, 0, 3)] {
            assert_eq!((numbers.at(column, row).unwrap(), numbers.decoded_now()), (all[5 * row + column], decoded), "{column} {row}");
        }
        assert!(numbers.at(2, 3).unwrap().is_nan());
    }
}
