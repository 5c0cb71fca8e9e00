//! The images of a pair, with what their points are compared by.

use crate::error::refuse;
use crate::{DescribedBy, Descriptor, Error, GreyView, InterestPoint, LocalFrame, Refusal};

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
    pub(super) fn moments(&self) -> Result<&'a [Option<Descriptor>], Error> {
        match self.descriptors {
            Descriptors::Moments(moments) => Ok(moments),
            _ => refuse(Refusal::NoMoments { described: self.described(), points: self.points.len() }),
        }
    }

    pub(super) fn gradients(&self) -> Result<&'a [u8], Error> {
        match self.descriptors {
            Descriptors::Gradients(bytes) if bytes.len() == self.points.len() * super::DESCRIPTOR_BYTES => Ok(bytes),
            _ => refuse(Refusal::NoGradients { described: self.described(), points: self.points.len() }),
        }
    }

    fn described(&self) -> DescribedBy {
        match self.descriptors {
            Descriptors::None => DescribedBy::None,
            Descriptors::Moments(moments) => DescribedBy::Moments { descriptors: moments.len() },
            Descriptors::Gradients(bytes) => DescribedBy::Gradients { bytes: bytes.len() },
        }
    }
}
