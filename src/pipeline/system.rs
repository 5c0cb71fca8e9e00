//! The coordinate reference system of a block's control points and results, and whether its control points can be in it.

use crate::crs::CoordinateSystem;
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
    let (point, distance_km, crs) = (point.name.clone(), km_from(place), system.definition().name());
    refuse(Refusal::ControlElsewhere { point, distance_km, crs, most_km: MOST_KM, swapped })
}

fn geographic(position: &ObservedPosition) -> Option<[f64; 3]> {
    match *position {
        ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, .. } => {
            Some([longitude_deg, latitude_deg, height_m.unwrap_or(0.0)])
        }
        ObservedPosition::Local { .. } => None,
    }
}
