//! The points of an image with what the strategy compares them by.

use super::settings::PairSettings;
use crate::{
    Descriptor, Descriptors, Error, Feature, GreyView, InterestPoint, LocalFrame, MatchImage, Operator, PointSet, ScalePoint, Strategy,
    describe, detect, gradient_features, multiscale_points,
};

/// The scale at which gradients describe points that have none, px: a window of about 30 px a side.
const SCALE_OF_POINTS_PX: f64 = 1.6;

/// The points of an image, described.
#[derive(Debug, Clone, PartialEq)]
pub struct DescribedImage {
    pub set: PointSet,
    /// One for each point for the strategies that compare moments, none for the others.
    pub moments: Vec<Option<Descriptor>>,
    /// [`DESCRIPTOR_BYTES`](crate::DESCRIPTOR_BYTES) for each point for the strategy that compares gradients, none for the others.
    pub gradients: Vec<u8>,
}

impl DescribedImage {
    /// As matching takes it.
    pub fn match_image<'a>(&'a self, grey: GreyView<'a>, strategy: Strategy) -> MatchImage<'a> {
        let descriptors = match strategy {
            Strategy::Moments | Strategy::Invariants => Descriptors::Moments(&self.moments),
            Strategy::Correlation | Strategy::LeastSquares => Descriptors::None,
            Strategy::Auto | Strategy::Gradient => Descriptors::Gradients(&self.gradients),
        };
        MatchImage { grey, points: &self.set.points, frames: &self.set.frames, descriptors }
    }
}

/// Finds the points of an image and describes them as the strategy needs it. Points whose pixel is 0 in the mask are left out.
///
/// Gradients describe points of any operator: those that have no scale at one of 1.6 px.
///
/// # Errors
/// As [`detect`], [`describe`], [`multiscale_points`] and [`gradient_features`]; [`Error::InvalidInput`] for a mask of another size.
pub fn describe_image(image: GreyView<'_>, mask: Option<GreyView<'_>>, settings: &PairSettings) -> Result<DescribedImage, Error> {
    let settings = &settings.resolved();
    let strategy = settings.matching.strategy;
    if strategy == Strategy::Gradient {
        return gradients_of(image, mask, settings);
    }
    let set = detect(image, mask, &settings.points, &settings.multiscale)?;
    let moments = match strategy.measure() {
        Some(measure) => describe(image, &set.points, &settings.window, measure)?,
        None => Vec::new(),
    };
    Ok(DescribedImage { set, moments, gradients: Vec::new() })
}

fn gradients_of(image: GreyView<'_>, mask: Option<GreyView<'_>>, settings: &PairSettings) -> Result<DescribedImage, Error> {
    let (mut points, space) = multiscale_points(image, mask, &settings.multiscale)?;
    let mut found = None;
    if settings.points.operator() != Operator::Multiscale {
        let set = detect(image, mask, &settings.points, &settings.multiscale)?;
        let framed = |p: &InterestPoint| ScalePoint { x: p.x, y: p.y, scale_px: SCALE_OF_POINTS_PX, weight: p.value };
        points = set.points.iter().map(framed).collect();
        found = Some(set);
    }
    let features = gradient_features(&space, &points, &settings.gradient)?;
    let gradients = features.iter().flat_map(|f| f.descriptor).collect();
    let framed =
        |f: &Feature| (InterestPoint::from(&f.point), LocalFrame { scale_px: f.point.scale_px, orientation_rad: f.orientation_rad });
    let mut set = PointSet::of_scales(features.iter().map(framed).collect(), &settings.multiscale);
    if let Some(found) = found {
        (set.counts, set.threshold) = (found.counts, found.threshold);
    }
    Ok(DescribedImage { set, moments: Vec::new(), gradients })
}
