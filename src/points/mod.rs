//! Interest points: one operator a file, thresholds, suppression of non-maxima.

mod box_sums;
mod candidates;
mod forstner;
mod ground;
mod mask;
mod moravec;
mod multiscale;
mod options;
mod suppression;
mod threshold;

pub use candidates::{Candidates, InterestPoint, LocalFrame, PointCounts, PointSet};
pub use forstner::forstner;
pub use ground::{ground1, ground2};
pub use moravec::moravec;
pub use multiscale::{MultiscaleOptions, PointPosition, ScalePoint, ScaleSpace, multiscale_points};
pub use options::{Operator, PointOptions, Ties};
use suppression::suppress_non_maxima;
pub use threshold::{LEAST_FRACTION, Selection};

pub(crate) use multiscale::Level;

use crate::{Error, GreyView};
use mask::Mask;

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
