//! Multi-ray points: each a set of features, at most one in an image, that show the same place.

use crate::error::refuse;
use crate::{Error, Refusal};

/// A feature that shows a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeatureObservation {
    pub image: u32,
    /// Index of the feature in its image.
    pub feature: u32,
    /// Probability, 0..1, that it belongs to its point.
    pub confidence: f32,
}

/// The multi-ray points of a block, ordered by their first ray; the rays of a point are ordered by image.
#[derive(Debug, Clone, PartialEq)]
pub struct TiePoints {
    /// The first ray of each point, and the number of all rays.
    starts: Vec<u32>,
    rays: Vec<FeatureObservation>,
    confidence: Vec<f32>,
}

impl Default for TiePoints {
    fn default() -> Self {
        Self { starts: vec![0], rays: Vec::new(), confidence: Vec::new() }
    }
}

impl TiePoints {
    pub(crate) fn with_capacity(points: usize, rays: usize) -> Self {
        let mut new = Self { rays: Vec::with_capacity(rays), confidence: Vec::with_capacity(points), ..Self::default() };
        new.starts.reserve(points);
        new
    }

    pub(crate) fn push(&mut self, rays: impl Iterator<Item = FeatureObservation>, confidence: f32) {
        self.rays.extend(rays);
        self.starts.push(self.rays.len() as u32);
        self.confidence.push(confidence);
    }

    /// Some of the points by themselves, in the order of `chosen`.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an index beyond the last point.
    pub fn some(&self, chosen: &[u32]) -> Result<Self, Error> {
        let mut some = Self::with_capacity(chosen.len(), 0);
        for index in chosen {
            if *index as usize >= self.len() {
                return refuse(Refusal::NoTiePoint { point: *index as usize, points: self.len() });
            }
            some.push(self.rays(*index as usize).iter().copied(), self.confidence(*index as usize));
        }
        Ok(some)
    }

    /// How many points there are.
    pub fn len(&self) -> usize {
        self.confidence.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.confidence.is_empty()
    }

    /// How many rays all points have together.
    pub fn ray_count(&self) -> usize {
        self.rays.len()
    }

    /// The rays of a point; none for an index beyond the last point.
    pub fn rays(&self, point: usize) -> &[FeatureObservation] {
        match (self.starts.get(point), self.starts.get(point + 1)) {
            (Some(first), Some(end)) => &self.rays[*first as usize..*end as usize],
            _ => &[],
        }
    }

    /// Probability, 0..1, that all its rays belong together; 0 beyond the last point.
    pub fn confidence(&self, point: usize) -> f32 {
        self.confidence.get(point).copied().unwrap_or(0.0)
    }

    /// The rays of all points, one after another.
    pub fn iter(&self) -> impl Iterator<Item = &[FeatureObservation]> {
        (0..self.len()).map(|point| self.rays(point))
    }
}
