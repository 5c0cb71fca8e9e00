//! The page of a report.

use super::input::ReportImage;
use super::picture::{self, Layer};
use super::steps::Report;
use super::thinned::Thinned;
use super::{camera, details, differences, tables};
use crate::html::{count, dots, fixed, footer, page, percent, said, settings_table, typeset};
use crate::{Error, GreyImage, PairSettings, Texts};
use maud::{Markup, html};

impl Report {
    /// The page in the language of these texts. Does the steps that are left.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn html(&mut self, texts: &Texts) -> Result<String, Error> {
        while self.step()? {}
        Ok(self.page(texts)?.into_string())
    }

    fn page(&self, texts: &Texts) -> Result<Markup, Error> {
        let [left, right] = &self.images;
        let run = &self.studies[0];
        let content = html! {
            (self.summary(texts))
            h2 { (texts.say("report-images-points-and-matches")) }
            (self.pictures(texts))
            h2 { (texts.say("report-all-strategies")) }
            @if let Some(thinned) = &self.thinned { p { (compared_on(texts, thinned)) } }
            (tables::counts(texts, self))
            (tables::refusals(texts, self))
            @if self.truth.is_some() { (tables::scores(texts, self)) }
            (tables::standard_errors(texts, self))
            (tables::orientations(texts, self))
            (differences::differences(texts, self))
            h2 { (texts.say("report-interior-orientation")) }
            (camera::cameras(texts, self)?)
            (details::interior(texts, self)?)
            h2 { (texts.say("report-relative-orientation")) }
            @match &run.result.orientation {
                Ok(orientation) => {
                    (details::precision(texts, self, orientation))
                    h2 { (texts.say("report-residuals")) }
                    (details::residuals(texts, self, orientation))
                    h2 { (texts.say("report-reliability")) }
                    (details::reliability(texts, self, orientation))
                }
                Err(reason) => p { (texts.with("report-not-oriented", [("reason", said(texts, reason))])) }
            }
            h2 { (texts.say("report-settings")) }
            (settings_table(texts, PairSettings::parameters(), &self.settings, &PairSettings::default()))
            (footer(texts))
        };
        let title = texts.with("report-title", [("left", left.name.clone()), ("right", right.name.clone())]);
        Ok(page(texts, &title, &content))
    }

    fn summary(&self, texts: &Texts) -> Markup {
        let run = &self.studies[0];
        let size = |image: &ReportImage| {
            let size = format!("{} × {}", count(image.grey.width()), count(image.grey.height()));
            texts.with("report-size", [("name", image.name.clone()), ("size", size)])
        };
        let [left, right] = self.images.each_ref().map(size);
        let matches = run.result.matching.matches.len();
        html! {
            ul.summary {
                li { (texts.with("report-sizes", [("left", left), ("right", right)])) }
                @for (image, name) in self.images.iter().zip(["report-mask-of-left", "report-mask-of-right"]) {
                    @if let Some(pixels) = image.left_out() {
                        li { (texts.with(name, [("share", percent(pixels, image.grey.data().len()))])) }
                    }
                }
                li { (texts.with("report-matches-of-points", [("matches", count(matches)), ("points", count(run.result.left.points.len()))])) }
                @if let Some(edits) = &self.edits {
                    li { (texts.with("report-edits-of-pair", [("rejected", count(edits.rejected)), ("measured", count(edits.measured))])) }
                }
                li { strong { (typeset(&said(texts, &run.result.verdict()))) } }
                @if let Some(hint) = &self.hint { li { (typeset(&said(texts, hint))) } }
                @if let Ok(o) = &run.result.orientation {
                    @let figures = [("used", count(run.used().unwrap_or(0))), ("sigma0", fixed(run.sigma0_px(), 3)), ("rejected", count(o.rejected.len()))];
                    li { (texts.with("report-took-part", figures)) }
                }
                @if let Some(score) = &run.score {
                    li { (texts.with("report-right-by-truth", [("share", percent(score.right, matches))])) }
                }
            }
        }
    }

    /// Both images with their points, matched, rejected and refused.
    fn pictures(&self, texts: &Texts) -> Markup {
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
            let figures = [("name", image.name.clone()), ("points", count(points.len())), ("matches", count(matches.len()))];
            let words = texts.with("report-points-and-matches", figures);
            let ground =
                picture::Ground::Grey(["left-image", "right-image"][index], image.grey.view(), image.mask.as_ref().map(GreyImage::view));
            html! { figure { (picture::picture(&ground, &layers, &words)) figcaption { (words) } } }
        };
        html! {
            div.pair { (side(0)) (side(1)) }
            p.legend {
                span.matched { "●" } " " (texts.say("report-legend-matched")) " "
                span.rejected { "●" } " " (texts.say("report-state-gross-error")) " "
                span.other { "●" } " " (texts.say("report-legend-other"))
                @if self.images.iter().any(|image| image.mask.is_some()) {
                    " " span style="color: #d82828" { "■" } " " (texts.say("report-legend-masked"))
                }
            }
        }
    }
}

/// Which points the strategies are compared on, where these are not all.
fn compared_on(texts: &Texts, Thinned { options, found: [left, right], taken }: &Thinned) -> String {
    let figures = [
        ("left_taken", count(taken[0])),
        ("left", count(*left)),
        ("right_taken", count(taken[1])),
        ("right", count(*right)),
        ("window", count(options.suppression_window)),
    ];
    texts.with("report-compared-on", figures)
}
