//! A place of the ground that somebody measures by eye on an orthophoto: a ground control point for a block, which images measure as any other.

use super::adjusting::PlaceErrors;
use super::block_links::in_metres;
use super::by_hand::BY_EYE_PX;
use super::heights::Heights;
use super::into_system::IntoSystem;
use super::links::height_spread;
use super::options::PlacingOptions;
use super::reference::Orthophoto;
use crate::crs::HeightZero;
use crate::error::refuse;
use crate::pipeline::{GroundPoint, name_by_hand};
use crate::{BlockEdit, ControlRole, Error, NotLinked, Refusal};

/// The edit that adds a place X, Y of an orthophoto, in its system and unit, as a ground control point to a block. Its height is looked up. Its standard
/// errors hold those of any place of the orthophoto (`options`), one px of it for the eye, and by how much the heights about it differ; its image
/// measurements have one of a px. Edits after it measure it.
///
/// `number`: of the places that were measured by hand so far, those that were given up included, from 1; the point is named by it. `crs`: the coordinate
/// reference system that the block has; absent: its control points are in the system of the orthophoto.
///
/// # Errors
/// [`Error::InvalidInput`] for a place that has no height, and where nothing leads from the orthophoto to the system of the block.
pub fn control_by_hand(
    number: usize,
    place: [f64; 2],
    orthophoto: &Orthophoto,
    crs: Option<&str>,
    options: &PlacingOptions,
) -> Result<BlockEdit, Error> {
    options.check_ranges()?;
    let system = |not_linked: NotLinked| match not_linked {
        NotLinked::OtherSystem { failure, crs, .. } => Refusal::PlaceSystem { crs, failure }.into_error(),
        NotLinked::Failed { failure } => Refusal::PlaceSystem { crs: crs.unwrap_or_default().into(), failure }.into_error(),
        _ => Refusal::PlaceWithoutHeight { place: format!("{place:?}") }.into_error(),
    };
    // Only places are taken: what is to be said of their heights the block has said.
    let into = crs.map(|crs| IntoSystem::into(crs, HeightZero::Unknown, orthophoto)).transpose().map_err(system)?;
    let reference = in_metres(into.as_ref(), orthophoto);
    let [x, y] = place.map(|v| v * into.as_ref().map_or(1.0, IntoSystem::unit_m));
    let Some(height) = Some([x, y]).filter(|at| at.iter().all(|v| v.is_finite())).and_then(|at| reference.heights.at(at)) else {
        return refuse(Refusal::PlaceWithoutHeight { place: format!("{place:?}") });
    };
    let gsd = reference.georeference.gsd();
    let errors = PlaceErrors::new(options, gsd, matches!(reference.heights, Heights::Model(_)));
    let spread = height_spread(&reference.heights, &reference.georeference, reference.georeference.pixel([x, y]), height);
    let sigma = [libm::hypot(errors.plan, BY_EYE_PX * gsd), libm::hypot(errors.height, spread)];
    let own = GroundPoint { place: [x, y, height], sigma, sigma_px: BY_EYE_PX, role: ControlRole::Control, seen: Vec::new() };
    let position = match &into {
        Some(into) => into.taken(vec![own.clone()], orthophoto).map_err(system)?.0.first().map_or(own.place, |taken| taken.place),
        None => own.place,
    };
    Ok(BlockEdit::AddControl {
        name: name_by_hand(number),
        position,
        standard_errors: Some(sigma),
        sigma_px: Some(own.sigma_px),
        role: own.role,
        epsg: orthophoto.epsg,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Georeference, GreyImage, HeightModel};

    /// 600 px of 0.5, on ground that rises to the east.
    fn orthophoto() -> Orthophoto {
        let georeference = Georeference::north_up([500_000.0, 5_400_000.0], 0.5);
        let rising = (0..61 * 61).map(|k| 100.0 + 2.0 * (k % 61) as f32).collect();
        let model = HeightModel::new(61, 61, rising, Georeference::north_up([500_000.0 - 2.5, 5_400_000.0 + 2.5], 5.0)).unwrap();
        let mut made = Orthophoto::new(GreyImage::from_fn(600, 600, |_, _| 90).unwrap(), georeference, Heights::Model(model)).unwrap();
        made.epsg = Some(32632);
        made
    }

    fn added(edit: BlockEdit) -> (String, [f64; 3], [f64; 2], Option<u16>) {
        match edit {
            BlockEdit::AddControl {
                name,
                position,
                standard_errors: Some(errors),
                sigma_px: Some(1.0),
                role: ControlRole::Control,
                epsg,
            } => (name, position, errors, epsg),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_place_has_the_height_and_the_standard_errors_of_the_orthophoto_and_of_the_eye() {
        let made = orthophoto();
        let options = PlacingOptions { place_sigma_px: 0.75, height_sigma_m: Some(0.5), ..PlacingOptions::default() };
        let (name, position, errors, epsg) = added(control_by_hand(3, [500_100.0, 5_399_900.0], &made, None, &options).unwrap());
        assert_eq!((name.as_str(), epsg), ("orthophoto_hand_3", Some(32632)));
        assert!((position[2] - 140.0).abs() < 1e-6, "{position:?}");
        assert!((errors[0] - 0.625).abs() < 1e-9, "0.375 m and 0.5 m: {errors:?}");
        assert!(errors[1] > 0.5 && errors[1] < 2.0, "{errors:?}");
        // In another system it is where that has it: 9° east is the central meridian of both, scaled otherwise.
        let other = added(control_by_hand(1, [500_000.0, 5_399_900.0], &made, Some("EPSG:25832"), &options).unwrap()).1;
        assert!((other[0] - 500_000.0).abs() < 1e-3 && (other[1] - 5_399_900.0).abs() < 1e-3, "{other:?}");
        let degrees = added(control_by_hand(1, [500_000.0, 5_399_900.0], &made, Some("EPSG:4326"), &options).unwrap()).1;
        assert!((degrees[0] - 9.0).abs() < 1e-7 && (degrees[1] - 48.75).abs() < 0.01, "{degrees:?}");
    }

    #[test]
    fn a_place_without_a_height_and_a_system_that_nothing_leads_to_are_refused() {
        let (made, options) = (orthophoto(), PlacingOptions::default());
        let refused = |place: [f64; 2], crs: Option<&str>| control_by_hand(1, place, &made, crs, &options).unwrap_err().to_string();
        assert!(refused([400_000.0, 5_399_900.0], None).contains("got [400000.0, 5399900.0]; allowed: where the ground"));
        assert!(refused([f64::NAN, 0.0], None).contains("NaN"));
        let other = refused([500_100.0, 5_399_900.0], Some("EPSG:99999"));
        assert!(other.contains("EPSG:99999"), "{other}");
    }
}
