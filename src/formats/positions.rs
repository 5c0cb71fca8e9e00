//! Reading where images were taken: the GNSS positions of a block from a table.

use super::column_units::units;
use super::columns::UnreadColumns;
use super::control::StatedUnit;
use super::control_columns::Coordinates;
use super::error_columns::ErrorColumns;
use super::hemispheres::{Axis, on_side};
use super::position_columns::PositionColumns;
use super::system_line::SystemLine;
use super::whole_numbers::has_leading_zero;
use crate::error::refuse;
use crate::text::{Headed, NumberedRecord, Records, is_none, records, shorten};
use crate::{Error, Input, Refusal};
use csv::StringRecord;
use serde::{Deserialize, Serialize};

/// The positions of images that a table has.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImagePositions {
    /// Whether places are longitude and latitude of WGS 84 in degrees, with heights above the ellipsoid; else they are x and y of a coordinate reference system.
    pub is_geographic: bool,
    pub rows: Vec<ImagePositionRow>,
}

/// The position of an image as a table has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImagePositionRow {
    /// The image as the table names it: its file name, perhaps with a folder or without its ending.
    pub image: String,
    /// Longitude and latitude in degrees, or x and y in the unit of the coordinate reference system.
    pub place: [f64; 2],
    /// Absent where the table has none.
    pub height: Option<f64>,
    /// Standard errors of the place and of the height in m, above 0; each is absent where the table has none.
    pub standard_errors: [Option<f64>; 2],
    /// The line of the table, counted from 1.
    pub line: usize,
}

/// Reads lines of image, longitude, latitude and height, or image, x, y and height, between commas, semicolons or tabs; between the latter two numbers may
/// have a decimal comma.
///
/// A first line that names columns may come before them, in any order, among others, in capitals or not, also behind a `#`: image, longitude and latitude or x
/// and y, height and standard errors of the place and of the height in m, each by one of many names, English or German. Longitudes and latitudes are read
/// where there are x and y beside them, with the height above the ellipsoid where there are two. What a run does not read it reports.
///
/// Longitudes and latitudes may have the letters of their hemispheres, in the field or in a column of their own (`GPSLatitudeRef`), and minutes and seconds, as
/// ExifTool writes them; heights above sea level and below it likewise. (0, 0), which receivers without a fix write, is no position.
///
/// Places under names that leave it open (`x`, `X/Longitude`) are longitudes and latitudes where all of them can be. Without names the columns are image, x,
/// y, height; of six columns the last two, and of nine, behind three angles, the last two are standard errors, where all of them are above 0 and up to 50 m. Degrees without names are longitude and
/// latitude in whatever order, where one of the two is beyond 90° somewhere. Rows without any coordinate, which a dash may stand for, are skipped, as are blank lines and
/// lines that begin with `#`.
///
/// # Errors
/// [`Error::InvalidInput`] for a table without any position; naming the line, for numbers that are none, hemispheres that are none or contradict a sign, commas
/// that may be decimal ones, images without a name, standard errors that are not above 0, and longitudes and
/// latitudes that cannot be; for degrees without names whose order nothing tells.
///
/// # Source
/// The tables of image positions of Metashape, Pix4D and Emlid, and of EXIF as ExifTool writes it.
pub fn parse_image_positions(text: &str) -> Result<ImagePositions, Error> {
    Table::read(text)?.positions().map(|(positions, _)| positions)
}

/// What a table of image positions says beside them.
#[derive(Debug, Clone, Default)]
pub(crate) struct PositionHead {
    /// Columns that are not read.
    pub unread: UnreadColumns,
    /// Units that columns of coordinates have in their names.
    pub stated_units: Vec<StatedUnit>,
    /// Columns of standard errors that say no unit.
    pub error_columns: ErrorColumns,
    /// A column of heights that is not understood, and how many positions have none for it.
    pub unread_height: Option<(String, usize)>,
    /// Images at longitude 0 and latitude 0, as the table names them.
    pub nowhere: Vec<String>,
    /// The coordinate system that the table names for itself.
    pub system: Option<SystemLine>,
}

/// What the table says beside its positions.
///
/// # Errors
/// As [`parse_image_positions`].
pub(crate) fn position_head(text: &str) -> Result<PositionHead, Error> {
    let table = Table::read(text)?;
    let (head, columns) = (table.head.as_ref(), &table.columns);
    let stated_units = head.map(|head| columns.stated_units(head)).unwrap_or_default();
    let (positions, nowhere) = table.positions()?;
    let of_side = columns.sides[Axis::Height as usize].and_then(|side| head?.get(side)).map(shorten);
    let unsided = table.rows().iter().filter(|(_, record)| table.has_unknown_side(record)).count();
    let unread_height = match head.and_then(|head| columns.unread_height(head)) {
        Some(column) => Some((column, positions.rows.len())),
        None => of_side.map(|column| (column, unsided)).filter(|(_, unsided)| *unsided > 0),
    };
    let (unread, error_columns) = (columns.unread(table.rows(), head), columns.error_columns(head));
    Ok(PositionHead { unread, stated_units, error_columns, unread_height, nowhere, system: table.system.clone() })
}

struct Table {
    records: Records,
    /// The line of names, where there is one.
    head: Option<StringRecord>,
    /// Of the records so many, the first, are no rows: titles, names, and their units.
    above: usize,
    columns: PositionColumns,
    /// The coordinate system that it names for itself.
    system: Option<SystemLine>,
}

impl Table {
    fn read(text: &str) -> Result<Self, Error> {
        let mut records = records(Input::PositionTable, text)?;
        let system = SystemLine::of(&records);
        if system.is_some() {
            records.rows.remove(0);
        }
        let Headed { names, rows, misplaced } = records.headed(PositionColumns::needed, &units())?;
        let above = records.rows.len() - rows.len();
        let is_number = |field: Option<&str>| field.is_some_and(|field| records.number(field).is_some());
        let is_given = |record: &StringRecord| (1..4).any(|column| record.get(column).is_some_and(|field| !is_none(field)));
        let first = || rows.iter().map(|(_, record)| record).find(|record| is_given(record));
        let is_in_order = || first().is_none_or(|first| [1, 2].iter().all(|column| is_number(first.get(*column))));
        if names.is_none() && misplaced.is_none() && is_in_order() {
            check_in_order(&records)?;
            // Places in a system that is named have east first, also in degrees.
            let coordinates = system.as_ref().map(|_| Coordinates::Either);
            let columns = PositionColumns::in_order(&records, coordinates);
            columns.numbers().check_thousands(&records, rows)?;
            return Ok(Self { columns, records, head: None, above, system });
        }
        let shown = names.or(misplaced).or_else(|| records.likely_head(PositionColumns::needed).cloned()).unwrap_or_default();
        let columns = PositionColumns::named_by(&records, &shown)?;
        columns.numbers().check_thousands(&records, rows)?;
        columns.numbers().check(&records, rows)?;
        Ok(Self { columns, records, head: Some(shown), above, system })
    }

    fn rows(&self) -> &[NumberedRecord] {
        &self.records.rows[self.above..]
    }

    /// The positions, and the images at longitude 0 and latitude 0.
    fn positions(&self) -> Result<(ImagePositions, Vec<String>), Error> {
        let read =
            self.rows().iter().map(|(line, record)| self.row(*line, record)).collect::<Result<Vec<Option<ImagePositionRow>>, Error>>()?;
        let mut rows: Vec<ImagePositionRow> = read.into_iter().flatten().collect();
        if rows.is_empty() {
            return refuse(Refusal::NoPositions { rows: self.rows().len() });
        }
        let is_geographic = match self.columns.coordinates {
            Some(Coordinates::Geographic) => true,
            Some(Coordinates::Plane) => false,
            Some(Coordinates::Either) => rows.iter().all(|row| is_on_earth(row.place)),
            None => in_order_of_degrees(&mut rows)?,
        };
        if let Some(row) = rows.iter().find(|row| is_geographic && !is_on_earth(row.place)) {
            let [longitude_deg, latitude_deg] = row.place;
            return refuse(Refusal::PositionDegrees { longitude_deg, latitude_deg, line: row.line });
        }
        let (nowhere, rows) = rows.into_iter().partition::<Vec<_>, _>(|row| is_geographic && row.place == [0.0; 2]);
        Ok((ImagePositions { is_geographic, rows }, nowhere.into_iter().map(|row| row.image).collect()))
    }

    /// Whether the side of sea level is not known on which the height of a row is.
    fn has_unknown_side(&self, record: &StringRecord) -> bool {
        let side = self.columns.sides[Axis::Height as usize].and_then(|side| record.get(side)).filter(|word| !word.is_empty());
        side.is_some_and(|word| Axis::Height.is_negative(word).is_none())
    }

    fn row(&self, line: usize, record: &StringRecord) -> Result<Option<ImagePositionRow>, Error> {
        let columns = &self.columns;
        let field = |column: usize| record.get(column).unwrap_or("");
        let name = |column: usize| self.head.as_ref().and_then(|head| head.get(column)).map_or_else(|| format!("#{}", column + 1), shorten);
        let plain = |field: &str| self.records.number(field);
        let refused = |column: usize| {
            let refusal = || Refusal::PositionNumber { word: shorten(field(column)), column: name(column), line }.into_error();
            self.records.refused_thousands(field(column), &name(column), line).unwrap_or_else(refusal)
        };
        let number = |column: usize| plain(field(column)).ok_or_else(|| refused(column));
        let is_of_degrees = columns.coordinates.is_some_and(|coordinates| coordinates != Coordinates::Plane);
        let coordinate = |axis: Axis, column: usize| {
            let value = if is_of_degrees { axis.read(field(column), plain) } else { plain(field(column)) };
            let value = value.ok_or_else(|| refused(column))?;
            let Some(side) = columns.sides[axis as usize].filter(|side| axis != Axis::Height || !field(*side).is_empty()) else {
                return Ok(value);
            };
            let refusal = || Refusal::PositionSide { word: shorten(field(side)), column: name(side), value: shorten(field(column)), line };
            axis.is_negative(field(side)).and_then(|is_negative| on_side(value, is_negative)).ok_or_else(|| refusal().into_error())
        };
        let given = |column: Option<usize>| column.filter(|column| !is_none(field(*column))).map(number).transpose();
        let image = field(columns.image).to_string();
        if image.is_empty() || image.chars().any(char::is_control) {
            return refuse(Refusal::PositionName { name: shorten(&image), line });
        }
        if columns.place.into_iter().chain(columns.height).all(|column| is_none(field(column))) {
            return Ok(None);
        }
        let place = [coordinate(Axis::Longitude, columns.place[0])?, coordinate(Axis::Latitude, columns.place[1])?];
        let [unit_x, unit_y, unit_up] = columns.error_units_m;
        let across = match columns.across {
            Some([x, y]) => {
                [given(Some(x))?.map(|x| unit_x * x), given(Some(y))?.map(|y| unit_y * y)].into_iter().flatten().reduce(f64::max)
            }
            None => None,
        };
        let standard_errors = [across, given(columns.up)?.map(|up| unit_up * up)];
        if let Some(error) = standard_errors.into_iter().flatten().find(|error| !(*error > 0.0)) {
            return refuse(Refusal::PositionErrors { errors: error.to_string(), line });
        }
        let height = columns.height.filter(|column| !is_none(field(*column)) && !self.has_unknown_side(record));
        let height = height.map(|column| coordinate(Axis::Height, column)).transpose()?;
        Ok(Some(ImagePositionRow { image, place, height, standard_errors, line }))
    }
}

/// Whether rows without names of columns are degrees, which are then longitude and latitude.
fn in_order_of_degrees(rows: &mut [ImagePositionRow]) -> Result<bool, Error> {
    let Some(first) = rows.first() else { return Ok(false) };
    let (place, line) = (first.place, first.line);
    let is_longitude_first = rows.iter().all(|row| is_on_earth(row.place));
    let is_latitude_first = rows.iter().all(|row| is_on_earth(exchanged(row.place)));
    match (is_longitude_first, is_latitude_first) {
        (true, true) => refuse(Refusal::PositionOrder { x: place[0], y: place[1], line }),
        (false, true) => {
            rows.iter_mut().for_each(|row| row.place = exchanged(row.place));
            Ok(true)
        }
        (is_geographic, false) => Ok(is_geographic),
    }
}

fn exchanged([x, y]: [f64; 2]) -> [f64; 2] {
    [y, x]
}

fn is_on_earth([longitude_deg, latitude_deg]: [f64; 2]) -> bool {
    longitude_deg.abs() <= 180.0 && latitude_deg.abs() <= 90.0
}

/// More numbers than these have decimal points: rows without names have a place, a height, and perhaps what is behind it.
const WHOLE_NUMBERS: usize = 3;

/// Refuses rows without names whose commas may be decimal ones.
fn check_in_order(records: &Records) -> Result<(), Error> {
    for (line, record) in &records.rows {
        let numbers: Vec<&str> = record.iter().skip(1).take_while(|field| records.number(field).is_some()).collect();
        if (numbers.len() > WHOLE_NUMBERS || numbers.iter().any(|field| has_leading_zero(field))) && records.may_be_cut(&numbers) {
            return refuse(Refusal::DecimalCommas { input: Input::PositionTable, record: records.shown(record), line: *line });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> ImagePositions {
        parse_image_positions(text).unwrap_or_else(|error| panic!("{text}: {error}"))
    }

    fn message(text: &str) -> String {
        parse_image_positions(text).unwrap_err().to_string()
    }

    fn unread(text: &str) -> UnreadColumns {
        position_head(text).unwrap().unread
    }

    #[test]
    fn titles_and_units_stand_about_the_names_and_commas_are_no_decimal_ones() {
        let own = read("image,x,y,z\na.jpg,446833.25,5594521.5,171\n").rows[0].clone();
        for text in [
            "Flight of May\nimage,x,y,z\na.jpg,446833.25,5594521.5,171\n",
            "image,x,y,z\n,m,m,m\na.jpg,446833.25,5594521.5,171\n",
            "image x y z\na.jpg 446833.25 5594521.5 171\n",
            "a.jpg 446833.25 5594521.5 171\n",
        ] {
            let row = read(text).rows[0].clone();
            assert_eq!((row.place, row.height), (own.place, own.height), "{text}");
        }
        for text in ["image,x,y,z\na.jpg,446833,25,5594521,5,171,5\n", "a.jpg,446833,25,5594521,5,171,5\n"] {
            let told = message(text);
            assert!(told.starts_with("the table of image positions: got 'a.jpg,446833,25,") && told.contains("decimal commas"), "{told}");
        }
        // Whole metres are no halves of numbers.
        assert_eq!(read("a.jpg,446833,5594521,171\n").rows[0].place, [446833.0, 5594521.0]);
    }

    #[test]
    fn standard_errors_have_the_units_of_their_names() {
        let row = &read("image,x,y,z,sigma_xy (mm),sigma_z (cm)\na.jpg,446833,5594521,171,20,4\n").rows[0];
        let [across, up] = row.standard_errors.map(Option::unwrap);
        assert!((across - 0.02).abs() < 1e-12 && (up - 0.04).abs() < 1e-12, "{across} {up}");
    }

    #[test]
    fn tables_of_many_programs_give_the_same_positions() {
        let wanted = [("a.jpg", [8.25, 50.5], 171.5), ("b.jpg", [8.26, 50.51], 172.0)];
        for (text, errors) in [
            // Pix4D, with the names that its documents give.
            (
                "imagename,latitude [decimal degrees],longitude [decimal degrees],altitude [meter],accuracy horz [meter],accuracy vert [meter]\n\
                 a.jpg,50.5,8.25,171.5,0.02,0.04\nb.jpg,50.51,8.26,172,0.02,0.04\n",
                [0.02, 0.04],
            ),
            (
                "image,latitude,longitude,altitude,acc horz,acc vert\na.jpg,50.5,8.25,171.5,0.02,0.04\nb.jpg,50.51,8.26,172,0.02,0.04\n",
                [0.02, 0.04],
            ),
            // Metashape: names behind a `#`, with other comments before and behind.
            (
                "# CoordinateSystem: GEOGCS[\"WGS 84\"]\n#Label,X/Longitude,Y/Latitude,Z/Altitude,Error_(m),X_error,X_est\na.jpg,8.25,50.5,171.5,,,\nb.jpg,8.26,50.51,172,1,2,3\n# Total error\n",
                [f64::NAN; 2],
            ),
            // Emlid: x and y of a system beside, and two heights.
            (
                "Name,Easting,Northing,Elevation,Longitude,Latitude,Ellipsoidal height,Easting RMS,Northing RMS,Elevation RMS\n\
                 a.jpg,446833.2,5594521.7,124,8.25,50.5,171.5,0.01,0.02,0.04\nb.jpg,446833.2,5594521.7,125,8.26,50.51,172,0.02,0.01,0.04\n",
                [0.02, 0.04],
            ),
            // ExifTool.
            ("SourceFile,GPSLatitude,GPSLongitude,GPSAltitude\na.jpg,50.5,8.25,171.5\nb.jpg,50.51,8.26,172\n", [f64::NAN; 2]),
            (
                "Bild;Länge;Breite;Höhe;Sigma Lage;Sigma Höhe\na.jpg;8,25;50,5;171,5;0,02;0,04\nb.jpg;8,26;50,51;172;0,02;0,04\n",
                [0.02, 0.04],
            ),
            (
                "photo\tlat\tlng\tellipsoidal height (m)\taccuracy\na.jpg\t50,5\t8,25\t171,5\t0,03\nb.jpg\t50,51\t8,26\t172\t0,03\n",
                [0.03, 0.03],
            ),
            ("file,x,y,z,sigma_xy,sigma_z\na.jpg,8.25,50.5,171.5,0.02,0.04\n\n# b\nb.jpg,8.26,50.51,172,0.02,0.04\n", [0.02, 0.04]),
        ] {
            let found = read(text);
            assert!(found.is_geographic, "{text}");
            let rows: Vec<_> = found.rows.iter().map(|row| (row.image.as_str(), row.place, row.height.unwrap())).collect();
            assert_eq!(rows, wanted, "{text}");
            let errors = errors.map(|error| Some(error).filter(|error| !error.is_nan()));
            assert!(found.rows.iter().all(|row| row.standard_errors == errors), "{text}: {found:?}");
        }
    }

    #[test]
    fn coordinates_of_a_plane_are_told_from_degrees() {
        for (text, errors) in [
            ("name;Rechtswert;Hochwert;Höhe\na;446833,25;5594521,5;171,5\n", [None, None]),
            ("image,easting,northing,elev\na,446833.25,5594521.5,171.5\n", [None, None]),
            ("#Label,X/Easting,Y/Northing,Z/Altitude\na,446833.25,5594521.5,171.5\n", [None, None]),
            ("# a flight\na,446833.25,5594521.5,171.5\n", [None, None]),
            ("a,446833.25,5594521.5,171.5,0.02,0.04\n", [Some(0.02), Some(0.04)]),
            ("a,446833.25,5594521.5,171.5,1,2,3,0.02,0.04\n", [Some(0.02), Some(0.04)]),
            ("a,446833.25,5594521.5,171.5,1,2,3\n", [None, None]),
            ("a,446833.25,5594521.5,171.5,91,2\n", [None, None]),
            ("a,446833.25,5594521.5,171.5,TP,bolt\n", [None, None]),
        ] {
            let found = read(text);
            assert!(!found.is_geographic, "{text}");
            let row = &found.rows[0];
            assert_eq!((row.place, row.height, row.standard_errors), ([446_833.25, 5_594_521.5], Some(171.5), errors), "{text}");
        }
        assert_eq!(unread("a,446833.25,5594521.5,171.5,91,2\n").unknown, ["#5", "#6"]);
        // `x` of a plane is no longitude where one row lies beyond.
        assert!(!read("image,x,y\na,10,20\nb,1000,20\n").is_geographic);
    }

    #[test]
    fn degrees_without_names_are_read_where_their_order_is_certain() {
        for text in ["a,-98.5,19.25,5\nb,-80,19.25,5\n", "a,19.25,-98.5,5\nb,19.25,-80,5\n"] {
            let found = read(text);
            assert!(found.is_geographic && found.rows[0].place == [-98.5, 19.25] && found.rows[1].place == [-80.0, 19.25], "{found:?}");
        }
        let refused = message("# x\na.jpg,50.5,8.25,171.5\n");
        assert!(
            refused.contains("50.5, 8.25") && refused.contains("line 2") && refused.contains("image,latitude,longitude,height"),
            "{refused}"
        );
        // One way round for all.
        assert!(!read("a,-98.5,19.25,5\nb,19.25,-98.5,5\n").is_geographic);
    }

    #[test]
    fn heights_and_standard_errors_may_be_absent() {
        let rows = read("image,lon,lat,height,sigma_xy,sigma_z\na,8,50,,,\nb,8,50,100,,0.05\nc,,,,,\nd,8,50,100,0.02,\n").rows;
        assert_eq!(
            rows.iter().map(|row| (row.image.as_str(), row.height)).collect::<Vec<_>>(),
            [("a", None), ("b", Some(100.0)), ("d", Some(100.0))]
        );
        assert_eq!(rows.iter().map(|row| row.standard_errors).collect::<Vec<_>>(), [[None, None], [None, Some(0.05)], [Some(0.02), None]]);
        assert_eq!(rows[2].line, 5);
        assert_eq!(read("image,lon,lat\na,8,50\n").rows[0].height, None);
        // Above the geoid is not above the ellipsoid.
        let orthometric = "image,lon,lat,orthometric height\na,8.5,50,100\n";
        assert_eq!(read(orthometric).rows[0].height, None);
        assert_eq!(unread(orthometric).unknown, ["orthometric height"]);
    }

    #[test]
    fn columns_that_are_not_read_are_named() {
        let text = "Label,Longitude,Latitude,Altitude,Yaw,Pitch,Roll,Easting,Northing\na,8.5,50,100,1,2,3,400000,5500000\n";
        assert_eq!(unread(text).unknown, ["Yaw", "Pitch", "Roll"]);
        assert_eq!(unread(text).doubled, ["Easting (Longitude)", "Northing (Latitude)"]);
        assert_eq!(unread("a,400000.5,5500000,100,1,2,3\n").unknown, ["#5", "#6", "#7"]);
        let feet = position_head("image,easting (ft),northing (ft),height (m)\na,1400000,5500000,1\n").unwrap().stated_units;
        assert_eq!(
            feet.iter().map(|stated| (stated.unit, stated.is_height)).collect::<Vec<_>>(),
            [("ft", false), ("ft", false), ("m", true)]
        );
    }

    #[test]
    fn angles_behind_a_commented_head_are_no_standard_errors() {
        let row = read("#image,easting,northing,altitude,yaw\na.jpg,446833,5594521.5,2300,91,\n").rows.remove(0);
        assert_eq!((row.place, row.height, row.standard_errors), ([446_833.0, 5_594_521.5], Some(2300.0), [None; 2]));
        let degrees = "#image,longitude,latitude,altitude\na.jpg,8.25,50.5,171.5,\n";
        assert_eq!((read(degrees).is_geographic, read(degrees).rows[0].place), (true, [8.25, 50.5]));
        assert_eq!(unread("a.jpg,446833,5594521.5,2300,91,\n").unknown, ["#5"]);
        assert_eq!(read("a.jpg,446833,5594521.5,2300,91,\n").rows[0].standard_errors, [None; 2]);
        // Names for fewer columns than there are do not leave the others to their order.
        assert!(message("#image,x,y,z\na.jpg,446833,5594521.5,2300,1,2\n").contains("more fields than the 4 columns"));
    }

    #[test]
    fn hemispheres_in_columns_of_their_own_and_beside_numbers_are_read() {
        let head = "image,GPSLatitudeRef,GPSLatitude,GPSLongitudeRef,GPSLongitude,GPSAltitude,GPSAltitudeRef\n";
        for row in [
            "a,S,49.99,W,8.5,171.5,1",
            "a,south,49.99,West,8.5,171.5,Below Sea Level",
            // As `exiftool -n` has them beside the numbers of EXIF.
            "a,S,-49.99,W,-8.5,-171.5,1",
            "a,S,\"49 deg 59' 24.00\"\"\",W,\"8 deg 30' 0.00\"\"\",171.5 m,1",
        ] {
            let text = format!("{head}{row}\n");
            let row = &read(&text).rows[0];
            assert!((row.place[0] + 8.5).abs() < 1e-12 && (row.place[1] + 49.99).abs() < 1e-12, "{text}: {row:?}");
            assert_eq!(row.height, Some(-171.5), "{text}");
            assert_eq!(unread(&text), UnreadColumns::default(), "{text}");
        }
        for (head, row) in [
            (
                "SourceFile,GPSLatitude,GPSLongitude,GPSAltitude",
                "./a.JPG,\"49 deg 59' 24.00\"\" S\",\"8 deg 30' 0.00\"\" W\",171.5 m Below Sea Level",
            ),
            ("image;Latitude;N/S;Longitude;E/W;Altitude", "a;49,99;S;8,5;W;-171,5"),
            ("image,lat,lat hemisphere,lon,lon hemisphere,alt", "a,49.99,S,8.5,W,-171.5"),
            ("image,lat,lon,alt", "a,49.99 S,W 8.5,-171.5"),
        ] {
            let row = &read(&format!("{head}\n{row}\n")).rows[0];
            assert!((row.place[0] + 8.5).abs() < 1e-12 && (row.place[1] + 49.99).abs() < 1e-12, "{row:?}");
            assert_eq!(row.height, Some(-171.5), "{row:?}");
        }
        for (row, named) in [
            ("a,E,49.99,W,8.5,171.5,0", "'E' for GPSLatitudeRef beside '49.99' in line 2"),
            ("a,,49.99,W,8.5,171.5,0", "'' for GPSLatitudeRef"),
            ("a,N,-49.99,W,8.5,171.5,0", "'N' for GPSLatitudeRef beside '-49.99'"),
            ("a,N,49.99,E,8.5,-171.5,2", "'2' for GPSAltitudeRef beside '-171.5'"),
            ("a,N,49.99 X,E,8.5,171.5,0", "'49.99 X' for GPSLatitude in line 2; allowed: finite numbers (as ExifTool writes them with -n)"),
        ] {
            let refused = message(&format!("{head}{row}\n"));
            assert!(refused.contains(named), "{row}: {refused}");
        }
        assert_eq!(read(&format!("{head}a,N,49.99,E,8.5,171.5,\n")).rows[0].height, Some(171.5));
        // Surfaces that heights refer to are no sides, nor are numbers of satellites hemispheres.
        let others = "image,lat,lon,alt,Height Ref,ns\na,49.99,8.5,171.5,geoid,12\n";
        assert_eq!((read(others).rows[0].height, unread(others).unknown), (Some(171.5), vec!["Height Ref".into(), "ns".into()]));
    }

    #[test]
    fn decimal_commas_do_not_hide_in_named_columns_that_are_left_over() {
        for text in [
            "image,lon,lat,alt,yaw,pitch,roll\na.jpg,8,25,50,5,171,5\n",
            "image,lon,lat,height,accuracy\na.jpg,8,25,50,5\n",
            "image,x,y,z\na.jpg,446833,05,5594521\n",
            "a.jpg,446833,05,5594521\n",
            "image,x,y,z,acc horz,acc vert\na.jpg,446833,25,5594521,5,171\n",
        ] {
            assert!(message(text).contains("may be meant as decimal commas"), "{text}: {}", message(text));
        }
        // Whole numbers in the columns that are read, or beside one with a point.
        assert_eq!(read("image,x,y,z\na.jpg,446833,5594521,171\n").rows[0].height, Some(171.0));
        assert_eq!(read("id,image,x,y,z\n7,a.jpg,446833,5594521,171\n").rows[0].height, Some(171.0));
        assert_eq!(read("image,x,y,z,accuracy\na.jpg,446833,5594521,171,3\n").rows[0].standard_errors, [Some(3.0); 2]);
        assert_eq!(read("image,x,y,z,yaw\na.jpg,446833,5594521,171,91\nb.jpg,446833,5594521,171,91.5\n").rows.len(), 2);
    }

    #[test]
    fn tables_without_a_position_are_refused() {
        for (text, named) in [
            ("", "got no row and no position"),
            ("image,lon,lat\n", "got no row and no position"),
            ("# all\n", "got no row and no position"),
            ("image,lon,lat\na.jpg,,\n", "got one row without coordinates and no position"),
            ("image,lon,lat\na.jpg,,\nb.jpg,,\n", "got 2 rows without coordinates and no position"),
            ("image,lon,lat,note\na.jpg,8,50,\"bolt\nb.jpg,8,51,\n", "from line 2 on, a field in quotes"),
        ] {
            assert!(message(text).contains(named), "{text}: {}", message(text));
            assert!(position_head(text).is_err(), "{text}");
        }
        assert_eq!(read("#image,lat,lon\ra.jpg,50.5,8.25\rb.jpg,50.5,8.5\r").rows.len(), 2);
    }

    #[test]
    fn longitude_and_latitude_0_are_no_position() {
        let text = "image,lon,lat\na,0,0\nb,8,50\nc,0,50\n";
        assert_eq!(read(text).rows.iter().map(|row| row.image.as_str()).collect::<Vec<_>>(), ["b", "c"]);
        assert_eq!(position_head(text).unwrap().nowhere, ["a"]);
        assert_eq!(read("image,easting,northing\na,0,0\n").rows.len(), 1);
    }

    #[test]
    fn images_without_coordinates_may_stand_first() {
        for head in ["#Label,X/Longitude,Y/Latitude,Z/Altitude", "Label,X/Longitude,Y/Latitude,Z/Altitude"] {
            let rows = read(&format!("{head}\na.jpg,,,\nb.jpg,8.25,50.5,171.5\n")).rows;
            assert_eq!(rows.iter().map(|row| (row.image.as_str(), row.line)).collect::<Vec<_>>(), [("b.jpg", 3)]);
        }
        assert_eq!(read("a.jpg,,,\nb.jpg,446833.25,5594521.5,171.5\n").rows[0].place, [446_833.25, 5_594_521.5]);
    }

    #[test]
    fn what_is_wrong_is_named_by_line() {
        for (text, named) in [
            ("image,lon,lat,height\na,8,50,1\nb,8,x,1\n", "'x' for lat in line 3"),
            ("image,lon,lat,height\na,8,50,high\n", "'high' for height in line 2"),
            ("image,lon,lat\n# one\n,8,50\n", "the name '' in line 3"),
            ("image,lon,lat,acc\na,8.5,50,0\n", "0 in line 2"),
            ("image,lon,lat\na,8,50\nb,50,98\n", "longitude 50 and latitude 98 in line 3"),
            ("image,lon,northing\na,8,50\n", "'lon' beside 'northing'"),
            ("station,lon,lat\na,8,50\n", "no column 'image' (or photo, picture,"),
            ("image,lon,h\na,8,50\n", "no column 'latitude' (or "),
            ("image,lat,h\na,8,50\n", "no column 'longitude' (or "),
            ("a,446833.25,5594521.5,171.5\nb,446833.25,x,1\n", "'x' for #3 in line 2"),
        ] {
            let refused = message(text);
            assert!(refused.contains(named), "{text}: {refused}");
        }
    }
}
