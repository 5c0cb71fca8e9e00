//! GNSS positions of images from a table, in place of those that their files record.

use super::named_images::{Meant, NamedImages};
use super::system::{check_stated_units, looks_like_degrees, system_of, units_of};
use crate::crs::{CoordinateSystem, Definition, HeightZero};
use crate::error::refuse;
use crate::formats::{ErrorColumns, PositionHead, SystemLine, UnreadColumns, position_head};
use crate::text::shorten;
use crate::{
    Error, ExifPosition, GeoreferencingOptions, ImagePositionRow, ImagePositions, ImpossiblePosition, Input, Refusal, Remark,
    parse_image_positions,
};
use serde::{Deserialize, Serialize};

/// Longitudes and latitudes of GNSS.
const WGS_84: &str = "EPSG:4326";

/// The GNSS position of an image that a table gives.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GivenPosition {
    /// Its height is above the ellipsoid; of one in the coordinate reference system above the zero of that, where it is not known how high this lies.
    pub position: ExifPosition,
    /// Standard errors of the place and of the height in m, above 0; each is absent where the table has none.
    pub standard_errors_m: [Option<f64>; 2],
    /// Whether it was given in the coordinate reference system of the block, whose heights it has.
    pub in_crs: bool,
}

impl GivenPosition {
    /// As a file would record it: the standard error of the place is the error that it states.
    pub fn as_recorded(&self) -> ExifPosition {
        ExifPosition { error_m: self.standard_errors_m[0], ..self.position }
    }
}

/// The table of GNSS positions of images.
#[derive(Debug, Clone)]
pub struct PositionTable {
    positions: ImagePositions,
    head: PositionHead,
}

impl PositionTable {
    /// Reads the table.
    ///
    /// # Errors
    /// As [`parse_image_positions`].
    pub fn read(text: &str) -> Result<Self, Error> {
        Ok(Self { positions: parse_image_positions(text)?, head: position_head(text)? })
    }

    /// The position of each of the images with these names, where the table has one; refuses, before they are read, what a run of them would refuse. Heights
    /// above a geoid of a file only the run converts. Of rows of `a.DNG` and `a.JPG` the latter is that of the image `a.JPG`; what a table has of other images,
    /// as one of a whole folder does, is not looked at.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for one of these images twice, for coordinates that are no longitude and latitude without a coordinate reference system or outside it,
    /// and for columns in another unit than that.
    pub fn positions(&self, images: &[String], placing: &GeoreferencingOptions) -> Result<Vec<Option<GivenPosition>>, Error> {
        self.of_images(images, placing, &placing.geoid_m.into())
    }

    /// The same. `zero`: where heights of the coordinate reference system count from.
    pub(super) fn of_images(
        &self,
        images: &[String],
        placing: &GeoreferencingOptions,
        zero: &HeightZero,
    ) -> Result<Vec<Option<GivenPosition>>, Error> {
        self.check_own_system(placing)?;
        let units = if self.positions.is_geographic { (None, 1.0) } else { units_of(placing)? };
        check_stated_units(Input::PositionTable, &self.head.stated_units, units)?;
        let rows = self.rows_of(images)?;
        let system = self.system(&rows, placing, zero)?;
        rows.iter().map(|row| row.map(|row| self.position(row, system.as_ref())).transpose()).collect()
    }

    /// Refuses a coordinate system that the table names for itself where it is not that of the block, or of WGS 84 for degrees.
    fn check_own_system(&self, placing: &GeoreferencingOptions) -> Result<(), Error> {
        let Some(SystemLine { crs, words, line }) = &self.head.system else { return Ok(()) };
        // One that is not known is none of these.
        let (own, block) = (Definition::read(crs).ok(), placing.definition()?);
        let wanted = if self.positions.is_geographic { Some(Definition::read(WGS_84)?) } else { block.clone() };
        match wanted.zip(own).is_some_and(|(wanted, own)| own.has_plane_of(&wanted)) {
            true => Ok(()),
            false => refuse(Refusal::PositionSystem { words: words.clone(), line: *line, crs: block.map(|block| block.name()) }),
        }
    }

    /// The row of each image.
    fn rows_of(&self, images: &[String]) -> Result<Vec<Option<&ImagePositionRow>>, Error> {
        let named = NamedImages::new(images);
        let mut rows: Vec<Option<(&ImagePositionRow, Meant)>> = vec![None; images.len()];
        let mut again: Vec<Option<&ImagePositionRow>> = vec![None; images.len()];
        for row in &self.positions.rows {
            let Some((image, meant)) = named.found(&row.image) else { continue };
            match rows[image] {
                Some((_, before)) if before < meant => {}
                Some((_, before)) if before == meant => again[image] = again[image].or(Some(row)),
                _ => (rows[image], again[image]) = (Some((row, meant)), None),
            }
        }
        if let Some(row) = again.into_iter().flatten().min_by_key(|row| row.line) {
            return refuse(Refusal::PositionAgain { image: shorten(&row.image), line: row.line });
        }
        Ok(rows.into_iter().map(|row| row.map(|(row, _)| row)).collect())
    }

    /// The system of its coordinates, which those of the images are in; absent for longitudes and latitudes.
    fn system(
        &self,
        rows: &[Option<&ImagePositionRow>],
        placing: &GeoreferencingOptions,
        zero: &HeightZero,
    ) -> Result<Option<CoordinateSystem>, Error> {
        let mut own: Vec<&ImagePositionRow> = rows.iter().flatten().copied().collect();
        own.sort_by_key(|row| row.line);
        let rows = if own.is_empty() { self.positions.rows.iter().collect() } else { own };
        let Some(first) = rows.first().copied().filter(|_| !self.positions.is_geographic) else { return Ok(None) };
        let ([x, y], line) = (first.place, first.line);
        let Some(definition) = placing.definition()? else { return refuse(Refusal::PositionWithoutCrs { x, y, line }) };
        if !definition.is_geographic() && rows.iter().all(|row| looks_like_degrees(row.place)) {
            return refuse(Refusal::PositionPlace { x, y, line, crs: definition.name(), degrees: true });
        }
        let plane: Vec<[f64; 2]> = rows.iter().map(|row| row.place).collect();
        let outside = |row: &&&ImagePositionRow| CoordinateSystem::about(definition.clone(), HeightZero::Unknown, row.place).is_err();
        system_of(placing, zero, &plane, &[]).map_err(|error| match &error {
            Error::InvalidInput { refusal: Refusal::CrsPlace { .. } } => {
                let ImagePositionRow { place: [x, y], line, .. } = rows.iter().find(outside).copied().unwrap_or(first);
                Refusal::PositionPlace { x: *x, y: *y, line: *line, crs: definition.name(), degrees: false }.into_error()
            }
            _ => error,
        })
    }

    fn position(&self, row: &ImagePositionRow, system: Option<&CoordinateSystem>) -> Result<GivenPosition, Error> {
        let ImagePositionRow { place: [x, y], height, standard_errors, line, .. } = *row;
        let [longitude_deg, latitude_deg, height_m] = match system {
            None => [x, y, height.unwrap_or(0.0)],
            Some(system) => {
                let crs = || system.definition().name();
                let place = system.geographic([x, y, height.unwrap_or(0.0)]);
                place.ok_or_else(|| Refusal::PositionPlace { x, y, line, crs: crs(), degrees: false }.into_error())?
            }
        };
        let position = ExifPosition { longitude_deg, latitude_deg, height_m: height.map(|_| height_m), error_m: None };
        Ok(GivenPosition { position, standard_errors_m: standard_errors, in_crs: system.is_some() })
    }

    /// The columns of standard errors that say no unit.
    pub(super) fn error_columns(&self) -> &ErrorColumns {
        &self.head.error_columns
    }

    /// What is to be said of the table beside images with these names: columns that are not understood, rows of other images.
    pub fn remarks(&self, images: &[String]) -> Vec<Remark> {
        let UnreadColumns { unknown, doubled } = self.head.unread.clone();
        let unnamed = self.head.unnamed_errors.clone();
        let named = NamedImages::new(images);
        let rows = &self.positions.rows;
        // A row that means an image less surely than another one is of a file beside it.
        let own = self.rows_of(images).map(|own| own.into_iter().flatten().map(|row| row.line).collect::<Vec<usize>>());
        // Of a table that is refused nothing is known of other images.
        let is_other = |row: &&ImagePositionRow| own.as_ref().is_ok_and(|own| !own.contains(&row.line));
        let others: Vec<String> = rows.iter().filter(is_other).map(|row| row.image.clone()).collect();
        let nowhere = self.head.nowhere.iter().filter_map(|name| named.find(name)).map(|image| images[image].clone());
        let nowhere: Vec<ImpossiblePosition> =
            nowhere.map(|name| ImpossiblePosition { name, value: crate::camera::NOWHERE.into() }).collect();
        let all = others.len() == rows.len() && nowhere.is_empty();
        let remarks = [
            (!unknown.is_empty()).then_some(Remark::UnknownPositionColumns { columns: unknown }),
            (!unnamed.is_empty()).then_some(Remark::UnnamedPositionErrors { columns: unnamed }),
            self.head.unread_height.clone().map(|(column, positions)| Remark::PositionHeights { column, positions }),
            (!doubled.is_empty()).then_some(Remark::DoubledPositionColumns { columns: doubled }),
            (!others.is_empty()).then_some(Remark::PositionsOfOtherImages { images: others, all }),
            (!nowhere.is_empty()).then_some(Remark::ImpossiblePositions { images: nowhere }),
        ];
        remarks.into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn images() -> [String; 3] {
        ["IMG_1.JPG", "IMG_2.JPG", "IMG_3.JPG"].map(String::from)
    }

    fn placing(crs: &str) -> GeoreferencingOptions {
        GeoreferencingOptions { crs: Some(crs.to_string()).filter(|crs| !crs.is_empty()), ..GeoreferencingOptions::default() }
    }

    fn refused(text: &str, crs: &str) -> String {
        let checked = PositionTable::read(text).and_then(|table| table.positions(&images(), &placing(crs)));
        checked.map_or_else(|error| error.to_string(), |_| String::new())
    }

    #[test]
    fn positions_are_those_of_the_images_that_a_table_means() {
        let text = "image,lat,lon,height,acc,roll\nflight\\img_2.jpg,50.5,8.25,171.5,0.03,1\nimg_3,50.6,8.5,,,1\nother.jpg,1,2,3,,\n";
        let table = PositionTable::read(text).unwrap();
        let given = table.of_images(&images(), &placing(""), &HeightZero::Unknown).unwrap();
        let position = |longitude_deg, latitude_deg, height_m| ExifPosition { longitude_deg, latitude_deg, height_m, error_m: None };
        let own = |position, standard_errors_m| Some(GivenPosition { position, standard_errors_m, in_crs: false });
        let wanted = [own(position(8.25, 50.5, Some(171.5)), [Some(0.03); 2]), own(position(8.5, 50.6, None), [None; 2])];
        assert_eq!(given, [None, wanted[0], wanted[1]]);
        assert_eq!(
            table.remarks(&images()),
            [
                Remark::UnknownPositionColumns { columns: vec!["roll".into()] },
                Remark::PositionsOfOtherImages { images: vec!["other.jpg".into()], all: false }
            ]
        );
        // Longitudes and latitudes are those of WGS 84 whatever system the block has.
        assert_eq!(table.of_images(&images(), &placing("EPSG:25832"), &HeightZero::Level(48.0)).unwrap(), given);
    }

    #[test]
    fn coordinates_of_the_system_of_a_block_have_its_heights() {
        let table = PositionTable::read("image,easting,northing,height\nIMG_1,446833.2,5594521.7,124.5\n").unwrap();
        let of = |zero: &HeightZero| table.of_images(&images(), &placing("EPSG:25832"), zero).unwrap()[0].unwrap();
        let (above, unknown) = (of(&HeightZero::Level(48.0)), of(&HeightZero::Unknown));
        assert!(above.in_crs && (above.position.longitude_deg - 8.25).abs() < 0.01 && (above.position.latitude_deg - 50.5).abs() < 0.01);
        assert_eq!((above.position.height_m, unknown.position.height_m), (Some(172.5), Some(124.5)));
    }

    #[test]
    fn what_a_run_would_refuse_is_refused_before_it() {
        let plane = "image,easting,northing,height\nIMG_1,446833.2,5594521.7,124.5\n";
        assert_eq!(refused(plane, "EPSG:25832"), "");
        for (text, crs, named) in [
            (plane, "", "(446833.2, 5594521.7) in line 2, which are no longitude and latitude, without a coordinate system"),
            ("image,x,y\nIMG_1,446833.2,5594521.7\n", "", "(--crs)"),
            ("image,easting,northing\nIMG_1,8.25,50.5\n", "EPSG:25832", "which look like degrees"),
            ("image,easting,northing\nIMG_1,446833.2,5594521.7\nIMG_2,4e8,5e9\n", "EPSG:25832", "in line 3, which lie outside"),
            (
                "image,easting (ft),northing (ft)\nIMG_1,446833.2,5594521.7\n",
                "EPSG:25832",
                "image positions: got the column 'easting (ft)' in ft",
            ),
            ("image,lon,lat,height (ft)\nIMG_1,8,50,300\n", "", "'height (ft)' in ft; allowed: coordinates in m"),
            ("image,lon,lat\nIMG_1.JPG,8,50\nimg_1.jpg,8,50\n", "", "'img_1.jpg' again in line 3"),
            ("image,lon,lat\nimg_1,8,50\nother,8,50\nimg_1.DNG,8,50\n", "", "'img_1.DNG' again in line 4"),
            ("image,lon,lat\n1/IMG_1.JPG,8,50\n2/IMG_1.JPG,8,50\n", "", "'2/IMG_1.JPG' again in line 3"),
        ] {
            let told = refused(text, crs);
            assert!(told.contains(named), "{text}: {told}");
        }
    }

    #[test]
    fn rows_of_files_beside_the_images_do_not_matter() {
        let of = |text: &str| {
            let table = PositionTable::read(text).unwrap();
            let given = table.positions(&images(), &placing("EPSG:25832")).unwrap();
            (given.into_iter().map(|given| given.map(|given| given.position.longitude_deg)).collect::<Vec<_>>(), table.remarks(&images()))
        };
        let others =
            |names: &[&str]| Remark::PositionsOfOtherImages { images: names.iter().map(ToString::to_string).collect(), all: false };
        let raw = "SourceFile,lat,lon\n./IMG_1.DNG,50,8.1\n./IMG_1.JPG,50,8.2\nIMG_2.dng,50,8.3\n";
        assert_eq!(of(raw), (vec![Some(8.2), Some(8.3), None], vec![others(&["./IMG_1.DNG"])]));
        let again = "image,lat,lon\nout.jpg,50,8\nIMG_1.JPG,50,8.2\nout.jpg,50,8\n";
        assert_eq!(of(again), (vec![Some(8.2), None, None], vec![others(&["out.jpg", "out.jpg"])]));
        let far = "image,easting,northing\nout.jpg,9e9,9e9\nIMG_1.JPG,446833.2,5594521.7\n";
        assert!(of(far).0[0].is_some_and(|longitude_deg| (longitude_deg - 8.25).abs() < 0.01));
        let both = "FileName,SourceFile,lat,lon\nIMG_1.JPG,x/IMG_2.JPG,50,8.2\n";
        assert_eq!(of(both).0, [None, Some(8.2), None]);
    }

    #[test]
    fn positions_of_opendronemap_are_read_in_the_system_that_they_name() {
        let utm = "WGS84 UTM 32N\nIMG_1.JPG 446833.2 5594521.7 171.5 0.1 0.2 0.3 0.02 0.03\n";
        for text in
            [utm.to_string(), utm.replace("WGS84 UTM 32N", "EPSG:32632"), utm.replace(' ', "\t").replace("WGS84\tUTM\t", "WGS84 UTM ")]
        {
            let table = PositionTable::read(&text).unwrap();
            let given = table.positions(&images(), &placing("EPSG:32632")).unwrap()[0].unwrap();
            assert!((given.position.longitude_deg - 8.25).abs() < 0.01 && given.standard_errors_m == [Some(0.02), Some(0.03)], "{text}");
        }
        let degrees = PositionTable::read("EPSG:4326\nIMG_1.JPG 8.25 50.5 171.5\n").unwrap();
        let given = degrees.positions(&images(), &placing("EPSG:25832")).unwrap()[0].unwrap();
        assert_eq!((given.position.longitude_deg, given.position.latitude_deg, given.in_crs), (8.25, 50.5, false));
        for (text, crs, named) in [
            (utm, "EPSG:25832", "'WGS84 UTM 32N' in line 1 beside ETRS89"),
            (utm, "", "'WGS84 UTM 32N' in line 1 and no other; allowed: positions in the coordinate system of the block (--crs)"),
            ("EPSG:32632\nIMG_1.JPG 8.25 50.5 171.5\n", "EPSG:32632", "'EPSG:32632' in line 1"),
            (
                "EPSG:99999\nIMG_1.JPG 446833.2 5594521.7 171.5\n",
                "EPSG:32632",
                "image positions: got the coordinate system 'EPSG:99999' in line 1",
            ),
            ("EPSG:4314\nIMG_1.JPG 8.25 50.5 171.5\n", "", "or longitudes and latitudes of WGS 84"),
        ] {
            let told = refused(text, crs);
            assert!(told.contains(named), "{text}: {told}");
        }
    }

    #[test]
    fn longitude_and_latitude_0_are_no_position_as_in_exif() {
        let table = PositionTable::read("image,lat,lon,height\nIMG_1.JPG,0,0,0\nIMG_2.JPG,50,8,171\nout.jpg,0,0,0\n").unwrap();
        let given = table.positions(&images(), &placing("")).unwrap();
        assert_eq!(given.iter().map(Option::is_some).collect::<Vec<_>>(), [false, true, false]);
        let nowhere = ImpossiblePosition { name: "IMG_1.JPG".into(), value: "longitude 0, latitude 0".into() };
        assert_eq!(table.remarks(&images()), [Remark::ImpossiblePositions { images: vec![nowhere] }]);
        // The origin of a system is a place.
        let plane = PositionTable::read("image,easting,northing\nIMG_1.JPG,0,0\nIMG_2.JPG,1000,1000\n").unwrap();
        assert!(plane.positions(&images(), &placing("+proj=tmerc +lat_0=50 +lon_0=8 +datum=WGS84")).unwrap()[0].is_some());
    }

    #[test]
    fn nothing_is_said_of_other_images_where_an_image_comes_twice() {
        let table = PositionTable::read("image,lat,lon\nIMG_1.JPG,50,8\nIMG_1.JPG,50,8.1\n").unwrap();
        assert!(table.positions(&images(), &placing("")).is_err());
        assert_eq!(table.remarks(&images()), []);
    }
}
