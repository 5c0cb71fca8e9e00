//! A coordinate reference system at a place: the way to WGS 84 and back, and the directions of its axes.

use super::definition::{Definition, HeightReference};
use super::{HeightZero, operation, rounding};
use crate::error::refuse;
use crate::math::{cross, dot3, local_from_geographic, minus, turn};
use crate::{Error, Refusal};
use proj_core::{Coord3D, Transform};

/// Coordinates that do not come back from WGS 84 within this, in the unit of the system or in parts of a degree as long as m, are outside it.
const RETURN: f64 = 1e-3;
const RETURN_DEG: f64 = 1e-8;

/// What the inverse of a datum shift may miss of the way back: more is a place outside the projection.
const LOST_DEG: f64 = 1e-4;
/// A transverse Mercator projection shows the hemisphere about its central meridian; beyond it the meridians run over the pole.
const HEMISPHERE_DEG: f64 = 90.0;

/// Half the length over which the direction of an axis is taken, in m, in the unit of the system or in parts of a degree about as long as m.
const STEP: f64 = 1000.0;
const STEP_DEG: f64 = 0.01;
/// Over which the length of a degree is taken.
const LENGTH_DEG: f64 = 1e-3;

/// A coordinate reference system with the operation to WGS 84 that holds at a place.
#[derive(Clone)]
pub(crate) struct CoordinateSystem {
    definition: Definition,
    zero: HeightZero,
    to_wgs84: Transform,
    from_wgs84: Transform,
}

impl CoordinateSystem {
    /// For positions about `[longitude, latitude]` of WGS 84. `zero`: where its heights count from.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a system that nothing leads from to WGS 84 there, and a geoid beside ellipsoidal heights.
    pub fn new(definition: Definition, zero: impl Into<HeightZero>, place: [f64; 2]) -> Result<Self, Error> {
        let zero = zero.into();
        let is_ellipsoidal = definition.heights() == HeightReference::Ellipsoid;
        if let Some(geoid_m) = zero.above_m(place).filter(|geoid_m| is_ellipsoidal && *geoid_m != 0.0) {
            return refuse(Refusal::GeoidOfEllipsoid { crs: definition.name(), geoid_m });
        }
        let to_wgs84 = operation::to_wgs84(&definition, place)?;
        let Ok(from_wgs84) = to_wgs84.inverse() else {
            return refuse(operation::no_shift(&definition));
        };
        Ok(Self { definition, zero: if is_ellipsoidal { HeightZero::Level(0.0) } else { zero }, to_wgs84, from_wgs84 })
    }

    /// For positions about these coordinates.
    ///
    /// # Errors
    /// As [`new`](Self::new); for coordinates that lie outside the system.
    pub fn about(definition: Definition, zero: impl Into<HeightZero>, at: [f64; 2]) -> Result<Self, Error> {
        let place = operation::about(&definition, at)?;
        Self::new(definition, zero, place)
    }

    pub fn definition(&self) -> &Definition {
        &self.definition
    }

    /// Where its heights count from.
    pub fn zero(&self) -> &HeightZero {
        &self.zero
    }

    /// What the registry calls the operation to WGS 84; absent for what the text states, and where none is needed.
    pub fn operation(&self) -> Option<&str> {
        let operation = self.to_wgs84.selected_operation();
        operation.id.map(|_| &operation.name[..])
    }

    /// Its accuracy, as the registry states it.
    pub fn accuracy_m(&self) -> Option<f64> {
        self.operation().and(self.to_wgs84.selected_operation().accuracy).map(|accuracy| accuracy.meters)
    }

    /// `[longitude, latitude, height above the ellipsoid]` on WGS 84, rounded, of coordinates; absent outside the system.
    pub fn geographic(&self, position: [f64; 3]) -> Option<[f64; 3]> {
        let place = self.exact_geographic(position)?;
        let back = self.exact_coordinates(place)?;
        let limit = if self.definition.is_geographic() { RETURN_DEG } else { RETURN };
        let returns = (0..2).all(|k| (back[k] - position[k]).abs() <= limit);
        let [longitude, latitude, height] = place;
        returns.then(|| [rounding::degrees(longitude), rounding::degrees(latitude), rounding::metres(height)])
    }

    /// The coordinates, rounded, of `[longitude, latitude, height above the ellipsoid]` on WGS 84; absent outside the system.
    pub fn coordinates(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        let [x, y, z] = self.exact_coordinates(place)?;
        let round = if self.definition.is_geographic() { rounding::degrees } else { rounding::metres };
        Some([round(x), round(y), rounding::metres(z)])
    }

    /// Differences of coordinates, these minus others, in m: degrees as long as they are at the first, longitudes by the shorter way around.
    pub fn difference_m(&self, position: [f64; 3], from: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = minus(&position, &from);
        let z = z * self.definition.height_unit_m();
        if let Some(unit_m) = self.definition.unit_m() {
            return [x * unit_m, y * unit_m, z];
        }
        let [longitude, latitude, _] = position;
        let of_step = |east: f64, north: f64| local_from_geographic([longitude + east, latitude + north, 0.0], [longitude, latitude, 0.0]);
        let [east, north] = [of_step(LENGTH_DEG, 0.0)[0], of_step(0.0, LENGTH_DEG)[1]].map(|length| length / LENGTH_DEG);
        [turn(x) * east, y * north, z]
    }

    /// The directions of its x, y and z at a place, in the system that touches the ellipsoid at `origin`: z is the vertical of the ellipsoid, y the
    /// direction in which x stays the same (grid north), x at right angles to both.
    pub fn axes(&self, place: [f64; 3], origin: [f64; 3]) -> Option<[[f64; 3]; 3]> {
        let local = |place: [f64; 3]| local_from_geographic(place, origin);
        let [longitude, latitude, height] = place;
        let up = unit(minus(&local([longitude, latitude, height + STEP]), &local([longitude, latitude, height - STEP])))?;
        let [x, y, z] = self.exact_coordinates(place)?;
        let step = if self.definition.is_geographic() { STEP_DEG } else { STEP };
        let at = |y: f64| Some(local(self.exact_geographic([x, y, z])?));
        let along = minus(&at(y + step)?, &at(y - step)?);
        let tilt = dot3(&along, &up);
        let north = unit([0, 1, 2].map(|k| along[k] - tilt * up[k]))?;
        Some([cross(&north, &up), north, up].map(rounding::direction))
    }

    fn exact_geographic(&self, [x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
        let [longitude, latitude, height] = converted(&self.to_wgs84, [x, y, z * self.definition.height_unit_m()])?;
        Some([longitude, latitude, height + self.zero.above_m([longitude, latitude]).unwrap_or(0.0)])
    }

    /// The inverse of a datum shift in the plane is not quite its way back, since heights are kept on both: what is missing is added.
    fn exact_coordinates(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        if self.definition.central_meridian_deg().is_some_and(|meridian| turn(place[0] - meridian).abs() > HEMISPHERE_DEG) {
            return None;
        }
        let first = converted(&self.from_wgs84, place)?;
        let again = converted(&self.to_wgs84, first)?;
        let [east, north] = [turn(place[0] - again[0]), place[1] - again[1]];
        if !((east * libm::cos(place[1].to_radians())).abs() <= LOST_DEG && north.abs() <= LOST_DEG) {
            return None;
        }
        let [x, y, z] = converted(&self.from_wgs84, [place[0] + east, place[1] + north, place[2]])?;
        let above_m = self.zero.above_m([place[0], place[1]]).unwrap_or(0.0);
        Some([x, y, (z - above_m) / self.definition.height_unit_m()])
    }
}

fn converted(transform: &Transform, [x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
    let Coord3D { x, y, z } = transform.convert_3d(Coord3D::new(x, y, z)).ok()?;
    Some([x, y, z]).filter(|place| place.iter().all(|value| value.is_finite()))
}

fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot3(&vector, &vector).sqrt();
    (length > 0.0).then(|| vector.map(|value| value / length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Refusal;

    fn system(crs: &str, geoid_m: Option<f64>, at: [f64; 2]) -> CoordinateSystem {
        CoordinateSystem::about(Definition::read(crs).unwrap(), geoid_m, at).unwrap()
    }

    fn degrees(degrees: f64, minutes: f64, seconds: f64) -> f64 {
        degrees + minutes / 60.0 + seconds / 3600.0
    }

    /// Metres east and north from a known longitude and latitude.
    fn off(place: [f64; 3], known: [f64; 2]) -> [f64; 2] {
        let [east, north, _] = local_from_geographic([place[0], place[1], 0.0], [known[0], known[1], 0.0]);
        [east, north]
    }

    #[test]
    fn published_positions_are_met_within_the_accuracy_of_their_datum_shifts() {
        // Ordnance Survey, A guide to coordinate systems in Great Britain, annexes B and C: Caister Water Tower.
        let tower = system("EPSG:27700", None, [651_409.903, 313_177.270]);
        let known = [degrees(1.0, 42.0, 57.787), degrees(52.0, 39.0, 28.723)];
        let apart = off(tower.geographic([651_409.903, 313_177.270, 24.7]).unwrap(), known);
        assert!(apart.iter().all(|d| d.abs() < 2.0), "{apart:?}");
        // swisstopo, Formeln und Konstanten für die Berechnung der Schweizerischen schiefachsigen Zylinderprojektion, numerical example of the
        // approximate formulas, which are good to 1 m.
        for (crs, false_origin) in [("EPSG:2056", [2e6, 1e6]), ("EPSG:21781", [0.0, 0.0])] {
            let [x, y] = [700_000.0 + false_origin[0], 100_000.0 + false_origin[1]];
            let known = [degrees(8.0, 43.0, 49.80), degrees(46.0, 2.0, 38.86)];
            let apart = off(system(crs, None, [x, y]).geographic([x, y, 600.0]).unwrap(), known);
            assert!(apart.iter().all(|d| d.abs() < 2.0), "{crs}: {apart:?}");
        }
        // Snyder 1987, Map Projections: A Working Manual, p. 17: a quarter of the meridian of WGS 84 holds 10,001,965.729 m; the series there
        // gives 4,984,944.378 m to 45°. On the central meridian the northing is 0.9996 of it.
        let [x, y, z] = system("EPSG:32632", None, [500_000.0, 5e6]).coordinates([9.0, 45.0, 123.4]).unwrap();
        assert!((x - 500_000.0).abs() < 1e-3 && (y - 0.9996 * 4_984_944.378).abs() < 2e-3 && z == 123.4, "{x} {y} {z}");
    }

    #[test]
    fn the_registry_and_the_shift_that_a_text_states_agree() {
        // DHDN to WGS 84 (2), EPSG operation 1777, which holds in the west of Germany.
        let text = "+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +y_0=0 +ellps=bessel +towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7 +units=m";
        let at = [3_513_000.0, 5_403_000.0];
        let [own, stated] = ["EPSG:31467", text].map(|crs| system(crs, None, at));
        assert_eq!((own.operation(), own.accuracy_m()), (Some("DHDN to WGS 84 (2)"), Some(3.0)));
        assert_eq!((stated.operation(), stated.accuracy_m()), (None, None));
        let [a, b] = [&own, &stated].map(|system| system.geographic([at[0], at[1], 250.0]).unwrap());
        assert!(off(a, [b[0], b[1]]).iter().all(|d| d.abs() < 1e-3), "{a:?} {b:?}");
    }

    #[test]
    fn positions_come_back_from_wgs84() {
        for (crs, position) in [
            ("EPSG:25832", [691_000.25, 5_334_000.5, 500.0]),
            ("EPSG:32733", [391_000.0, 6_820_000.0, -5.0]),
            ("EPSG:31468", [4_468_503.333, 5_333_317.78, 520.0]),
            ("EPSG:27700", [651_409.903, 313_177.27, 24.7]),
            ("EPSG:2056", [2_600_000.0, 1_200_000.0, 550.0]),
            ("EPSG:21781", [600_000.0, 200_000.0, 550.0]),
            ("EPSG:28992", [155_000.0, 463_000.0, 3.0]),
            ("EPSG:31370", [150_000.0, 165_000.0, 40.0]),
            ("EPSG:5514", [-743_000.0, -1_043_000.0, 250.0]),
            ("EPSG:2154", [652_000.0, 6_862_000.0, 40.0]),
            ("EPSG:31287", [600_000.0, 400_000.0, 900.0]),
            ("EPSG:7856", [334_000.0, 6_251_000.0, 20.0]),
            ("EPSG:4258", [10.0, 50.0, 100.0]),
            ("EPSG:4937", [10.0, 50.0, 100.0]),
            ("+proj=utm +zone=32 +datum=WGS84", [691_000.25, 5_334_000.5, 500.0]),
            ("+proj=utm +zone=32 +ellps=GRS80 +towgs84=0,0,0", [691_000.25, 5_334_000.5, 500.0]),
            ("EPSG:2227", [6_048_000.0, 2_120_000.0, 30.0]),
            ("EPSG:2227+6360", [6_048_000.0, 2_120_000.0, 100.0]),
        ] {
            let system = system(crs, None, [position[0], position[1]]);
            let back = system.coordinates(system.geographic(position).unwrap()).unwrap();
            let unit = if system.definition().is_geographic() { 1.1e-9 } else { 1.1e-4 };
            assert!((0..2).all(|k| (back[k] - position[k]).abs() <= unit) && (back[2] - position[2]).abs() < 1.1e-4, "{crs}: {back:?}");
        }
    }

    #[test]
    fn heights_above_a_geoid_are_not_those_above_the_ellipsoid() {
        let at = [691_000.0, 5_334_000.0];
        let [plain, above] = [None, Some(46.5)].map(|geoid_m| system("EPSG:25832", geoid_m, at));
        let height = |system: &CoordinateSystem| system.geographic([at[0], at[1], 500.0]).unwrap()[2];
        assert_eq!((height(&plain), height(&above), plain.zero().is_known()), (500.0, 546.5, false));
        let known = |crs: &str| Definition::read(crs).unwrap().heights();
        assert_eq!(
            ["EPSG:25832", "EPSG:5555", "EPSG:25832+7837", "EPSG:4979"].map(known),
            [HeightReference::Unsaid, HeightReference::Other, HeightReference::Other, HeightReference::Ellipsoid]
        );
        assert_eq!(system("EPSG:4979", None, [10.0, 50.0]).zero().above_m([10.0, 50.0]), Some(0.0));
        let refused = CoordinateSystem::about(Definition::read("EPSG:4979").unwrap(), Some(46.5), [10.0, 50.0]).err().unwrap();
        assert!(matches!(refused, Error::InvalidInput { refusal } if matches!(refusal, Refusal::GeoidOfEllipsoid { .. })));
    }

    /// Stem, L. 1989, State Plane Coordinate System of 1983, NOAA Manual NOS NGS 5: California zone 3.
    const CALIFORNIA_3: &str = "+proj=lcc +lat_0=36.5 +lon_0=-120.5 +lat_1=37.0666666666666667 +lat_2=38.4333333333333333 +x_0=2000000 \
        +y_0=500000 +datum=NAD83";

    #[test]
    fn systems_in_feet_are_those_in_metres() {
        const FOOT_US: f64 = 1200.0 / 3937.0;
        let at = [1_843_000.0, 646_000.0];
        let metres = system("EPSG:26943", None, at).geographic([at[0], at[1], 12.0]).unwrap();
        let text = |units: &str| format!("{CALIFORNIA_3} +towgs84=0,0,0 {units}");
        for (crs, unit, height_unit) in [
            ("EPSG:2227".to_string(), FOOT_US, 1.0),
            ("EPSG:2227+6360".to_string(), FOOT_US, FOOT_US),
            (format!("{CALIFORNIA_3} +units=us-ft"), FOOT_US, 1.0),
            (text("+units=us-ft"), FOOT_US, 1.0),
            (text("+units=ft +vunits=us-ft"), 0.3048, FOOT_US),
            (text("+to_meter=0.3048 +vto_meter=0.3048"), 0.3048, 0.3048),
        ] {
            let in_feet = [at[0] / unit, at[1] / unit, 12.0 / height_unit];
            let feet = system(&crs, None, [in_feet[0], in_feet[1]]);
            let place = feet.geographic(in_feet).unwrap();
            assert!((0..2).all(|k| (place[k] - metres[k]).abs() < 1.1e-8) && (place[2] - 12.0).abs() < 1e-4, "{crs}: {place:?} {metres:?}");
            let back = feet.coordinates(place).unwrap();
            assert!((0..3).all(|k| (back[k] - in_feet[k]).abs() < 1e-3), "{crs}: {back:?}");
            let known = (feet.definition().unit_m().unwrap(), feet.definition().height_unit_m());
            assert!((known.0 - unit).abs() < 1e-12 && (known.1 - height_unit).abs() < 1e-12, "{crs}: {known:?}");
        }
    }

    #[test]
    fn a_system_has_one_plane_in_all_its_spellings() {
        let read = |crs: &str| Definition::read(crs).unwrap();
        assert!(read("EPSG:25832+7837").has_plane_of(&read("EPSG:25832")) && read("epsg:2227").has_plane_of(&read("EPSG:2227+6360")));
        for other in ["EPSG:25833", "EPSG:32632", "EPSG:4258", "EPSG:4979"] {
            assert!(!read("EPSG:25832").has_plane_of(&read(other)), "{other}");
        }
        assert!(!read("EPSG:26943").has_plane_of(&read("EPSG:2227")));
        // JGD2000 and JGD2011: one ellipsoid, and ground that has moved by metres.
        assert!(!read("EPSG:2451").has_plane_of(&read("EPSG:6677")));
    }

    #[test]
    fn swiss_coordinates_are_read_from_text() {
        const LV95: &str = "+proj=somerc +lat_0=46.9524055555556 +lon_0=7.43958333333333 +k_0=1 +x_0=2600000 +y_0=1200000 +ellps=bessel \
            +towgs84=674.374,15.056,405.346 +units=m +no_defs";
        let lv03 = LV95.replace("2600000", "600000").replace("1200000", "200000");
        let of_gdal = r#"PROJCS["CH1903+ / LV95",GEOGCS["CH1903+",DATUM["CH1903+",SPHEROID["Bessel 1841",6377397.155,299.1528128],TOWGS84[674.374,15.056,405.346,0,0,0,0]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Hotine_Oblique_Mercator_Azimuth_Center"],PARAMETER["latitude_of_center",46.9524055555556],PARAMETER["longitude_of_center",7.43958333333333],PARAMETER["azimuth",90],PARAMETER["rectified_grid_angle",90],PARAMETER["scale_factor",1],PARAMETER["false_easting",2600000],PARAMETER["false_northing",1200000],UNIT["metre",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]]"#;
        let older = of_gdal
            .replace("Hotine_Oblique_Mercator_Azimuth_Center", "Swiss_Oblique_Cylindrical")
            .replace("PARAMETER[\"azimuth\",90],PARAMETER[\"rectified_grid_angle\",90],", "");
        let tagged = of_gdal.replace("AXIS[\"Northing\",NORTH]]", "AXIS[\"Northing\",NORTH],AUTHORITY[\"EPSG\",\"2056\"]]");
        let tagged = tagged.replace("DATUM[\"CH1903+\",SPHEROID[\"Bessel 1841\",6377397.155,299.1528128],TOWGS84[674.374,15.056,405.346,0,0,0,0]]", "DATUM[\"CH1903+\",SPHEROID[\"Bessel 1841\",6377397.155,299.1528128,AUTHORITY[\"EPSG\",\"7004\"]],AUTHORITY[\"EPSG\",\"6150\"]]");
        for at in [[2_700_000.0, 1_100_000.0], [2_485_000.0, 1_110_000.0], [2_830_000.0, 1_180_000.0]] {
            let known = system("EPSG:2056", None, at).geographic([at[0], at[1], 600.0]).unwrap();
            for crs in [LV95, of_gdal, &older, &tagged] {
                let place = system(crs, None, at).geographic([at[0], at[1], 600.0]).unwrap();
                let apart = off(place, [known[0], known[1]]);
                assert!(apart.iter().all(|d| d.abs() < 2e-3), "{crs}: {apart:?}");
            }
            let former = [at[0] - 2e6, at[1] - 1e6];
            let place = system(&lv03, None, former).geographic([former[0], former[1], 600.0]).unwrap();
            assert!(off(place, [known[0], known[1]]).iter().all(|d| d.abs() < 2e-3), "{place:?}");
        }
    }

    #[test]
    fn axes_hold_the_convergence_of_the_meridians() {
        let (place, origin) = ([11.0, 50.0, 400.0], [11.0, 50.0, 400.0]);
        let [east, north, up] = system("EPSG:25832", None, [643_000.0, 5_540_000.0]).axes(place, origin).unwrap();
        // Torge & Müller 2012, 6.2: tan γ is nearly tan Δλ sin φ; east of the central meridian grid north lies east of north.
        let convergence = libm::atan(libm::tan(2f64.to_radians()) * libm::sin(50f64.to_radians()));
        assert!((libm::atan2(north[0], north[1]) - convergence).abs() < 2e-5, "{north:?}");
        assert!(dot3(&east, &north).abs() < 1e-8 && dot3(&up, &[0.0, 0.0, 1.0]) > 1.0 - 1e-9, "{up:?}");
        // Of degrees: east, north and up of the place itself, 70 km from where the system of the block touches the earth.
        let [_, north, up] = system("EPSG:4326", None, [11.0, 50.0]).axes(place, [10.0, 50.0, 0.0]).unwrap();
        let turn = 1f64.to_radians() * libm::sin(50f64.to_radians());
        assert!(
            (north[0] + turn).abs() < 2e-4 && (up[0] - 1f64.to_radians() * libm::cos(50f64.to_radians())).abs() < 2e-4,
            "{north:?} {up:?}"
        );
    }

    #[test]
    fn differences_of_coordinates_are_lengths_in_every_unit() {
        let apart = |crs: &str, at: [f64; 2], to: [f64; 3], from: [f64; 3]| system(crs, None, at).difference_m(to, from);
        assert_eq!(apart("EPSG:25832", [5e5, 5e6], [5e5, 5e6, 20.0], [5e6, 5e5, 30.0]), [-4.5e6, 4.5e6, -10.0]);
        let feet =
            apart("EPSG:2227+6360", [6_048_000.0, 2_120_000.0], [6_048_003.937, 2_120_000.0, 3.937], [6_048_000.0, 2_120_000.0, 0.0]);
        assert!((feet[0] - 1.2).abs() < 1e-6 && feet[1] == 0.0 && (feet[2] - 1.2).abs() < 1e-9, "{feet:?}");
        // Torge & Müller 2012, 4.1: at 60° a degree of GRS 80 is 55.80 km long along the parallel and 111.41 km along the meridian; over the date line.
        let degrees = apart("EPSG:4326", [179.5, 60.0], [179.5, 60.0, 1.0], [-179.5, 59.0, 0.0]);
        assert!((degrees[0] + 55_800.0).abs() < 5.0 && (degrees[1] - 111_412.0).abs() < 5.0 && degrees[2] == 1.0, "{degrees:?}");
    }

    #[test]
    fn what_is_no_system_here_is_refused_by_name() {
        let refused = |crs: &str, at: [f64; 2]| {
            let made = Definition::read(crs).and_then(|definition| CoordinateSystem::about(definition, None, at));
            made.err().unwrap_or_else(|| panic!("{crs}")).to_string()
        };
        let at = [400_000.0, 5e6];
        for (crs, word) in [
            ("EPSG:99999", "EPSG:99999, a code that is unknown here"),
            ("", "cannot be read"),
            ("hello", "hello, which cannot be read"),
            ("EPSG:", "EPSG:"),
            ("+proj=robin +lon_0=0", "projections longlat, utm"),
            ("+proj=utm +zone=77 +datum=WGS84", "cannot be read"),
            ("PROJCS[\"half", "cannot be read"),
            ("EPSG:4978", "centre of the earth"),
            ("+proj=utm +zone=32 +ellps=GRS80 +units=m", "+towgs84"),
            ("+proj=tmerc +lat_0=0 +lon_0=12 +x_0=4500000 +ellps=bessel +nadgrids=BETA2007.gsb +units=m", "without a grid"),
        ] {
            let told = refused(crs, at);
            assert!(told.contains(word), "{crs}: {told}");
            // What has no name beside its text is printed once.
            assert!(!crs.starts_with('+') || told.matches(crs).count() <= 1, "{crs}: {told}");
        }
        // The shifts of the German datum hold in Germany.
        let told = refused("EPSG:31468", [4_500_000.0, 4_500_000.0]);
        assert!(told.contains("no shift of its datum") && told.contains("Germany"), "{told}");
        let told = refused("EPSG:4326", [691_000.0, 50.0]);
        assert!(told.contains("longitude as x"), "{told}");
        // Where the way back does not lead to the same place.
        assert_eq!(system("EPSG:25832", None, [691_000.0, 5_334_000.0]).geographic([4e7, 5e6, 0.0]), None);
    }
}
