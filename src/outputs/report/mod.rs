//! The report of a block: one self-contained HTML page, of bounded size for blocks of any size.

mod cameras;
mod components;
mod control;
mod field;
mod gnss;
mod head;
mod images;
mod interval;
mod observations;
mod plan;
mod plane;
mod priors;
mod range;
mod subject;

use super::pairs::PairRow;
use super::summary::Summary;
use crate::html::{footer, page, settings_table};
use crate::{BlockRun, BlockSettings, Texts};
use maud::html;
use subject::Subject;

/// `report.html` in the language of these texts. Its figures are those of the summary and of the model that is written.
pub(super) fn block_report(texts: &Texts, run: &BlockRun, summary: &Summary, pairs: &[PairRow]) -> String {
    let subject = Subject::new(texts, run, summary, pairs);
    let content = html! {
        (head::head(&subject))
        (head::remarks(&subject))
        @if let Some(plan) = plan::plan(&subject) { h2 { (texts.say("report-plan")) } (plan) }
        @if let Some(model) = subject.model {
            (images::precision(&subject, model))
            (cameras::cameras(&subject, model))
            (gnss::gnss(&subject, model))
            (gnss::systematic(&subject, model))
            (control::control(&subject, model))
            (components::components(texts, model))
            (observations::residuals(texts, model))
            (observations::reliability(&subject, model))
            (observations::rejected(&subject, model))
        }
        (images::left_out(&subject))
        h2 { (texts.say("report-settings")) }
        (settings_table(texts, BlockSettings::parameters(), &run.input.settings, &BlockSettings::default()))
        (footer(texts))
    };
    page(texts, &texts.with("report-block-title", [("images", run.images.len().to_string())]), &content).into_string()
}
