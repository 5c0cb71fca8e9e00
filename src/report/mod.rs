//! The report of a pair: one self-contained HTML page with pictures, tables of all strategies, residuals, reliability and parameters.

mod details;
mod figures;
mod paper;
mod picture;
mod study;
mod tables;
mod text;

use crate::{Error, ExifCamera, FiveParameters, GreyImage, PairImage, PairInput, PairSettings};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use picture::Layer;
use study::Study;
use text::{count, fixed};

/// An image of the report.
#[derive(Debug, Clone)]
pub struct ReportImage {
    pub name: String,
    pub grey: GreyImage,
    pub exif: Option<ExifCamera>,
    /// As large as the image: points whose pixel is 0 in it are left out.
    pub mask: Option<GreyImage>,
}

impl ReportImage {
    /// The image as matching takes it.
    fn pair_image(&self) -> PairImage<'_> {
        PairImage { grey: self.grey.view(), exif: self.exif.as_ref(), mask: self.mask.as_ref().map(GreyImage::view) }
    }

    /// How many of the image's pixels its mask leaves out.
    fn left_out(&self) -> Option<usize> {
        self.mask.as_ref().map(|mask| mask.data().iter().filter(|value| **value == 0).count())
    }
}

/// The known answer of a simulated pair.
#[derive(Debug, Clone)]
pub struct ReportTruth {
    pub orientation: FiveParameters,
    /// The base that gives `by` and `bz` of the orientation their scale, in mm.
    pub base_mm: f64,
    /// As [`Sample::right_position`](crate::Sample::right_position).
    pub right_position: Vec<[f32; 2]>,
}

impl ReportTruth {
    /// The orientation with `by` and `bz` at the scale of another base; they are not finite where the true base is 0, which has no scale.
    fn orientation_at(&self, base_mm: f64) -> FiveParameters {
        let scale = base_mm / self.base_mm;
        let FiveParameters { by_mm, bz_mm, .. } = self.orientation;
        FiveParameters { by_mm: scale * by_mm, bz_mm: scale * bz_mm, ..self.orientation }
    }
}

/// A report in the making: each step matches the pair in one way.
#[derive(Debug, Clone)]
pub struct Report {
    images: [ReportImage; 2],
    input: PairInput,
    settings: PairSettings,
    truth: Option<ReportTruth>,
    plan: Vec<(&'static str, PairSettings)>,
    studies: Vec<Study>,
}

impl Report {
    /// A report of a pair; nothing is computed yet.
    pub fn new(images: [ReportImage; 2], input: PairInput, settings: PairSettings, truth: Option<ReportTruth>) -> Self {
        let plan = study::plan(&settings);
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
        let done = self.studies.iter().find(|study| study.settings == *settings);
        let study = match done {
            Some(study) => Study { name, ..study.clone() },
            None => {
                let images = self.images.each_ref().map(ReportImage::pair_image);
                study::study(name, settings, images, &self.input, self.truth.as_ref())?
            }
        };
        self.studies.push(study);
        Ok(true)
    }

    /// The page. Does the steps that are left.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn html(&mut self) -> Result<String, Error> {
        while self.step()? {}
        Ok(self.page()?.into_string())
    }

    fn page(&self) -> Result<Markup, Error> {
        /// Whatever names and texts a report quotes: it runs no script and loads nothing.
        const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";
        let [left, right] = &self.images;
        let run = &self.studies[0];
        let title = format!("Tiepoint report: {}, {}", left.name, right.name);
        Ok(html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(POLICY);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { (title) }
                    style { (PreEscaped(include_str!("style.css"))) }
                }
                body {
                    h1 { (title) }
                    (self.summary())
                    h2 { "Images, points and matches" }
                    (self.pictures())
                    h2 { "All strategies on the same points" }
                    (tables::counts(self))
                    (tables::refusals(self))
                    @if self.truth.is_some() { (tables::scores(self)) }
                    (tables::standard_errors(self))
                    (tables::orientations(self))
                    (tables::differences(self))
                    h2 { "Interior orientation" }
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
                    (details::settings(&self.settings))
                    footer { "Tiepoint " (env!("CARGO_PKG_VERSION")) ". The same images and parameters give the same report." }
                }
            }
        })
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
                        li { "A mask leaves out " (text::percent(pixels, image.grey.data().len())) " of the " (side) " image." }
                    }
                }
                li { (count(matches.len())) " matches of " (count(run.result.left.points.len())) " left points by this run's strategy." }
                @match &run.result.orientation {
                    Ok(o) => li { "Oriented with " (count(run.used())) " matches, σ₀ " (fixed(run.sigma0_px(), 3)) " px; " (count(o.rejected.len())) " gross errors left out." }
                    Err(reason) => li { "Not oriented: " (reason) "." }
                }
                @if let Some(score) = &run.score {
                    li { (text::percent(score.right, matches.len())) " of the matches are right by the truth of the simulated pair." }
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
            picture::dots(kept.map(|(m, _)| if right { m.right_px } else { m.left_px }))
        };
        let side = |index: usize| {
            let points = if index == 0 { &result.left.points } else { &result.right.points };
            let layers = [
                Layer { class: "dot", path: picture::dots(points.iter().map(|p| [p.x, p.y])) },
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
                @if self.images.iter().any(|image| image.mask.is_some()) { " " span style="color: #d82828" { "■" } " left out by a mask" }
            }
        }
    }
}
