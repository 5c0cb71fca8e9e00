//! What a report is about.

use crate::outputs::in_system::InSystem;
use crate::outputs::pairs::PairRow;
use crate::outputs::precision::written;
use crate::outputs::summary::Summary;
use crate::text::shorten;
use crate::{BlockRun, Factors95, ReconstructedModel, SurveyedPoint, Texts};
use std::borrow::Cow;

/// Rows of a list of the worst.
pub(super) const WORST: usize = 15;
/// Rows of a list that names all where there are not too many.
pub(super) const NAMED: usize = 100;

/// A finished block with what the other files say of it.
pub(super) struct Subject<'a> {
    pub texts: &'a Texts,
    pub run: &'a BlockRun,
    pub summary: &'a Summary,
    pub pairs: &'a [PairRow],
    /// Of the points that are written.
    pub numbers: Vec<u32>,
    /// The model that is written; absent without an orientation.
    pub model: Option<&'a ReconstructedModel>,
    /// Its surveyed points in the system of the tables.
    pub surveyed: Cow<'a, [SurveyedPoint]>,
}

impl<'a> Subject<'a> {
    pub fn new(texts: &'a Texts, run: &'a BlockRun, summary: &'a Summary, pairs: &'a [PairRow]) -> Self {
        Self { texts, run, summary, pairs, numbers: run.model.point_numbers(), model: written(run), surveyed: InSystem::of(run).surveyed() }
    }

    /// By what its standard errors grow for 95 %; absent without any.
    pub fn factors_95(&self) -> Option<Factors95> {
        self.model.and_then(|model| model.adjusted.factors_95())
    }

    /// The name of an image of the block.
    pub fn name(&self, image: usize) -> String {
        self.run.images.get(image).map_or_else(String::new, |image| shorten(&image.name))
    }

    /// The number of a point, with its name where it was surveyed. `point`: its place in the model that is written.
    pub fn point(&self, point: usize) -> String {
        let number = self.numbers[point];
        match self.run.model.points.get(point).and_then(|point| point.name.as_ref()) {
            Some(name) => format!("{number} ({})", shorten(name)),
            None => number.to_string(),
        }
    }

    /// The unit of lengths of the model that is written.
    pub fn unit(&self) -> String {
        if self.model.is_some_and(|model| model.in_system) { self.texts.unit("m") } else { self.texts.say("report-model-units") }
    }
}
