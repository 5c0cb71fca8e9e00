//! A block on an orthophoto: its images are placed, places of the ground that several of them show take part in its adjustment.

use super::adjusting::{PlaceErrors, PlacingCamera, variance_px2};
use super::confirming::checks;
use super::heights::Heights;
use super::into_system::IntoSystem;
use super::links::{Found, MEASURED_PX, height_spread};
use super::options::PlacingOptions;
use super::outcome::{LinkUse, PlacedImage, Placement, PlacingVerdict, PlacingWeakness};
use super::place::{place_image, place_near};
use super::placement::Part;
use super::rectify::Seen;
use super::reference::Orthophoto;
use super::search_area::SearchArea;
use super::verdict::contradiction;
use crate::error::refuse;
use crate::math::{dot3, median, minus, scatter};
use crate::pipeline::GroundPoint;
use crate::{BlockRun, ControlRole, Error, ExifPosition, Failure, GreyView, Input, NotLinked, OnOrthophoto, Pose, Refusal, Remark};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// Images that are placed, at least.
const LEAST_IMAGES: usize = 2;
/// The camera of a block is one for all of its images: where chance has it two standard errors off, all of them contradict it. Farther off than so many,
/// something else is wrong, unless the camera is what was known of it before the block: that of a block over flat ground may be off by more than its standard errors say.
const MOST_APART: f64 = 4.0;
/// Neighbouring places share errors, as those of one roof do: each square of so many on the longer side of an image gives one.
const CELLS: f64 = 10.0;
/// Links of several images within so many px, of the orthophoto or of the images, whose are larger, are of one place.
const ONE_PLACE_PX: f64 = 2.0;
/// Standard errors are no smaller than this share of what was stated, and those of coordinates in images within what is allowed of them, in px.
const LEAST_FACTOR: f64 = 0.05;
const LEAST_SIGMA_PX: f64 = 0.02;
const MOST_SIGMA_PX: f64 = 50.0;
/// Beside walls any height may be meant: heights about a place differ by no more than this many standard errors.
const LEVEL: f64 = 2.0;

/// The images of a block while they are placed on an orthophoto, one after the other.
#[derive(Debug, Clone, Default)]
pub struct BlockLinks {
    placed: BTreeMap<usize, PlacedImage>,
    /// Of these the images whose camera is what was known of it before the block, whatever the block makes of it.
    as_known: BTreeSet<usize>,
}

/// A link of an image that takes part.
#[derive(Debug, Clone, Copy)]
struct Seeing {
    image: usize,
    link: Found,
}

impl BlockLinks {
    /// Places an image of an oriented block, with the camera that the block has adjusted: near where those that were placed before have it,
    /// otherwise anywhere. `None` for an image that is not oriented, and where nothing leads from the orthophoto into the coordinate reference system of the
    /// block, as [`linked`](Self::linked) then says. A block with one has placements in m, whatever the unit of the orthophoto is.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an image that does not exist; as [`place_image`].
    pub fn place(
        &mut self,
        run: &BlockRun,
        image: usize,
        grey: GreyView<'_>,
        reference: &Orthophoto,
        area: &SearchArea,
        options: &PlacingOptions,
    ) -> Result<Option<&PlacedImage>, Error> {
        let count = run.model.images.len();
        if image >= count {
            return refuse(Refusal::Index { input: Input::Image, index: image, count });
        }
        let Some(known) = PlacingCamera::of_block(run, image) else { return Ok(None) };
        let reference = match IntoSystem::of(run, reference) {
            Ok(into) => in_metres(into.as_ref(), reference),
            Err(_) => return Ok(None),
        };
        // The block has check points of its own.
        let all = PlacingOptions { check_share: 0.0, ..options.clone() };
        let near = self.expected(run, image).map(|pose| place_near(grey, &known, &reference, &pose, &all)).transpose()?;
        let found = match near.filter(|found| found.placement.is_some()) {
            Some(found) => found,
            None => place_image(grey, &known, &reference, area, &all)?,
        };
        let is_as_known = found.placement.as_ref().zip(PlacingCamera::before_block(run, image)).is_some_and(|(placement, before)| {
            // A guess is no knowledge.
            !before.uncertainty.is_guess() && contradiction(placement, &before).is_none()
        });
        if is_as_known {
            self.as_known.insert(image);
        } else {
            self.as_known.remove(&image);
        }
        self.placed.insert(image, found);
        Ok(self.placed.get(&image))
    }

    /// Images that were placed without doubt of anything but the camera of the block, which is adjusted once more with what they show of the ground, and
    /// the width of intervals, which other images of the block narrow.
    fn sure(&self) -> impl Iterator<Item = (usize, &Placement)> {
        let sure = self.placed.iter().filter(|(image, placed)| is_sure(&placed.verdict, self.as_known.contains(image)));
        sure.filter_map(|(image, placed)| Some((*image, placed.placement.as_ref()?)))
    }

    /// Where an image is by the one of its block that was placed nearest to it, and the distance from there to another.
    fn expected(&self, run: &BlockRun, image: usize) -> Option<Pose> {
        let pose = |image: usize| run.model.images.get(image)?.pose;
        let own = pose(image)?;
        let placed = || self.sure().filter_map(|(other, placement)| Some((pose(other)?, placement.pose)));
        let square = |a: &Pose, b: &Pose| {
            let off = minus(&a.position, &b.position);
            dot3(&off, &off)
        };
        let (near, there) = placed().min_by(|(a, _), (b, _)| square(a, &own).total_cmp(&square(b, &own)))?;
        let (far, far_there) = placed().max_by(|(a, _), (b, _)| square(a, &near).total_cmp(&square(b, &near)))?;
        let scale = (square(&far_there, &there) / square(&far, &near)).sqrt();
        if !(scale.is_finite() && scale > 0.0) {
            return None;
        }
        // Of the map from the block's system: from that into the nearest photo, and back by where it was placed.
        let turn = |row: usize, column: usize| (0..3).map(|k| there.rotation[k][row] * near.rotation[k][column]).sum::<f64>();
        let rotation: [[f64; 3]; 3] = std::array::from_fn(|row| std::array::from_fn(|column| turn(row, column)));
        let off = minus(&own.position, &near.position);
        let position = [0, 1, 2].map(|row| there.position[row] + scale * dot3(&rotation[row], &off));
        let rotation = std::array::from_fn(|row| std::array::from_fn(|column| dot3(&own.rotation[row], &rotation[column])));
        Some(Pose { rotation, position })
    }

    /// The block in the system of the orthophoto, or in the coordinate reference system that it has: adjusted by places of the ground that two images
    /// or more show, beside its tie points and ground control points, and beside its GNSS positions where it has such a system. A share of the places takes no part and checks it. What came of it is `orthophoto` of the block, which is as it was where it
    /// could not be linked.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for ground control points of names that the places have; as [`BlockRun::with_edits`] where it stays with its edits.
    pub fn linked(&self, run: &BlockRun, reference: &Orthophoto, options: &PlacingOptions) -> Result<BlockRun, Error> {
        let positions: Vec<ExifPosition> = run.gnss_positions().copied().collect();
        let elsewhere = reference.elsewhere(&positions, options);
        let mut found = self.linked_by_places(run, reference, options)?;
        found.remarks.retain(|remark| !matches!(remark, Remark::OrthophotoElsewhere { .. }));
        found.remarks.extend(elsewhere);
        Ok(found)
    }

    fn linked_by_places(&self, run: &BlockRun, reference: &Orthophoto, options: &PlacingOptions) -> Result<BlockRun, Error> {
        let oriented = run.model.images.iter().filter(|image| image.pose.is_some()).count();
        if oriented == 0 {
            return run.not_linked(NotLinked::NotOriented);
        }
        let into = match IntoSystem::of(run, reference) {
            Ok(into) => into,
            Err(no_way) => return run.not_linked(no_way.into()),
        };
        let placed = self.sure().count();
        if placed < LEAST_IMAGES {
            return run.not_linked(NotLinked::FewImages { placed, images: oriented, needed: LEAST_IMAGES });
        }
        let metric = in_metres(into.as_ref(), reference);
        let errors = PlaceErrors::new(options, metric.georeference.gsd(), matches!(metric.heights, Heights::Model(_)));
        let points = self.points(&metric, errors, options);
        let on_ground = match into.map(|into| into.taken(points.clone(), reference)).transpose() {
            Ok(None) => run.on_ground(&points, reference.epsg, &[]),
            Ok(Some((points, remarks))) => run.on_ground(&points, reference.epsg, &remarks),
            Err(error) => return run.not_linked(NotLinked::Failed { failure: Failure::from(&error) }),
        };
        on_ground.map(|found| match found.orthophoto {
            Some(OnOrthophoto::Linked { .. }) => found.judged_beside_positions(reference, options).judged_by_checks(errors.height),
            _ => found,
        })
    }

    /// The places of the ground, of which each square gives one.
    fn points(&self, reference: &Orthophoto, errors: PlaceErrors, options: &PlacingOptions) -> Vec<GroundPoint> {
        let gsd = reference.georeference.gsd();
        let side = |placement: &Placement| placement.gsd_m * f64::from(placement.camera.width_px.max(placement.camera.height_px)) / CELLS;
        let Some(side) = median(&mut self.sure().map(|(_, placement)| side(placement)).collect::<Vec<_>>()) else { return Vec::new() };
        let mut squares: BTreeMap<[i64; 2], Vec<Seeing>> = BTreeMap::new();
        let mut factors = Vec::new();
        for (image, placement) in self.sure() {
            let resampled = reference.georeference.with_gsd(gsd.max(placement.gsd_m));
            let mut ratios = Vec::new();
            for link in placement.links.iter().filter(|link| link.role == LinkUse::Used) {
                let at = resampled.pixel([link.place[0], link.place[1]]);
                let height_spread = height_spread(&reference.heights, &resampled, at, link.place[2]);
                if height_spread > LEVEL * errors.height {
                    continue;
                }
                let own = Found { at: link.at, place: link.place, height_spread, measured_px: MEASURED_PX };
                let sigma = variance_px2(&own, &placement.camera, &placement.pose, errors).sqrt();
                ratios.extend(link.residual_px.into_iter().flatten().map(|residual| residual.abs() / sigma));
                let square = [0, 1].map(|k| (link.place[k] / side).floor() as i64);
                squares.entry(square).or_default().push(Seeing { image, link: own });
            }
            factors.extend(median(&mut ratios));
        }
        // Residuals say how large all errors are, and what was stated how they differ.
        let factor = scatter(&mut factors).map_or(1.0, |found| found.max(LEAST_FACTOR));
        let of_images = median(&mut self.sure().map(|(_, placement)| placement.gsd_m).collect::<Vec<_>>()).unwrap_or(gsd);
        let within = ONE_PLACE_PX * gsd.max(of_images);
        let chosen: Vec<(&Found, Vec<&Seeing>)> = squares.values().filter_map(|links| most_seen(links, within)).collect();
        let parts = checks(chosen.len(), options.check_share);
        let points = chosen.into_iter().zip(parts).map(|((of, links), part)| GroundPoint {
            place: of.place,
            sigma: [errors.plan, libm::hypot(errors.height, of.height_spread)].map(|sigma| factor * sigma),
            sigma_px: (factor * MEASURED_PX).clamp(LEAST_SIGMA_PX, MOST_SIGMA_PX),
            role: if part == Part::Check { ControlRole::Check } else { ControlRole::Control },
            seen: links.into_iter().filter_map(|seeing| Some((seeing.image, self.seen_at(seeing, &of.place)?))).collect(),
        });
        points.filter(|point| point.seen.len() >= LEAST_IMAGES).collect()
    }

    /// Where the image of a link shows a place beside that of the link.
    fn seen_at(&self, Seeing { image, link }: &Seeing, place: &[f64; 3]) -> Option<[f64; 2]> {
        let placement = self.placed.get(image)?.placement.as_ref()?;
        let seen = Seen::new(&placement.camera, &placement.pose);
        let (there, here) = (seen.at(place)?, seen.at(&link.place)?);
        let at = [0, 1].map(|k| link.at[k] + there[k] - here[k]);
        placement.camera.sees(at[0], at[1]).then_some(at)
    }
}

/// The orthophoto in m where it goes into a coordinate reference system, else as it is.
pub(super) fn in_metres<'a>(into: Option<&IntoSystem>, reference: &'a Orthophoto) -> Cow<'a, Orthophoto> {
    into.map_or(Cow::Borrowed(reference), |into| Cow::Owned(into.in_metres(reference)))
}

/// Of the links of a square the one whose place most images show, of equal ones that on the most level ground; with the nearest link of each of these
/// images. `None` where no two images show one place.
fn most_seen(links: &[Seeing], within: f64) -> Option<(&Found, Vec<&Seeing>)> {
    let square = |a: &Seeing, b: &Seeing| {
        let [dx, dy] = [0, 1].map(|k| a.link.place[k] - b.link.place[k]);
        dx * dx + dy * dy
    };
    let nearest = |of: &Seeing| -> Vec<&Seeing> {
        let mut nearest: BTreeMap<usize, &Seeing> = BTreeMap::new();
        for seeing in links.iter().filter(|seeing| square(of, seeing) <= within * within) {
            let known = nearest.entry(seeing.image).or_insert(seeing);
            if square(of, seeing) < square(of, known) {
                *known = seeing;
            }
        }
        nearest.into_values().collect()
    };
    let mut best: Option<(&Found, Vec<&Seeing>)> = None;
    for of in links {
        let seen = nearest(of);
        let is_better = best
            .as_ref()
            .is_none_or(|(best, most)| seen.len() > most.len() || (seen.len() == most.len() && of.link.height_spread < best.height_spread));
        if is_better {
            best = Some((&of.link, seen));
        }
    }
    best.filter(|(_, seen)| seen.len() >= LEAST_IMAGES)
}

fn is_sure(verdict: &PlacingVerdict, is_as_known: bool) -> bool {
    match verdict {
        PlacingVerdict::Placed { .. } => true,
        wide if wide.is_wide() => true,
        PlacingVerdict::Weak { placing_weakness: PlacingWeakness::Camera { apart, .. }, .. } => is_as_known || *apart <= MOST_APART,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CameraParameter;

    #[test]
    fn a_camera_of_the_block_that_is_somewhat_off_keeps_no_image_from_it() {
        let weak = |placing_weakness: PlacingWeakness| is_sure(&PlacingVerdict::Weak { links: 3_000, placing_weakness }, false);
        let off = |apart: f64| {
            weak(PlacingWeakness::Camera { camera_parameter: CameraParameter::Focal, estimated_px: 1884.3, prior_px: 1970.8, apart })
        };
        assert_eq!([2.3, 3.9, 4.1, 20.0].map(off), [true, true, false, false]);
        // A flat block may have a focal length far from its own: what was known of it before decides.
        let camera =
            PlacingWeakness::Camera { camera_parameter: CameraParameter::Focal, estimated_px: 1884.3, prior_px: 1970.8, apart: 7.0 };
        assert!(is_sure(&PlacingVerdict::Weak { links: 3_000, placing_weakness: camera }, true));
        // One that is known within a wide interval alone says no less of its links.
        assert!(
            weak(PlacingWeakness::Plan { height_m: 800.0, half_width_m: 64.0 })
                && weak(PlacingWeakness::Height { height_m: 800.0, half_width_m: 64.0 })
        );
        let of_ground = PlacingWeakness::Relief { displaced: 0.2 };
        assert!(!is_sure(&PlacingVerdict::Weak { links: 3_000, placing_weakness: of_ground }, true));
        assert!(
            !weak(PlacingWeakness::HeightFactor { factor: 3.3, standard_error: 0.1 }) && !weak(PlacingWeakness::Relief { displaced: 0.2 })
        );
    }

    fn seeing(image: usize, x: f64, height_spread: f64) -> Seeing {
        Seeing { image, link: Found { at: [0.0; 2], place: [x, 7.0, 0.0], height_spread, measured_px: MEASURED_PX } }
    }

    #[test]
    fn a_square_gives_the_place_that_most_images_show() {
        let links = [
            seeing(0, 10.0, 0.0),
            seeing(1, 11.5, 0.2),
            seeing(2, 12.5, 0.1),
            seeing(2, 11.0, 0.3),
            seeing(3, 40.0, 0.0),
            seeing(4, 40.1, 0.0),
        ];
        let (place, seen) = most_seen(&links, 2.0).unwrap();
        // Three images show the places at 10, 11 and 11.5, of which the first is on the most level ground.
        assert_eq!(place.place[0], 10.0);
        assert_eq!(seen.iter().map(|seeing| (seeing.image, seeing.link.place[0])).collect::<Vec<_>>(), [(0, 10.0), (1, 11.5), (2, 11.0)]);
        assert!(most_seen(&links[..1], 2.0).is_none() && most_seen(&[links[2], links[3]], 2.0).is_none());
        assert!(most_seen(&[links[0], links[2]], 2.0).is_none());
    }
}
