//! Ground control points with their image measurements, as the reconstruction takes them.

use super::control_point::control_point;
use super::named_images::NamedImages;
use super::system::{check_stated_units, looks_like_degrees, system_of, units_of, with_unit};
use crate::crs::{Definition, HeightZero};
use crate::error::refuse;
use crate::formats::{
    ErrorColumns, StatedUnit, SystemLine, UnreadColumns, control_system, error_columns, points_without_coordinates, stated_units,
    unnamed_errors, unread_columns, unread_mark_columns,
};
use crate::{
    BlockDescription, ControlRole, Error, GeoreferencingOptions, GroundControlPoint, GroundControlRow, ImageMeasurementRow,
    ImageObservation, Input, KnownCamera, KnownImage, Refusal, parse_ground_control_points, parse_image_measurements,
};
use std::collections::{BTreeMap, BTreeSet};

/// Ground control points that two images each show, without which they do not georeference a block; GNSS positions of so many images do as well.
pub(super) const LEAST_CONTROL: usize = 3;

/// No photo has a longer side in px.
const MOST_PX: u32 = 10_000_000;

/// The tables of ground control points and of their image measurements.
#[derive(Debug, Clone)]
pub struct ControlTables {
    points: Vec<GroundControlRow>,
    marks: Vec<ImageMeasurementRow>,
    /// Columns of the points that are not read.
    pub(super) unread_columns: UnreadColumns,
    /// Those without a name that are read as standard errors, and may be something else.
    pub(super) unnamed_errors: Vec<String>,
    /// Columns of the image measurements that are not read.
    pub(super) unread_mark_columns: Vec<String>,
    /// Points of the table without any coordinate.
    pub(super) without_coordinates: Vec<String>,
    /// Units that columns of coordinates have in their names.
    stated_units: Vec<StatedUnit>,
    /// Columns of standard errors that say no unit.
    pub(super) error_columns: ErrorColumns,
    /// The coordinate system that the table of points names for itself.
    own_system: Option<SystemLine>,
}

impl ControlTables {
    /// Reads both tables.
    ///
    /// # Errors
    /// As [`parse_ground_control_points`] and [`parse_image_measurements`].
    pub fn read(points: &str, marks: &str) -> Result<Self, Error> {
        let (unread_columns, stated_units, error_columns) = (unread_columns(points)?, stated_units(points)?, error_columns(points)?);
        let (without_coordinates, own_system) = (points_without_coordinates(points)?, control_system(points)?);
        let (unnamed_errors, unread_mark_columns) = (unnamed_errors(points)?, unread_mark_columns(marks)?);
        let (points, marks) = (parse_ground_control_points(points)?, parse_image_measurements(marks)?);
        Ok(Self {
            points,
            marks,
            unread_columns,
            unnamed_errors,
            unread_mark_columns,
            without_coordinates,
            stated_units,
            error_columns,
            own_system,
        })
    }

    /// Refuses, before the images are read, what a run of images with these names would refuse. Before there is a block, the images that the
    /// measurements name stand for its own. Whether GNSS positions make up for control points in their coordinate system only the run knows.
    /// `on_orthophoto`: one places the block afterwards.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where all measurements are of unknown points, where fewer than three points are measured in two images or more, and for points
    /// outside their coordinate system; as [`BlockDescription::check`].
    pub fn check(&self, images: &[String], placing: &GeoreferencingOptions, on_orthophoto: bool) -> Result<(), Error> {
        let named: BTreeSet<&String> = self.marks.iter().map(|mark| &mark.image).collect();
        let named: Vec<String> = if images.len() < 2 { named.into_iter().cloned().collect() } else { images.to_vec() };
        let least = if placing.crs.is_some() || on_orthophoto { 0 } else { LEAST_CONTROL };
        let joined = self.join(&named, placing, &HeightZero::Unknown, least);
        let (control, _) = joined.map_err(|error| with_unit(error, placing, &self.plane(), &[]))?;
        // How large an image is, and with it whether a measurement is outside it, only the run knows, which names the size.
        for (point, seen) in control.iter().flat_map(|point| point.measurements.iter().map(move |seen| (point, seen))) {
            if ![seen.x_px, seen.y_px].iter().all(|place| (0.0..=f64::from(MOST_PX)).contains(place)) {
                let (point, name) = (point.name.clone(), named[seen.image].clone());
                return refuse(Refusal::MeasuredBeyond { x_px: seen.x_px, y_px: seen.y_px, point, name });
            }
        }
        let cameras = vec![KnownCamera::of_size(MOST_PX, MOST_PX, Some(f64::from(MOST_PX)))];
        let images = named.into_iter().map(|name| KnownImage { name, camera: 0, position: None, view: None }).collect();
        BlockDescription { cameras, images, control }.check()
    }

    /// The ground control points with the images, by index, that show them; and the names of images that are not among these, ascending. `zero`: where
    /// their heights count from. `least`: so many control points are needed.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    pub(super) fn join(
        &self,
        images: &[String],
        placing: &GeoreferencingOptions,
        zero: &HeightZero,
        least: usize,
    ) -> Result<(Vec<GroundControlPoint>, Vec<String>), Error> {
        self.check_own_system(placing)?;
        check_stated_units(Input::ControlTable, &self.stated_units, units_of(placing)?)?;
        self.check_metres(placing)?;
        let system = system_of(placing, zero, &self.plane(), &[])?;
        let used = || self.used();
        let joined = used().map(|(point, role)| control_point(point, role, placing, system.as_ref()));
        let mut joined = joined.collect::<Result<Vec<GroundControlPoint>, Error>>()?;
        let index_of: BTreeMap<&str, usize> = used().enumerate().map(|(index, (point, _))| (point.name.as_str(), index)).collect();
        let off: BTreeSet<&str> = self.points.iter().filter(|point| point.role.is_none()).map(|point| point.name.as_str()).collect();
        let named = NamedImages::new(images);
        let mut unknown = BTreeSet::new();
        for mark in self.marks.iter().filter(|mark| !off.contains(mark.point.as_str())) {
            // A remark lists those that are not there.
            let Some(point) = index_of.get(mark.point.as_str()) else { continue };
            match named.find(&mark.image) {
                Some(image) => {
                    joined[*point].measurements.push(ImageObservation { image, x_px: mark.x_px, y_px: mark.y_px, confidence: 1.0 })
                }
                // An image that was skipped, or is of another block.
                None => drop(unknown.insert(mark.image.clone())),
            }
        }
        let unknown: Vec<String> = unknown.into_iter().collect();
        if joined.is_empty() && !self.points.is_empty() {
            return Ok((joined, unknown));
        }
        let placing = || joined.iter().filter(|point| point.role == ControlRole::Control);
        let seen = placing().filter(|point| point.measurements.len() >= 2).count();
        // Where no name is that of a point, or some that are not leave too few, these are what is wrong.
        if let Some(point) = self.unknown_points().into_iter().next().filter(|_| seen < least || !self.names_points()) {
            return refuse(Refusal::MeasuredUnknown { point });
        }
        if seen < least {
            let placing = placing().count();
            let checks = placing < joined.len();
            return refuse(Refusal::FewControlPoints { seen, placing, checks, images: unknown, needed: least });
        }
        Ok((joined, unknown))
    }

    /// The points that are not switched off.
    fn used(&self) -> impl Iterator<Item = (&GroundControlRow, ControlRole)> {
        self.points.iter().filter_map(|point| Some((point, point.role?)))
    }

    /// Names of those that no image measurement names.
    pub(super) fn unmeasured(&self) -> Vec<String> {
        let measured: BTreeSet<&str> = self.marks.iter().map(|mark| mark.point.as_str()).collect();
        self.used().map(|(point, _)| &point.name).filter(|name| !measured.contains(name.as_str())).cloned().collect()
    }

    /// Points that image measurements name and the table does not have, not even without coordinates, ascending.
    pub(super) fn unknown_points(&self) -> Vec<String> {
        let without = self.without_coordinates.iter();
        let known: BTreeSet<&str> = self.points.iter().map(|point| &point.name).chain(without).map(String::as_str).collect();
        let named: BTreeSet<&str> = self.marks.iter().map(|mark| mark.point.as_str()).collect();
        named.difference(&known).map(|name| (*name).to_string()).collect()
    }

    /// Whether any image measurement names a point of the table.
    fn names_points(&self) -> bool {
        let known: BTreeSet<&str> = self.points.iter().map(|point| point.name.as_str()).collect();
        self.marks.iter().any(|mark| known.contains(mark.point.as_str()))
    }

    /// The coordinates of a point as they were written.
    pub(super) fn coordinates(&self, point: &str) -> Option<[f64; 3]> {
        self.points.iter().find(|row| row.name == point).map(|row| row.position)
    }

    /// Names of all, those that are switched off, too.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.points.iter().map(|point| point.name.as_str())
    }

    /// The standard errors of the place and of the height of a point, where the table has them.
    pub(super) fn standard_errors(&self, point: &str) -> Option<[f64; 2]> {
        self.points.iter().find(|row| row.name == point)?.standard_errors
    }

    /// Refuses a coordinate system that the table names for itself where it is not that of the block.
    fn check_own_system(&self, placing: &GeoreferencingOptions) -> Result<(), Error> {
        let Some(SystemLine { crs, words, line }) = &self.own_system else { return Ok(()) };
        let block = placing.definition()?;
        let is_own = block.as_ref().zip(Definition::read(crs).ok()).is_some_and(|(block, own)| own.has_plane_of(block));
        let crs = block.map(|block| block.name());
        if is_own { Ok(()) } else { refuse(Refusal::ControlSystem { words: words.clone(), line: *line, crs }) }
    }

    /// Refuses degrees where the coordinate system has metres.
    fn check_metres(&self, placing: &GeoreferencingOptions) -> Result<(), Error> {
        let Some(definition) = placing.definition()?.filter(|definition| !definition.is_geographic()) else { return Ok(()) };
        // One of many may lie beside the origin of the system.
        if !self.used().all(|(point, _)| looks_like_degrees([point.position[0], point.position[1]])) {
            return Ok(());
        }
        self.used().next().map_or(Ok(()), |(point, _)| {
            let [x, y, _] = point.position;
            refuse(Refusal::ControlDegrees { point: point.name.clone(), x, y, crs: definition.name() })
        })
    }

    /// x and y of these.
    pub(super) fn plane(&self) -> Vec<[f64; 2]> {
        self.used().map(|(point, _)| [point.position[0], point.position[1]]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ObservedPosition;

    const POINTS: &str = "a,0,0,0\nb,100,0,0,0.5,0.7\nc,0,100,0\n";

    #[test]
    fn measurements_are_joined_to_points_and_images() {
        let marks = "1.png,a,10,20\n2.png,a,11,21\n1.png,b,30,40\n2.png,b,31,41\n1.png,c,50,60\n2.png,c,51,61\nx.png,c,1,1\n";
        let images = ["2.png", "1.png"].map(String::from);
        let (joined, unknown) = ControlTables::read(POINTS, marks)
            .unwrap()
            .join(&images, &GeoreferencingOptions::default(), &HeightZero::Unknown, LEAST_CONTROL)
            .unwrap();
        assert_eq!(unknown, ["x.png"]);
        assert_eq!(
            joined[0].measurements,
            [
                ImageObservation { image: 1, x_px: 10.0, y_px: 20.0, confidence: 1.0 },
                ImageObservation { image: 0, x_px: 11.0, y_px: 21.0, confidence: 1.0 }
            ]
        );
        assert!(matches!(joined[0].position, ObservedPosition::Local { sigma: [0.02, 0.02, 0.03], .. }));
        assert!(matches!(joined[1].position, ObservedPosition::Local { sigma: [0.5, 0.5, 0.7], .. }));
    }

    #[test]
    fn images_are_known_whatever_their_folder_ending_and_capitals_are_in_the_table() {
        let marks = "IMG_1.JPG,a,1,2\nIMG_2,a,1,2\nC:\\flight\\img_1.jpg,b,3,4\nimg_2.jpg,b,3,4\nimg_1,c,5,6\nsub/IMG_2.jpg,c,5,6\n";
        let images = ["img_1.jpg", "img_2.jpg"].map(String::from);
        let tables = ControlTables::read(POINTS, marks).unwrap();
        let (joined, unknown) = tables.join(&images, &GeoreferencingOptions::default(), &HeightZero::Unknown, LEAST_CONTROL).unwrap();
        assert!(unknown.is_empty());
        assert!(joined.iter().all(|point| point.measurements.iter().map(|seen| seen.image).eq([0, 1])), "{joined:?}");
        // Two names of one image.
        let twice = format!("{marks}img_1.jpg,a,9,9\n");
        let told =
            ControlTables::read(POINTS, &twice).unwrap().check(&images, &GeoreferencingOptions::default(), false).unwrap_err().to_string();
        assert!(told.contains("got two for a in img_1.jpg"), "{told}");
    }

    #[test]
    fn a_unit_that_a_column_states_is_that_of_the_coordinate_system_or_refused() {
        let refused = |head: &str, crs: &str| {
            let rows = format!("{head}\na,1404913.4,18172674.3,1\nb,1404923.4,18172674.3,1\nc,1404913.4,18172684.3,1\n");
            let marks = "1.png,a,1,2\n2.png,a,1,2\n1.png,b,3,4\n2.png,b,3,4\n1.png,c,5,6\n2.png,c,5,6\n";
            let placing =
                GeoreferencingOptions { crs: Some(crs.to_string()).filter(|crs| !crs.is_empty()), ..GeoreferencingOptions::default() };
            let images = ["1.png", "2.png"].map(String::from);
            ControlTables::read(&rows, marks)
                .unwrap()
                .check(&images, &placing, false)
                .err()
                .map(|error| error.to_string())
                .unwrap_or_default()
        };
        let feet = "name,Easting (ft),Northing (ft),Height (ft)";
        assert!(refused(feet, "").contains("the column 'Easting (ft)' in ft; allowed: coordinates in m, or"), "{}", refused(feet, ""));
        assert!(refused(feet, "EPSG:25832").contains("'Easting (ft)' in ft; allowed: coordinates in m"));
        // The plane of this system is in feet, its heights are in metres.
        let in_feet = "+proj=utm +zone=32 +datum=WGS84 +units=us-ft";
        assert!(refused(feet, in_feet).contains("'Height (ft)' in ft; allowed: coordinates in m"));
        assert_eq!(refused(feet, &format!("{in_feet} +vunits=us-ft")), "");
        assert_eq!(refused("name,x,y,z (m)", in_feet), "");
        assert!(refused("name,x,y,z (m)", &format!("{in_feet} +vunits=us-ft")).contains("'z (m)' in m; allowed: coordinates in ft"));
        assert!(refused("name,x_ft,y_ft,z", "EPSG:4326").contains("'x_ft' in ft; allowed: coordinates in °"));
    }

    #[test]
    fn a_measurement_outside_its_image_is_refused_without_a_size_that_nobody_knows() {
        let marks = |x: &str| format!("1.png,a,{x},20\n2.png,a,1,2\n1.png,b,3,4\n2.png,b,3,4\n1.png,c,5,6\n2.png,c,5,6\n");
        let images = ["1.png", "2.png"].map(String::from);
        let check = |x: &str| ControlTables::read(POINTS, &marks(x)).unwrap().check(&images, &GeoreferencingOptions::default(), false);
        for x in ["-1", "1e9"] {
            let told = check(x).unwrap_err().to_string();
            assert!(
                told.contains("for a in 1.png, outside any image; allowed: positions within the image") && !told.contains(" x "),
                "{told}"
            );
        }
        // The run, which knows the size, refuses what is outside it.
        check("9000").unwrap();
    }

    #[test]
    fn unknown_points_and_too_few_measurements_are_refused() {
        let refused = |marks: &str| {
            let tables = ControlTables::read(POINTS, marks).unwrap();
            tables
                .join(&["1.png".to_string()], &GeoreferencingOptions::default(), &HeightZero::Unknown, LEAST_CONTROL)
                .unwrap_err()
                .to_string()
        };
        assert!(refused("1.png,z,1,1\n").contains("the point z"));
        let few = refused("1.png,a,1,1\n9.png,a,1,1\n");
        let rows = "name,x,y,z,use\na,0,0,0,control\nb,100,0,0,check\nc,0,100,0,off\n";
        assert_eq!(ControlTables::read(rows, "1.png,a,1,1\n").unwrap().unmeasured(), ["b"]);
        let checked = ControlTables::read(rows, "1.png,a,1,1\n1.png,c,2,2\n").unwrap();
        let checked = checked
            .join(&["1.png".to_string()], &GeoreferencingOptions::default(), &HeightZero::Unknown, LEAST_CONTROL)
            .unwrap_err()
            .to_string();
        assert!(checked.contains("0 of 1 (check points do not count) measured in two images"), "{checked}");
        let alone = ControlTables::read(&rows.replace("control", "check"), "1.png,a,1,1\n").unwrap();
        let alone = alone
            .join(&["1.png".to_string()], &GeoreferencingOptions::default(), &HeightZero::Unknown, LEAST_CONTROL)
            .unwrap_err()
            .to_string();
        assert!(
            alone.contains(
                "got check points alone, which do not georeference the block; allowed: 3 or more measured in two images or more, or neither"
            ),
            "{alone}"
        );
        // GNSS positions in their system may place the block: the run knows.
        let in_crs = GeoreferencingOptions { crs: Some("EPSG:25832".into()), ..GeoreferencingOptions::default() };
        let on_earth = "name,x,y,z,use\na,428217,5539031,100,check\nb,428459,5539032,95,control\n";
        let beside = ControlTables::read(on_earth, "1.png,a,1,1\n2.png,a,1,1\n1.png,b,2,2\n2.png,b,2,2\n").unwrap();
        let images = ["1.png", "2.png"].map(String::from);
        beside.check(&images, &in_crs, false).unwrap();
        assert_eq!(beside.join(&images, &in_crs, &HeightZero::Unknown, 0).unwrap().0.len(), 2);
        assert!(
            beside.join(&images, &in_crs, &HeightZero::Unknown, LEAST_CONTROL).unwrap_err().to_string().contains("1 of 1 (check points")
        );
        let off = ControlTables::read(&rows.replace("control", "off").replace("check", "off"), "1.png,a,1,1\n").unwrap();
        assert_eq!(
            off.join(&["1.png".to_string()], &GeoreferencingOptions::default(), &HeightZero::Unknown, LEAST_CONTROL).unwrap(),
            (Vec::new(), Vec::new())
        );
        assert!(few.contains("0 of 3 measured in two images or more; the block does not have the images 9.png;"), "{few}");
    }

    #[test]
    fn measurements_of_points_that_the_table_does_not_have_are_left_out_and_listed() {
        let images = ["1.png", "2.png"].map(String::from);
        let seen = |points: &[&str]| {
            let rows = points.iter().flat_map(|point| ["1.png", "2.png"].map(|image| format!("{image},{point},1,2\n")));
            ControlTables::read(POINTS, &rows.collect::<String>()).unwrap()
        };
        let placing = GeoreferencingOptions::default();
        let tables = seen(&["a", "102", "b", "c", "101"]);
        tables.check(&images, &placing, false).unwrap();
        assert_eq!(tables.unknown_points(), ["101", "102"]);
        let (joined, unknown) = tables.join(&images, &placing, &HeightZero::Unknown, LEAST_CONTROL).unwrap();
        assert_eq!((joined.iter().map(|point| point.measurements.len()).collect::<Vec<_>>(), unknown.len()), (vec![2; 3], 0));
        // Where too few points are left, or none, the names are what is wrong.
        for (points, least) in [(&["a", "101", "b"][..], LEAST_CONTROL), (&["101", "102"], 0)] {
            let told = seen(points).join(&images, &placing, &HeightZero::Unknown, least).unwrap_err().to_string();
            assert!(told.contains("the point 101"), "{told}");
        }
    }

    #[test]
    fn a_coordinate_system_above_the_names_of_columns_is_that_of_the_block_or_refused() {
        let rows = "name;x;y;z\na;446833,2;5594521,7;124\nb;446933,2;5594521,7;124\nc;446833,2;5594621,7;124\n";
        let marks = "EPSG:25832\nimage,point,x,y\n1.png,a,1,2\n2.png,a,1,2\n1.png,b,3,4\n2.png,b,3,4\n1.png,c,5,6\n2.png,c,5,6\n";
        let images = ["1.png", "2.png"].map(String::from);
        let checked = |line: &str, crs: &str| {
            let placing =
                GeoreferencingOptions { crs: Some(crs.to_string()).filter(|crs| !crs.is_empty()), ..GeoreferencingOptions::default() };
            let tables = ControlTables::read(&format!("{line}\n{rows}"), marks).unwrap();
            tables.check(&images, &placing, false).map_or_else(|error| error.to_string(), |()| String::new())
        };
        for line in ["EPSG:25832", "EPSG:25832;;;", "EPSG:25832 (ETRS89 / UTM 32N)"] {
            assert_eq!(checked(line, "EPSG:25832"), "", "{line}");
            let other = checked(line, "EPSG:25833");
            assert!(other.contains("in line 1 beside ETRS89"), "{other}");
            assert!(checked(line, "").contains("in line 1 and no other"), "{}", checked(line, ""));
        }
        assert!(checked("EPSG:99999", "EPSG:25832").contains("control points: got the coordinate system 'EPSG:99999'"));
    }
}
