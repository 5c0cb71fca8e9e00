//! The steps of a report: each matches the pair in one way.

use super::input::{ReportImage, ReportTruth};
use super::study::{Study, plan, study};
use crate::{Error, PairInput, PairSettings};

/// A report in the making: each step matches the pair in one way.
#[derive(Debug, Clone)]
pub struct Report {
    pub(super) images: [ReportImage; 2],
    pub(super) input: PairInput,
    pub(super) settings: PairSettings,
    pub(super) truth: Option<ReportTruth>,
    pub(super) plan: Vec<(&'static str, PairSettings)>,
    pub(super) studies: Vec<Study>,
}

impl Report {
    /// A report of a pair; nothing is computed yet.
    pub fn new(images: [ReportImage; 2], input: PairInput, settings: PairSettings, truth: Option<ReportTruth>) -> Self {
        let plan = plan(&settings);
        Self { images, input, settings, truth, plan, studies: Vec::new() }
    }

    /// What each step does, in their order.
    pub fn steps(&self) -> Vec<&'static str> {
        self.plan.iter().map(|(name, _)| *name).collect()
    }

    /// Does the next step; false when all were done.
    ///
    /// # Errors
    /// As [`match_pair`](crate::match_pair), and those of a truth that does not fit the images.
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some((name, settings)) = self.plan.get(self.studies.len()) else { return Ok(false) };
        let done = self.studies.iter().find(|study| study.settings.resolved() == settings.resolved());
        let study = match done {
            Some(study) => Study { name, ..study.clone() },
            None => {
                let images = self.images.each_ref().map(ReportImage::pair_image);
                study(name, settings, images, &self.input, self.truth.as_ref())?
            }
        };
        self.studies.push(study);
        Ok(true)
    }
}
