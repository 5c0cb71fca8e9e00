//! A block before its adjustment, with what its parts are; and the adjustment in the best datum.

use super::control_course::ControlTests;
use super::control_tests::tested_control;
use super::frame::PLACING;
use super::level::{Level, is_open, uncertainty_deg};
use super::material::Known;
use super::placing::Placing;
use super::result::{ObservationSource, PointSource, ReconstructedModel, RejectedObservation};
use super::review::warnings;
use super::surveyed::surveyed_points;
use crate::adjustment::{AdjustmentOptions, AdjustmentResult, Block, BlockImage, CameraPrior, ControlPoint, Datum, adjust_block};
use crate::camera::{Camera, Pose};
use crate::{Cause, ControlRole, Error};

/// A block before its adjustment, with what its parts are.
#[derive(Default)]
pub(super) struct Draft {
    pub block: Block,
    pub images: Vec<usize>,
    pub cameras: Vec<usize>,
    pub points: Vec<PointSource>,
    pub rays: Vec<ObservationSource>,
    pub rejected: Vec<RejectedObservation>,
}

impl Draft {
    /// Images (ascending) without points; `pose_of` gives the camera of an image and its pose. Cameras start as `cameras` has them, held by what
    /// was known of them before the block.
    pub fn of_images(known: &Known<'_>, images: Vec<usize>, cameras: &[Camera], pose_of: impl Fn(usize) -> (usize, Option<Pose>)) -> Self {
        let mut used: Vec<usize> = images.iter().map(|image| pose_of(*image).0).collect();
        used.sort_unstable();
        used.dedup();
        let mut block = Block { cameras: used.iter().map(|camera| cameras[*camera]).collect(), ..Block::default() };
        let prior = |(place, camera): (usize, &usize)| {
            let given = &known.description.cameras[*camera];
            CameraPrior::of(place, &given.approximate(), given.known_within())
        };
        block.camera_priors = used.iter().enumerate().map(prior).collect();
        for image in &images {
            let (camera, Some(pose)) = pose_of(*image) else { continue };
            let camera = used.binary_search(&camera).unwrap_or_default();
            block.images.push(BlockImage { camera, pose, gnss: known.frame.images[*image], axis: None });
        }
        Self { block, images, cameras: used, ..Self::default() }
    }

    /// Adds a point without its rays; a surveyed one that places the block, with its coordinates. Gives its index.
    pub fn add_point(&mut self, known: &Known<'_>, source: PointSource, place: [f64; 3]) -> usize {
        let point = self.block.points.len();
        self.points.push(source);
        self.block.points.push(place);
        if let PointSource::GroundControl(control) = source
            && known.description.control[control].role == ControlRole::Control
        {
            let (position, sigma) = known.frame.control[control];
            self.block.control.push(ControlPoint { point, position, sigma });
        }
        point
    }

    /// Adjusts in the datum that was asked for, or in the best that the observed positions allow, levelled where they leave the rotation of
    /// the whole block open; tells how it is placed.
    /// Control points that contradict the other observations take no part.
    pub fn adjust(&self, known: &Known<'_>) -> Result<(AdjustmentResult, Placing, ControlTests), Error> {
        let tested = known.options.tested_control.unwrap_or(usize::MAX);
        let is_tested = |control: &ControlPoint| matches!(self.points[control.point], PointSource::GroundControl(index) if index < tested);
        let is_tested: Vec<bool> = self.block.control.iter().map(is_tested).collect();
        tested_control(&self.block, &is_tested, known, |block| self.adjust_by(block, known))
    }

    /// Adjusts by some of the control points.
    fn adjust_by(&self, own: &Block, known: &Known<'_>) -> Result<(AdjustmentResult, Placing), Error> {
        let options = known.options;
        let with = |block: &Block, datum: Datum| adjust_block(block, &AdjustmentOptions { datum, ..options.adjustment.clone() });
        // Errors that positions share turn the block and leave no residuals: what these say of their precision does not say that it is level.
        let as_stated = |block: &Block| {
            let stated = AdjustmentOptions { datum: Datum::Gnss, variance_components: false, ..options.adjustment.clone() };
            adjust_block(block, &stated)
        };
        if let Some(datum) = options.datum {
            let placing = if datum == Datum::Free { Placing::Free { cause: None } } else { Placing::Observed };
            return with(own, datum).map(|adjusted| (adjusted, placing));
        }
        let positions = || own.images.iter().filter_map(|image| image.gnss);
        let (gnss, control) = (positions().count(), own.control.len());
        // Positions without a coordinate take part beside others that place the block.
        let whole = control + positions().filter(|gnss| gnss.sigma.iter().all(Option::is_some)).count();
        let datum = match (gnss >= PLACING && whole >= PLACING, control >= PLACING) {
            (true, _) if control > 0 => Datum::GnssAndControl,
            (true, _) => Datum::Gnss,
            (false, true) => Datum::Control,
            (false, false) => Datum::Free,
        };
        let level = || {
            let views: Vec<_> = self.images.iter().map(|image| known.frame.views[*image]).collect();
            Level::of(own, &views).filter(|_| datum == Datum::Gnss)
        };
        match with(own, datum) {
            Ok(found) if datum == Datum::Gnss => {
                let is_weighted = found.components.iter().any(|component| component.applied);
                let stated = if is_weighted { as_stated(own).ok() } else { None };
                let plain = stated.as_ref().unwrap_or(&found);
                if !is_open(plain) {
                    return Ok((found, Placing::Observed));
                }
                let error_deg = uncertainty_deg(plain);
                let levelled = level().and_then(|level| {
                    let adjusted = as_stated(&level.block).ok().filter(|adjusted| level.is_plausible(plain, adjusted))?;
                    Some((adjusted, Placing::Levelled { recorded: level.recorded, error_deg }))
                });
                Ok(levelled.unwrap_or_else(|| (stated.unwrap_or(found), Placing::Observed)))
            }
            Ok(adjusted) if datum == Datum::Free => Ok((adjusted, Placing::Free { cause: None })),
            Ok(adjusted) => Ok((adjusted, Placing::Observed)),
            // Poor positions along one strip hardly tell its roll: the adjustment in their system may creep without end. Wrong ones pull images
            // off their rays.
            Err(Error::NotConverged { cause, .. } | Error::Degenerate { cause, .. } | Error::UndeterminedImage { cause, .. })
                if datum != Datum::Free =>
            {
                let levelled = level().filter(|_| !matches!(cause, Cause::NoPosition)).and_then(|level| {
                    let adjusted = with(&level.block, datum).ok().filter(|adjusted| level.is_kept(adjusted))?;
                    Some((adjusted, Placing::Levelled { recorded: level.recorded, error_deg: None }))
                });
                levelled.map_or_else(|| with(own, Datum::Free).map(|adjusted| (adjusted, Placing::Free { cause: Some(cause) })), Ok)
            }
            Err(error) => Err(error),
        }
    }

    /// The model of its adjustment.
    pub fn model(self, known: &Known<'_>, (adjusted, placing, tests): (AdjustmentResult, Placing, ControlTests)) -> ReconstructedModel {
        let guessed = |camera: &usize| known.description.cameras[*camera].focal_px.is_none();
        let mut model = ReconstructedModel {
            guessed_focal: self.cameras.iter().copied().filter(guessed).collect(),
            images: self.images,
            cameras: self.cameras,
            points: self.points,
            rays: self.rays,
            rejected: self.rejected,
            adjusted,
            supporting: Vec::new(),
            surveyed: Vec::new(),
            in_system: !matches!(placing, Placing::Free { .. }),
            warnings: Vec::new(),
        };
        model.surveyed = surveyed_points(&model, known, &tests);
        model.warnings = warnings(&model, known, placing, &tests);
        model
    }
}
