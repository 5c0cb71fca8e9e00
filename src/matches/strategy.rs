//! One entry for all strategies: the same points, the same rules.

use super::{Expectation, MatchOptions, MatchSet, Strategy, area, match_points, refine};
use crate::{Descriptor, Error, GreyView, InterestPoint};

/// An image with its interest points.
#[derive(Clone, Copy)]
pub struct MatchImage<'a> {
    pub grey: GreyView<'a>,
    pub points: &'a [InterestPoint],
    /// One for each point, or none at all for the strategies that compare grey values.
    pub descriptors: &'a [Option<Descriptor>],
}

/// Matches the left points by the strategy of the options, and refines the matches where that is wanted.
///
/// Moments and invariants choose among the right interest points: see [`match_points`]. Correlation and least squares matching search
/// the right image itself, at the left points. All go through the rules of many-to-one and y-parallax, and every refused point keeps
/// the rule that refused it. A refinement moves the right positions only; a match that it cannot confirm is refused.
///
/// # Errors
/// As [`match_points`].
pub fn match_images<'a>(
    left: MatchImage<'a>,
    right: MatchImage<'a>,
    expected: impl Into<Expectation<'a>>,
    options: &MatchOptions,
) -> Result<MatchSet, Error> {
    options.check()?;
    let expected = expected.into();
    let set = match options.strategy {
        Strategy::Moments | Strategy::Invariants => {
            match_points((left.points, left.descriptors), (right.points, right.descriptors), expected, options)?
        }
        Strategy::Correlation => area::correlate(left, right.grey, expected, options)?,
        Strategy::LeastSquares => area::adjust(left, right.grey, expected, options)?,
    };
    Ok(refine::refine(set, left, right.grey, options))
}
