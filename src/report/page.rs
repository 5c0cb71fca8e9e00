//! The page of a report.

use super::input::ReportImage;
use super::picture::{self, Layer};
use super::steps::Report;
use super::{camera, details, tables};
use crate::html::{count, dots, fixed, page, percent, settings_table, typeset};
use crate::{Error, GreyImage, PairSettings};
use maud::{Markup, html};

impl Report {
    /// The page. Does the steps that are left.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn html(&mut self) -> Result<String, Error> {
        while self.step()? {}
        Ok(self.page()?.into_string())
    }

    fn page(&self) -> Result<Markup, Error> {
        let [left, right] = &self.images;
        let run = &self.studies[0];
        let content = html! {
            (self.summary())
            h2 { "Images, points and matches" }
            (self.pictures())
            h2 { "All strategies" }
            (tables::counts(self))
            (tables::refusals(self))
            @if self.truth.is_some() { (tables::scores(self)) }
            (tables::standard_errors(self))
            (tables::orientations(self))
            (tables::differences(self))
            h2 { "Interior orientation" }
            (camera::cameras(self)?)
            (details::interior(self)?)
            h2 { "Relative orientation of this run" }
            @match &run.result.orientation {
                Ok(orientation) => {
                    (details::precision(self, orientation))
                    h2 { "Residuals" }
                    (details::residuals(self, orientation))
                    h2 { "Reliability" }
                    (details::reliability(self, orientation))
                }
                Err(reason) => p { "Not oriented: " (reason) "." }
            }
            h2 { "Parameters" }
            (settings_table(PairSettings::parameters(), &self.settings, &PairSettings::default()))
            footer { "Tiepoint " (env!("CARGO_PKG_VERSION")) ". The same images and parameters give the same report." }
        };
        Ok(page(&format!("Tiepoint report: {}, {}", left.name, right.name), &content))
    }

    fn summary(&self) -> Markup {
        let run = &self.studies[0];
        let size = |image: &ReportImage| format!("{}: {} × {} px", image.name, count(image.grey.width()), count(image.grey.height()));
        let matches = &run.result.matching.matches;
        html! {
            ul.summary {
                li { "Left " (size(&self.images[0])) "; right " (size(&self.images[1])) "." }
                @for (image, side) in self.images.iter().zip(["left", "right"]) {
                    @if let Some(pixels) = image.left_out() {
                        li { "A mask leaves out " (percent(pixels, image.grey.data().len())) " of the " (side) " image." }
                    }
                }
                li { (count(matches.len())) " matches of " (count(run.result.left.points.len())) " left points by this run's strategy." }
                @if let Some(edits) = &self.edits {
                    li {
                        "Edits by hand: " (count(edits.rejected)) " matches rejected, " (count(edits.measured)) " measured. This run is that of the edited "
                        "matches; the other strategies match by themselves."
                    }
                }
                li { strong { (typeset(&run.result.verdict().to_string())) } }
                @if let Ok(o) = &run.result.orientation {
                    li { (count(run.used())) " matches took part, σ₀ " (fixed(run.sigma0_px(), 3)) " px; " (count(o.rejected.len())) " gross errors rejected." }
                }
                @if let Some(score) = &run.score {
                    li { (percent(score.right, matches.len())) " of the matches are right by the truth of the simulated pair." }
                }
            }
        }
    }

    /// Both images with their points, matched, rejected and refused.
    fn pictures(&self) -> Markup {
        let result = &self.studies[0].result;
        let matches = &result.matching.matches;
        let mut rejected = vec![false; matches.len()];
        result.orientation.iter().flat_map(|o| &o.rejected).for_each(|i| rejected[*i] = true);
        let of = |wanted: bool, right: bool| {
            let kept = matches.iter().zip(&rejected).filter(move |(_, r)| **r == wanted);
            dots(kept.map(|(m, _)| if right { m.right_px } else { m.left_px }))
        };
        let side = |index: usize| {
            let points = if index == 0 { &result.left.points } else { &result.right.points };
            let layers = [
                Layer { class: "dot", path: dots(points.iter().map(|p| [p.x, p.y])) },
                Layer { class: "dot matched", path: of(false, index == 1) },
                Layer { class: "dot rejected", path: of(true, index == 1) },
            ];
            let image = &self.images[index];
            let words = format!("{}: {} points, {} matches", image.name, count(points.len()), count(matches.len()));
            let ground =
                picture::Ground::Grey(["left-image", "right-image"][index], image.grey.view(), image.mask.as_ref().map(GreyImage::view));
            html! { figure { (picture::picture(&ground, &layers, &words)) figcaption { (words) } } }
        };
        html! {
            div.pair { (side(0)) (side(1)) }
            p.legend { span.matched { "●" } " matched " span.rejected { "●" } " gross error " span.other { "●" } " other interest point"
                @if self.images.iter().any(|image| image.mask.is_some()) { " " span style="color: #d82828" { "■" } " masked out" }
            }
        }
    }
}
