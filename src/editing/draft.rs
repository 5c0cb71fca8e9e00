//! A block as it was found, and its observations while edits are applied to them one after the other.

use super::edit::{BlockEdit, HandMeasurement, MeasuredBy, PointImage};
use super::rejected_pairs::{ImagePairs, ascending, sort_pairs, take_out};
use crate::error::refuse;
use crate::model::{BlockDescription, ControlRole, ImageObservation};
use crate::reconstruction::{ObservedPoint, ObservedRay, PointNumbers, RayPart, RayWeight};
use crate::{
    Camera, Connection, Error, Input, KnownImage, Location, ObservationSource, PairOutcome, PointName, PointSource, ReconstructedModel,
    ReconstructionOptions, Refusal,
};
use std::collections::{BTreeMap, BTreeSet};

/// A block as it was found, as far as edits change it.
pub(crate) struct FoundBlock<'a> {
    pub model: &'a ReconstructedModel,
    /// As the block was found.
    pub as_found: &'a BlockDescription,
    /// With the surveyed points that the edits add behind those that were given, and what is known of images beside them.
    pub description: &'a BlockDescription,
    /// Whether the model lies in the system of the coordinates of surveyed points.
    pub is_in_their_system: bool,
    /// Its images as they are known without control points, which they are where none is left of those that the block had.
    pub alone: &'a [KnownImage],
    /// The pairs that were matched.
    pub connections: &'a [Connection],
}

/// The observations of a model while edits are applied.
pub(super) struct Draft<'a> {
    model: &'a ReconstructedModel,
    numbers: PointNumbers,
    description: BlockDescription,
    /// Pairs that matches connect.
    connected: ImagePairs,
    points: Vec<ObservedPoint>,
    place_of: BTreeMap<PointSource, usize>,
    /// Those that take no part.
    rejected_points: BTreeSet<PointSource>,
    pub rejected_images: BTreeSet<usize>,
    rejected_pairs: ImagePairs,
    /// Points that were added.
    added: u32,
    /// Surveyed points that are known so far: those that were given, and those that were added.
    surveyed: usize,
}

impl<'a> Draft<'a> {
    pub fn new(found: &FoundBlock<'a>, options: &ReconstructionOptions) -> Self {
        let FoundBlock { model, as_found, description, connections, .. } = *found;
        let matched = connections.iter().filter(|pair| matches!(pair.outcome, PairOutcome::Connected { .. }));
        let connected = matched.map(|pair| ascending(pair.images.map(|image| image as usize))).collect();
        let points = model.observed_points();
        let place_of = points.iter().enumerate().map(|(place, point)| (point.source, place)).collect();
        Self {
            model,
            numbers: PointNumbers::new(&model.points, options.found_points),
            description: description.clone(),
            connected,
            points,
            place_of,
            rejected_points: BTreeSet::new(),
            rejected_images: BTreeSet::new(),
            rejected_pairs: ImagePairs::new(),
            added: 0,
            surveyed: as_found.control.len(),
        }
    }

    pub fn apply(&mut self, edit: &BlockEdit) -> Result<(), Error> {
        match edit {
            BlockEdit::RejectObservations { observations } => self.set_part(observations, RayPart::RejectedByHand),
            BlockEdit::RestoreObservations { observations } => self.set_part(observations, RayPart::Takes),
            BlockEdit::RejectPoints { points } => points.iter().try_for_each(|point| {
                self.known(*point)?;
                self.rejected_points.insert(*point);
                Ok(())
            }),
            BlockEdit::RestorePoints { points } => points.iter().try_for_each(|point| self.restore(*point)),
            BlockEdit::RejectImages { images } => images.iter().try_for_each(|image| {
                self.oriented(*image)?;
                self.rejected_images.insert(*image);
                Ok(())
            }),
            BlockEdit::RestoreImages { images } => images.iter().try_for_each(|image| {
                self.oriented(*image)?;
                self.rejected_images.remove(image);
                Ok(())
            }),
            BlockEdit::RejectPairs { pairs } | BlockEdit::RestorePairs { pairs } => {
                pairs.iter().try_for_each(|pair| self.connected(*pair))?;
                sort_pairs(&mut self.rejected_pairs, edit);
                Ok(())
            }
            BlockEdit::Measure { point, image, x_px, y_px, by } => {
                self.measure(*point, &HandMeasurement { image: *image, x_px: *x_px, y_px: *y_px, by: *by })
            }
            BlockEdit::AddPoint { observations } => self.add(observations),
            // The description has it already.
            BlockEdit::AddControl { .. } => {
                self.surveyed += 1;
                Ok(())
            }
            BlockEdit::SetUse { point, role } => self.set_use(*point, *role),
        }
    }

    /// Takes a point in again, unless a point that was added has its observations: they would count twice.
    fn restore(&mut self, point: PointSource) -> Result<(), Error> {
        let own = &self.points[self.known(point)?];
        let is_of_own = |ray: &ObservedRay| own.rays.iter().any(|seen| (seen.image, seen.at_px) == (ray.image, ray.at_px));
        let takes_its_place = |other: &&ObservedPoint| {
            let is_added = matches!(other.source, PointSource::Manual(_)) && other.source != point;
            is_added && !self.rejected_points.contains(&other.source) && other.rays.iter().any(is_of_own)
        };
        // Of a point that takes part nothing changes.
        if self.rejected_points.contains(&point)
            && let Some(other) = self.points.iter().find(takes_its_place)
        {
            return refuse(Refusal::ReplacedPoint { point_name: self.label(other.source) });
        }
        self.rejected_points.remove(&point);
        Ok(())
    }

    fn set_part(&mut self, observations: &[PointImage], part: RayPart) -> Result<(), Error> {
        for PointImage { point, image } in observations {
            let place = self.known(*point)?;
            let ray = self.points[place].rays.iter_mut().find(|ray| ray.image == *image);
            let Some(ray) = ray else {
                return refuse(Refusal::NoObservation { location: self.name(*image), point_name: self.label(*point) });
            };
            ray.part = part;
        }
        Ok(())
    }

    fn measure(&mut self, point: PointSource, measurement: &HandMeasurement) -> Result<(), Error> {
        let ray = self.measured(measurement, point)?;
        if let (PointSource::GroundControl(control), None) = (point, self.place_of.get(&point)) {
            if control >= self.surveyed {
                return self.known(point).map(|_| ());
            }
            let rays = self.marks_of(control);
            self.push(ObservedPoint { source: point, place: None, is_given: true, rays });
        }
        let place = self.known(point)?;
        if self.rejected_points.contains(&point) {
            return refuse(Refusal::RejectedPoint { point_name: self.label(point) });
        }
        self.points[place].is_given = true;
        let rays = &mut self.points[place].rays;
        match rays.iter_mut().find(|known| known.image == ray.image) {
            Some(known) => *known = ray,
            None => rays.push(ray),
        }
        Ok(())
    }

    fn add(&mut self, observations: &[HandMeasurement]) -> Result<(), Error> {
        let source = PointSource::Manual(self.added);
        let rays = observations.iter().map(|seen| self.measured(seen, source)).collect::<Result<Vec<ObservedRay>, Error>>()?;
        let images: BTreeSet<usize> = rays.iter().map(|ray| ray.image).collect();
        if images.len() < rays.len() || images.len() < 2 {
            return refuse(Refusal::NewPointImages { images: images.len(), observations: rays.len() });
        }
        self.added += 1;
        self.push(ObservedPoint { source, place: None, is_given: true, rays });
        Ok(())
    }

    fn set_use(&mut self, point: usize, role: Option<ControlRole>) -> Result<(), Error> {
        let Some(known) = self.description.control[..self.surveyed].get_mut(point) else {
            return refuse(Refusal::Index { input: Input::SurveyedPoint, index: point, count: self.surveyed });
        };
        let source = PointSource::GroundControl(point);
        match role {
            Some(role) => {
                known.role = role;
                self.rejected_points.remove(&source);
            }
            None => drop(self.rejected_points.insert(source)),
        }
        Ok(())
    }

    fn push(&mut self, point: ObservedPoint) {
        self.place_of.insert(point.source, self.points.len());
        self.points.push(point);
    }

    /// A measurement as an observation of a point.
    fn measured(&self, measurement: &HandMeasurement, point: PointSource) -> Result<ObservedRay, Error> {
        let HandMeasurement { image, x_px, y_px, by } = *measurement;
        self.oriented(image)?;
        let camera = self.description.cameras[self.description.images[image].camera].approximate();
        if !camera.sees(x_px, y_px) {
            let Camera { width_px, height_px, .. } = camera;
            return refuse(Refusal::MeasuredPlace { x_px, y_px, location: self.name(image), width_px, height_px });
        }
        let is_surveyed = matches!(point, PointSource::GroundControl(_));
        let weight = if by == MeasuredBy::LeastSquares && !is_surveyed { RayWeight::Known(1.0) } else { RayWeight::Mark };
        let source = ObservationSource { feature: None, confidence: 1.0, by_hand: true };
        Ok(ObservedRay { image, at_px: [x_px, y_px], source, weight, part: RayPart::Takes })
    }

    /// The place of a point, or why it has none.
    fn known(&self, point: PointSource) -> Result<usize, Error> {
        match self.place_of.get(&point) {
            Some(place) => Ok(*place),
            None => refuse(Refusal::UnknownPoint { point_name: self.label(point) }),
        }
    }

    fn oriented(&self, image: usize) -> Result<(), Error> {
        match self.model.images.binary_search(&image) {
            Ok(_) => Ok(()),
            Err(_) => refuse(Refusal::ImageNotOriented { location: self.name(image) }),
        }
    }

    fn connected(&self, images: [usize; 2]) -> Result<(), Error> {
        images.iter().try_for_each(|image| self.oriented(*image))?;
        let [a, b] = images;
        if a == b {
            let count = self.description.images.len();
            return refuse(Refusal::PairOfImages { images: images.map(|image| image as u32), count });
        }
        if !self.connected.contains(&ascending(images)) {
            let [first, second] =
                images.map(|image| self.description.images.get(image).map(|known| known.name.clone()).unwrap_or_default());
            return refuse(Refusal::PairNotConnected { first, second });
        }
        Ok(())
    }

    fn name(&self, image: usize) -> Location {
        match self.description.images.get(image) {
            Some(known) => Location::Image { name: known.name.clone() },
            None => Location::ImageIndex { image },
        }
    }

    fn label(&self, point: PointSource) -> PointName {
        self.description.name_of(point, self.numbers.of(point))
    }

    /// The image measurements of a surveyed point that was given with them and is not in the model.
    fn marks_of(&self, control: usize) -> Vec<ObservedRay> {
        let source = ObservationSource { feature: None, confidence: 1.0, by_hand: false };
        let marks = self.description.control[control].measurements.iter();
        let ray = |mark: &ImageObservation| ObservedRay {
            image: mark.image,
            at_px: [mark.x_px, mark.y_px],
            source,
            weight: RayWeight::Mark,
            part: RayPart::Takes,
        };
        marks.filter(|mark| self.model.images.binary_search(&mark.image).is_ok()).map(ray).collect()
    }

    /// What the model is adjusted by: points, images, and what is known of the block.
    pub fn taken(self) -> (Vec<ObservedPoint>, Vec<usize>, BlockDescription) {
        let Self { model, mut description, connected, mut points, rejected_points, rejected_images, rejected_pairs, .. } = self;
        take_out(&mut points, &connected, &rejected_pairs, |image| rejected_images.contains(&image));
        let images = model.images.iter().copied().filter(|image| !rejected_images.contains(image)).collect();
        let points: Vec<ObservedPoint> = points.into_iter().filter(|point| !rejected_points.contains(&point.source)).collect();
        for point in &points {
            let PointSource::GroundControl(control) = point.source else { continue };
            let taking = point.rays.iter().filter(|ray| ray.part != RayPart::RejectedByHand);
            let measurements =
                taking.map(|ray| ImageObservation { image: ray.image, x_px: ray.at_px[0], y_px: ray.at_px[1], confidence: 1.0 });
            description.control[control].measurements = measurements.collect();
        }
        for control in &rejected_points {
            let PointSource::GroundControl(control) = control else { continue };
            description.control[*control].measurements = Vec::new();
        }
        (points, images, description)
    }
}
