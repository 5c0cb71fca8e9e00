//! A place of the ground that somebody measures by eye on an orthophoto: a ground control point for a block, which images measure as any other.

use super::adjusting::PlaceErrors;
use super::block_links::in_metres;
use super::by_hand::BY_EYE_PX;
use super::heights::Heights;
use super::into_system::{IntoSystem, NoWay};
use super::links::height_spread;
use super::options::PlacingOptions;
use super::reference::Orthophoto;
use crate::error::refuse;
use crate::pipeline::name_by_hand;
use crate::{BlockEdit, ControlRole, Error, Failure, HeightZero, Refusal};

/// The edit that adds a place X, Y of an orthophoto, in its system and unit, as a ground control point to a block. Its height is looked up. Its standard
/// errors hold those of any place of the orthophoto (`options`), one px of it for the eye, and by how much the heights about it differ; its image
/// measurements have one of a px. Edits after it measure it.
///
/// `number`: of the places that were measured by hand so far, those that were given up included, from 1; the point is named by it. `system`: the coordinate
/// reference system that the block has, with where its heights count from; absent: its control points are in the
/// system of the orthophoto. What is to be said of the way there goes with the edit.
///
/// # Errors
/// [`Error::InvalidInput`] for a place that has no height, and where nothing leads from the orthophoto to the system of the block.
pub fn control_by_hand(
    number: usize,
    place: [f64; 2],
    orthophoto: &Orthophoto,
    system: Option<(&str, HeightZero)>,
    options: &PlacingOptions,
) -> Result<BlockEdit, Error> {
    options.check_ranges()?;
    let beyond = |crs: String, failure: Failure| Refusal::PlaceSystem { crs, failure }.into_error();
    let into = system.map(|(crs, zero)| IntoSystem::into(crs, zero, orthophoto)).transpose();
    let into = into.map_err(|NoWay { crs, failure, .. }| beyond(crs, failure))?;
    let reference = in_metres(into.as_ref(), orthophoto);
    let [x, y] = place.map(|v| v * into.as_ref().map_or(1.0, IntoSystem::unit_m));
    let Some(height) = Some([x, y]).filter(|at| at.iter().all(|v| v.is_finite())).and_then(|at| reference.heights.at(at)) else {
        return refuse(Refusal::PlaceWithoutHeight { place: format!("{place:?}") });
    };
    let gsd = reference.georeference.gsd();
    let errors = PlaceErrors::new(options, gsd, matches!(reference.heights, Heights::Model(_)));
    let spread = height_spread(&reference.heights, &reference.georeference, reference.georeference.pixel([x, y]), height);
    let sigma = [libm::hypot(errors.plan, BY_EYE_PX * gsd), libm::hypot(errors.height, spread)];
    let own = [x, y, height];
    let (position, remarks) = match &into {
        Some(into) => into.taken_place(own, orthophoto).map_err(|error| beyond(into.crs(), Failure::from(&error)))?,
        None => (own, Vec::new()),
    };
    Ok(BlockEdit::AddControl {
        name: name_by_hand(number),
        position,
        standard_errors: Some(sigma),
        sigma_px: Some(BY_EYE_PX),
        role: ControlRole::Control,
        epsg: orthophoto.epsg,
        remarks,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Georeference, GreyImage, HeightModel, Remark};

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
                ..
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
        let other =
            added(control_by_hand(1, [500_000.0, 5_399_900.0], &made, Some(("EPSG:25832", HeightZero::Unknown)), &options).unwrap()).1;
        assert!((other[0] - 500_000.0).abs() < 1e-3 && (other[1] - 5_399_900.0).abs() < 1e-3, "{other:?}");
        let degrees =
            added(control_by_hand(1, [500_000.0, 5_399_900.0], &made, Some(("EPSG:4326", HeightZero::Unknown)), &options).unwrap()).1;
        assert!((degrees[0] - 9.0).abs() < 1e-7 && (degrees[1] - 48.75).abs() < 0.01, "{degrees:?}");
    }

    #[test]
    fn a_place_without_a_height_and_a_system_that_nothing_leads_to_are_refused() {
        let (made, options) = (orthophoto(), PlacingOptions::default());
        let refused = |place: [f64; 2], crs: Option<&str>| {
            control_by_hand(1, place, &made, crs.map(|crs| (crs, HeightZero::Unknown)), &options).unwrap_err().to_string()
        };
        assert!(refused([400_000.0, 5_399_900.0], None).contains("got [400000.0, 5399900.0]; allowed: where the ground"));
        assert!(refused([f64::NAN, 0.0], None).contains("NaN"));
        let other = refused([500_100.0, 5_399_900.0], Some("EPSG:99999"));
        assert!(other.contains("EPSG:99999"), "{other}");
        // Nor has a place far beyond the system of the block coordinates there.
        let mut made =
            Orthophoto::new(made.grey().unwrap(), Georeference::north_up([500_000.0, 5_400_000.0], 2e5), Heights::Level(0.0)).unwrap();
        made.epsg = Some(32632);
        let beyond =
            control_by_hand(1, [5e7, 5_300_000.0], &made, Some(("EPSG:4326", HeightZero::Unknown)), &options).unwrap_err().to_string();
        assert!(beyond.contains("nothing leads to WGS 84") && beyond.contains("50000000"), "{beyond}");
    }

    #[test]
    fn what_is_to_be_said_of_heights_and_system_goes_with_the_edit() {
        let mut made = orthophoto();
        let Heights::Model(model) = made.heights else { panic!() };
        made.heights = Heights::Model(model.counting_from(4979));
        let said = |system: Option<(&str, HeightZero)>| match control_by_hand(
            1,
            [500_100.0, 5_399_900.0],
            &made,
            system,
            &PlacingOptions::default(),
        )
        .unwrap()
        {
            BlockEdit::AddControl { remarks, .. } => remarks,
            other => panic!("{other:?}"),
        };
        let remarks = said(Some(("EPSG:25832", HeightZero::Level(46.8))));
        assert!(
            matches!(
                &remarks[..],
                [Remark::OrthophotoConverted { .. }, Remark::OrthophotoHeights { from_ellipsoid: true, above_m: Some(46.8), .. }]
            ),
            "{remarks:?}"
        );
        // Where nobody knows what heights of the block count from, and in the system of the orthophoto, there is nothing to say of them.
        assert!(matches!(said(Some(("EPSG:25832", HeightZero::Unknown)))[..], [Remark::OrthophotoConverted { .. }]));
        assert!(said(None).is_empty());
    }
}
