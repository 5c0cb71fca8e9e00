//! The coordinate reference system of a block's control points and results, and whether its control points can be in it.

use crate::crs::{CoordinateSystem, Definition};
use crate::error::refuse;
use crate::math::{dot3, median};
use crate::{Error, GeoreferencingOptions, GroundControlPoint, ObservedPosition, Refusal, local_from_geographic};

/// No block has ground control points farther from its images.
const MOST_KM: f64 = 100.0;

/// The system at these coordinates in it or, without any, at these longitudes and latitudes; absent where none was chosen, and where nothing says
/// where the block is.
///
/// # Errors
/// [`Error::InvalidInput`] for a system that cannot be read, and one that nothing leads from to WGS 84 there.
pub(super) fn system_of(
    placing: &GeoreferencingOptions,
    control: Option<[f64; 2]>,
    gnss: &[[f64; 2]],
) -> Result<Option<CoordinateSystem>, Error> {
    let Some(definition) = placing.definition()? else { return Ok(None) };
    if let Some(at) = control {
        return CoordinateSystem::about(definition, placing.geoid_m, at).map(Some);
    }
    middle(gnss).map(|at| CoordinateSystem::new(definition, placing.geoid_m, at)).transpose()
}

/// The medians; absent without positions.
pub(super) fn middle(places: &[[f64; 2]]) -> Option<[f64; 2]> {
    let of = |k: usize| median(&mut places.iter().map(|place| place[k]).collect::<Vec<_>>());
    Some([of(0)?, of(1)?])
}

/// Refuses a control point that lies elsewhere on the earth than the GNSS positions of the images.
pub(super) fn check_near(control: &[GroundControlPoint], gnss: &[[f64; 2]], system: &CoordinateSystem) -> Result<(), Error> {
    let Some([longitude, latitude]) = middle(gnss) else { return Ok(()) };
    // Along the chord.
    let km_from = |place: [f64; 3]| {
        let apart = local_from_geographic([place[0], place[1], 0.0], [longitude, latitude, 0.0]);
        0.001 * dot3(&apart, &apart).sqrt()
    };
    let far = control.iter().filter_map(|point| Some((point, geographic(&point.position)?))).find(|(_, place)| km_from(*place) > MOST_KM);
    let Some((point, place)) = far else { return Ok(()) };
    let exchanged = system.coordinates(place).and_then(|[x, y, z]| system.geographic([y, x, z]));
    let swapped = exchanged.is_some_and(|place| km_from(place) <= MOST_KM);
    let given = system.coordinates(place);
    let is_near = |own: [f64; 3]| system.geographic(own).is_some_and(|place| km_from(place) <= MOST_KM);
    let zone = given.filter(|_| !swapped).and_then(|given| in_other_zone(system, given, is_near));
    let (point, distance_km, crs) = (point.name.clone(), km_from(place), system.definition().name());
    refuse(Refusal::ControlElsewhere { point, distance_km, crs, most_km: MOST_KM, swapped, zone })
}

/// Zones beside its own whose coordinates are taken for those of a system.
const ZONES_BESIDE: i64 = 2;

/// The other zone of a system of UTM whose coordinates these are, where `is_right` holds for them in the system itself: the nearest one.
pub(super) fn in_other_zone(system: &CoordinateSystem, given: [f64; 3], is_right: impl Fn([f64; 3]) -> bool) -> Option<u32> {
    let own = |text: String| {
        let other = CoordinateSystem::about(Definition::read(&text).ok()?, system.geoid_m(), [given[0], given[1]]).ok()?;
        system.coordinates(other.geographic(given)?)
    };
    other_zones(system.definition().text()).into_iter().find(|(_, text)| own(text.clone()).is_some_and(&is_right)).map(|(zone, _)| zone)
}

/// The zones beside that of a system, each with its definition, the nearest first; none where it names no zone of UTM.
fn other_zones(text: &str) -> Vec<(u32, String)> {
    let Some((before, zone, after)) = zone_in(text) else { return Vec::new() };
    let beside = (1..=ZONES_BESIDE).flat_map(|off| [-off, off]).map(|off| (i64::from(zone) - 1 + off).rem_euclid(60) + 1);
    beside.filter_map(|zone| u32::try_from(zone).ok()).map(|zone| (zone, format!("{before}{zone:02}{after}"))).collect()
}

/// The zone of UTM that a definition names, with the text before and after its digits: `EPSG:32632` of WGS 84, `EPSG:25832` of ETRS89, `+zone=32`.
fn zone_in(text: &str) -> Option<(&str, u32, &str)> {
    const BEFORE: [&str; 4] = ["EPSG:326", "EPSG:327", "EPSG:258", "+zone="];
    let upper = text.to_ascii_uppercase();
    let at = BEFORE.iter().find_map(|before| Some(upper.find(&before.to_ascii_uppercase())? + before.len()))?;
    let digits = text.get(at..)?.bytes().take_while(u8::is_ascii_digit).count();
    let zone = text.get(at..at + digits)?.parse().ok()?;
    ((1..=2).contains(&digits) && (1..=60).contains(&zone)).then(|| (&text[..at], zone, &text[at + digits..]))
}

fn geographic(position: &ObservedPosition) -> Option<[f64; 3]> {
    match *position {
        ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, .. } => {
            Some([longitude_deg, latitude_deg, height_m.unwrap_or(0.0)])
        }
        ObservedPosition::Local { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_zones_beside_a_zone_are_those_of_the_same_datum() {
        let texts = |text: &str| other_zones(text).into_iter().map(|(_, text)| text).collect::<Vec<_>>();
        assert_eq!(texts("EPSG:25832"), ["EPSG:25831", "EPSG:25833", "EPSG:25830", "EPSG:25834"]);
        assert_eq!(texts("epsg:32601+5773")[..2], ["epsg:32660+5773", "epsg:32602+5773"]);
        assert_eq!(texts("+proj=utm +zone=9 +datum=WGS84")[1], "+proj=utm +zone=10 +datum=WGS84");
        for none in ["EPSG:4326", "EPSG:31467", "EPSG:326", "EPSG:32699", "+proj=tmerc +lon_0=9"] {
            assert!(other_zones(none).is_empty(), "{none}");
        }
    }
}
