//! The steps of a report: each matches the pair in one way.

use super::input::{ReportEdits, ReportImage, ReportTruth};
use super::step::ReportStep;
use super::study::{Study, plan, study};
use super::thinned::{MOST, Thinned};
use crate::{Error, PairHint, PairInput, PairSettings, PairVerdict, PhotoDifference};

/// A report in the making: each step matches the pair in one way.
#[derive(Debug, Clone)]
pub struct Report {
    pub(super) images: [ReportImage; 2],
    pub(super) input: PairInput,
    pub(super) settings: PairSettings,
    pub(super) truth: Option<ReportTruth>,
    pub(super) edits: Option<ReportEdits>,
    pub(super) plan: Vec<(ReportStep, PairSettings)>,
    pub(super) studies: Vec<Study>,
    /// What else would do for this run.
    pub(super) hint: Option<PairHint>,
    /// Points of an image on which strategies are compared.
    pub(super) most_compared: usize,
    /// What these are where the operator finds more.
    pub(super) thinned: Option<Thinned>,
}

impl Report {
    /// A report of a pair; nothing is computed yet.
    pub fn new(images: [ReportImage; 2], input: PairInput, settings: PairSettings, truth: Option<ReportTruth>) -> Self {
        let plan = plan(&settings);
        Self { images, input, settings, truth, edits: None, plan, studies: Vec::new(), hint: None, most_compared: MOST, thinned: None }
    }

    /// The same of matches that were edited by hand: this run is made of them; the other strategies match by themselves.
    #[must_use]
    pub fn edited(mut self, edits: ReportEdits) -> Self {
        self.plan[0].0 = ReportStep::ThisRunEdited;
        Self { edits: Some(edits), ..self }
    }

    /// What each step does, in their order.
    pub fn steps(&self) -> Vec<ReportStep> {
        self.plan.iter().map(|(step, _)| *step).collect()
    }

    /// Does the next step; false when all were done.
    ///
    /// # Errors
    /// As [`match_pair`](crate::match_pair), and those of a truth that does not fit the images.
    pub fn step(&mut self) -> Result<bool, Error> {
        if self.studies.len() == 1 {
            self.thin()?;
        }
        let Some((step, settings)) = self.plan.get(self.studies.len()) else { return Ok(false) };
        let edits = self.edits.as_ref().filter(|_| self.studies.is_empty());
        // What was edited is no result of these settings alone.
        let unedited = self.studies.iter().skip(usize::from(self.edits.is_some()));
        let done = unedited.clone().find(|study| study.settings.resolved() == settings.resolved());
        let study = match done {
            Some(study) => Study { step: *step, ..study.clone() },
            None => {
                let images = self.images.each_ref().map(ReportImage::pair_image);
                study(*step, settings, images, &self.input, (self.truth.as_ref(), edits))?
            }
        };
        if self.studies.is_empty() {
            self.hint = self.hint_for(&study)?;
        }
        self.studies.push(study);
        Ok(true)
    }

    /// The verdict on this run; `None` before the first step.
    pub fn verdict(&self) -> Option<PairVerdict> {
        self.studies.first().map(|study| study.result.verdict())
    }

    /// What else would do for this run.
    fn hint_for(&self, run: &Study) -> Result<Option<PairHint>, Error> {
        let Some(hint) = PairHint::of(&run.result.verdict(), &run.settings) else { return Ok(None) };
        let [left, right] = self.images.each_ref().map(|image| image.grey.view());
        let difference = PhotoDifference::between(left, right)?;
        Ok(Some(difference.map_or(hint, |difference| hint.with(&difference, run.result.offset.as_ref(), &run.settings))))
    }

    /// Has the strategies compared on no more points than end in time.
    fn thin(&mut self) -> Result<(), Error> {
        let compared = &mut self.plan[1..];
        let Some((_, settings)) = compared.first() else { return Ok(()) };
        self.thinned = Thinned::of(self.images.each_ref(), settings, self.most_compared)?;
        if let Some(thinned) = &self.thinned {
            compared.iter_mut().for_each(|(_, settings)| settings.points.clone_from(&thinned.options));
        }
        Ok(())
    }
}
