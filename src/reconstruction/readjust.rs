//! A finished model adjusted anew with other observations: what an edit by hand asks for.

use super::draft::Draft;
use super::finish::{LEAST_RAYS, WITHOUT};
use super::frame::Frame;
use super::material::Known;
use super::net::Net;
use super::numbers::PointNumbers;
use super::options::ReconstructionOptions;
use super::rays::Rays;
use super::result::{ObservationSource, PointSource, ReconstructedModel, RejectedObservation, UnorientedImage};
use super::warning::UnorientedReason;
use crate::adjustment::BlockObservation;
use crate::camera::{Camera, Pose};
use crate::error::refuse;
use crate::model::BlockDescription;
use crate::{Error, PointName, Refusal};
use std::collections::BTreeSet;

/// A point with all of its observations.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ObservedPoint {
    pub source: PointSource,
    /// Absent where it is to be intersected.
    pub place: Option<[f64; 3]>,
    /// Whether it is given, or supports the adjustment alone.
    pub is_given: bool,
    pub rays: Vec<ObservedRay>,
}

/// An observation of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ObservedRay {
    /// Index of the image in the block.
    pub image: usize,
    pub at_px: [f64; 2],
    pub source: ObservationSource,
    pub weight: RayWeight,
    pub part: RayPart,
}

/// What an observation weighs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RayWeight {
    Known(f64),
    /// As an image measurement of a control point.
    Mark,
}

impl RayWeight {
    /// Of an adjusted observation. Projects of former versions state no standard error of image measurements: these keep the weights that they had.
    fn of(ray: &BlockObservation) -> Self {
        ray.sigma_px.map_or(Self::Known(ray.weight), |_| Self::Mark)
    }
}

/// Whether an observation takes part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RayPart {
    Takes,
    /// Not before the adjustment that was: its residual then.
    DoesNotFit(Option<f64>),
    RejectedByHand,
}

impl ReconstructedModel {
    /// Its points with all of their observations, those that support it last.
    pub(crate) fn observed_points(&self) -> Vec<ObservedPoint> {
        let block = &self.adjusted.block;
        let given = self.points.iter().zip(&block.points);
        let mut points: Vec<ObservedPoint> =
            given.map(|(source, place)| ObservedPoint { source: *source, place: Some(*place), is_given: true, rays: Vec::new() }).collect();
        for (ray, source) in block.rays.iter().zip(&self.rays) {
            points[ray.point].rays.push(ObservedRay {
                image: self.images[ray.image],
                at_px: [ray.x_px, ray.y_px],
                source: *source,
                weight: RayWeight::of(ray),
                part: RayPart::Takes,
            });
        }
        let unknown = ObservationSource { feature: None, confidence: 1.0, by_hand: false };
        for ray in &self.rejected {
            let weight = if matches!(self.points[ray.point], PointSource::TiePoint(_)) { RayWeight::Known(1.0) } else { RayWeight::Mark };
            points[ray.point].rays.push(ObservedRay {
                image: self.images[ray.image],
                at_px: [ray.x_px, ray.y_px],
                source: unknown,
                weight,
                part: RayPart::DoesNotFit(ray.residual_px),
            });
        }
        points.extend(self.supporting.iter().map(|point| {
            let rays = point.rays.iter().map(|ray| ObservedRay {
                image: self.images[ray.image],
                at_px: [ray.x_px, ray.y_px].map(f64::from),
                source: unknown,
                weight: RayWeight::Known(1.0),
                part: RayPart::Takes,
            });
            ObservedPoint { source: PointSource::TiePoint(point.point), place: Some(point.position), is_given: false, rays: rays.collect() }
        }));
        points
    }
}

/// What a model is adjusted anew by.
pub(crate) struct Changed<'a> {
    /// Those of its images (ascending, by their indices in the block) that stay.
    pub images: Vec<usize>,
    pub points: &'a [ObservedPoint],
    /// With the uses of the surveyed points, and the positions of the images, as they are now.
    pub description: &'a BlockDescription,
}

/// Adjusts a model anew; images that are then hardly seen fall out, with the reason, and so do points that fewer than two rays are left of.
/// `found`: the description by which the model was found, whose system it keeps.
///
/// # Errors
/// [`Error::InvalidInput`] for a new point whose rays do not meet; the errors of [`adjust_block`](crate::adjust_block).
pub(crate) fn readjust(
    model: &ReconstructedModel,
    changed: Changed<'_>,
    found: &BlockDescription,
    options: &ReconstructionOptions,
) -> Result<(ReconstructedModel, Vec<UnorientedImage>), Error> {
    let Changed { mut images, points, description } = changed;
    let frame = Frame::with_images(found, &description.images)?;
    let known = Known { description, options, frame: &frame };
    let base = Base::new(model, description, options);
    let places = points.iter().map(|point| base.place(&known, point)).collect::<Result<Vec<Option<[f64; 3]>>, Error>>()?;
    let mut lost = Vec::new();
    let mut lose = |images: &mut Vec<usize>, place: usize, reason: UnorientedReason| {
        lost.push(UnorientedImage { image: images.remove(place), reason });
    };
    let mut attempt = 0;
    loop {
        while let Some((place, rays)) = weak(&images, points) {
            lose(&mut images, place, UnorientedReason::Lost { rays });
        }
        let mut draft = Draft::of_images(&known, images.clone(), &base.cameras, |image| (base.camera_of[image], base.poses[image]));
        let mut given = Vec::new();
        for (point, place) in points.iter().zip(&places) {
            let Some(place) = *place else { continue };
            let index = draft.add_point(&known, point.source, place);
            given.extend(point.is_given.then_some(index));
            let mark_sigma_px = known.mark_sigma_px(point.source);
            point.rays.iter().for_each(|ray| add_ray(&mut draft, index, ray, mark_sigma_px));
        }
        match draft.adjust(&known) {
            Ok(adjusted) => return Ok((draft.model(&known, adjusted).with_points(&given), lost)),
            Err(Error::UndeterminedImage { image, .. }) if attempt < WITHOUT && images.len() > 2 && image < images.len() => {
                attempt += 1;
                let rays = seen(&images, points)[image];
                lose(&mut images, image, UnorientedReason::Undetermined { rays });
            }
            // Of an image the error tells its place among those of the adjustment.
            Err(Error::UndeterminedImage { computation, image, cause }) => {
                let image = images.get(image).copied().unwrap_or(image);
                return Err(Error::UndeterminedImage { computation, image, cause });
            }
            Err(error) => return Err(error),
        }
    }
}

fn add_ray(draft: &mut Draft, point: usize, ray: &ObservedRay, mark_sigma_px: f64) {
    let Ok(image) = draft.images.binary_search(&ray.image) else { return };
    let [x_px, y_px] = ray.at_px;
    let measured = ray.source.by_hand;
    let mut reject =
        |residual_px, by_hand| draft.rejected.push(RejectedObservation { image, point, x_px, y_px, residual_px, by_hand, measured });
    match ray.part {
        RayPart::DoesNotFit(residual_px) => reject(residual_px, false),
        RayPart::RejectedByHand => reject(None, true),
        RayPart::Takes => {
            let (weight, sigma_px) = match ray.weight {
                RayWeight::Known(weight) => (weight, None),
                RayWeight::Mark => (1.0, Some(mark_sigma_px)),
            };
            draft.block.rays.push(BlockObservation { image, point, x_px, y_px, weight, sigma_px });
            draft.rays.push(ray.source);
        }
    }
}

/// Rays of each of these images to points that two of them see.
fn seen(images: &[usize], points: &[ObservedPoint]) -> Vec<usize> {
    let mut counts = vec![0; images.len()];
    for point in points {
        let taking = point.rays.iter().filter(|ray| ray.part == RayPart::Takes);
        let places: Vec<usize> = taking.filter_map(|ray| images.binary_search(&ray.image).ok()).collect();
        if places.len() >= 2 {
            places.iter().for_each(|place| counts[*place] += 1);
        }
    }
    counts
}

/// The place of an image with too few rays, and how many it has.
fn weak(images: &[usize], points: &[ObservedPoint]) -> Option<(usize, usize)> {
    if images.len() <= 2 {
        return None;
    }
    seen(images, points).into_iter().enumerate().find(|(_, rays)| *rays < LEAST_RAYS)
}

/// The adjusted cameras and images by their indices in the block.
struct Base {
    numbers: PointNumbers,
    cameras: Vec<Camera>,
    camera_of: Vec<usize>,
    poses: Vec<Option<Pose>>,
    in_system: bool,
}

impl Base {
    fn new(model: &ReconstructedModel, description: &BlockDescription, options: &ReconstructionOptions) -> Self {
        let block = &model.adjusted.block;
        let mut cameras = description.to_model().cameras;
        model.cameras.iter().zip(&block.cameras).for_each(|(camera, adjusted)| cameras[*camera] = *adjusted);
        let mut poses = vec![None; description.images.len()];
        model.images.iter().zip(&block.images).for_each(|(image, adjusted)| poses[*image] = Some(adjusted.pose));
        let camera_of = description.images.iter().map(|image| image.camera).collect();
        Self { numbers: PointNumbers::new(&model.points, options.found_points), cameras, camera_of, poses, in_system: model.in_system }
    }

    /// Where a point is: known, surveyed, or where its rays meet; `None` with fewer than two.
    fn place(&self, known: &Known<'_>, point: &ObservedPoint) -> Result<Option<[f64; 3]>, Error> {
        if point.place.is_some() {
            return Ok(point.place);
        }
        if let PointSource::GroundControl(control) = point.source
            && self.in_system
        {
            return Ok(Some(known.frame.control[control].0));
        }
        let rays = self.taking(point).count();
        if rays < 2 {
            return Ok(None);
        }
        let meeting = self.meeting(point, known.options);
        if meeting.is_none() {
            let (least_angle_deg, largest_px) = (known.options.least_angle_deg, known.options.largest_residual_px);
            let point_name = known.description.name_of(point.source, self.numbers.of(point.source));
            return refuse(Refusal::NoIntersection { rays, point_name, largest_px, least_angle_deg });
        }
        Ok(meeting)
    }

    fn taking<'p>(&self, point: &'p ObservedPoint) -> impl Iterator<Item = &'p ObservedRay> {
        point.rays.iter().filter(|ray| ray.part == RayPart::Takes && self.poses[ray.image].is_some())
    }

    /// Where the rays of a point meet.
    fn meeting(&self, point: &ObservedPoint, options: &ReconstructionOptions) -> Option<[f64; 3]> {
        let rays =
            Rays::new(std::iter::once(self.taking(point).map(|ray| (ray.image as u32, ray.at_px)).collect::<Vec<_>>()), self.poses.len());
        let longer_side_px: Vec<f64> = self.cameras.iter().map(|camera| f64::from(camera.width_px.max(camera.height_px))).collect();
        let mut net = Net::new(&rays, &self.camera_of, &longer_side_px, self.cameras.clone(), options);
        net.poses.clone_from(&self.poses);
        net.intersect(0, libm::cos(options.least_angle_deg.to_radians()));
        net.points[0]
    }
}

/// Adjusts a model anew with further surveyed points, which `description` has behind those by which it was found: in their system, whatever
/// its own was. Points whose image measurements do not meet take no part.
///
/// # Errors
/// As [`readjust`].
pub(crate) fn with_further_control(
    model: &ReconstructedModel,
    description: &BlockDescription,
    options: &ReconstructionOptions,
) -> Result<ReconstructedModel, Error> {
    let mut points = model.observed_points();
    let known: BTreeSet<PointSource> = points.iter().map(|point| point.source).collect();
    let source = ObservationSource { feature: None, confidence: 1.0, by_hand: false };
    for (index, control) in description.control.iter().enumerate() {
        let rays = control.measurements.iter().map(|seen| ObservedRay {
            image: seen.image,
            at_px: [seen.x_px, seen.y_px],
            source,
            weight: RayWeight::Mark,
            part: RayPart::Takes,
        });
        let point = ObservedPoint { source: PointSource::GroundControl(index), place: None, is_given: true, rays: rays.collect() };
        points.extend((!known.contains(&point.source)).then_some(point));
    }
    brought(model, Changed { images: model.images.clone(), points: &points, description }, options).map(|(model, _)| model)
}

/// Adjusts a model anew in the system of the surveyed points of `changed`, whatever its own was; those without a place whose image measurements do not
/// meet take no part.
///
/// # Errors
/// As [`readjust`].
pub(crate) fn brought(
    model: &ReconstructedModel,
    changed: Changed<'_>,
    options: &ReconstructionOptions,
) -> Result<(ReconstructedModel, Vec<UnorientedImage>), Error> {
    let Changed { images, points, description } = changed;
    let base = Base::new(model, description, options);
    let placed = |point: &ObservedPoint| match point.source {
        PointSource::GroundControl(_) if point.place.is_none() => {
            base.meeting(point, options).map(|place| ObservedPoint { place: Some(place), ..point.clone() })
        }
        _ => Some(point.clone()),
    };
    let points: Vec<ObservedPoint> = points.iter().filter_map(placed).collect();
    readjust(model, Changed { images, points: &points, description }, description, options)
}

impl BlockDescription {
    /// A point as texts name it.
    pub(crate) fn name_of(&self, point: PointSource, number: u32) -> PointName {
        match point {
            PointSource::TiePoint(_) => PointName::TiePoint { number },
            PointSource::GroundControl(point) => match self.control.get(point) {
                Some(known) => PointName::Control { name: known.name.clone() },
                None => PointName::ControlIndex { point },
            },
            PointSource::Manual(_) => PointName::Manual { number },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn image_measurements_of_former_versions_keep_their_weights() {
        let weight = |text: &str| RayWeight::of(&serde_json::from_str(text).unwrap());
        let former = r#"{"image": 0, "point": 1, "x_px": 2.5, "y_px": 3.5, "weight": 0.09"#;
        assert_eq!(weight(&format!("{former}}}")), RayWeight::Known(0.09));
        assert_eq!(weight(&format!("{former}, \"sigma_px\": 1.5}}")), RayWeight::Mark);
    }
}
