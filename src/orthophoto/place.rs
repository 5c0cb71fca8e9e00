//! The place of an image on an orthophoto, from nothing but both pictures: a first place, an orientation, links, the adjustment, a verdict.

use super::adjusting::{PlaceErrors, PlacingCamera, adjusted};
use super::first_place::first_place;
use super::heights::Heights;
use super::into_system::{RecordedPlace, recorded_place};
use super::links::{Found, Over, Search, halvings};
use super::options::PlacingOptions;
use super::outcome::{Link, LinkChecks, LinkUse, NotPlaced, PlaceSearch, PlacedImage, Placement, PlacingVerdict};
use super::precision::{TotalErrors, total_errors};
use super::rectify::Seen;
use super::reference::{Orthophoto, enlarge};
use super::verdict::verdict;
use crate::error::refuse;
use crate::reconstruction::resect_image;
use crate::two_view::Support;
use crate::{
    AdjustmentResult, Camera, CameraUncertainty, Error, ExifPosition, Failure, Feature, FeatureOptions, GreyView, ImageOperation, Location,
    MultiscaleOptions, ObservationVerdict, Pose, Refusal, features, reduce_to,
};

/// Longest side of the pictures in which a first place is sought, in px.
const SEARCHED_PX: usize = 4000;
/// Sides of an image, at least.
const LEAST_IMAGE_PX: usize = 32;
/// Sides of the part of the orthophoto that is searched, at least.
const LEAST_SEARCHED_PX: f64 = 64.0;
/// The orthophoto has so many times the points of an image.
const POINTS_OF_GROUND: usize = 4;
/// Where the image is easily found some of its points are enough, at least so many; the time goes with their number.
const ENOUGH_POINTS: usize = 1500;
/// Points agree on a first orientation within this share of the longer side of the image.
const FIRST_SHARE: f64 = 0.03;
/// Points that agree on it, at least.
const LEAST_POINTS: usize = 6;
/// Focal lengths in units of the assumed one that are tried where the camera is unknown.
const FOCAL_FACTORS: [f64; 5] = [1.0, 0.7, 1.4, 0.5, 2.0];
/// Coarse links, then fine ones.
const COARSE: Search = Search { radius_px: 25.0, longest_px: 1200.0, refines: false };
const FINE: Search = Search { radius_px: 4.0, longest_px: 4000.0, refines: true };
/// Coarse links within this of where the adjusted orientation has them agree with it, in px of the resampled image.
const AGREEING_PX: f64 = 4.0;
/// Natural logarithm of how often chance would agree as well, at most.
const MOST_FALSE_ALARMS: f64 = -30.0;
/// Links with which an image can be adjusted.
const LEAST_LINKS: usize = 10;
/// Residuals of check links beyond so many standard errors are gross errors.
const GROSS: f64 = 3.29;

/// The features of an orthophoto among which images are sought: of all of it, or of what lies near a place.
#[derive(Debug, Clone)]
pub struct SearchArea {
    features: Vec<Feature>,
    area_px2: f64,
    /// Whether a smaller part of the orthophoto would have more of them: from a finer picture, or as many on less ground.
    is_sparse: bool,
}

impl SearchArea {
    /// Finds them; they serve all images that are placed with the same options.
    ///
    /// # Errors
    /// [`Error::InvalidOption`]; [`Error::InvalidInput`] for a place beside the orthophoto, or without one of its coordinates.
    pub fn new(reference: &Orthophoto, options: &PlacingOptions) -> Result<Self, Error> {
        options.check_ranges()?;
        let size = reference.size();
        if reference.heights_share() == 0.0 {
            return refuse(Refusal::NoHeightsThere);
        }
        let (first, size) = match (options.near_x, options.near_y) {
            (None, None) => ([0, 0], size),
            (Some(x), Some(y)) => near(reference, [x, y], options.within_m)?,
            _ => return refuse(Refusal::OneCoordinate),
        };
        let mut down = 0;
        while size[0].max(size[1]) >> down > SEARCHED_PX {
            down += 1;
        }
        let most = POINTS_OF_GROUND * options.points;
        let features = reference.features(first, size, down, &of_number(most))?;
        let is_sparse = down > 0 || features.len() >= most;
        Ok(Self { features, area_px2: size[0] as f64 * size[1] as f64, is_sparse })
    }

    /// Those within a distance of a place, both in the unit of the orthophoto; absent where they are all.
    fn within(&self, reference: &Orthophoto, place: [f64; 2], within: f64) -> Option<Self> {
        let reach = within / reference.georeference.gsd();
        let at = reference.georeference.pixel(place);
        let is_near = |feature: &&Feature| (feature.point.x - at[0]).abs() <= reach && (feature.point.y - at[1]).abs() <= reach;
        let features: Vec<Feature> = self.features.iter().filter(is_near).cloned().collect();
        let size = reference.size().map(|side| side as f64);
        let side = |k: usize| ((at[k] + reach).min(size[k]) - (at[k] - reach).max(0.0)).max(0.0);
        let area_px2 = (side(0) * side(1)).min(self.area_px2);
        (features.len() < self.features.len()).then_some(Self { features, area_px2, is_sparse: self.is_sparse })
    }

    /// How many there are.
    pub fn points(&self) -> usize {
        self.features.len()
    }
}

/// The part of an orthophoto within a distance of a place.
fn near(reference: &Orthophoto, place: [f64; 2], within: f64) -> Result<([usize; 2], [usize; 2]), Error> {
    let at = reference.georeference.pixel(place);
    let reach = within / reference.georeference.gsd();
    let size = reference.size().map(|side| side as f64);
    let low = [0, 1].map(|k| (at[k] - reach).max(0.0));
    let high = [0, 1].map(|k| (at[k] + reach).min(size[k]));
    if !(0..2).all(|k| high[k] > low[k]) {
        let corners = [[0.0, 0.0], size].map(|corner| reference.georeference.ground(corner));
        let [first, last] = corners.map(|corner| format!("{corner:?}"));
        return refuse(Refusal::NearPlace { place: format!("{place:?}"), within_m: within, first, last });
    }
    if !(0..2).all(|k| high[k] - low[k] >= LEAST_SEARCHED_PX) {
        return refuse(Refusal::NearRadius { within_m: within, least_px: LEAST_SEARCHED_PX });
    }
    Ok((low.map(|v| v as usize), [0, 1].map(|k| (high[k] - low[k]) as usize)))
}

fn of_number(number: usize) -> FeatureOptions {
    FeatureOptions { multiscale: MultiscaleOptions { number, ..MultiscaleOptions::default() }, ..FeatureOptions::default() }
}

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
    check(image, known, options)?;
    placed(image, known, reference, area, options).map(|placed| judged(placed, known))
}

/// Places an image that records a GNSS position: about that first, within `within_m`, where the orthophoto says its system and no other place is
/// given by the options, then anywhere. The result says which.
///
/// # Errors
/// As [`place_image`].
pub fn place_recorded(
    image: GreyView<'_>,
    known: &PlacingCamera,
    position: Option<&ExifPosition>,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    let is_free = options.near_x.is_none() && options.near_y.is_none();
    let Some(on_map) = position.filter(|_| is_free).and_then(|position| recorded_place(position, reference)) else {
        return place_image(image, known, reference, area, options);
    };
    let RecordedPlace { place, unit_m } = on_map;
    let within_m = options.within_m;
    let within = within_m / unit_m;
    let about = PlacingOptions { near_x: Some(place[0]), near_y: Some(place[1]), within_m: within, ..options.clone() };
    let areas = Areas {
        all: area,
        near: area.within(reference, place, within),
        // A position beside the orthophoto has no surroundings on it.
        dense: || area.is_sparse.then(|| SearchArea::new(reference, &about).ok()).flatten(),
    };
    areas.searched(within_m, |area| place_image(image, known, reference, area, options))
}

/// Where an image that records its position is sought.
struct Areas<'a, D: FnOnce() -> Option<SearchArea>> {
    all: &'a SearchArea,
    /// The surroundings of the position; absent where they are all.
    near: Option<SearchArea>,
    /// The same with more features, where there may be more.
    dense: D,
}

impl<D: FnOnce() -> Option<SearchArea>> Areas<'_, D> {
    /// One after the other until the image is found, each once.
    fn searched(self, within_m: f64, mut search: impl FnMut(&SearchArea) -> Result<PlacedImage, Error>) -> Result<PlacedImage, Error> {
        let Self { all, near, dense } = self;
        let found = |placed: &PlacedImage| placed.placement.is_some();
        let of = |placed: PlacedImage, search: PlaceSearch| Ok(PlacedImage { search: Some(search), ..placed });
        // Where the surroundings are all, the search of them is that of all.
        let mut of_all = None;
        if near.as_ref().is_none_or(|near| !near.features.is_empty()) {
            let placed = search(near.as_ref().unwrap_or(all))?;
            if found(&placed) {
                return of(placed, PlaceSearch::Gnss { within_m });
            }
            of_all = near.is_none().then_some(placed);
        }
        if let Some(dense) = dense() {
            let placed = search(&dense)?;
            if found(&placed) {
                return of(placed, PlaceSearch::Gnss { within_m });
            }
        }
        let placed = of_all.map_or_else(|| search(all), Ok)?;
        of(placed, PlaceSearch::BeyondGnss { within_m })
    }
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
    confirmed(image, known, reference, first, (known.camera, start), options).map(|placed| judged(placed, known))
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
    image: GreyView<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<Result<Placement, NotPlaced>, Error> {
    let reduced = reduce_to(image, SEARCHED_PX);
    let mut own = features(reduced.image.view(), None, &of_number(options.points))?;
    let factor = f64::from(1_u32 << reduced.halvings);
    own.iter_mut().for_each(|feature| enlarge(&mut feature.point, factor));
    let every = own.len() / ENOUGH_POINTS;
    if every > 1 {
        let some: Vec<Feature> = own.iter().step_by(every).cloned().collect();
        let found = placed_by(&some, image, known, reference, area, options)?;
        if found.as_ref().is_ok_and(|placement| matches!(verdict(placement, known), PlacingVerdict::Placed { .. })) {
            return Ok(found);
        }
    }
    placed_by(&own, image, known, reference, area, options)
}

/// By these features of the image.
fn placed_by(
    own: &[Feature],
    image: GreyView<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<Result<Placement, NotPlaced>, Error> {
    let longer_px = image.width().max(image.height()) as f64;
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

/// What comes of an approximate camera and orientation, in a system about a place of the ground: links, coarse and fine, and the adjustment
/// by them.
fn confirmed(
    image: GreyView<'_>,
    known: &PlacingCamera,
    reference: &Orthophoto,
    first: [f64; 2],
    (camera, pose): (Camera, Pose),
    options: &PlacingOptions,
) -> Result<Result<Placement, NotPlaced>, Error> {
    let (georeference, heights) = reference.about(first);
    let levels = halvings(&image.to_image());
    let mut over = Over { image: &levels, camera, pose, reference, georeference, heights: &heights };
    let has_model = matches!(heights, Heights::Model(_));
    let errors = PlaceErrors::new(options, georeference.gsd(), has_model);
    let features = of_number(options.points);
    if let Err(refused) = coarse(&mut over, known, errors, &features)? {
        return Ok(Err(refused));
    }
    fine(&mut over, known, errors, &features, options).map(|fine| fine.map(|placement| moved(placement, first)))
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

/// Links over a coarse picture orient the image better, and say whether it is there at all.
fn coarse(
    over: &mut Over<'_>,
    known: &PlacingCamera,
    errors: PlaceErrors,
    features: &FeatureOptions,
) -> Result<Result<(), NotPlaced>, Error> {
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
    Ok(Ok(()))
}

/// Links over the finest picture that both have, the adjustment by most of them and what the others say of it.
fn fine(
    over: &mut Over<'_>,
    known: &PlacingCamera,
    errors: PlaceErrors,
    features: &FeatureOptions,
    options: &PlacingOptions,
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
    let mut placement = placement(over, &links, &parts, &result, &total_errors(&result, known));
    placement.links.retain(|link| link.residual_px.is_some());
    Ok(Ok(placement))
}

/// How a link takes part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Used,
    Check,
    Rejected,
}

/// Which of so many links check: evenly among them.
pub(super) fn checks(links: usize, share: f64) -> Vec<Part> {
    let is_check = |k: usize| ((k + 1) as f64 * share).floor() > (k as f64 * share).floor();
    (0..links).map(|k| if is_check(k) { Part::Check } else { Part::Used }).collect()
}

/// What comes of an adjustment, whose rays are the links that take part in their order.
pub(super) fn placement(over: &Over<'_>, links: &[Found], parts: &[Part], result: &AdjustmentResult, errors: &TotalErrors) -> Placement {
    let (camera, pose) = (over.camera, over.pose);
    let seen = Seen::new(&camera, &pose);
    let mut rays = result.rays.iter();
    let linked = links.iter().zip(parts).map(|(link, part)| {
        let residual_px = seen.at(&link.place).map(|at| [link.at[0] - at[0], link.at[1] - at[1]]);
        let role = match part {
            Part::Check => LinkUse::Check,
            Part::Rejected => LinkUse::Rejected,
            Part::Used => match rays.next().map(|ray| ray.verdict) {
                Some(ObservationVerdict::Accepted) => LinkUse::Used,
                _ => LinkUse::Rejected,
            },
        };
        Link { at: link.at, place: link.place, residual_px, role, by_hand: false }
    });
    let links: Vec<Link> = linked.collect();
    let gsd_m = over.footprint().gsd();
    Placement {
        camera,
        camera_errors: errors.camera,
        pose,
        angles_deg: pose.angles().map(f64::to_degrees),
        angle_errors_deg: errors.angles_deg,
        position_errors_m: errors.position,
        above_ground_m: over.footprint().above_ground(),
        gsd_m,
        footprint: over.footprint().border(),
        sigma0_px: result.sigma0_px,
        rmse_px: rms(links.iter().filter(|link| link.role == LinkUse::Used)),
        degrees_of_freedom: result.degrees_of_freedom,
        coverage: coverage(&camera, &links),
        checks: check_links(&links, gsd_m),
        links,
    }
}

/// Root mean square length of residuals, where there are any.
fn rms<'a>(links: impl Iterator<Item = &'a Link>) -> f64 {
    let residuals = links.filter_map(|link| link.residual_px);
    let (sum, number) = residuals.fold((0.0, 0_usize), |(sum, n), [x, y]| (sum + x * x + y * y, n + 1));
    if number == 0 { 0.0 } else { (sum / number as f64).sqrt() }
}

/// What the links say that took no part, those as far off as the used ones never are left apart.
fn check_links(links: &[Link], gsd_m: f64) -> Option<LinkChecks> {
    let checks = || links.iter().filter(|link| link.role == LinkUse::Check && link.residual_px.is_some());
    let number = checks().count();
    let limit = GROSS * rms(links.iter().filter(|link| link.role == LinkUse::Used));
    let within = |link: &&Link| link.residual_px.is_some_and(|[x, y]| libm::hypot(x, y) <= limit);
    let rmse_px = rms(checks().filter(within));
    let beyond = number - checks().filter(within).count();
    (number > 0).then_some(LinkChecks { number, beyond, rmse_px, rmse_m: rmse_px * gsd_m })
}

/// Cells of the image in which links are counted, on its longer side.
const CELLS: f64 = 8.0;

/// Share of the cells of the image that hold a used link.
fn coverage(camera: &Camera, links: &[Link]) -> f64 {
    let [width, height] = [camera.width_px, camera.height_px].map(f64::from);
    let side = width.max(height) / CELLS;
    let [columns, rows] = [width, height].map(|length| (length / side).ceil().max(1.0) as usize);
    let mut held = vec![false; columns * rows];
    for link in links.iter().filter(|link| link.role == LinkUse::Used) {
        let [column, row] = link.at.map(|v| (v / side) as usize);
        held[row.min(rows - 1) * columns + column.min(columns - 1)] = true;
    }
    held.iter().filter(|held| **held).count() as f64 / held.len() as f64
}

/// The placement in the system of the orthophoto itself.
pub(super) fn moved(mut placement: Placement, by: [f64; 2]) -> Placement {
    let plan = |place: &mut [f64]| (0..2).for_each(|k| place[k] += by[k]);
    plan(&mut placement.pose.position);
    placement.footprint.iter_mut().for_each(|corner| plan(corner));
    placement.links.iter_mut().for_each(|link| plan(&mut link.place));
    placement
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
        let known = PlacingCamera { camera: scene.truth().cameras[0], uncertainty: CameraUncertainty::NONE };
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
        let picture = super::super::rectify_placed(own.photo(0).unwrap().view(), &placement, &reference).unwrap();
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
    fn what_shows_nothing_in_common_has_no_place() {
        let reference = scene(3).orthophoto(0.8).unwrap();
        let area = SearchArea::new(&reference, &options()).unwrap();
        let blank = GreyImage::from_fn(300, 200, |_, _| 128).unwrap();
        let noise = GreyImage::from_fn(300, 200, |c, r| ((c * 7919 + r * 104_729) % 251) as u8).unwrap();
        let known = PlacingCamera { camera: Camera::without_distortion(300, 200, 300.0), uncertainty: CameraUncertainty::ASSUMED };
        for image in [&blank, &noise] {
            let found = place_image(image.view(), &known, &reference, &area, &options()).unwrap();
            assert!(matches!(found.verdict, PlacingVerdict::NotPlaced { .. }) && found.placement.is_none(), "{}", found.verdict);
        }
        let other = PlacingCamera { camera: Camera::without_distortion(200, 300, 300.0), ..known };
        assert!(place_image(blank.view(), &other, &reference, &area, &options()).unwrap_err().to_string().contains("300 x 200"));
    }

    #[test]
    fn each_part_of_an_orthophoto_is_searched_once_for_an_image() {
        let empty = || SearchArea { features: Vec::new(), area_px2: 1.0, is_sparse: true };
        let all = SearchArea { area_px2: 9.0, ..empty() };
        let dense = || Some(SearchArea { area_px2: 2.0, ..empty() });
        let nowhere = || PlacedImage {
            verdict: PlacingVerdict::NotPlaced { not_placed: NotPlaced::NoOrientation { points: 0 } },
            placement: None,
            search: None,
        };
        let searched = |near: Option<SearchArea>, dense: Option<SearchArea>| {
            let mut areas = Vec::new();
            let search = |area: &SearchArea| {
                areas.push(area.area_px2);
                Ok(nowhere())
            };
            let placed = Areas { all: &all, near, dense: || dense }.searched(50.0, search).unwrap();
            assert_eq!(placed.search, Some(PlaceSearch::BeyondGnss { within_m: 50.0 }));
            areas
        };
        // All are the surroundings; they are a part; nothing is there.
        assert_eq!((searched(None, dense()), searched(None, None)), (vec![9.0, 2.0], vec![9.0]));
        let scene = scene(3).orthophoto(0.8).unwrap();
        let some = SearchArea { area_px2: 3.0, ..SearchArea::new(&scene, &options()).unwrap() };
        assert_eq!((searched(Some(some.clone()), dense()), searched(Some(some), None)), (vec![3.0, 2.0, 9.0], vec![3.0, 9.0]));
        assert_eq!(searched(Some(empty()), dense()), [2.0, 9.0]);
    }

    #[test]
    fn check_links_are_spread_evenly() {
        let number = |links: usize, share: f64| checks(links, share).iter().filter(|part| **part == Part::Check).count();
        assert_eq!((number(10, 0.2), number(7, 0.0), number(8, 0.5)), (2, 0, 4));
    }
}
