//! The operation that leads from a coordinate reference system to WGS 84 at a place.

use super::definition::{Definition, HeightReference};
use crate::error::refuse;
use crate::text::shorten;
use crate::{Error, Refusal};
use proj_core::{
    AreaOfInterest, Coord, CoordinateOperationMetadata, CrsDef, SelectionOptions, Transform, lookup_epsg,
    operation_candidates_between_with_selection_options,
};
use proj_wkt::transform_from_crs_strings_horizontal_with_selection_options;

/// WGS 84, and the semi-major axis that it shares with GRS 80.
const WGS84: u32 = 4326;
const SEMI_MAJOR_AXIS_M: f64 = 6_378_137.0;

/// Areas that a refusal names.
const NAMED_AREAS: usize = 5;

/// The transformation of the plane from its coordinates to longitude and latitude.
///
/// Of the operations of the EPSG registry that hold at the place, it is the first in the order of the library that needs no grid and states its
/// accuracy: one that states none may be wrong by kilometres.
///
/// # Errors
/// [`Error::InvalidInput`] where no operation leads there, or none that holds at the place.
pub(super) fn to_wgs84(definition: &Definition, place: [f64; 2]) -> Result<Transform, Error> {
    let interest = AreaOfInterest::geographic_point(Coord::new(place[0], place[1]));
    let options = SelectionOptions::new().with_area_of_interest(interest);
    if definition.may_state_shift() {
        return stated(definition, options);
    }
    let Some((source, target)) = ends(definition) else { return refuse(no_shift(definition)) };
    let own = |options| Transform::from_crs_defs_with_selection_options(&source, &target, options);
    let candidates = operation_candidates_between_with_selection_options(&source, &target, &options).unwrap_or_default();
    let usable: Vec<&CoordinateOperationMetadata> = candidates.iter().filter(|one| !one.uses_grids && one.accuracy.is_some()).collect();
    let holds = |one: &&&CoordinateOperationMetadata| {
        let [longitude, latitude] = place;
        one.area_of_use.as_ref().is_none_or(|area| area.contains_point(Coord::new(longitude, latitude)))
    };
    let chosen = usable.iter().find(holds).map(|one| one.id);
    let found = match (chosen, usable.is_empty()) {
        (Some(Some(id)), _) => own(options.with_operation(id)).ok(),
        // A system on WGS 84 itself needs none.
        (Some(None), _) | (None, true) => own(options).ok().filter(|found| found.selected_operation().id.is_none()),
        (None, false) => return refuse(outside(definition, place, &usable)),
    };
    found.ok_or_else(|| no_shift(definition).into_error())
}

fn outside(definition: &Definition, [longitude_deg, latitude_deg]: [f64; 2], usable: &[&CoordinateOperationMetadata]) -> Refusal {
    let mut areas: Vec<&str> = usable.iter().filter_map(|one| Some(&one.area_of_use.as_ref()?.name[..])).collect();
    areas.dedup();
    let areas = areas[..areas.len().min(NAMED_AREAS)].join("; ");
    Refusal::CrsArea { crs: definition.name(), longitude_deg, latitude_deg, areas }
}

/// By the shift that the text states, if it states one.
fn stated(definition: &Definition, options: SelectionOptions) -> Result<Transform, Error> {
    let target = format!("EPSG:{WGS84}");
    transform_from_crs_strings_horizontal_with_selection_options(definition.spelling(), &target, options)
        .map_err(|_| no_shift(definition).into_error())
}

/// In the plane: heights are kept, since those of GNSS are above the ellipsoid of WGS 84, and those above a geoid count from that. Heights above
/// another ellipsoid are neither.
fn ends(definition: &Definition) -> Option<(CrsDef, CrsDef)> {
    let is_alike = (definition.crs().datum().ellipsoid().semi_major_axis() - SEMI_MAJOR_AXIS_M).abs() < 1.0;
    let is_kept = is_alike || definition.heights() != HeightReference::Ellipsoid;
    Some((definition.crs().horizontal_crs().filter(|_| is_kept)?, lookup_epsg(WGS84)?))
}

pub(super) fn no_shift(definition: &Definition) -> Refusal {
    let (crs, name) = (shorten(definition.text()), definition.name());
    Refusal::NoDatumShift { name: Some(name).filter(|name| *name != crs), crs }
}

/// About where coordinates are: near enough to choose the operation that holds there.
///
/// # Errors
/// As [`to_wgs84`]; for coordinates outside the system.
pub(super) fn about(definition: &Definition, [x, y]: [f64; 2]) -> Result<[f64; 2], Error> {
    let degrees = definition.is_geographic();
    let outside = || Refusal::CrsPlace { x, y, crs: definition.name(), degrees }.into_error();
    if degrees {
        return Some([x, y]).filter(|[x, y]| x.abs() <= 180.0 && y.abs() <= 90.0).ok_or_else(outside);
    }
    let Some((plane, wgs84)) = ends(definition) else { return refuse(no_shift(definition)) };
    let to_degrees = match plane.base_geographic_crs_epsg().and_then(lookup_epsg) {
        Some(base) => Transform::from_crs_defs(&plane, &base).ok(),
        None if definition.may_state_shift() => Some(stated(definition, SelectionOptions::new())?),
        None => Transform::from_crs_defs(&plane, &wgs84).ok(),
    };
    let Some(to_degrees) = to_degrees else { return refuse(no_shift(definition)) };
    to_degrees.convert(Coord::new(x, y)).map(|Coord { x, y }| [x, y]).map_err(|_| outside())
}
