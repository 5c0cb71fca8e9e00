//! One entry for all strategies: the same points, the same rules.

use super::refine::refine;
use super::{Expectation, MatchOptions, MatchSet, Strategy, area, gradients, match_points};
use crate::{Descriptor, Error, GreyView, InterestPoint, LocalFrame};

/// What the strategies compare points by, one for each point.
#[derive(Debug, Clone, Copy)]
pub enum Descriptors<'a> {
    /// For the strategies that compare grey values.
    None,
    /// Moments or invariants.
    Moments(&'a [Option<Descriptor>]),
    /// Histograms of gradients, [`DESCRIPTOR_BYTES`](crate::DESCRIPTOR_BYTES) each.
    Gradients(&'a [u8]),
}

/// An image with its interest points.
#[derive(Clone, Copy)]
pub struct MatchImage<'a> {
    pub grey: GreyView<'a>,
    pub points: &'a [InterestPoint],
    /// One for each point, or none at all.
    pub frames: &'a [LocalFrame],
    pub descriptors: Descriptors<'a>,
}

impl<'a> MatchImage<'a> {
    fn moments(&self) -> Result<&'a [Option<Descriptor>], Error> {
        match self.descriptors {
            Descriptors::Moments(moments) => Ok(moments),
            _ => Err(self.lacks("moments of each point")),
        }
    }

    fn gradients(&self) -> Result<&'a [u8], Error> {
        match self.descriptors {
            Descriptors::Gradients(bytes) if bytes.len() == self.points.len() * super::DESCRIPTOR_BYTES => Ok(bytes),
            _ => Err(self.lacks("a gradient descriptor of each point")),
        }
    }

    fn lacks(&self, allowed: &str) -> Error {
        let got = match self.descriptors {
            Descriptors::None => "none".to_string(),
            Descriptors::Moments(moments) => format!("{} of moments", moments.len()),
            Descriptors::Gradients(bytes) => format!("{} bytes of gradients", bytes.len()),
        };
        Error::InvalidInput { what: "descriptors", got: format!("{got} for {} points", self.points.len()), allowed: allowed.into() }
    }
}

/// Matches the left points by the strategy of the options, and refines the matches where that is wanted.
///
/// Moments and invariants choose among the right interest points: see [`match_points`]. Correlation and least squares matching search
/// the right image itself, at the left points. These go through the rules of many-to-one and y-parallax. Gradients choose among all right
/// points, wherever they lie: the geometry of the two views has to verify them, before they can be refined. Every refused point keeps
/// the rule that refused it. A refinement moves the right positions only; a match that it cannot confirm is refused.
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
        Strategy::Gradient => {
            return gradients::match_gradients((left, left.gradients()?), (right, right.gradients()?), expected.nearest, options);
        }
    };
    Ok(refine(set, left, right, options))
}
