//! Many positions at once, into a coordinate reference system and out of it.

use super::{CoordinateSystem, Definition, HeightZero};
use crate::error::refuse;
use crate::math::{median, median_longitude};
use crate::{Error, Refusal};

/// Longitudes are no larger, counted either way from Greenwich.
const TURN_DEG: f64 = 360.0;

/// Latitudes of the poles.
const POLE_DEG: f64 = 90.0;

/// Coordinates in a system of places on the earth.
///
/// `crs`: an EPSG code, PROJ text or WKT. `places`: longitude and latitude on WGS 84 in degrees, height above its ellipsoid in m. Coordinates are
/// those of the system: x, east or longitude, first; heights in its unit, from where they count (`zero`), above the ellipsoid still where that is not known.
/// They are rounded to 0.1 mm, or 1e-9°.
/// Of the operations that lead to the system the one that holds about the median of the places takes all of them. A place that is no number, or
/// lies outside the system, has none. No places give no coordinates, once the system was read.
///
/// # Errors
/// [`Error::InvalidInput`] for a system that cannot be read, and one that nothing leads to there; for places the median of which lies outside the system;
/// for heights of an ellipsoidal system that count from elsewhere.
pub fn coordinates_in_system(crs: &str, zero: impl Into<HeightZero>, places: &[[f64; 3]]) -> Result<Vec<Option<[f64; 3]>>, Error> {
    let definition = Definition::read(crs)?;
    let Some(about) = middle(known(places), true) else { return Ok(vec![None; places.len()]) };
    let [longitude_deg, latitude_deg] = about;
    if latitude_deg.abs() > POLE_DEG {
        return refuse(Refusal::OutsideCrs { longitude_deg, latitude_deg, crs: definition.name() });
    }
    let system = CoordinateSystem::new(definition, zero, about)?;
    if system.coordinates([longitude_deg, latitude_deg, 0.0]).is_none() {
        return refuse(Refusal::OutsideCrs { longitude_deg, latitude_deg, crs: system.definition().name() });
    }
    Ok(converted(places, |place| system.coordinates(place)))
}

/// The inverse of [`coordinates_in_system`].
///
/// # Errors
/// As [`coordinates_in_system`], and for coordinates the median of which lies outside the system.
pub fn places_of_coordinates(crs: &str, zero: impl Into<HeightZero>, coordinates: &[[f64; 3]]) -> Result<Vec<Option<[f64; 3]>>, Error> {
    let definition = Definition::read(crs)?;
    let Some(about) = middle(known(coordinates), definition.is_geographic()) else { return Ok(vec![None; coordinates.len()]) };
    let system = CoordinateSystem::about(definition, zero, about)?;
    Ok(converted(coordinates, |position| system.geographic(position)))
}

fn converted(all: &[[f64; 3]], of: impl Fn([f64; 3]) -> Option<[f64; 3]>) -> Vec<Option<[f64; 3]>> {
    all.iter().map(|one| Some(*one).filter(is_known).and_then(&of)).collect()
}

/// The coordinates of the plane of those that are numbers.
fn known(positions: &[[f64; 3]]) -> impl Iterator<Item = [f64; 2]> {
    positions.iter().filter(|position| is_known(position)).map(|[x, y, _]| [*x, *y])
}

fn is_known(position: &[f64; 3]) -> bool {
    position.iter().all(|value| value.is_finite())
}

/// The medians of both coordinates of the plane of positions; absent without any. Longitudes on either side of the date line are near each other.
pub(crate) fn middle(positions: impl Iterator<Item = [f64; 2]>, in_degrees: bool) -> Option<[f64; 2]> {
    let (all_x, mut all_y): (Vec<f64>, Vec<f64>) = positions.map(|[x, y]| (x, y)).unzip();
    let y = median(&mut all_y)?;
    let x = median(&mut all_x.clone())?;
    // What is no longitude stays what it is, and is refused as that.
    let around = all_x.iter().copied().filter(|x| in_degrees && x.abs() <= TURN_DEG).collect::<Vec<f64>>();
    Some([median_longitude(&around).filter(|_| x.abs() <= TURN_DEG).unwrap_or(x), y])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Geoid;

    #[test]
    fn many_positions_go_into_a_system_and_come_back() {
        let places: Vec<[f64; 3]> =
            (0..200).map(|i| [11.0 + 0.001 * f64::from(i % 20), 48.0 + 0.001 * f64::from(i / 20), 500.0 + f64::from(i)]).collect();
        for crs in ["EPSG:32632", "EPSG:31468", "EPSG:4326"] {
            let there = coordinates_in_system(crs, None, &places).unwrap();
            let back = places_of_coordinates(crs, None, &there.iter().map(|one| one.unwrap()).collect::<Vec<_>>()).unwrap();
            for (place, again) in places.iter().zip(back) {
                let again = again.unwrap();
                assert!(
                    (0..2).all(|k| (place[k] - again[k]).abs() < 3e-9) && (place[2] - again[2]).abs() < 1e-3,
                    "{crs}: {place:?} {again:?}"
                );
            }
        }
        // The central meridian of the zone, and the scale on it (Snyder 1987, p. 17: the meridian to 45°).
        let [on_meridian] = &coordinates_in_system("EPSG:32632", None, &[[9.0, 45.0, 7.0]]).unwrap()[..] else { unreachable!() };
        let [x, y, z] = on_meridian.unwrap();
        assert!((x - 500_000.0).abs() < 1e-3 && (y - 0.9996 * 4_984_944.378).abs() < 2e-3 && z == 7.0, "{x} {y} {z}");
    }

    #[test]
    fn heights_count_from_the_geoid_at_each_place_and_come_back() {
        let geoid = Geoid {
            name: "sloping.gtx".into(),
            south_west_deg: [10.0, 47.0],
            step_deg: [1.0, 1.0],
            columns: 3,
            heights_m: vec![40.0, 50.0, 60.0, 41.0, 51.0, 61.0],
        };
        let zero = HeightZero::of(None, Some(geoid));
        let places = [[10.25, 47.5, 500.0], [10.5, 47.5, 500.0], [11.75, 47.5, 500.0]];
        let there: Vec<[f64; 3]> =
            coordinates_in_system("EPSG:32632", zero.clone(), &places).unwrap().into_iter().map(Option::unwrap).collect();
        for ([_, _, height], above_m) in there.iter().zip([43.0, 45.5, 58.0]) {
            assert!((height - (500.0 - above_m)).abs() < 1e-3, "{height} {above_m}");
        }
        let back = places_of_coordinates("EPSG:32632", zero, &there).unwrap();
        assert!(places.iter().zip(back).all(|(place, again)| (place[2] - again.unwrap()[2]).abs() < 1e-3));
    }

    #[test]
    fn places_outside_a_projection_have_no_coordinates_in_it() {
        // 180° from the central meridian the projection would come back over the pole.
        let refused = coordinates_in_system("EPSG:32632", None, &[[-171.0, 10.0, 0.0]]).unwrap_err();
        assert!(matches!(&refused, Error::InvalidInput { refusal } if matches!(refusal, Refusal::OutsideCrs { .. })), "{refused}");
        assert!(refused.to_string().contains("-171") && refused.to_string().contains("UTM zone 32N"), "{refused}");
        // Beyond the pole there is no place, nor a shift of datum.
        for latitude in [95.0, -90.1] {
            let beyond = coordinates_in_system("EPSG:32633", None, &[[15.0, latitude, 0.0]]).unwrap_err();
            assert!(matches!(&beyond, Error::InvalidInput { refusal } if matches!(refusal, Refusal::OutsideCrs { .. })), "{beyond}");
        }
        let few = |crs: &str, places: &[[f64; 3]]| {
            coordinates_in_system(crs, None, places).unwrap().iter().map(Option::is_some).collect::<Vec<_>>()
        };
        // A single one of many; just within, and beyond; on the other side of the date line.
        assert_eq!(few("EPSG:32632", &[[9.0, 50.0, 0.0], [9.5, 50.0, 0.0], [-171.0, 10.0, 0.0]]), [true, true, false]);
        assert_eq!(few("EPSG:32632", &[[9.0, 50.0, 0.0], [50.0, 50.0, 0.0], [100.0, 50.0, 0.0]]), [true, true, false]);
        assert_eq!(few("EPSG:32601", &[[-177.0, 52.0, 0.0], [179.0, 52.0, 0.0]]), [true, true]);
        // A position without a fix stands first.
        let places = [[0.0, 0.0, 0.0], [179.9, 52.0, 0.0], [-179.9, 52.0, 0.0], [-179.8, 52.0, 0.0], [179.8, 52.0, 0.0]];
        assert_eq!(few("EPSG:32601", &places), [false, true, true, true, true]);
    }

    #[test]
    fn what_is_no_place_has_no_coordinates_and_what_is_no_system_is_refused() {
        let places = [[11.0, 48.0, 0.0], [f64::NAN, 48.0, 0.0], [11.0, f64::INFINITY, 0.0]];
        let found = coordinates_in_system("EPSG:32632", None, &places).unwrap();
        assert_eq!(found.iter().map(Option::is_some).collect::<Vec<_>>(), [true, false, false]);
        assert_eq!(coordinates_in_system("EPSG:32632", None, &[]).unwrap(), []);
        assert_eq!(places_of_coordinates("EPSG:32632", None, &[[f64::NAN; 3]]).unwrap(), [None]);
        for refused in [coordinates_in_system("EPSG:99999", None, &[]), places_of_coordinates("none", None, &[[0.0; 3]])] {
            assert!(matches!(refused, Err(Error::InvalidInput { .. })), "{refused:?}");
        }
        // Longitudes beyond the earth.
        assert!(places_of_coordinates("EPSG:4326", None, &[[691_000.0, 50.0, 0.0]]).is_err());
    }
}
