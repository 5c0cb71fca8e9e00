//! The zones of UTM: coordinates of one that were taken for those of another.

use super::definition::Definition;
use super::rounding;
use proj_core::{Coord, CrsDef, Datum, DatumToWgs84, ProjectedCrsDef, ProjectionMethod, Transform};

/// Zones on either side whose coordinates are taken for those of a system.
const BESIDE: i32 = 2;
const ZONES: i32 = 60;
const ZONE_DEG: f64 = 6.0;
/// The scale on the central meridian, its easting and, in the south, the northing of the equator in m.
const SCALE: f64 = 0.9996;
const EASTING_M: f64 = 500_000.0;
const NORTHINGS_M: [f64; 2] = [0.0, 10_000_000.0];

/// What a position has for coordinates in a system of UTM if those given are of another zone of the same datum: by zones, the nearest first; none for
/// other systems, whatever text or code defines them.
pub(crate) fn beside(definition: &Definition, given: [f64; 2]) -> Vec<(u32, [f64; 2])> {
    let Some(plane) = definition.crs().horizontal_crs() else { return Vec::new() };
    let Some((own, zone)) = plane.as_projected().and_then(|own| Some((own, number(own)?))) else { return Vec::new() };
    let of_zone = |other: i32| {
        let [from, to] = [in_zone(own, other)?, in_zone(own, zone)?];
        let Coord { x, y } = Transform::from_crs_defs(&from, &to).ok()?.convert(Coord::new(given[0], given[1])).ok()?;
        let place = [x, y].map(rounding::metres);
        Some((u32::try_from(other).ok()?, place)).filter(|_| place.iter().all(|value| value.is_finite()))
    };
    let zones = (1..=BESIDE).flat_map(|off| [-off, off]).map(|off| (zone - 1 + off).rem_euclid(ZONES) + 1);
    zones.filter_map(of_zone).collect()
}

/// The zone of a system of UTM.
pub(crate) fn zone_of(definition: &Definition) -> Option<u32> {
    u32::try_from(number(definition.crs().horizontal_crs()?.as_projected()?)?).ok()
}

/// The code of the system of a zone, on the datum of this one, whose eastings begin with the number of the zone; absent where there is none.
///
/// # Source
/// EPSG registry, ETRS89 / UTM zone 31N to 33N (zE-N); the difference of WGS 84 is below a metre.
pub(crate) fn prefixed_code(definition: &Definition, zone: u32) -> Option<u16> {
    let is_alike = definition.plane_epsg().is_some_and(|code| matches!(code, 25828..=25838 | 32601..=32660));
    PREFIXED.iter().find(|(prefixed, _)| is_alike && *prefixed == zone).map(|(_, code)| *code)
}

const PREFIXED: [(u32, u16); 3] = [(31, 5649), (32, 4647), (33, 5650)];

/// The number of its zone; absent for other projections.
fn number(own: &ProjectedCrsDef) -> Option<i32> {
    let ProjectionMethod::TransverseMercator { lon0, lat0, k0, false_easting, false_northing } = own.method() else { return None };
    let is_alike = |value: f64, wanted: f64| (value - wanted).abs() < 1e-6;
    let zone = (lon0 - 0.5 * ZONE_DEG + 180.0) / ZONE_DEG + 1.0;
    let is_zone = is_alike(zone, zone.round()) && (1.0..=f64::from(ZONES)).contains(&zone.round());
    let is_utm = is_alike(lat0, 0.0) && is_alike(k0, SCALE) && is_alike(false_easting, EASTING_M);
    (is_zone && is_utm && NORTHINGS_M.iter().any(|northing| is_alike(false_northing, *northing))).then_some(zone.round() as i32)
}

/// In another zone; one ellipsoid has no shift between its zones, whatever its datum is.
fn in_zone(own: &ProjectedCrsDef, zone: i32) -> Option<CrsDef> {
    let ProjectionMethod::TransverseMercator { lat0, k0, false_easting, false_northing, .. } = own.method() else { return None };
    let lon0 = f64::from(zone - 1) * ZONE_DEG - 180.0 + 0.5 * ZONE_DEG;
    let method = ProjectionMethod::TransverseMercator { lon0, lat0, k0, false_easting, false_northing };
    let datum = Datum::new(own.datum().ellipsoid(), DatumToWgs84::Identity).ok()?;
    Some(CrsDef::Projected(ProjectedCrsDef::new(0, datum, method, own.linear_unit(), "")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crs::CoordinateSystem;

    const WKT: &str = r#"PROJCS["NAD83 / UTM zone 10N",GEOGCS["NAD83",DATUM["North_American_Datum_1983",SPHEROID["GRS 1980",6378137,298.257222101],TOWGS84[0,0,0,0,0,0,0]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",-123],PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]]"#;

    #[test]
    fn coordinates_of_the_zone_beside_are_found_of_every_system_of_utm() {
        for (crs, other, zone, place) in [
            ("EPSG:25832", "EPSG:25831", 31, [8.0, 50.0]),
            ("epsg:32601+5773", "EPSG:32660", 60, [179.0, 52.0]),
            ("EPSG:32733", "EPSG:32734", 34, [17.0, -29.0]),
            ("EPSG:26910", "EPSG:26911", 11, [-121.0, 38.0]),
            (WKT, "EPSG:26911", 11, [-121.0, 38.0]),
            ("+proj=utm +zone=9 +datum=WGS84", "EPSG:32610", 10, [-126.5, 51.0]),
            (
                "+proj=utm +zone=32 +ellps=GRS80 +towgs84=0,0,0 +units=us-ft",
                "+proj=utm +zone=34 +ellps=GRS80 +towgs84=0,0,0 +units=us-ft",
                34,
                [11.0, 60.0],
            ),
        ] {
            let of = |crs: &str| {
                let system = CoordinateSystem::new(Definition::read(crs).unwrap(), None, place).unwrap();
                system.coordinates([place[0], place[1], 0.0]).unwrap()
            };
            let ([x, y, _], [own_x, own_y, _]) = (of(other), of(crs));
            let found = beside(&Definition::read(crs).unwrap(), [x, y]);
            let (_, [found_x, found_y]) = found.iter().find(|(number, _)| *number == zone).unwrap_or_else(|| panic!("{crs}: {found:?}"));
            assert!((found_x - own_x).abs() < 0.01 && (found_y - own_y).abs() < 0.01, "{crs}: {found:?} {own_x} {own_y}");
        }
        let zones = |crs: &str| beside(&Definition::read(crs).unwrap(), [5e5, 5e6]).into_iter().map(|(zone, _)| zone).collect::<Vec<_>>();
        assert_eq!((zones("EPSG:25832"), zones("EPSG:32601")), (vec![31, 33, 30, 34], vec![60, 2, 59, 3]));
        for none in ["EPSG:4326", "EPSG:31467", "EPSG:2227", "+proj=tmerc +lon_0=9 +k=1 +x_0=500000 +datum=WGS84"] {
            assert!(zones(none).is_empty(), "{none}");
        }
    }
}
