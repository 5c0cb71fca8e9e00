//! The report of a block: one self-contained HTML page, of bounded size for blocks of any size.

mod cameras;
mod field;
mod head;
mod images;
mod interval;
mod observations;
mod plan;
mod plane;
mod positions;
mod range;
mod subject;

use super::pairs::PairRow;
use super::summary::Summary;
use crate::html::{page, settings_table};
use crate::{BlockRun, BlockSettings};
use maud::html;
use subject::Subject;

/// `report.html`. Its figures are those of the summary and of the model that is written.
pub(super) fn block_report(run: &BlockRun, summary: &Summary, pairs: &[PairRow]) -> String {
    let subject = Subject::new(run, summary, pairs);
    let content = html! {
        (head::head(&subject))
        (head::remarks(&subject))
        @if let Some(plan) = plan::plan(&subject) { h2 { "Projection centres and connections" } (plan) }
        @if let Some(model) = subject.model {
            (images::precision(&subject, model))
            (cameras::cameras(&subject, model))
            (positions::gnss(&subject, model))
            (positions::systematic(&subject, model))
            (positions::control(&subject, model))
            (positions::components(model))
            (observations::residuals(model))
            (observations::reliability(&subject, model))
            (observations::rejected(&subject, model))
        }
        (images::left_out(&subject))
        h2 { "Parameters" }
        (settings_table(BlockSettings::parameters(), &run.input.settings, &BlockSettings::default()))
        footer { "Tiepoint " (env!("CARGO_PKG_VERSION")) ". The same images and parameters give the same report." }
    };
    page(&format!("Tiepoint report: block of {} images", run.images.len()), &content).into_string()
}
