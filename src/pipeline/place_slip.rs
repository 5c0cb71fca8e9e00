//! How an orthophoto, or positions of a table, may have come to lie elsewhere than GNSS positions: by a slip of its own, or one of these.

use super::system::{OTHER_HALF_M, Slip, ZONE_PREFIX, doubted_at, middle_of_places, reach_m, slip_of, unit_beside};
use crate::crs::{CoordinateSystem, Definition, beside_in_utm};
use crate::math::dot3;
use crate::{PlaceSlip, local_from_geographic};

/// By the coordinates of its middle, in the unit of its system, and how far it reaches from there in m; absent where nothing known brings one to the other.
pub(crate) fn place_slip(definition: &Definition, middle: [f64; 2], gnss: &[[f64; 2]], extent_m: f64) -> Option<PlaceSlip> {
    let own = of_coordinates(definition, middle, gnss, extent_m);
    // The sign of a northing is that of all latitudes.
    match own {
        None | Some(PlaceSlip::Coordinate { .. }) => of_positions(definition, middle, gnss, extent_m).or(own),
        _ => own,
    }
}

/// The same of slips of its own alone, in a system that has the positions.
pub(super) fn of_coordinates(definition: &Definition, [x, y]: [f64; 2], gnss: &[[f64; 2]], extent_m: f64) -> Option<PlaceSlip> {
    let images = middle_of_places(gnss)?;
    let system = CoordinateSystem::new(definition.clone(), None, images).ok()?;
    let reach_m = reach_m(gnss, images) + extent_m;
    let doubted = doubted_at(&system, [x, y, 0.0], images, reach_m)?;
    let Slip { swapped, zone, likely } = slip_of(&system, &doubted);
    let is_utm = || !beside_in_utm(definition, [x, y]).is_empty();
    let other_half = || [1.0, -1.0].into_iter().any(|sign| doubted.explains([x, y + sign * OTHER_HALF_M, 0.0]));
    // Eastings with the number of the zone before them, where the system has them without.
    let short_x = libm::fmod(x, ZONE_PREFIX);
    let is_prefixed = || x > ZONE_PREFIX && doubted.explains([short_x, y, 0.0]);
    zone.map(|zone| PlaceSlip::Zone { zone })
        .or_else(|| swapped.then_some(PlaceSlip::Exchanged))
        .or_else(|| (is_utm() && other_half()).then_some(PlaceSlip::OtherHalf))
        .or_else(|| {
            let (given_in, _) = unit_beside(definition, [x, y], Some((images, reach_m)))?;
            Some(PlaceSlip::Unit { given_in: given_in.into() })
        })
        .or_else(|| is_prefixed().then(|| PlaceSlip::Coordinate { likely: format!("x = {short_x}") }))
        .or_else(|| likely.map(|likely| PlaceSlip::Coordinate { likely }))
}

/// Longitude and latitude of a position as a slip has them.
type Slipped = fn([f64; 2]) -> [f64; 2];

/// Slips of those who record positions: letters of the hemisphere that are not written or not read, and latitude in the place of longitude.
const OF_POSITIONS: [(PlaceSlip, Slipped); 4] = [
    (PlaceSlip::ExchangedPositions, |[longitude, latitude]| [latitude, longitude]),
    (PlaceSlip::LatitudeSign, |[longitude, latitude]| [longitude, -latitude]),
    (PlaceSlip::LongitudeSign, |[longitude, latitude]| [-longitude, latitude]),
    (PlaceSlip::BothSigns, |[longitude, latitude]| [-longitude, -latitude]),
];

/// Of the positions, which need not lie in the system.
fn of_positions(definition: &Definition, middle: [f64; 2], gnss: &[[f64; 2]], extent_m: f64) -> Option<PlaceSlip> {
    let system = CoordinateSystem::about(definition.clone(), None, middle).ok()?;
    let [longitude, latitude, _] = system.geographic([middle[0], middle[1], 0.0])?;
    let lie_there = |slipped: Slipped| {
        let gnss: Vec<[f64; 2]> = gnss.iter().map(|place| slipped(*place)).filter(|[_, latitude]| latitude.abs() <= 90.0).collect();
        middle_of_places(&gnss).is_some_and(|images| {
            // Along the chord: what lies on the other side of the earth is near no plane.
            let apart = local_from_geographic([images[0], images[1], 0.0], [longitude, latitude, 0.0]);
            dot3(&apart, &apart).sqrt() <= reach_m(&gnss, images) + extent_m
        })
    };
    // Near the equator or the zero meridian the sign is no matter.
    if lie_there(|place| place) {
        return None;
    }
    OF_POSITIONS.into_iter().find(|(_, slipped)| lie_there(*slipped)).map(|(slip, _)| slip)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of an orthophoto at that place of the earth, whose images record positions about another one.
    fn slip(crs: &str, at: [f64; 2], recorded: [f64; 2]) -> Option<PlaceSlip> {
        let definition = Definition::read(crs).unwrap();
        let [x, y, _] = CoordinateSystem::new(definition.clone(), None, at).unwrap().coordinates([at[0], at[1], 0.0]).unwrap();
        let gnss = [[0.0, 0.0], [0.002, 0.0], [0.0, 0.002]].map(|[east, north]| [recorded[0] + east, recorded[1] + north]);
        place_slip(&definition, [x, y], &gnss, 300.0)
    }

    #[test]
    fn slips_of_recorded_positions_are_named_also_where_the_system_does_not_reach_them() {
        // ETRS89 is of Europe, WGS 84 of the whole earth.
        for crs in ["EPSG:25832", "EPSG:32632"] {
            let of = |recorded: [f64; 2]| slip(crs, [8.0, 50.0], recorded);
            assert_eq!(of([50.0, 8.0]), Some(PlaceSlip::ExchangedPositions), "{crs}");
            assert_eq!(of([8.0, -50.0]), Some(PlaceSlip::LatitudeSign), "{crs}");
            assert_eq!(of([-8.0, 50.0]), Some(PlaceSlip::LongitudeSign), "{crs}");
            assert_eq!(of([-8.0, -50.0]), Some(PlaceSlip::BothSigns), "{crs}");
            // Where they belong, and elsewhere.
            assert_eq!([of([8.0, 50.0]), of([30.0, 20.0])], [None, None], "{crs}");
        }
        assert_eq!(slip("EPSG:31983", [-46.0, -23.5], [46.0, 23.5]), Some(PlaceSlip::BothSigns));
        // On the zero meridian the sign of the longitude is no matter.
        assert_eq!(slip("EPSG:27700", [0.002, 51.48], [-0.002, 51.48]), None);
        assert_eq!(slip("EPSG:27700", [-0.1, 51.48], [0.1, 51.48]), Some(PlaceSlip::LongitudeSign));
    }
}
