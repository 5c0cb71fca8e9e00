//! The tags of GeoTIFF: where a TIFF lies, in which system and units, and which value stands for nothing.

use super::georeference::Georeference;
use crate::crs::{Definition, Described, Projection, Vertical};
use crate::error::refuse;
use crate::image::{Directory, checked_directory};
use crate::text::shorten;
use crate::{Error, FileSource, Refusal};

pub(crate) const PIXEL_SCALE: u64 = 33550;
pub(crate) const TIE_POINTS: u64 = 33922;
pub(crate) const TRANSFORMATION: u64 = 34264;
pub(crate) const KEYS: u64 = 34735;
pub(crate) const KEY_NUMBERS: u64 = 34736;
pub(crate) const KEY_TEXTS: u64 = 34737;
/// Of GDAL, in no standard.
pub(crate) const NO_DATA: u64 = 42113;

pub(crate) const MODEL_TYPE: u16 = 1024;
pub(crate) const RASTER_TYPE: u16 = 1025;
const CITATION: u16 = 1026;
const GEOGRAPHIC_SYSTEM: u16 = 2048;
const ANGULAR_UNIT: u16 = 2054;
pub(crate) const PROJECTED_SYSTEM: u16 = 3072;
const PROJECTED_CITATION: u16 = 3073;
const PROJECTION_CODE: u16 = 3074;
pub(crate) const LINEAR_UNIT: u16 = 3076;
const LINEAR_UNIT_SIZE: u16 = 3077;
const PROJECTION: u16 = 3075;
const PARALLELS: [u16; 2] = [3078, 3079];
const ORIGIN: [u16; 2] = [3080, 3081];
const OF_ORIGIN: [u16; 2] = [3082, 3083];
/// Of Lambert's conic projection with two parallels: those of its false origin, for which some writers take the others.
const FALSE_ORIGIN: [u16; 2] = [3084, 3085];
const OF_FALSE_ORIGIN: [u16; 2] = [3086, 3087];
const SCALE: u16 = 3092;
/// Codes of geographic systems whose longitudes count from Paris, Ferro and others.
const OTHER_MERIDIANS: std::ops::RangeInclusive<u16> = 4801..=4904;
const DEGREE: u16 = 9102;
const TRANSVERSE_MERCATOR: u16 = 1;
const CONIC_OF_TWO_PARALLELS: u16 = 8;
const CONIC_OF_ONE_PARALLEL: u16 = 9;
const HEIGHT_SYSTEM: u16 = 4096;
pub(crate) const HEIGHT_UNIT: u16 = 4099;
pub(crate) const PROJECTED: u16 = 1;
const GEOGRAPHIC: u16 = 2;
const PIXEL_IS_POINT: u16 = 2;
/// Says 'described by other keys'.
const USER_DEFINED: u16 = 32767;

/// Units of length by their codes, in m: the metre, the international foot, the foot of the US survey.
const UNITS: [(u16, f64); 3] = [(9001, 1.0), (9002, 0.3048), (9003, 1200.0 / 3937.0)];

/// The code of a unit of length other than the metre, which files have without saying so; absent where it has none here.
pub(crate) fn unit_code(unit_m: f64) -> Option<u16> {
    UNITS[1..].iter().find(|(_, own_m)| (own_m - unit_m).abs() < UNIT_DIGITS).map(|(code, _)| *code)
}

/// Units that differ by less are one, written with fewer digits.
const UNIT_DIGITS: f64 = 1e-9;

/// What a TIFF says of its place.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct GeoTags {
    pub georeference: Option<Georeference>,
    pub system: SaidSystem,
    pub no_data: Option<f64>,
}

/// What a file says of its coordinate reference system.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SaidSystem {
    /// The code of its projected system, where it has one.
    pub epsg: Option<u16>,
    /// The name of a system that is described without a code.
    pub described: Option<String>,
    /// Its parameters, where the projection is one that is read.
    pub parameters: Option<Described>,
    /// The text of a file beside it.
    pub text: Option<String>,
    /// The unit of eastings and northings in m.
    pub unit_m: Option<f64>,
    /// The unit of heights in m.
    pub height_unit_m: Option<f64>,
    /// The code of what its heights count from.
    pub height_code: Option<u16>,
}

impl SaidSystem {
    /// Its code, or the name of a system without one.
    pub fn name(&self) -> Option<String> {
        let described = || self.described.as_deref().filter(|name| !name.is_empty()).map(shorten);
        self.epsg.map(name_of).or_else(described)
    }

    /// The unit of eastings and northings in m: the one that the file names, or that of the system.
    pub fn plane_unit_m(&self) -> Option<f64> {
        self.unit_m.or_else(|| self.definition()?.unit_m())
    }

    /// What its heights count from: by their own code, or as its system has them. Absent where nothing says it.
    pub fn vertical(&self) -> Option<Vertical> {
        self.height_code.and_then(Vertical::of_code).or_else(|| Vertical::of_system(&self.definition()?))
    }

    /// Absent for a code that is unknown here, and for a system of which not all is said.
    pub fn definition(&self) -> Option<Definition> {
        match self.epsg {
            Some(code) => Definition::read(&name_of(code)).ok(),
            None => self.text.as_deref().map_or_else(|| self.parameters.as_ref()?.definition(), |text| Definition::read(text).ok()),
        }
    }
}

/// As systems are named by their code.
pub(crate) fn name_of(code: u16) -> String {
    format!("EPSG:{code}")
}

impl GeoTags {
    /// Reads the tags of the first image.
    ///
    /// # Errors
    /// [`Error::UnreadableImage`] for a truncated file; [`Error::InvalidInput`] where coordinates are degrees, or the tags place no picture.
    ///
    /// # Source
    /// OGC 19-008r4, GeoTIFF standard 1.1.
    pub fn read<S: FileSource>(tiff: S) -> Result<Self, Error> {
        let directory = checked_directory(tiff)?;
        let keys = Keys::read(&directory);
        if keys.short(MODEL_TYPE) == Some(GEOGRAPHIC) {
            return refuse_degrees();
        }
        Ok(Self { georeference: place(&directory, &keys)?, system: keys.system()?, no_data: number_of(&directory, NO_DATA) })
    }
}

/// Of a raster at longitudes and latitudes: the way to these from its pixels; absent for one of another system, and where it has no place.
///
/// # Errors
/// As [`GeoTags::read`].
pub(super) fn degrees_of(tiff: &[u8]) -> Result<Option<Georeference>, Error> {
    let directory = checked_directory(tiff)?;
    let keys = Keys::read(&directory);
    if keys.short(MODEL_TYPE) != Some(GEOGRAPHIC) || keys.short(ANGULAR_UNIT).is_some_and(|unit| unit != DEGREE) {
        return Ok(None);
    }
    place(&directory, &keys)
}

fn place<S: FileSource>(directory: &Directory<S>, keys: &Keys) -> Result<Option<Georeference>, Error> {
    let Some(of_corner) = transformation(directory).filter(|own| *own != NOWHERE) else { return Ok(None) };
    let half = if keys.short(RASTER_TYPE) == Some(PIXEL_IS_POINT) { -0.5 } else { 0.0 };
    Georeference { origin: of_corner.ground([half, half]), ..of_corner }.checked().map(Some)
}

/// A number that a tag has as text.
pub(super) fn number_of<S: FileSource>(directory: &Directory<S>, tag: u64) -> Option<f64> {
    directory.text(tag).and_then(|text| text.parse().ok())
}

/// Angles are no lengths: north and east differ by the cosine of the latitude.
pub(crate) fn refuse_degrees<T>() -> Result<T, Error> {
    refuse(Refusal::Degrees)
}

/// The identity: programs write it of pictures that lie nowhere.
const NOWHERE: Georeference = Georeference { origin: [0.0; 2], by_column: [1.0, 0.0], by_row: [0.0, 1.0] };

/// By which (0, 0) of the raster, be that a corner or a centre, and its steps lie on the map.
fn transformation<S: FileSource>(directory: &Directory<S>) -> Option<Georeference> {
    if let Some(&[a, b, _, x, d, e, _, y, ..]) = directory.doubles(TRANSFORMATION).as_deref() {
        return Some(Georeference { origin: [x, y], by_column: [a, d], by_row: [b, e] });
    }
    let (scale, ties) = (directory.doubles(PIXEL_SCALE)?, directory.doubles(TIE_POINTS)?);
    let (&[sx, sy, ..], &[i, j, _, x, y, ..]) = (scale.as_slice(), ties.as_slice()) else { return None };
    Some(Georeference { origin: [x - i * sx, y + j * sy], by_column: [sx, 0.0], by_row: [0.0, -sy] })
}

/// The directory of keys, with the numbers and texts that do not stand in itself.
struct Keys {
    entries: Vec<[u16; 4]>,
    numbers: Vec<f64>,
    text: String,
}

impl Keys {
    fn read<S: FileSource>(directory: &Directory<S>) -> Self {
        let shorts = directory.all_shorts(KEYS).unwrap_or_default();
        let entries = shorts.get(4..).map(|entries| entries.as_chunks::<4>().0.to_vec()).unwrap_or_default();
        let numbers = directory.doubles(KEY_NUMBERS).unwrap_or_default();
        Self { entries, numbers, text: directory.text(KEY_TEXTS).unwrap_or_default() }
    }

    fn entry(&self, wanted: u16, place: u64) -> Option<&[u16; 4]> {
        self.entries.iter().find(|entry| entry[0] == wanted && u64::from(entry[1]) == place)
    }

    /// The value of a key that stands in the directory of keys itself.
    fn short(&self, wanted: u16) -> Option<u16> {
        self.entry(wanted, 0).map(|entry| entry[3])
    }

    fn number(&self, wanted: u16) -> Option<f64> {
        self.numbers.get(usize::from(self.entry(wanted, KEY_NUMBERS)?[3])).copied()
    }

    /// Texts end with a bar.
    fn text(&self, wanted: u16) -> Option<&str> {
        let [_, _, length, first] = *self.entry(wanted, KEY_TEXTS)?;
        let (first, length) = (usize::from(first), usize::from(length));
        let text = self.text.get(first..(first + length).min(self.text.len()))?;
        Some(text.trim_end_matches(['|', '\0', ' '])).filter(|text| !text.is_empty())
    }

    /// # Errors
    /// [`Error::InvalidInput`] for units of length that are not known.
    fn system(&self) -> Result<SaidSystem, Error> {
        let describes =
            || [PROJECTED_CITATION, PROJECTION_CODE, PROJECTION].iter().any(|key| self.entries.iter().any(|entry| entry[0] == *key));
        let code = self.short(PROJECTED_SYSTEM).filter(|code| *code != 0).or_else(|| describes().then_some(USER_DEFINED));
        let epsg = code.filter(|code| *code != USER_DEFINED);
        let citation = || self.text(PROJECTED_CITATION).or_else(|| self.text(CITATION)).unwrap_or_default();
        let unit_m = |key: u16| match self.short(key).filter(|code| *code != 0 && *code != USER_DEFINED) {
            None => Ok(None),
            Some(code) => match UNITS.iter().find(|(unit, _)| *unit == code) {
                Some((_, unit_m)) => Ok(Some(*unit_m)),
                None => refuse(Refusal::OrthophotoUnit { code }),
            },
        };
        let stated_m = self.number(LINEAR_UNIT_SIZE).filter(|unit_m| unit_m.is_finite() && *unit_m > 0.0);
        let described = (code == Some(USER_DEFINED)).then(|| citation().to_string());
        let plane_m = match stated_m {
            Some(stated_m) => Some(stated_m),
            None => unit_m(LINEAR_UNIT)?,
        };
        let parameters = described.as_ref().and_then(|name| self.described(name, plane_m.unwrap_or(1.0)));
        let height_code = self.short(HEIGHT_SYSTEM).filter(|code| *code != 0 && *code != USER_DEFINED);
        let height_unit_m = unit_m(HEIGHT_UNIT)?;
        let said = SaidSystem { epsg, described, parameters, text: None, unit_m: plane_m, height_unit_m, height_code };
        // A vertical system has its unit, which the key need not repeat.
        let own_m = || said.vertical().and_then(|vertical| vertical.unit_m);
        Ok(SaidSystem { height_unit_m: height_unit_m.or_else(own_m), ..said })
    }

    /// A system by its parameters; absent for other projections, and where one is missing.
    fn described(&self, name: &str, unit_m: f64) -> Option<Described> {
        let base_epsg =
            self.short(GEOGRAPHIC_SYSTEM).filter(|code| *code != USER_DEFINED && *code != 0 && !OTHER_MERIDIANS.contains(code))?;
        if self.short(ANGULAR_UNIT).is_some_and(|unit| unit != DEGREE) {
            return None;
        }
        let both = |keys: [u16; 2]| Some([self.number(keys[0])?, self.number(keys[1])?]);
        let (projection, scale, at) = match self.short(PROJECTION)? {
            TRANSVERSE_MERCATOR => (Projection::TransverseMercator, self.number(SCALE)?, None),
            CONIC_OF_ONE_PARALLEL => (Projection::Conic { parallels_deg: None }, self.number(SCALE)?, None),
            CONIC_OF_TWO_PARALLELS => {
                (Projection::Conic { parallels_deg: Some(both(PARALLELS)?) }, 1.0, both(FALSE_ORIGIN).zip(both(OF_FALSE_ORIGIN)))
            }
            _ => return None,
        };
        let (origin_deg, of_origin) = at.or_else(|| both(ORIGIN).zip(both(OF_ORIGIN)))?;
        let name = if name.is_empty() { format!("EPSG:{base_epsg}") } else { name.into() };
        Some(Described { name, base_epsg, unit_m, projection, origin_deg, scale, of_origin })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A TIFF of one directory that has these keys, and nothing of a picture.
    fn tiff(keys: &[[u16; 4]], numbers: &[f64], text: &str) -> Vec<u8> {
        let entries: Vec<u16> = [&[1, 1, 0, keys.len() as u16][..], keys.concat().as_slice()].concat();
        let shorts: Vec<u8> = entries.iter().flat_map(|v| v.to_le_bytes()).collect();
        let doubles: Vec<u8> = numbers.iter().flat_map(|v| v.to_le_bytes()).collect();
        let text = [text.as_bytes(), b"\0"].concat();
        let tags = [(KEYS, 3_u16, entries.len(), shorts), (KEY_NUMBERS, 12, numbers.len(), doubles), (KEY_TEXTS, 2, text.len(), text)];
        let mut file = vec![b'I', b'I', 42, 0, 8, 0, 0, 0, tags.len() as u8, 0];
        let mut at = 8 + 2 + 12 * tags.len() + 4;
        for (tag, kind, count, bytes) in &tags {
            file.extend([(*tag as u16).to_le_bytes(), kind.to_le_bytes()].concat());
            file.extend((*count as u32).to_le_bytes());
            file.extend((at as u32).to_le_bytes());
            at += bytes.len();
        }
        file.extend([0; 4]);
        tags.iter().for_each(|(_, _, _, bytes)| file.extend(bytes));
        file
    }

    fn said(keys: &[[u16; 4]], numbers: &[f64], text: &str) -> SaidSystem {
        GeoTags::read(&tiff(keys, numbers, text)[..]).unwrap().system
    }

    #[test]
    fn systems_are_named_by_code_or_described_in_units_of_length() {
        const FOOT_US: f64 = 1200.0 / 3937.0;
        let coded = said(&[[MODEL_TYPE, 0, 1, PROJECTED], [PROJECTED_SYSTEM, 0, 1, 2227], [LINEAR_UNIT, 0, 1, 9003]], &[1.0], "x|");
        assert_eq!(coded, SaidSystem { epsg: Some(2227), unit_m: Some(FOOT_US), ..SaidSystem::default() });
        let texts = "all of it|California zone 3|";
        let own = [
            [CITATION, KEY_TEXTS as u16, 10, 0],
            [PROJECTED_SYSTEM, 0, 1, USER_DEFINED],
            [PROJECTED_CITATION, KEY_TEXTS as u16, 18, 10],
            [LINEAR_UNIT, 0, 1, USER_DEFINED],
            [LINEAR_UNIT_SIZE, KEY_NUMBERS as u16, 1, 1],
            [HEIGHT_UNIT, 0, 1, 9002],
        ];
        let described = said(&own, &[7.0, 0.3], texts);
        let name = Some("California zone 3".to_string());
        assert_eq!(described, SaidSystem { described: name, unit_m: Some(0.3), height_unit_m: Some(0.3048), ..SaidSystem::default() });
        let unnamed = said(&[own[0], own[1]], &[0.0], texts);
        assert_eq!(unnamed.described.as_deref(), Some("all of it"));
        // Without a code of its own a system that is described is none that nothing is said of.
        assert_eq!(said(&[own[2]], &[0.0], texts).described.as_deref(), Some("California zone 3"));
        // What heights count from, by their own code before that of a system with heights.
        let heights = |keys: &[[u16; 4]]| said(keys, &[1.0], "x|").vertical().map(|vertical| (vertical.name, vertical.is_ellipsoidal));
        let compound = [PROJECTED_SYSTEM, 0, 1, 5555];
        let egm96 = heights(&[compound, [HEIGHT_SYSTEM, 0, 1, 5773]]).unwrap();
        assert!(egm96.0.contains("EGM96") && !egm96.1, "{egm96:?}");
        assert!(heights(&[compound]).is_some_and(|(name, is_ellipsoidal)| name.contains("DHHN92") && !is_ellipsoidal));
        assert!(heights(&[[HEIGHT_SYSTEM, 0, 1, 4979]]).is_some_and(|(_, is_ellipsoidal)| is_ellipsoidal));
        for nothing in [0, USER_DEFINED, 9999] {
            assert_eq!(heights(&[[PROJECTED_SYSTEM, 0, 1, 25832], [HEIGHT_SYSTEM, 0, 1, nothing]]), None);
        }
        // Their unit is that of their system, unless a key has another.
        let unit_m = |keys: &[[u16; 4]]| said(keys, &[1.0], "x|").height_unit_m;
        let feet = [[PROJECTED_SYSTEM, 0, 1, 2227], [HEIGHT_SYSTEM, 0, 1, 6360], [HEIGHT_UNIT, 0, 1, 9001]];
        assert_eq!([unit_m(&feet[..1]), unit_m(&feet), unit_m(&[compound])], [None, Some(1.0), Some(1.0)]);
        assert!(unit_m(&feet[..2]).is_some_and(|found| (found - FOOT_US).abs() < 1e-12), "{:?}", unit_m(&feet[..2]));
        let rods = GeoTags::read(&tiff(&[[LINEAR_UNIT, 0, 1, 9042]], &[0.0], "")[..]).unwrap_err();
        assert!(rods.to_string().contains("9042"), "{rods}");
        // Keys that lead nowhere say nothing.
        let broken =
            [[PROJECTED_SYSTEM, 0, 1, USER_DEFINED], [CITATION, KEY_TEXTS as u16, 900, 800], [LINEAR_UNIT_SIZE, KEY_NUMBERS as u16, 1, 9]];
        assert_eq!(said(&broken, &[0.3], "a|"), SaidSystem { described: Some(String::new()), ..SaidSystem::default() });
        assert_eq!(said(&[[MODEL_TYPE, 0, 1, PROJECTED]], &[0.3], "a|"), SaidSystem::default());
    }

    #[test]
    fn parameters_of_a_system_are_read_where_all_are_there() {
        let number = |key: u16, at: u16| [key, KEY_NUMBERS as u16, 1, at];
        let head = [
            [GEOGRAPHIC_SYSTEM, 0, 1, 4269],
            [ANGULAR_UNIT, 0, 1, DEGREE],
            [PROJECTED_SYSTEM, 0, 1, USER_DEFINED],
            [LINEAR_UNIT, 0, 1, 9003],
        ];
        let conic = [[PROJECTION, 0, 1, CONIC_OF_TWO_PARALLELS], number(3078, 0), number(3079, 1)];
        let false_origin = [number(3084, 2), number(3085, 3), number(3086, 4), number(3087, 5)];
        let origin = [number(3080, 2), number(3081, 3), number(3082, 4), number(3083, 5)];
        let numbers = [37.0, 38.5, -120.5, 36.5, 6e6, 1e6, 0.9996];
        let expected = Described {
            name: "EPSG:4269".into(),
            base_epsg: 4269,
            unit_m: 1200.0 / 3937.0,
            projection: Projection::Conic { parallels_deg: Some([37.0, 38.5]) },
            origin_deg: [-120.5, 36.5],
            scale: 1.0,
            of_origin: [6e6, 1e6],
        };
        let read = |keys: &[&[[u16; 4]]]| said(&keys.concat(), &numbers, "").parameters;
        assert_eq!(read(&[&head, &conic, &false_origin]), Some(expected.clone()));
        assert_eq!(read(&[&head, &conic, &origin]), Some(expected.clone()));
        let transverse = [[PROJECTION, 0, 1, TRANSVERSE_MERCATOR], number(SCALE, 6)];
        let transversal = Described { projection: Projection::TransverseMercator, scale: 0.9996, ..expected };
        assert_eq!(read(&[&head, &transverse, &origin]), Some(transversal));
        assert_eq!(read(&[&head, &transverse[..1], &origin]), None);
        assert_eq!(read(&[&head, &conic, &origin[..3]]), None);
        assert_eq!(read(&[&head[1..], &conic, &origin]), None);
        assert_eq!(read(&[&head, &[[PROJECTION, 0, 1, 15]], &origin]), None);
    }
}
