//! The place of an image on an orthophoto, from nothing but both pictures: a first place, an orientation, links, the adjustment, a verdict.

use super::adjusting::PlacingCamera;
use super::confirming::confirmed;
use super::first_place::first_place;
use super::heights::Heights;
use super::options::PlacingOptions;
use super::outcome::{NotPlaced, PlacedImage, Placement, PlacingVerdict};
use super::photograph::Photograph;
use super::reference::{Orthophoto, enlarge};
use super::search_area::{SEARCHED_PX, SearchArea, of_number};
use super::verdict::verdict;
use crate::error::refuse;
use crate::reconstruction::resect_image;
use crate::{Camera, CameraUncertainty, Error, Feature, GreyView, ImageOperation, Location, Pose, Refusal, features, reduce_to};

/// Sides of an image, at least.
const LEAST_IMAGE_PX: usize = 32;
/// Where the image is easily found some of its points are enough, at least so many; the time goes with their number.
const ENOUGH_POINTS: usize = 1500;
/// Points agree on a first orientation within this share of the longer side of the image.
const FIRST_SHARE: f64 = 0.03;
/// Points that agree on it, at least.
const LEAST_POINTS: usize = 6;
/// Focal lengths in units of the assumed one that are tried where the camera is unknown.
const FOCAL_FACTORS: [f64; 5] = [1.0, 0.7, 1.4, 0.5, 2.0];

/// Places an image on an orthophoto: its orientation in the system of the orthophoto, with standard errors and a verdict.
///
/// Lengths are those of the map, heights in the same unit.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for a camera of another size than the image. That an image has no place is no error: the
/// verdict says so.
///
/// # Source
/// Resection by collinearity: Kraus 2007, Photogrammetry, 4.2.1; the places come from gradient descriptors, then least squares matching
/// between the orthophoto and the image resampled to the ground.
pub fn place_image(
    image: GreyView<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    place_photograph(image.into(), known, reference, area, options)
}

/// As [`place_image`], where not all of the image may be a photograph.
pub(super) fn place_photograph(
    image: Photograph<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    check(image.grey, known, options)?;
    placed(image, known, reference, area, options).map(|placed| judged(placed, known))
}

/// Places an image near where another source has it: within some px of the picture, each pixel as large as of those 1200 on its longer side.
///
/// # Errors
/// As [`place_image`].
pub(super) fn place_near(
    image: GreyView<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    pose: &Pose,
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    check(image, known, options)?;
    let first = [0, 1].map(|k| pose.position[k].round());
    let [x, y, z] = pose.position;
    let start = Pose { position: [x - first[0], y - first[1], z], ..*pose };
    confirmed(image.into(), known, reference, first, (known.camera, start), options).map(|placed| judged(placed, known))
}

fn check(image: GreyView<'_>, known: &PlacingCamera, options: &PlacingOptions) -> Result<(), Error> {
    options.check_ranges()?;
    if image.width().min(image.height()) < LEAST_IMAGE_PX {
        let [width, height] = [image.width(), image.height()];
        return Err(Error::ImageTooSmall { width, height, image_operation: ImageOperation::PlacingOnOrthophoto, min_side: LEAST_IMAGE_PX });
    }
    known.camera.check(|| Location::CameraOfImage)?;
    let size = [known.camera.width_px, known.camera.height_px].map(|side| side as usize);
    if size != [image.width(), image.height()] {
        let ([width_px, height_px], [width, height]) = (size, [image.width(), image.height()]);
        return refuse(Refusal::CameraSize { width_px, height_px, width, height });
    }
    Ok(())
}

fn judged(placed: Result<Placement, NotPlaced>, known: &PlacingCamera) -> PlacedImage {
    match placed {
        Ok(placement) => PlacedImage { verdict: verdict(&placement, known), placement: Some(placement), search: None },
        Err(not_placed) => PlacedImage { verdict: PlacingVerdict::NotPlaced { not_placed }, placement: None, search: None },
    }
}

fn placed(
    image: Photograph<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<Result<Placement, NotPlaced>, Error> {
    let reduced = reduce_to(image.grey, SEARCHED_PX);
    let mut own = features(reduced.image.view(), None, &of_number(options.points))?;
    let factor = f64::from(1_u32 << reduced.halvings);
    own.iter_mut().for_each(|feature| enlarge(&mut feature.point, factor));
    own.retain(|feature| (image.shows)([feature.point.x, feature.point.y]));
    let every = own.len() / ENOUGH_POINTS;
    if every > 1 {
        let some: Vec<Feature> = own.iter().step_by(every).cloned().collect();
        let found = placed_by(&some, image, known, reference, area, options)?;
        if found.as_ref().is_ok_and(|placement| is_final(&verdict(placement, known), &reference.heights)) {
            return Ok(found);
        }
        // What some have found is not lost where all find nothing.
        return Ok(placed_by(&own, image, known, reference, area, options)?.or(found));
    }
    placed_by(&own, image, known, reference, area, options)
}

/// Whether more features of an image would not place it better: it is placed, or wide intervals are those of a level that stands for its ground.
fn is_final(verdict: &PlacingVerdict, heights: &Heights) -> bool {
    matches!(verdict, PlacingVerdict::Placed { .. }) || (matches!(heights, Heights::Level(_)) && verdict.is_wide())
}

/// By these features of the image.
fn placed_by(
    own: &[Feature],
    image: Photograph<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<Result<Placement, NotPlaced>, Error> {
    let longer_px = image.grey.width().max(image.grey.height()) as f64;
    let matches = match first_place(own, &area.features, longer_px, area.area_px2) {
        Ok(matches) => matches,
        Err(refused) => return Ok(Err(refused)),
    };
    // Coordinates of maps are large: everything is computed about a place in the middle of the matches.
    let on_ground = |m: &crate::DescriptorMatch| {
        let point = &area.features[m.right].point;
        reference.georeference.ground([point.x, point.y])
    };
    let first = on_ground(&matches[matches.len() / 2]).map(f64::round);
    let (_, heights) = reference.about(first);
    let seen: Vec<([f64; 2], [f64; 3])> = (matches.iter())
        .filter_map(|m| {
            let [x, y] = on_ground(m);
            let place = [x - first[0], y - first[1]];
            Some(([own[m.left].point.x, own[m.left].point.y], [place[0], place[1], heights.at(place)?]))
        })
        .collect();
    match first_orientation(&seen, known, longer_px, LEAST_POINTS, options.seed) {
        Some(start) => confirmed(image, known, reference, first, start, options),
        None => Ok(Err(NotPlaced::NoOrientation { points: seen.len() })),
    }
}

/// The camera and orientation on which most points agree; of an unknown camera by one of several focal lengths.
pub(super) fn first_orientation(
    seen: &[([f64; 2], [f64; 3])],
    known: &PlacingCamera,
    longer_px: f64,
    least: usize,
    seed: u32,
) -> Option<(Camera, Pose)> {
    let is_unknown = known.uncertainty.focal >= CameraUncertainty::ASSUMED.focal;
    let factors = if is_unknown { &FOCAL_FACTORS[..] } else { &FOCAL_FACTORS[..1] };
    let tried = factors.iter().filter_map(|factor| {
        let camera = Camera { focal_px: factor * known.camera.focal_px, ..known.camera };
        let (pose, agreeing) = resect_image(&camera, seen, FIRST_SHARE * longer_px, least, seed).ok()?;
        Some((agreeing, camera, pose))
    });
    // Of equals the first, which is the most usual.
    tried
        .fold(None, |best: Option<(usize, Camera, Pose)>, next| if best.is_none_or(|(most, ..)| next.0 > most) { Some(next) } else { best })
        .map(|(_, camera, pose)| (camera, pose))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockFlight, BlockScene, GreyImage};

    fn scene(seed: u32) -> BlockScene {
        let flight = BlockFlight {
            strips: 1,
            exposures: 1,
            width_px: 480,
            height_px: 360,
            pixel_mm: 0.075,
            relief_m: 40.0,
            seed,
            ..BlockFlight::default()
        };
        BlockScene::new(&flight).unwrap()
    }

    fn options() -> PlacingOptions {
        PlacingOptions { points: 3000, ..PlacingOptions::default() }
    }

    fn placed(scene: &BlockScene, reference: &Orthophoto, options: &PlacingOptions) -> Result<PlacedImage, Error> {
        let known = PlacingCamera { camera: scene.truth().cameras[0], uncertainty: CameraUncertainty::NONE, decentring: None };
        place_image(scene.photo(0)?.view(), &known, reference, &SearchArea::new(reference, options)?, options)
    }

    #[test]
    fn a_photo_is_placed_where_it_was_taken_and_a_stranger_is_not() {
        let (own, other) = (scene(3), scene(4));
        let orthophoto = own.orthophoto(0.8).unwrap();
        // Far from the origin, as maps are.
        let (georeference, heights) = orthophoto.about([-3.5e5, -5.8e6]);
        let reference = Orthophoto::new(orthophoto.grey().unwrap(), georeference, heights).unwrap();
        let found = placed(&own, &reference, &options()).unwrap();
        assert!(matches!(found.verdict, PlacingVerdict::Placed { .. }), "{}", found.verdict);
        let (placement, truth) = (found.placement.unwrap(), own.truth().images[0].pose.unwrap());
        let errors = placement.position_errors_m.unwrap();
        for (k, shift) in [3.5e5, 5.8e6, 0.0].into_iter().enumerate() {
            let off = placement.pose.position[k] - shift - truth.position[k];
            assert!(off.abs() < 4.0 * errors[k] && off.abs() < 1.0, "{off} ± {} along axis {k}", errors[k]);
        }
        assert!(placement.checks.is_some_and(|checks| checks.rmse_px < 0.5 && checks.number > 50), "{:?}", placement.checks);
        let picture = super::super::rectify_placed(&own.photo(0).unwrap().into(), &placement, &reference).unwrap();
        assert!(picture.mask.data().iter().filter(|v| **v == 255).count() > 100_000);

        let stranger = placed(&other, &reference, &options()).unwrap();
        assert!(matches!(stranger.verdict, PlacingVerdict::NotPlaced { .. }), "{}", stranger.verdict);
        let near = PlacingOptions { near_x: Some(3.5e5), near_y: Some(5.8e6), within_m: 400.0, ..options() };
        assert!(matches!(placed(&own, &reference, &near).unwrap().verdict, PlacingVerdict::Placed { .. }));
        let beside = PlacingOptions { near_x: Some(0.0), near_y: Some(0.0), ..options() };
        assert!(placed(&own, &reference, &beside).unwrap_err().to_string().contains("place near an image"));
        assert!(placed(&own, &reference, &PlacingOptions { near_y: None, ..near }).is_err());
    }

    #[test]
    fn links_beside_houses_do_not_make_an_image_larger() {
        let own = scene(5);
        let reference = own.orthophoto(0.8).unwrap();
        let placement = placed(&own, &reference, &options()).unwrap().placement.unwrap();
        let (camera, truth) = (own.truth().cameras[0], own.truth().images[0].pose.unwrap());
        let seen = crate::orthophoto::Seen::new(&camera, &truth);
        // Of errors of links, what grows with the distance from the principal point.
        let (mut product, mut square) = (0.0, 0.0);
        for link in placement.links.iter().filter(|link| link.role != crate::LinkUse::Rejected) {
            let Some(at) = seen.at(&link.place) else { continue };
            let from_middle = [0, 1].map(|k| at[k] - camera.principal_point_px[k]);
            product += (link.at[0] - at[0]) * from_middle[0] + (link.at[1] - at[1]) * from_middle[1];
            square += from_middle[0] * from_middle[0] + from_middle[1] * from_middle[1];
        }
        let larger = product / square;
        assert!(placement.links.len() > 300 && larger.abs() < 1e-4, "{larger} by {} links", placement.links.len());
        let [.., z] = placement.position_errors_m.unwrap();
        let off = placement.pose.position[2] - truth.position[2];
        assert!(off.abs() < 2.0 * z, "{off} ± {z} m");
    }

    #[test]
    fn what_shows_nothing_in_common_has_no_place() {
        let reference = scene(3).orthophoto(0.8).unwrap();
        let area = SearchArea::new(&reference, &options()).unwrap();
        let blank = GreyImage::from_fn(300, 200, |_, _| 128).unwrap();
        let noise = GreyImage::from_fn(300, 200, |c, r| ((c * 7919 + r * 104_729) % 251) as u8).unwrap();
        let known = PlacingCamera {
            camera: Camera::without_distortion(300, 200, 300.0),
            uncertainty: CameraUncertainty::ASSUMED,
            decentring: None,
        };
        for image in [&blank, &noise] {
            let found = place_image(image.view(), &known, &reference, &area, &options()).unwrap();
            assert!(matches!(found.verdict, PlacingVerdict::NotPlaced { .. }) && found.placement.is_none(), "{}", found.verdict);
        }
        let other = PlacingCamera { camera: Camera::without_distortion(200, 300, 300.0), ..known };
        assert!(place_image(blank.view(), &other, &reference, &area, &options()).unwrap_err().to_string().contains("300 x 200"));
    }
}
