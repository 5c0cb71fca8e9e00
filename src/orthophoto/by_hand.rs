//! The orientation of an image by links that are given: nothing is matched, so that a link can be rejected or measured by hand.

use super::adjusting::{PlaceErrors, PlacingCamera, adjusted};
use super::footprint::Footprint;
use super::heights::Heights;
use super::links::{Found, MEASURED_PX, Over, height_spread};
use super::options::PlacingOptions;
use super::outcome::{NotPlaced, PlacedImage, Placement, PlacingVerdict};
use super::place::first_orientation;
use super::placement::{Part, moved, placement};
use super::precision::total_errors;
use super::recorded_place::judged;
use super::recorded_position::RecordedPosition;
use super::rectify::Seen;
use super::reference::Orthophoto;
use super::relief::{Relief, height_factor};
use super::verdict::verdict;
use crate::error::refuse;
use crate::{Camera, Error, Failure, Few, Location, Refusal};
use serde::{Deserialize, Serialize};

/// What a given link is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum GivenUse {
    /// It takes part, unless data snooping rejects it.
    Used,
    /// It takes no part, and checks the orientation.
    Check,
    /// It takes no part: somebody rejected it.
    Rejected,
}

/// A point of an image and the place of the orthophoto that shows it, as somebody gives them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct GivenLink {
    /// Column and row in px; the centre of the top-left pixel is (0.5, 0.5).
    pub at: [f64; 2],
    /// X and Y in the system of the orthophoto; its height is looked up.
    pub place: [f64; 2],
    #[serde(rename = "use")]
    pub part: GivenUse,
    /// Whether it was measured by eye, to about a pixel of both pictures.
    #[serde(default)]
    pub by_hand: bool,
}

/// Links that take part, at least: three orient an image, and a fourth tells whether they are right.
const LEAST_LINKS: usize = 4;
/// Standard error of a position that was measured by eye, in px of its picture.
pub(super) const BY_EYE_PX: f64 = 1.0;
/// That of a link, in px of the image: it was measured in either picture.
const BY_HAND_PX: f64 = std::f64::consts::SQRT_2 * BY_EYE_PX;

/// Orients an image by given links: from where it was placed before, or by resection where it was not. The links of the result are the given
/// ones in their order. `position`: the GNSS position that it records, which doubts where the links have it as [`place_recorded`](crate::place_recorded) does.
///
/// # Errors
/// [`Error::TooFew`] for fewer than 4 links that take part; [`Error::InvalidInput`] for one beside the image or the heights.
pub fn place_by_links(
    known: &PlacingCamera,
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    start: Option<&Placement>,
    links: &[GivenLink],
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    options.check_ranges()?;
    known.camera.check(|| Location::CameraOfImage)?;
    let used = links.iter().filter(|link| link.part == GivenUse::Used).count();
    if used < LEAST_LINKS {
        return Err(Error::TooFew { few: Few::Links, got: used, needed: LEAST_LINKS });
    }
    // Coordinates of maps are large: everything is computed about a place near the image.
    let first = links[0].place.map(f64::round);
    if !first.iter().all(|v| v.is_finite()) {
        return refused(0, links[0].place);
    }
    let (georeference, heights) = reference.about(first);
    let mut found = Vec::with_capacity(links.len());
    for (number, link) in links.iter().enumerate() {
        // One that takes no part keeps nobody from editing the others.
        let takes_part = link.part == GivenUse::Used;
        if takes_part && !known.camera.sees(link.at[0], link.at[1]) {
            let Camera { width_px, height_px, .. } = known.camera;
            return refuse(Refusal::LinkPosition { position: format!("{:?}", link.at), link: number + 1, width_px, height_px });
        }
        let plan = [link.place[0] - first[0], link.place[1] - first[1]];
        if !plan.iter().chain(&link.at).all(|v| v.is_finite()) {
            return refused(number, link.place);
        }
        let height = match heights.at(plan) {
            Some(height) => height,
            None if takes_part => return refused(number, link.place),
            None => {
                let [low, high] = heights.range();
                0.5 * (low + high)
            }
        };
        let measured_px = if link.by_hand { BY_HAND_PX } else { MEASURED_PX };
        let height_spread = height_spread(&heights, &georeference, georeference.pixel(plan), height);
        found.push(Found { at: link.at, place: [plan[0], plan[1], height], height_spread, measured_px });
    }
    let part = |link: &GivenLink| match link.part {
        GivenUse::Used => Part::Used,
        GivenUse::Check => Part::Check,
        GivenUse::Rejected => Part::Rejected,
    };
    let parts: Vec<Part> = links.iter().map(part).collect();
    let taking: Vec<Found> = found.iter().zip(&parts).filter(|(_, part)| **part == Part::Used).map(|(link, _)| *link).collect();
    let approximate = match start {
        Some(start) => {
            let mut pose = start.pose;
            (0..2).for_each(|k| pose.position[k] -= first[k]);
            (start.camera, pose)
        }
        None => {
            let seen: Vec<([f64; 2], [f64; 3])> = taking.iter().map(|link| (link.at, link.place)).collect();
            let longer_px = f64::from(known.camera.width_px.max(known.camera.height_px));
            match first_orientation(&seen, known, longer_px, LEAST_LINKS, options.seed) {
                Some(found) => found,
                None => return Ok(not_placed(NotPlaced::NoOrientation { points: taking.len() })),
            }
        }
    };
    let errors = PlaceErrors::new(options, georeference.gsd(), matches!(heights, Heights::Model(_)));
    let result = match adjusted(&taking, known, approximate, errors) {
        Ok(result) => result,
        Err(error) => return Ok(not_placed(NotPlaced::Failed { failure: Failure::from(&error) })),
    };
    let (camera, pose) = (result.block.cameras[0], result.block.images[0].pose);
    let over = Over { image: &[], shows: &|_| true, camera, pose, reference, georeference, heights: &heights };
    // The heights are what they were where the image was placed.
    let relief = Relief { factor: height_factor(&result, known), displaced: start.and_then(|start| start.relief.displaced) };
    let mut placement = placement(&over, &found, &parts, &result, (&total_errors(&result, known, errors), errors), relief);
    placement.links.iter_mut().zip(links).for_each(|(link, given)| link.by_hand = given.by_hand);
    let placement = moved(placement, first);
    // What somebody rejected contradicts nothing.
    let standing = placement.links.iter().zip(&parts).filter(|(_, part)| **part != Part::Rejected).map(|(link, _)| *link).collect();
    let verdict = verdict(&Placement { links: standing, ..placement.clone() }, known);
    Ok(judged(PlacedImage { verdict, placement: Some(placement), search: None }, position, reference, options))
}

fn not_placed(not_placed: NotPlaced) -> PlacedImage {
    PlacedImage { verdict: PlacingVerdict::NotPlaced { not_placed }, placement: None, search: None }
}

fn refused<T>(number: usize, place: [f64; 2]) -> Result<T, Error> {
    refuse(Refusal::LinkPlace { place: format!("{place:?}"), link: number + 1 })
}

/// The position in px at which a placed image shows each place X, Y of the ground; `None` where it does not.
pub fn image_positions(placement: &Placement, heights: &Heights, places: &[[f64; 2]]) -> Vec<Option<[f64; 2]>> {
    let seen = Seen::new(&placement.camera, &placement.pose);
    let in_image = |at: [f64; 2]| placement.film.as_ref().map_or(Some(at), |film| film.in_scan(at));
    places.iter().map(|[x, y]| seen.at(&[*x, *y, heights.at([*x, *y])?]).and_then(in_image)).collect()
}

/// The ground X, Y, Z that each position in px of a placed image shows; `None` where there are no heights.
pub fn ground_positions(placement: &Placement, heights: &Heights, positions: &[[f64; 2]]) -> Vec<Option<[f64; 3]>> {
    let footprint = Footprint { camera: &placement.camera, pose: &placement.pose, heights };
    let in_frame = |at: &[f64; 2]| placement.film.as_ref().map_or(*at, |film| film.in_frame(*at));
    let ground = |at: &[f64; 2]| footprint.arrives(in_frame(at)).and_then(|[x, y]| Some([x, y, heights.at([x, y])?]));
    positions.iter().map(ground).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthophoto::into_system::recorded_place;
    use crate::orthophoto::outcome::{PlaceSearch, PlacingWeakness};
    use crate::{Camera, CameraUncertainty, ExifPosition, Georeference, GreyImage, Pose, rotation_from_angles};

    const ORIGIN: [f64; 2] = [500_000.0, 5_400_000.0];

    fn reference() -> Orthophoto {
        let georeference = Georeference::north_up([ORIGIN[0] - 300.0, ORIGIN[1] + 300.0], 1.0);
        Orthophoto::new(GreyImage::from_fn(600, 600, |_, _| 90).unwrap(), georeference, Heights::Level(50.0)).unwrap()
    }

    fn known() -> PlacingCamera {
        PlacingCamera { camera: Camera::without_distortion(800, 600, 700.0), uncertainty: CameraUncertainty::NONE, decentring: None }
    }

    fn pose() -> Pose {
        Pose::new(&rotation_from_angles(0.02, -0.03, 0.4), [ORIGIN[0] + 12.0, ORIGIN[1] - 7.0, 350.0])
    }

    /// Links as the true pose sees them, with errors of some tenths of a px.
    fn links(number: usize) -> Vec<GivenLink> {
        let (camera, pose) = (known().camera, pose());
        let seen = Seen::new(&camera, &pose);
        let places = (0..).map(|k| [ORIGIN[0] - 100.0 + ((k * 67) % 200) as f64, ORIGIN[1] - 80.0 + ((k * 41) % 160) as f64]);
        let error = |k: usize| 0.3 * [1.0, -1.0, 0.5, -0.5][k % 4];
        let linked = places.filter_map(|place| seen.at(&[place[0], place[1], 50.0]).map(|at| (at, place))).take(number).enumerate();
        linked
            .map(|(k, (at, place))| GivenLink { at: [at[0] + error(k), at[1] - error(k / 2)], place, part: GivenUse::Used, by_hand: k < 4 })
            .collect()
    }

    fn placed(links: &[GivenLink]) -> Placement {
        place_by_links(&known(), None, &reference(), None, links, &PlacingOptions::default()).unwrap().placement.unwrap()
    }

    #[test]
    fn given_links_place_an_image_that_no_search_found() {
        let found = placed(&links(12));
        let off = (0..3).map(|k| (found.pose.position[k] - pose().position[k]).abs()).fold(0.0, f64::max);
        assert!(off < 2.0, "{off} m");
        assert_eq!(found.links.len(), 12);
        assert!(found.links[0].by_hand && !found.links[11].by_hand);
        // σ₀ is what residuals are by the standard errors of their links; those that were measured by eye have larger ones.
        let used = found.links.iter().filter(|link| link.role == crate::LinkUse::Used);
        let by_sigma = used.filter_map(|link| Some((link.residual_px?, link.sigma_px?)));
        let squares: f64 = by_sigma.map(|([x, y], sigma)| (x * x + y * y) / (sigma * sigma)).sum();
        assert!((squares / found.degrees_of_freedom as f64 - 1.0).abs() < 0.02, "{squares} of {}", found.degrees_of_freedom);
        let sigma = |link: usize| found.links[link].sigma_px.unwrap();
        assert!(sigma(0) > sigma(11), "{} {}", sigma(0), sigma(11));
        // From there the next adjustment starts, and comes to the same.
        let again =
            place_by_links(&known(), None, &reference(), Some(&found), &links(12), &PlacingOptions::default()).unwrap().placement.unwrap();
        // Weights follow from where an adjustment starts.
        let moved = (0..3).map(|k| (again.pose.position[k] - found.pose.position[k]).abs()).fold(0.0, f64::max);
        assert!(moved < 0.05, "{moved} m");
    }

    #[test]
    fn a_link_that_is_rejected_or_checks_does_not_move_the_image() {
        let all = links(14);
        let fewer = placed(&all[..12]);
        let mut given = all.clone();
        (given[12].part, given[13].part) = (GivenUse::Rejected, GivenUse::Check);
        given[12].at[0] = (given[12].at[0] + 30.0).min(799.0);
        let found = placed(&given);
        assert_eq!(found.pose, fewer.pose);
        let roles: Vec<_> = found.links[12..].iter().map(|link| link.role).collect();
        assert_eq!(roles, [crate::LinkUse::Rejected, crate::LinkUse::Check]);
        assert!(found.links[12].residual_px.unwrap()[0].abs() > 5.0, "its residual is given");
        // One that the image does not see has none, and comes back from JSON as it went.
        given[13].place[0] += 4000.0;
        given[13].part = GivenUse::Rejected;
        let found = placed(&given);
        assert_eq!((found.links[13].residual_px, found.links.len()), (None, 14));
        let again: Placement = serde_json::from_str(&serde_json::to_string(&found).unwrap()).unwrap();
        assert_eq!(again, found);
    }

    #[test]
    fn links_far_from_the_gnss_position_are_doubted_as_a_place_that_was_found_is() {
        let mut reference = reference();
        reference.epsg = Some(32632);
        // 9° east is the central meridian: 500 km; the latitude is that of the pose, to some metres.
        let position =
            |off_deg: f64| ExifPosition { longitude_deg: 9.000_163, latitude_deg: 48.752_2 + off_deg, height_m: None, error_m: None };
        let at = recorded_place(&position(0.0), &reference).unwrap().place;
        let north_m = pose().position[1] - at[1];
        let deg = |m: f64| (north_m + m) / 111_200.0;
        let by = |links: &[GivenLink], position: Option<ExifPosition>, options: &PlacingOptions| {
            place_by_links(&known(), position.map(RecordedPosition::from).as_ref(), &reference, None, links, options).unwrap()
        };
        let (all, options) = (links(60), PlacingOptions::default());
        for (off_m, is_doubted) in [(0.0, false), (27.0, false), (33.0, true), (-400.0, true)] {
            let placed = by(&all, Some(position(deg(off_m))), &options);
            match placed.verdict {
                PlacingVerdict::Placed { .. } => assert!(!is_doubted, "{off_m} m"),
                PlacingVerdict::Weak { placing_weakness: PlacingWeakness::Gnss { plan_m, .. }, .. } => {
                    assert!(is_doubted && (plan_m - f64::abs(off_m)).abs() < 2.0, "{off_m} m: {plan_m} m");
                }
                other => panic!("{other}"),
            }
        }
        // Another doubt stays, with the distance beside it; and a rough place goes before the position.
        let few = by(&all[..12], Some(position(deg(-400.0))), &options);
        assert!(matches!(few.verdict, PlacingVerdict::Weak { placing_weakness: PlacingWeakness::FewLinks { .. }, .. }), "{}", few.verdict);
        assert!(matches!(few.search, Some(PlaceSearch::ApartFromGnss { .. })), "{:?}", few.search);
        let near = PlacingOptions { near_x: Some(ORIGIN[0]), near_y: Some(ORIGIN[1]), ..options.clone() };
        for placed in [by(&all, Some(position(deg(-400.0))), &near), by(&all, None, &options)] {
            assert!(matches!(placed.verdict, PlacingVerdict::Placed { .. }) && placed.search.is_none(), "{}", placed.verdict);
        }
    }

    #[test]
    fn heights_that_are_off_as_a_whole_are_doubted_beside_a_precise_gnss_position() {
        let placed_by = |level: f64, height_error_m: Option<f64>, links: &[GivenLink], heights_geoid_m: Option<f64>| {
            let mut reference = reference();
            (reference.heights, reference.epsg) = (Heights::Level(level), Some(32632));
            let height_m = Some(pose().position[2]);
            let position = ExifPosition { longitude_deg: 9.000_163, latitude_deg: 48.752_95, height_m, error_m: None };
            let position = RecordedPosition { height_error_m, ..position.into() };
            let options = PlacingOptions { height_sigma_m: Some(0.5), heights_geoid_m, ..PlacingOptions::default() };
            place_by_links(&known(), Some(&position), &reference, None, links, &options).unwrap()
        };
        let by = |level: f64, height_error_m: Option<f64>, links: &[GivenLink]| placed_by(level, height_error_m, links, None);
        let all = links(60);
        let above_geoid = |level: f64, geoid_m: Option<f64>| placed_by(level, Some(0.03), &all, geoid_m);
        for (level, height_error_m, off_m) in [(55.0, Some(0.03), Some(5.0)), (45.0, Some(0.03), Some(-5.0)), (50.0, Some(0.03), None)] {
            match (by(level, height_error_m, &all).verdict, off_m) {
                (PlacingVerdict::Placed { .. }, None) => {}
                (PlacingVerdict::Weak { placing_weakness: PlacingWeakness::GnssHeight { height_m, usual_m }, .. }, Some(off_m)) => {
                    assert!((height_m - off_m).abs() < 0.5 && (0.5..4.0).contains(&usual_m), "{height_m} m, {usual_m} m");
                }
                (other, _) => panic!("{level} m: {other}"),
            }
        }
        // Of a receiver that states nothing, or states as much, the height says nothing; nor where nobody gave heights: they count from the ground.
        for (level, height_error_m) in [(55.0, None), (55.0, Some(3.0)), (0.0, Some(0.03))] {
            let placed = by(level, height_error_m, &all);
            assert!(matches!(placed.verdict, PlacingVerdict::Placed { .. }), "{level} m: {}", placed.verdict);
        }
        // Heights above sea level lie below those of the position by the geoid, where it is given.
        for (level, is_right) in [(50.0 - 47.0, true), (50.0, false)] {
            let placed = above_geoid(level, Some(47.0));
            assert_eq!(matches!(placed.verdict, PlacingVerdict::Placed { .. }), is_right, "{level} m: {}", placed.verdict);
        }
        let PlacingVerdict::Weak { placing_weakness, .. } = above_geoid(50.0 - 47.0, None).verdict else {
            panic!("the geoid is not known")
        };
        assert!(placing_weakness.to_string().contains("--heights-geoid-m"), "{placing_weakness}");
        // Another doubt stays, with the height beside it.
        let few = by(55.0, Some(0.03), &all[..12]);
        assert!(matches!(few.verdict, PlacingVerdict::Weak { placing_weakness: PlacingWeakness::FewLinks { .. }, .. }), "{}", few.verdict);
        assert!(matches!(few.search, Some(PlaceSearch::HeightApartFromGnss { .. })), "{:?}", few.search);
    }

    #[test]
    fn places_and_positions_lead_to_each_other() {
        let (found, heights) = (placed(&links(12)), Heights::Level(50.0));
        let at = [[200.0, 150.0], [640.0, 420.0]];
        let ground: Vec<[f64; 3]> = ground_positions(&found, &heights, &at).into_iter().flatten().collect();
        let back = image_positions(&found, &heights, &ground.iter().map(|g| [g[0], g[1]]).collect::<Vec<_>>());
        for (at, back) in at.iter().zip(back) {
            assert!((0..2).all(|k| (at[k] - back.unwrap()[k]).abs() < 1e-3), "{at:?} {back:?}");
        }
        assert_eq!(image_positions(&found, &heights, &[[ORIGIN[0] + 5000.0, ORIGIN[1]]]), [None]);
    }

    #[test]
    fn links_that_cannot_be_are_refused_by_their_number() {
        let place =
            |links: &[GivenLink]| place_by_links(&known(), None, &reference(), None, links, &PlacingOptions::default()).unwrap_err();
        assert!(matches!(place(&links(3)), Error::TooFew { got: 3, needed: 4, .. }));
        let mut beside = links(6);
        beside[4].at = [900.0, 10.0];
        assert!(place(&beside).to_string().contains("link 5"));
        let mut nowhere = links(6);
        nowhere[2].place[0] = f64::NAN;
        assert!(place(&nowhere).to_string().contains("link 3"));
    }
}
