//! The height of the ground: one for all, or a grid.

use super::ground::Ground;
use super::height_values::HeightValues;
use crate::Georeference;
use crate::crs::Vertical;
use crate::error::refuse;
use crate::georeferenced::{GeoTags, MOST_VALUES, Numbers, SaidSystem, Sidecars, range_of, refuse_many};
use crate::image::is_tiff;
use crate::pipeline::{is_unit, unit_name};
use crate::source::read_all;
use crate::{Document, Error, FileSource, Refusal};
use std::borrow::Cow;
use std::sync::Arc;

/// A model of heights on a grid; between the centres of its pixels heights are interpolated in both directions.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightModel {
    pub georeference: Georeference,
    width: usize,
    height: usize,
    values: HeightValues,
    /// Lowest and highest.
    range: [f64; 2],
    /// Heights are so many times the values.
    factor: f64,
    /// The unit of the heights in m, where the file says it.
    unit_m: Option<f64>,
    /// What the file says of its system.
    said: Arc<SaidSystem>,
}

/// What is known of the height of the ground.
#[derive(Debug, Clone, PartialEq)]
pub enum Heights {
    /// The same everywhere.
    Level(f64),
    Model(HeightModel),
}

impl Heights {
    /// The height at a place; `None` outside the model and in its holes.
    pub fn at(&self, place: [f64; 2]) -> Option<f64> {
        match self {
            Self::Level(height) => Some(*height),
            Self::Model(model) => model.at(place),
        }
    }

    /// Lowest and highest.
    pub fn range(&self) -> [f64; 2] {
        match self {
            Self::Level(height) => [*height; 2],
            Self::Model(model) => model.range,
        }
    }

    /// These heights for ground in a system, in its unit where their file says theirs: that of their file is none other.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for heights of a system with another projection or datum, which names both.
    pub(super) fn for_ground(self, ground: &Ground) -> Result<Self, Error> {
        let Self::Model(model) = self else { return Ok(self) };
        if ground.is_contradicted_by(&model.said) {
            let (heights, ground) = (model.said.name().unwrap_or_default(), ground.name.clone().unwrap_or_default());
            return refuse(Refusal::HeightsSystem { heights, ground });
        }
        let Some(own_m) = model.unit_m else { return Ok(Self::Model(model)) };
        // Ground that says no unit is in that of the plane of its heights.
        let unit_m = ground.height_unit_m.or_else(|| model.said.plane_unit_m()).unwrap_or(1.0);
        Ok(Self::Model(HeightModel { unit_m: Some(unit_m), ..model.times(own_m / unit_m) }))
    }

    /// The unit in m that their file says; metres where it says none.
    pub(super) fn said_unit_m(&self) -> f64 {
        match self {
            Self::Level(_) => 1.0,
            Self::Model(model) => model.said.height_unit_m.unwrap_or(1.0),
        }
    }

    /// The unit in which their file says that they are, where they were converted from it to that of the ground.
    pub fn given_in(&self) -> Option<String> {
        match self {
            Self::Level(_) => None,
            Self::Model(model) => {
                let (given_m, unit_m) = model.said.height_unit_m.zip(model.unit_m)?;
                (!is_unit(given_m, unit_m)).then(|| unit_name(given_m))
            }
        }
    }

    /// What they count from, as the name of a vertical system, where their file says it.
    pub fn counts_from(&self) -> Option<String> {
        self.vertical().map(|vertical| vertical.name)
    }

    /// What they count from, where their file says it.
    pub(super) fn vertical(&self) -> Option<Vertical> {
        match self {
            Self::Level(_) => None,
            Self::Model(model) => model.said.vertical(),
        }
    }

    /// The unit of heights in m: metres, unless their file says otherwise.
    pub(super) fn unit_m(&self) -> f64 {
        match self {
            Self::Level(_) => 1.0,
            Self::Model(model) => model.unit_m.unwrap_or(1.0),
        }
    }

    /// In m; an easting and a northing of 1 are so many.
    pub(super) fn in_metres(&self, plane_m: f64) -> Self {
        let height_m = self.unit_m();
        match self {
            Self::Level(height) => Self::Level(*height),
            Self::Model(model) => Self::Model(HeightModel {
                georeference: model.georeference.enlarged(plane_m),
                unit_m: None,
                ..model.clone().times(height_m)
            }),
        }
    }

    /// In a system whose origin is that place of this one.
    pub(super) fn about(&self, place: [f64; 2]) -> Self {
        match self {
            Self::Level(height) => Self::Level(*height),
            Self::Model(model) => Self::Model(HeightModel { georeference: model.georeference.about(place), ..model.clone() }),
        }
    }
}

/// Heights beyond these are none of ground: what stands for 'no height' is below, as -9999 and -32768.
const LOWEST: f64 = -1_000.0;
const HIGHEST: f64 = 20_000.0;
/// Stands for 'no height' in an ESRI grid that does not say.
const NO_HEIGHT: f64 = -9999.0;

impl HeightModel {
    /// The same from a file that says by this code what they count from.
    #[cfg(test)]
    pub(super) fn counting_from(self, height_code: u16) -> Self {
        let said = SaidSystem { height_code: Some(height_code), ..(*self.said).clone() };
        Self { said: Arc::new(said), ..self }
    }

    /// The same from a file that says this unit, in m.
    #[cfg(test)]
    pub(super) fn said_in(self, unit_m: f64) -> Self {
        let said = SaidSystem { height_unit_m: Some(unit_m), ..(*self.said).clone() };
        Self { unit_m: Some(unit_m), said: Arc::new(said), ..self }
    }

    /// Takes heights row by row; what is not finite is a hole.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for another number of heights, a grid of less than 2 x 2, heights that are none of the earth, and holes alone.
    pub fn new(width: usize, height: usize, values: Vec<f32>, georeference: Georeference) -> Result<Self, Error> {
        if width < 2 || height < 2 || width.checked_mul(height) != Some(values.len()) {
            return refuse(Refusal::HeightCount { heights: values.len(), width, height });
        }
        let range = range_of(&values);
        Self::of([width, height], HeightValues::Whole(Arc::new(values)), range, georeference)
    }

    /// Of values of this lowest and highest one.
    fn of([width, height]: [usize; 2], values: HeightValues, range: [f32; 2], georeference: Georeference) -> Result<Self, Error> {
        let range @ [low, high] = range.map(f64::from);
        if !(low <= high && low >= LOWEST && high <= HIGHEST) {
            return refuse(Refusal::HeightRange { low, high });
        }
        let (georeference, said) = (georeference.checked()?, Arc::default());
        Ok(Self { georeference, width, height, values, range, factor: 1.0, unit_m: None, said })
    }

    /// The same in the system of this code, with heights in a unit of so many m, where these are known.
    pub(super) fn in_system(self, epsg: Option<u16>, unit_m: Option<f64>) -> Self {
        Self { unit_m, said: Arc::new(SaidSystem { epsg, ..SaidSystem::default() }), ..self }
    }

    /// Reads a GeoTIFF of whole or floating-point numbers, or an ESRI ASCII grid. Whole numbers of 8 bits, as pictures have them, are heights where the file
    /// says so. `sidecars`: where a TIFF lies that does not say so, and the system.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn read(file: &[u8], sidecars: impl Into<Sidecars>) -> Result<Self, Error> {
        Self::open(Arc::new(file.to_vec()), sidecars)
    }

    /// The same of a file that is given in parts. A GeoTIFF of more than 100 million heights in tiles or strips is looked through once, and then read where
    /// it is needed; everything else at once.
    ///
    /// # Errors
    /// [`Error::InvalidInput`], [`Error::UnreadableImage`] and [`Error::Degenerate`] for what is neither, is damaged or lies nowhere.
    pub fn open(file: Arc<dyn FileSource>, sidecars: impl Into<Sidecars>) -> Result<Self, Error> {
        let sidecars = sidecars.into();
        if is_tiff(&file) {
            return Self::of_tiff(file, &sidecars, HeightValues::MOST_WHOLE);
        }
        let file = read_all(&*file, Document::Heights)?;
        let Ok(text) = std::str::from_utf8(&file) else { return refuse(Refusal::NoHeightModel) };
        let said = sidecars.system(SaidSystem::default())?;
        Ok(Self { unit_m: said.height_unit_m, said: Arc::new(said), ..Self::read_ascii(text)? })
    }

    /// The EPSG code of its system, where its file tells one.
    pub fn epsg(&self) -> Option<u16> {
        self.said.epsg
    }

    /// Width and height.
    pub(crate) fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// The heights row by row.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for those that are read in parts.
    pub(super) fn all(&self) -> Result<Cow<'_, [f32]>, Error> {
        let values = self.values.all()?;
        Ok(match self.factor {
            1.0 => values,
            factor => values.iter().map(|value| (factor * f64::from(*value)) as f32).collect(),
        })
    }

    /// The same of heights that are so many times as large.
    fn times(self, factor: f64) -> Self {
        Self { range: self.range.map(|height| factor * height), factor: factor * self.factor, ..self }
    }

    /// Of more than so many heights they are read where they are needed.
    fn of_tiff(file: Arc<dyn FileSource>, sidecars: &Sidecars, most_whole: usize) -> Result<Self, Error> {
        let tags = GeoTags::read(Arc::clone(&file))?;
        let georeference = match (tags.georeference, &sidecars.world_file) {
            (Some(own), _) => own,
            (None, Some(text)) => Georeference::read_world_file(text)?,
            (None, None) => {
                return refuse(Refusal::HeightsWithoutPlace);
            }
        };
        let numbers = Numbers::open(file)?;
        let is_said = tags.system.height_code.is_some() || tags.system.height_unit_m.is_some();
        if numbers.are_as_of_picture() && !is_said {
            return refuse(Refusal::HeightsOfPicture);
        }
        let size @ [width, height] = numbers.size();
        if width < 2 || height < 2 {
            return refuse(Refusal::HeightCount { heights: width * height, width, height });
        }
        let said = sidecars.system(tags.system)?;
        let (values, range) = HeightValues::of_file(numbers, most_whole)?;
        Ok(Self { unit_m: said.height_unit_m, said: Arc::new(said), ..Self::of(size, values, range, georeference)? })
    }

    /// # Source
    /// ESRI, ASCII raster format: `ncols`, `nrows`, `xllcorner` or `xllcenter`, `yllcorner` or `yllcenter`, `cellsize`, `nodata_value`.
    fn read_ascii(text: &str) -> Result<Self, Error> {
        let mut words = text.split_whitespace().peekable();
        let mut head = std::collections::BTreeMap::new();
        while let Some(name) =
            words.next_if(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()) && !word.eq_ignore_ascii_case("nan"))
        {
            let value = words.next().and_then(|word| word.parse::<f64>().ok());
            head.insert(name.to_ascii_lowercase(), value.ok_or_else(|| Refusal::GridWord { name: name.into() }.into_error())?);
        }
        let of = |name: &str| head.get(name).copied().ok_or_else(|| Refusal::GridLacks { name: name.into() }.into_error());
        let (columns, rows, cell) = (of("ncols")?, of("nrows")?, of("cellsize")?);
        if !(columns >= 2.0 && rows >= 2.0 && cell > 0.0) {
            return refuse(Refusal::GridSize { columns, rows, cell });
        }
        if columns * rows > MOST_VALUES as f64 {
            return refuse_many([columns as usize, rows as usize]);
        }
        let low = |corner: &str, centre: &str| of(corner).or_else(|_| of(centre).map(|v| v - 0.5 * cell));
        let [x, y] = [low("xllcorner", "xllcenter")?, low("yllcorner", "yllcenter")?];
        let hole = Some(head.get("nodata_value").copied().unwrap_or(NO_HEIGHT) as f32);
        let value = |word: &str| word.parse::<f32>().map(|v| if Some(v) == hole { f32::NAN } else { v });
        let values: Result<Vec<f32>, _> =
            words.map(|word| value(word).map_err(|_| Refusal::GridHeight { word: format!("{word:?}") }.into_error())).collect();
        Self::new(columns as usize, rows as usize, values?, Georeference::north_up([x, y + rows * cell], cell))
    }

    /// The height at a place; `None` outside, and where one of the four heights around it is missing. Half a pixel at the edges has the
    /// height of the edge.
    pub fn at(&self, place: [f64; 2]) -> Option<f64> {
        let [x, y] = self.georeference.pixel(place);
        if !(x >= 0.0 && y >= 0.0 && x <= self.width as f64 && y <= self.height as f64) {
            return None;
        }
        let along = |position: f64, number: usize| {
            let from_centre = (position - 0.5).clamp(0.0, (number - 1) as f64);
            let first = (from_centre as usize).min(number - 2);
            (first, from_centre - first as f64)
        };
        let ((column, s), (row, t)) = (along(x, self.width), along(y, self.height));
        let values = self.values.four_from(column, row, self.width);
        // A hole counts only where it has a share.
        let share = |k: usize, share: f64| if share > 0.0 { share * f64::from(values[k]) } else { 0.0 };
        let above = share(0, (1.0 - s) * (1.0 - t)) + share(1, s * (1.0 - t));
        let height = above + share(2, (1.0 - s) * t) + share(3, s * t);
        height.is_finite().then_some(self.factor * height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRID: &str = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 50\ncellsize 10\nNODATA_value -9999\n1 2 3\n4 5 -9999\n";

    /// A TIFF of whole numbers of 8 bits, with what GDAL says of them and its GeoKeys.
    fn of_bytes(metadata: &str, keys: &[u16]) -> Vec<u8> {
        use tiff::encoder::{TiffEncoder, colortype::Gray8};
        use tiff::tags::Tag;
        let mut out = std::io::Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut out).unwrap();
        let mut image = encoder.new_image::<Gray8>(3, 2).unwrap();
        image.encoder().write_tag(Tag::Unknown(42112), metadata).unwrap();
        image.encoder().write_tag(Tag::GeoKeyDirectoryTag, keys).unwrap();
        image.write_data(&[10, 20, 30, 40, 50, 60]).unwrap();
        out.into_inner()
    }

    #[test]
    fn a_picture_is_no_height_model_unless_it_says_so() {
        let read = |metadata: &str, keys: &[u16]| HeightModel::read(&of_bytes(metadata, keys), Some("10\n0\n0\n-10\n105\n65\n"));
        let (nothing, in_feet) = ([1, 1, 0, 0], [1, 1, 0, 1, 4099, 0, 1, 9002]);
        assert_eq!(read("", &nothing).unwrap_err(), Refusal::HeightsOfPicture.into_error());
        assert_eq!(read("", &in_feet).unwrap().at([115.0, 55.0]), Some(50.0));
        let scaled = r#"<GDALMetadata><Item name="SCALE" sample="0" role="scale">2</Item></GDALMetadata>"#;
        assert_eq!(read(scaled, &nothing).unwrap().at([115.0, 55.0]), Some(100.0));
    }

    #[test]
    fn heights_are_interpolated_between_the_centres() {
        let model = HeightModel::read(GRID.as_bytes(), None).unwrap();
        assert_eq!([model.at([105.0, 65.0]), model.at([115.0, 55.0])], [Some(1.0), Some(5.0)]);
        assert_eq!((model.at([110.0, 60.0]), model.at([100.0, 70.0])), (Some(3.0), Some(1.0)));
        // A hole, and outside.
        assert_eq!([model.at([123.0, 58.0]), model.at([99.9, 60.0]), model.at([f64::NAN, 60.0])], [None; 3]);
        let centred = GRID.replace("xllcorner 100", "xllcenter 105").replace("yllcorner 50", "yllcenter 55");
        let centred = HeightModel::read(centred.as_bytes(), None).unwrap();
        assert_eq!((centred.georeference, centred.range), (model.georeference, model.range));
    }

    #[test]
    fn heights_in_feet_become_metres_with_their_places() {
        const FOOT_M: f64 = 0.3048;
        let model = HeightModel { unit_m: Some(FOOT_M), ..HeightModel::read(GRID.as_bytes(), None).unwrap() };
        let [own, metric] = [Heights::Model(model.clone()), Heights::Model(model).in_metres(0.5)];
        for place in [[105.0, 65.0], [110.0, 60.0], [101.0, 69.0]] {
            assert_eq!(metric.at(place.map(|v| 0.5 * v)), own.at(place).map(|height| FOOT_M * height));
        }
        assert_eq!((metric.range(), metric.at([61.5, 29.0])), ([FOOT_M, 5.0 * FOOT_M], None));
        // In m it is what it is.
        let again = metric.in_metres(1.0);
        assert_eq!((again.range(), again.at([52.5, 32.5])), (metric.range(), metric.at([52.5, 32.5])));
        assert_eq!((Heights::Level(7.0).in_metres(0.3), Heights::Level(7.0).unit_m()), (Heights::Level(7.0), 1.0));
    }

    #[test]
    fn what_is_no_height_model_is_refused_with_what_it_is() {
        let said = |text: &str| HeightModel::read(text.as_bytes(), None).unwrap_err().to_string();
        assert!(said(&GRID.replace("cellsize 10", "")).contains("no cellsize"), "{}", said(&GRID.replace("cellsize 10", "")));
        assert!(said(&GRID.replace(" 3\n4", " x\n4")).contains("\"x\""));
        assert!(said(&GRID.replace("1 2 3", "1 2")).contains("5 heights"));
        assert!(said(&GRID.replace("1 2 3", "1 2 99999")).contains("99999"));
        let many = GRID.replace("ncols 3", "ncols 10001").replace("nrows 2", "nrows 10000");
        assert!(said(&many).contains("got 10001 x 10000 heights; allowed: up to 100 million"), "{}", said(&many));
        assert!(said("").contains("ESRI ASCII grid") && said("II").contains("ESRI"));
        assert!(HeightModel::read(&[0xff, 0xfe, 0x80], None).is_err() && HeightModel::read(b"II*\0\x08\0\0\0", None).is_err());
    }
}
