//! The coordinate reference system of a block's control points and results, and whether its control points can be in it.

use crate::crs::{CoordinateSystem, Definition, HeightZero, beside_in_utm, middle, prefixed_code, zone_of};
use crate::error::refuse;
use crate::formats::{LENGTHS, StatedUnit};
use crate::math::{dot3, median, turn};
use crate::reconstruction::Doubted;
use crate::{Axis, Error, GeoreferencingOptions, GroundControlPoint, Input, Mistake, ObservedPosition, Refusal, local_from_geographic};

/// No block has ground control points farther from its images.
pub(super) const MOST_KM: f64 = 100.0;
/// What explains a control point elsewhere brings it to the block: within so many times the distance from its middle that half of the images have, and
/// what a control point may lie beside them, in m.
const REACH: f64 = 3.0;
const BESIDE_M: f64 = 5_000.0;
/// Of a system, over which its units are taken.
const UNITS: f64 = 1e-3;

/// The system about these coordinates in it or, without any, about these longitudes and latitudes; absent where none was chosen, and where nothing says
/// where the block is. `zero`: where its heights count from.
///
/// # Errors
/// [`Error::InvalidInput`] for a system that cannot be read, one that nothing leads from to WGS 84 there, and eastings with the number of a zone before them
/// in one that has them without.
pub(super) fn system_of(
    placing: &GeoreferencingOptions,
    zero: &HeightZero,
    control: &[[f64; 2]],
    gnss: &[[f64; 2]],
) -> Result<Option<CoordinateSystem>, Error> {
    let Some(definition) = placing.definition()? else { return Ok(None) };
    if let Some(refusal) = with_zone(&definition, control) {
        return refuse(refusal);
    }
    if let Some(at) = middle(control.iter().copied(), definition.is_geographic()) {
        return CoordinateSystem::about(definition, zero.clone(), at).map(Some);
    }
    middle_of_places(gnss).map(|at| CoordinateSystem::new(definition, zero.clone(), at)).transpose()
}

/// What is wrong with eastings that all begin with the number of one zone, as no easting of UTM does.
fn with_zone(definition: &Definition, control: &[[f64; 2]]) -> Option<Refusal> {
    let own = zone_of(definition).filter(|_| definition.unit_m().is_some_and(|unit_m| is_unit(unit_m, 1.0)))?;
    let zone = |[x, y]: [f64; 2]| {
        let prefix = (x / ZONE_PREFIX).floor();
        let is_easting = EASTINGS_M.contains(&(x - prefix * ZONE_PREFIX));
        // Eastings in cm begin with all numbers; their northings are larger than any.
        Some(prefix as u32).filter(|zone| is_easting && prefix >= 1.0 && zone.abs_diff(own) <= 1 && y.abs() <= OTHER_HALF_M)
    };
    let first = *control.first()?;
    let number = zone(first).filter(|number| control.iter().all(|place| zone(*place) == Some(*number)))?;
    let x = first[0].to_string();
    let short = x.strip_prefix(&number.to_string()).unwrap_or(&x).to_string();
    let code = prefixed_code(definition, number).map(|code| format!("EPSG:{code}"));
    Some(Refusal::ControlZone { x, zone: number, short, crs: definition.name(), code })
}

/// Eastings of UTM, wide of every zone, in m.
const EASTINGS_M: std::ops::Range<f64> = 100_000.0..900_000.0;

/// Of longitudes and latitudes.
pub(super) fn middle_of_places(places: &[[f64; 2]]) -> Option<[f64; 2]> {
    middle(places.iter().copied(), true)
}

/// Refuses a control point that lies elsewhere on the earth than the GNSS positions of the images.
pub(super) fn check_near(control: &[GroundControlPoint], gnss: &[[f64; 2]], system: &CoordinateSystem) -> Result<(), Error> {
    let Some([longitude, latitude]) = middle_of_places(gnss) else { return Ok(()) };
    // Along the chord.
    let km_from = |place: [f64; 3]| {
        let apart = local_from_geographic([place[0], place[1], 0.0], [longitude, latitude, 0.0]);
        0.001 * dot3(&apart, &apart).sqrt()
    };
    let far = control.iter().filter_map(|point| Some((point, geographic(&point.position)?))).find(|(_, place)| km_from(*place) > MOST_KM);
    let Some((point, place)) = far else { return Ok(()) };
    let slip = doubted(system, place, [longitude, latitude], reach_m(gnss, [longitude, latitude])).map(|doubted| slip_of(system, &doubted));
    let Slip { swapped, zone, likely } = slip.unwrap_or_default();
    let (point, distance_km, crs) = (point.name.clone(), km_from(place), system.definition().name());
    refuse(Refusal::ControlElsewhere { point, distance_km, crs, most_km: MOST_KM, swapped, zone, likely })
}

/// Feet differ by less, and are told apart by nothing.
const ALIKE: f64 = 1e-5;

/// Whether coordinates in a plane are hardly others than longitude and latitude.
pub(super) fn looks_like_degrees([x, y]: [f64; 2]) -> bool {
    x.abs() <= 180.0 && y.abs() <= 90.0
}

/// No map of a transverse Mercator projection reaches farther from its central meridian.
const MOST_FROM_MERIDIAN_DEG: f64 = 4.0;

/// Whether two units of length are one, as far as tables tell them apart.
pub(crate) fn is_unit(length_m: f64, other_m: f64) -> bool {
    (length_m / other_m - 1.0).abs() < ALIKE
}

/// What a unit of length is called.
pub(crate) fn unit_name(unit_m: f64) -> String {
    let named = LENGTHS.iter().find(|(_, own_m)| is_unit(*own_m, unit_m)).map(|(name, _)| (*name).to_string());
    named.unwrap_or_else(|| format!("{unit_m} m"))
}

/// The units in m of coordinates in the plane of the system that was chosen, absent for degrees, and of its heights; without one both are metres.
pub(super) fn units_of(placing: &GeoreferencingOptions) -> Result<(Option<f64>, f64), Error> {
    Ok(placing.definition()?.map_or((Some(1.0), 1.0), |definition| (definition.unit_m(), definition.height_unit_m())))
}

/// Refuses a column of coordinates whose name has another unit than those of the plane, which are degrees without one, and of the heights.
pub(super) fn check_stated_units(input: Input, stated: &[StatedUnit], (plane_m, height_m): (Option<f64>, f64)) -> Result<(), Error> {
    let other = stated.iter().find_map(|StatedUnit { column, unit, is_height }| {
        let own_m = if *is_height { Some(height_m) } else { plane_m };
        let given_m = LENGTHS.iter().find(|(name, _)| name == unit).map(|(_, given_m)| *given_m);
        let is_own = own_m.zip(given_m).is_some_and(|(own_m, given_m)| is_unit(own_m, given_m));
        (!is_own).then(|| (column.clone(), *unit, own_m.map_or_else(|| "°".into(), unit_name)))
    });
    other.map_or(Ok(()), |(column, unit, own)| refuse(Refusal::HeadUnit { input, column, given_in: unit.into(), own }))
}

/// An error of control points that lie elsewhere than they can, or that unit in which they would not.
pub(super) fn with_unit(error: Error, placing: &GeoreferencingOptions, control: &[[f64; 2]], gnss: &[[f64; 2]]) -> Error {
    let Error::InvalidInput { refusal } = &error else { return error };
    let is_of_place = matches!(
        refusal,
        Refusal::CrsPlace { .. } | Refusal::CrsArea { .. } | Refusal::ControlPlace { .. } | Refusal::ControlElsewhere { .. }
    );
    let unit = if is_of_place { in_other_unit(placing, control, gnss) } else { None };
    unit.map_or(error, Refusal::into_error)
}

/// The unit in which control points that cannot be in the system would be: that in which they lie near the images or, where no image has a position, the
/// only one in which they lie on the map of the system; absent where there is none.
fn in_other_unit(placing: &GeoreferencingOptions, control: &[[f64; 2]], gnss: &[[f64; 2]]) -> Option<Refusal> {
    let definition = placing.definition().ok()??;
    let images = middle_of_places(gnss).map(|images| (images, reach_m(gnss, images)));
    let (unit, own) = unit_beside(&definition, middle(control.iter().copied(), false)?, images)?;
    Some(Refusal::ControlUnit { given_in: unit.into(), own, crs: definition.name(), near: images.is_some() })
}

/// The unit in which coordinates in the plane of a system, that cannot be there, would be, and that of the system. `images`: the middle of the GNSS positions
/// and how far from it, in m, coordinates are near them.
pub(super) fn unit_beside(definition: &Definition, [x, y]: [f64; 2], images: Option<([f64; 2], f64)>) -> Option<(&'static str, String)> {
    let unit_m = definition.unit_m()?;
    let is_there = |factor: f64| {
        let at = [factor * x, factor * y];
        let system = match images {
            Some((images, _)) => CoordinateSystem::new(definition.clone(), None, images),
            None => CoordinateSystem::about(definition.clone(), None, at),
        };
        let Some([longitude, latitude, _]) = system.ok().and_then(|system| system.geographic([at[0], at[1], 0.0])) else { return false };
        match images {
            Some((images, reach_m)) => {
                let [east, north, _] = local_from_geographic([longitude, latitude, 0.0], [images[0], images[1], 0.0]);
                libm::hypot(east, north) <= reach_m
            }
            None => definition.central_meridian_deg().is_some_and(|meridian| turn(longitude - meridian).abs() <= MOST_FROM_MERIDIAN_DEG),
        }
    };
    if is_there(1.0) {
        return None;
    }
    let mut found = LENGTHS.iter().filter(|(_, own_m)| !is_unit(*own_m, unit_m) && is_there(own_m / unit_m));
    let (unit, own_m) = found.next()?;
    if found.any(|(_, other_m)| !is_unit(*other_m, *own_m)) {
        return None;
    }
    Some((*unit, unit_name(unit_m)))
}

/// How a control point that lies elsewhere may have come there.
#[derive(Default)]
pub(super) struct Slip {
    pub swapped: bool,
    pub zone: Option<u32>,
    /// The coordinate that would be right.
    pub likely: Option<String>,
}

/// The northing of the equator on the southern half of UTM, and what stands before an easting that begins with the number of its zone, in m.
pub(super) const OTHER_HALF_M: f64 = 10_000_000.0;
pub(super) const ZONE_PREFIX: f64 = 1_000_000.0;

pub(super) fn slip_of(system: &CoordinateSystem, doubted: &Doubted) -> Slip {
    let zone = in_other_zone(system, doubted.given, |place| doubted.explains(place));
    let mistake = doubted.mistake().filter(|_| zone.is_none());
    // A point that is refused lies so far off that chance explains no exchange, however far its block reaches.
    let [x, y, z] = doubted.given;
    let swapped = zone.is_none() && doubted.explains([y, x, z]) && !doubted.explains(doubted.given);
    let likely = match &mistake {
        Some(Mistake::Sign { axis, given }) => Some((axis, given.strip_prefix('-').map_or_else(|| format!("-{given}"), String::from))),
        Some(
            Mistake::DecimalPoint { axis, likely, .. } | Mistake::Digit { axis, likely, .. } | Mistake::Transposed { axis, likely, .. },
        ) => Some((axis, likely.clone())),
        _ => None,
    };
    let likely = likely.map(|(axis, value)| format!("{} = {value}", if *axis == Axis::X { "x" } else { "y" }));
    Slip { swapped, zone, likely: likely.filter(|_| !swapped) }
}

/// How far the images of a block reach from its middle, with what a control point may lie beside them: a far-off position counts for nothing.
pub(super) fn reach_m(gnss: &[[f64; 2]], [longitude, latitude]: [f64; 2]) -> f64 {
    let from_middle = gnss.iter().map(|place| {
        let [east, north, _] = local_from_geographic([place[0], place[1], 0.0], [longitude, latitude, 0.0]);
        libm::hypot(east, north)
    });
    REACH * median(&mut from_middle.collect::<Vec<_>>()).unwrap_or(0.0) + BESIDE_M
}

/// The coordinates of a place beside those of the middle of a block, whose heights are not known; absent where one lies outside the system.
fn doubted(system: &CoordinateSystem, place: [f64; 3], images: [f64; 2], reach_m: f64) -> Option<Doubted> {
    doubted_at(system, system.coordinates(place)?, images, reach_m)
}

/// The same of coordinates in the system.
pub(super) fn doubted_at(system: &CoordinateSystem, given: [f64; 3], [longitude, latitude]: [f64; 2], reach_m: f64) -> Option<Doubted> {
    let [x, y, _] = system.coordinates([longitude, latitude, 0.0])?;
    let likely = [x, y, given[2]];
    let [east, north, _] = system.difference_m(likely, [x - UNITS, y - UNITS, given[2]]).map(|length_m| length_m / UNITS);
    Some(Doubted {
        given,
        likely,
        height_unit_m: system.definition().height_unit_m(),
        within: [reach_m / east, reach_m / north, f64::INFINITY],
    })
}

/// The other zone of a system of UTM whose coordinates these are, where `is_right` holds for them in the system itself: the nearest one.
pub(super) fn in_other_zone(system: &CoordinateSystem, [x, y, z]: [f64; 3], is_right: impl Fn([f64; 3]) -> bool) -> Option<u32> {
    beside_in_utm(system.definition(), [x, y]).into_iter().find(|(_, [x, y])| is_right([*x, *y, z])).map(|(zone, _)| zone)
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
    use crate::ControlRole;

    const UTM: &str = "EPSG:32632";

    /// What is refused of a control point with these coordinates in a system beside images at these places, of which the first has it.
    fn refused_beside(crs: &str, [x, y]: [f64; 2], gnss: &[[f64; 2]]) -> Option<String> {
        let system = CoordinateSystem::new(Definition::read(crs).unwrap(), None, gnss[0]).unwrap();
        let [longitude_deg, latitude_deg, height] = system.geographic([x, y, 100.0]).unwrap();
        let position = ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: Some(height), sigma_m: [0.02; 3] };
        let control =
            GroundControlPoint { name: "G1".into(), position, role: ControlRole::Control, measurements: Vec::new(), sigma_px: None };
        check_near(&[control], gnss, &system).err().map(|error| error.to_string())
    }

    /// What is refused of a control point with these coordinates in a system beside images over some hundred metres at 8° and 50°.
    fn refused(crs: &str, [x, y]: [f64; 2]) -> String {
        let gnss: Vec<[f64; 2]> = (0..9).map(|k| [8.0 + 0.002 * f64::from(k % 3), 50.0 + 0.002 * f64::from(k / 3)]).collect();
        refused_beside(crs, [x, y], &gnss).unwrap()
    }

    #[test]
    fn a_block_across_the_date_line_has_its_control_points_near_it() {
        let gnss: Vec<[f64; 2]> = [179.99, -179.99, 179.98, -179.98].iter().map(|longitude| [*longitude, 52.0]).collect();
        let system = CoordinateSystem::new(Definition::read("EPSG:32601").unwrap(), None, gnss[0]).unwrap();
        let [x, y, _] = system.coordinates([179.995, 52.001, 0.0]).unwrap();
        assert_eq!(refused_beside("EPSG:32601", [x, y], &gnss), None);
        assert!(refused_beside("EPSG:32601", [x + 150_000.0, y], &gnss).is_some());
        // Of control points, too, by which the system of a block is chosen.
        let placing = GeoreferencingOptions { crs: Some("EPSG:4326".into()), ..GeoreferencingOptions::default() };
        assert!(system_of(&placing, &HeightZero::Unknown, &gnss, &[]).unwrap().is_some());
    }

    #[test]
    fn the_number_of_a_zone_before_eastings_is_named_before_other_units() {
        let told = |crs: &str, control: &[[f64; 2]], gnss: &[[f64; 2]]| {
            let placing = GeoreferencingOptions { crs: Some(crs.into()), ..GeoreferencingOptions::default() };
            let named = |error| with_unit(error, &placing, control, gnss).to_string();
            system_of(&placing, &HeightZero::Unknown, control, gnss).map_err(named).err()
        };
        let control = [[32_428_374.069, 5_539_031.0], [32_428_474.069, 5_539_131.0]];
        for crs in ["EPSG:25832", "EPSG:32632", "EPSG:25832+7837"] {
            for gnss in [&[][..], &[[8.0, 50.0]]] {
                let told = told(crs, &control, gnss).unwrap();
                assert!(told.contains("begin with the number of a zone (32, in 32428374.069)"), "{told}");
                assert!(told.contains("allowed: --crs EPSG:4647, or eastings without the 32 (428374.069)"), "{told}");
            }
        }
        // The system that has them so is known.
        assert_eq!(told("EPSG:4647", &control, &[]), None);
        let other = told("EPSG:23032", &control, &[]).unwrap();
        assert!(other.contains("allowed: eastings without the 32") && !other.contains("4647"), "{other}");
        assert_eq!(told("EPSG:25832", &[[428_374.0, 5_539_031.0]], &[]), None);
        // Centimetres and feet have other numbers before them, or larger northings, and one point of many has a slip.
        for [x, y] in [[42_837_406.9, 553_903_100.0], [32_537_406.9, 553_903_100.0], [1_405_426.4, 9_172_674.3]] {
            assert_eq!(with_zone(&Definition::read(UTM).unwrap(), &[[x, y]; 2]), None);
        }
        assert_eq!(with_zone(&Definition::read("+proj=utm +zone=32 +datum=WGS84 +units=us-ft").unwrap(), &control), None);
        assert_eq!(with_zone(&Definition::read(UTM).unwrap(), &[control[0], [428_374.0, 5_539_031.0]]), None);
    }

    #[test]
    fn exchanged_coordinates_are_named_beside_a_large_block_in_a_system_of_small_numbers() {
        // LV03: 600 km and 200 km; images over 120 km.
        let gnss: Vec<[f64; 2]> = (0..9).map(|k| [6.8 + 0.4 * f64::from(k % 3), 46.5 + 0.4 * f64::from(k / 3)]).collect();
        let told = refused_beside("EPSG:21781", [200_000.0, 600_000.0], &gnss).unwrap();
        assert!(told.contains("exchanged"), "{told}");
    }

    #[test]
    fn the_unit_that_brings_control_points_to_the_images_is_named() {
        let gnss: Vec<[f64; 2]> = (0..9).map(|k| [8.0 + 0.002 * f64::from(k % 3), 50.0 + 0.002 * f64::from(k / 3)]).collect();
        let system = CoordinateSystem::new(Definition::read(UTM).unwrap(), None, gnss[0]).unwrap();
        let [x, y, _] = system.coordinates([8.003, 50.001, 0.0]).unwrap();
        let placing = GeoreferencingOptions { crs: Some(UTM.into()), ..GeoreferencingOptions::default() };
        let told =
            |factor: f64| in_other_unit(&placing, &[[factor * x, factor * y]; 3], &gnss).map(|refusal| refusal.into_error().to_string());
        for (factor, unit) in [(1000.0, "mm"), (1.0 / 0.3048, "ft"), (0.001, "km")] {
            let told = told(factor).unwrap();
            assert!(told.contains(&format!("if they are in {unit}")) && told.contains("whose unit is m"), "{told}");
        }
        assert_eq!([told(1.0), told(1.5)], [None, None]);
        // Another error of coordinates that lie far from the meridian is that error.
        let [far_x, far_y] = [840_000.0, 5_390_000.0];
        let other = Refusal::MeasuredUnknown { point: "a".into() }.into_error();
        assert_eq!(with_unit(other.clone(), &placing, &[[far_x, far_y]; 3], &[]), other);
        // Without positions of images by where the map of the system is.
        for (factor, unit) in [(1000.0, "mm"), (1.0 / 0.3048, "ft")] {
            let told = in_other_unit(&placing, &[[factor * x, factor * y]; 3], &[]).unwrap().into_error().to_string();
            assert!(told.contains(&format!("in the area of this system if they are in {unit}")), "{told}");
        }
    }

    #[test]
    fn what_brings_a_control_point_to_the_block_is_named_and_nothing_that_does_not() {
        let system = CoordinateSystem::new(Definition::read(UTM).unwrap(), None, [8.0, 50.0]).unwrap();
        let [x, y, _] = system.coordinates([8.003, 50.001, 0.0]).unwrap();
        let coordinate = |name: &str, value: f64| format!("With {name} = {value} it lies near them");
        // A decimal point beside which another zone lies within 100 km.
        let [told, negative, digit] = [refused(UTM, [x / 10.0, y]), refused(UTM, [-x, y]), refused(UTM, [x + 400_000.0, y])];
        assert!(told.contains("With x = 428") && told.contains("it lies near them") && !told.contains("zone 33 it lies"), "{told}");
        assert!(negative.contains(&coordinate("x", x)), "{negative}");
        assert!(digit.contains("With x = 428"), "{digit}");
        assert!(refused(UTM, [y, x]).contains("exchanged"), "{}", refused(UTM, [y, x]));
        let other = CoordinateSystem::new(Definition::read("EPSG:32631").unwrap(), None, [8.0, 50.0]).unwrap();
        let [x, y, _] = other.coordinates([8.003, 50.001, 0.0]).unwrap();
        for crs in [UTM, "+proj=utm +zone=32 +datum=WGS84", "EPSG:25832"] {
            let told = refused(crs, [x, y]);
            assert!(told.contains("In zone 31 it lies near them"), "{told}");
        }
        // 60 km beside it in that zone it is not near.
        let told = refused(UTM, [x + 60_000.0, y]);
        assert!(!told.contains("lies near them") && told.contains("zone right"), "{told}");
    }
}
