//! Whether an image is where a first orientation has it, and its place then: links, coarse and fine, and the adjustment by them.

use super::adjusting::{PlaceErrors, PlacingCamera, adjusted};
use super::heights::Heights;
use super::links::{Found, Over, Search, halvings};
use super::options::PlacingOptions;
use super::outcome::{NotPlaced, Placement};
use super::photograph::Photograph;
use super::placement::{Part, moved, placement};
use super::precision::total_errors;
use super::rectify::Seen;
use super::reference::Orthophoto;
use super::relief::{Relief, displaced, height_factor};
use super::search_area::of_number;
use crate::two_view::Support;
use crate::{Camera, Error, Failure, FeatureOptions, Pose};

/// Coarse links, then fine ones.
const COARSE: Search = Search { radius_px: 25.0, longest_px: 1200.0, refines: false };
const FINE: Search = Search { radius_px: 4.0, longest_px: 4000.0, refines: true };
/// Coarse links within this of where the adjusted orientation has them agree with it, in px of the resampled image.
const AGREEING_PX: f64 = 4.0;
/// Natural logarithm of how often chance would agree as well, at most.
const MOST_FALSE_ALARMS: f64 = -30.0;
/// Links with which an image can be adjusted.
const LEAST_LINKS: usize = 10;

/// What comes of an approximate camera and orientation, in a system about a place of the ground: links, coarse and fine, and the adjustment
/// by them.
pub(super) fn confirmed(
    image: Photograph<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    first: [f64; 2],
    (camera, pose): (Camera, Pose),
    options: &PlacingOptions,
) -> Result<Result<Placement, NotPlaced>, Error> {
    let (georeference, heights) = reference.about(first);
    let levels = halvings(&image.grey.to_image());
    let mut over = Over { image: &levels, shows: image.shows, camera, pose, reference, georeference, heights: &heights };
    let has_model = matches!(heights, Heights::Model(_));
    let errors = PlaceErrors::new(options, georeference.gsd(), has_model);
    let features = of_number(options.points);
    let everywhere = match coarse(&mut over, known, errors, &features)? {
        Ok(links) => links,
        Err(refused) => return Ok(Err(refused)),
    };
    fine(&mut over, known, errors, &features, options, &everywhere).map(|fine| fine.map(|placement| moved(placement, first)))
}

/// Links over a coarse picture, wherever they are found: they orient the image better, and say whether it is there at all.
fn coarse(
    over: &mut Over<'_>,
    known: &PlacingCamera,
    errors: PlaceErrors,
    features: &FeatureOptions,
) -> Result<Result<Vec<Found>, NotPlaced>, Error> {
    let links = over.links(&COARSE, features)?;
    let refused = |agreeing: usize| Ok(Err(NotPlaced::NotConfirmed { links: links.len(), agreeing }));
    if links.len() < LEAST_LINKS {
        return refused(0);
    }
    // Links that fit nowhere leave nothing to adjust.
    let Ok(result) = adjusted(&links, known, (over.camera, over.pose), errors) else { return refused(0) };
    let seen = Seen::new(&result.block.cameras[0], &result.block.images[0].pose);
    // In px of the picture in which they were sought: 'agreeing' there is a share of the radius.
    let [width, height] = [over.camera.width_px, over.camera.height_px].map(f64::from);
    let unit = (width.max(height) / COARSE.longest_px).max(1.0);
    let off = |link: &Found| seen.at(&link.place).map_or(f64::INFINITY, |at| libm::hypot(at[0] - link.at[0], at[1] - link.at[1]));
    let agreeing = links.iter().filter(|link| off(link) <= AGREEING_PX * unit).count();
    let chance = AGREEING_PX / COARSE.radius_px * (AGREEING_PX / COARSE.radius_px);
    let support = Support { count: links.len(), agreeing, sample: 3, models: 4, chance };
    if agreeing < LEAST_LINKS || !(support.log_false_alarms() < MOST_FALSE_ALARMS) {
        return refused(agreeing);
    }
    (over.camera, over.pose) = (result.block.cameras[0], result.block.images[0].pose);
    Ok(Ok(links))
}

/// Links over the finest picture that both have, the adjustment by most of them and what the others say of it. `everywhere`: links that were sought
/// farther away.
fn fine(
    over: &mut Over<'_>,
    known: &PlacingCamera,
    errors: PlaceErrors,
    features: &FeatureOptions,
    options: &PlacingOptions,
    everywhere: &[Found],
) -> Result<Result<Placement, NotPlaced>, Error> {
    let links = over.links(&FINE, features)?;
    let parts = checks(links.len(), options.check_share);
    let used: Vec<Found> = links.iter().zip(&parts).filter(|(_, part)| **part == Part::Used).map(|(link, _)| *link).collect();
    if used.len() < LEAST_LINKS {
        return Ok(Err(NotPlaced::NotConfirmed { links: links.len(), agreeing: used.len() }));
    }
    let result = match adjusted(&used, known, (over.camera, over.pose), errors) {
        Ok(result) => result,
        Err(error) => return Ok(Err(NotPlaced::Failed { failure: Failure::from(&error) })),
    };
    (over.camera, over.pose) = (result.block.cameras[0], result.block.images[0].pose);
    let relief = Relief { factor: height_factor(&result, known), displaced: displaced(everywhere, &over.camera, &over.pose) };
    let mut placement = placement(over, &links, &parts, &result, (&total_errors(&result, known, errors), errors), relief);
    placement.links.retain(|link| link.residual_px.is_some());
    Ok(Ok(placement))
}

/// Which of so many links check: evenly among them.
pub(super) fn checks(links: usize, share: f64) -> Vec<Part> {
    let is_check = |k: usize| ((k + 1) as f64 * share).floor() > (k as f64 * share).floor();
    (0..links).map(|k| if is_check(k) { Part::Check } else { Part::Used }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn check_links_are_spread_evenly() {
        let number = |links: usize, share: f64| checks(links, share).iter().filter(|part| **part == Part::Check).count();
        assert_eq!((number(10, 0.2), number(7, 0.0), number(8, 0.5)), (2, 0, 4));
    }
}
