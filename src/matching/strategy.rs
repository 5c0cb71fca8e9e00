//! One entry for all strategies: the same points, the same rules.

use super::refine::refine;
use super::{Expectation, MatchImage, MatchOptions, MatchSet, Strategy, area, gradients, match_points};
use crate::Error;

/// Matches the left points by the strategy of the options, and refines the matches where that is wanted.
///
/// Moments and invariants choose among the right interest points: see [`match_points`]. Correlation and least squares matching search
/// the right image itself, at the left points. These go through the rules of many-to-one and y-parallax. Gradients choose among all right
/// points, wherever they lie: the geometry of the two views has to verify them, before they can be refined. Every refused point keeps
/// the rule that refused it. A refinement moves the right positions only.
///
/// # Errors
/// As [`match_points`]; [`Error::InvalidInput`] where the descriptors are not those of the strategy.
pub fn match_images<'a>(
    left: MatchImage<'a>,
    right: MatchImage<'a>,
    expected: impl Into<Expectation<'a>>,
    options: &MatchOptions,
) -> Result<MatchSet, Error> {
    options.check_ranges()?;
    let expected = expected.into();
    let set = match options.strategy {
        Strategy::Moments | Strategy::Invariants => {
            match_points((left.points, left.moments()?), (right.points, right.moments()?), expected, options)?
        }
        Strategy::Correlation => area::correlate(left, right.grey, expected, options)?,
        Strategy::LeastSquares => area::adjust(left, right.grey, expected, options)?,
        Strategy::Auto | Strategy::Gradient => {
            return gradients::match_gradients((left, left.gradients()?), (right, right.gradients()?), expected.nearest, options);
        }
    };
    Ok(refine(set, left, right, options))
}
