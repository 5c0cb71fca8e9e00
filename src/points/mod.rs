//! Interest points: one operator a file, thresholds, suppression of non-maxima.

mod box_sums;
mod forstner;
mod ground;
mod mask;
mod moravec;
mod multiscale;
mod options;
mod suppression;
mod threshold;

pub use forstner::forstner;
pub use ground::{ground1, ground2};
pub use moravec::moravec;
pub use multiscale::{MultiscaleOptions, PointPosition, ScalePoint, ScaleSpace, multiscale_points};
pub use options::{Operator, PointOptions, Ties};
pub use suppression::suppress_non_maxima;
pub use threshold::{LEAST_FRACTION, Selection};

pub(crate) use multiscale::Level;

use crate::{Error, GreyView};
use mask::Mask;
use serde::{Deserialize, Serialize};

/// A point of interest. Positions are in px; the centre of the top-left pixel is (0.5, 0.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InterestPoint {
    pub x: f64,
    pub y: f64,
    /// The operator's interest value; its unit is the operator's.
    pub value: f64,
}

/// The scale and the direction of a point that has them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalFrame {
    /// Standard deviation of the Gaussian at whose blur the point is most distinct, px.
    pub scale_px: f64,
    /// The dominant direction of the gradients, from x towards y; 0 where none was sought.
    pub orientation_rad: f64,
}

/// How many points each phase left (the first rows of the paper's Table 1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PointCounts {
    /// Pixels (or windows) that passed the operator's threshold.
    pub candidates: usize,
    /// Of these, the ones that passed the threshold of roundness; all of them where the operator has none.
    pub after_roundness: usize,
    /// Of these, the ones that suppression of non-maxima left.
    pub after_suppression: usize,
}

/// What an operator found before suppression.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Candidates {
    /// The points that passed all thresholds, in raster order: by row, then column.
    pub points: Vec<InterestPoint>,
    /// How many passed the first threshold, before that of roundness.
    pub candidates: usize,
    /// The threshold that was applied, in the operator's unit: as given, or as found for the wanted fraction.
    pub threshold: f64,
}

/// What an operator found, after suppression of non-maxima.
#[derive(Debug, Clone, PartialEq)]
pub struct PointSet {
    /// In raster order: by row, then column; points of many scales by octave.
    pub points: Vec<InterestPoint>,
    /// One for each point, or none for the operators that look at one scale.
    pub frames: Vec<LocalFrame>,
    pub counts: PointCounts,
    /// As in [`Candidates`].
    pub threshold: f64,
}

/// Finds interest points: operator, threshold, roundness, suppression of non-maxima; or points of many scales.
///
/// A flat image gives an empty set. Points whose pixel is 0 in the mask, which is as large as the image, are left out.
///
/// # Errors
/// [`Error::ImageTooSmall`] for the operator's window; [`Error::InvalidOption`], naming the field and its range; [`Error::InvalidInput`] for a
/// mask of another size.
pub fn detect(
    image: GreyView<'_>,
    mask: Option<GreyView<'_>>,
    options: &PointOptions,
    multiscale: &MultiscaleOptions,
) -> Result<PointSet, Error> {
    options.check_ranges()?;
    let selection = options.selection()?;
    let window = options.operator_window();
    let allowed = Mask::new(mask, image)?;
    let mut found = match options.operator() {
        Operator::Moravec => moravec(image, selection, window, options.tiled)?,
        Operator::Forstner => forstner(image, selection, window, options.roundness())?,
        Operator::Ground1 => ground1(image, selection)?,
        Operator::Ground2 => ground2(image, selection, options.roundness())?,
        Operator::Multiscale => {
            let framed = |p: &ScalePoint| (InterestPoint::from(p), LocalFrame { scale_px: p.scale_px, orientation_rad: 0.0 });
            let (points, _) = multiscale_points(image, mask, multiscale)?;
            return Ok(PointSet::of_scales(points.iter().map(framed).collect(), multiscale));
        }
    };
    found.points.retain(|p| allowed.allows(p.x, p.y));
    let points = suppress_non_maxima(&found.points, options.suppression_window, options.ties)?;
    let counts = PointCounts { candidates: found.candidates, after_roundness: found.points.len(), after_suppression: points.len() };
    Ok(PointSet { points, frames: Vec::new(), counts, threshold: found.threshold })
}

impl From<&ScalePoint> for InterestPoint {
    fn from(point: &ScalePoint) -> Self {
        Self { x: point.x, y: point.y, value: point.weight }
    }
}

impl PointSet {
    /// The set of points of many scales; their order is kept.
    pub(crate) fn of_scales(framed: Vec<(InterestPoint, LocalFrame)>, options: &MultiscaleOptions) -> Self {
        let number = framed.len();
        let (points, frames) = framed.into_iter().unzip();
        let counts = PointCounts { candidates: number, after_roundness: number, after_suppression: number };
        Self { points, frames, counts, threshold: options.contrast }
    }
}
