//! What sets the tables of a pair apart from those that the paper printed, and why.

use super::input::ReportTruth;
use super::paper::PAPER;
use super::step::ReportStep;
use super::steps::Report;
use super::study::Study;
use super::unknowns::{PRINTED_DIGITS, UNKNOWNS, five};
use crate::html::{count, digits_of_error, fixed, percent, quantity, said, significant};
use crate::{Denominator, MatchOptions, Texts};
use maud::{Markup, html};

/// Each reason with the figure that shows it on this pair.
pub fn differences(texts: &Texts, report: &Report) -> Markup {
    let Some(moments) = report.studies.iter().find(|study| study.step == ReportStep::Moments) else { return html! {} };
    html! {
        h3 { (texts.say("report-differs")) }
        ul {
            li { (of_pairs(texts, report.truth.as_ref())) }
            li { (of_matches(texts, moments)) }
            li { (of_precision(texts, moments)) }
            li {
                (texts.say("report-orientations-differ"))
                @if let Some((study, unknown, times)) = worst_ratio(report) {
                    @let figures = [("times", fixed(times, 1)), ("unknown", UNKNOWNS[unknown].0.into()), ("step", said(texts, &study.step))];
                    " " (texts.with("report-largest-true-error", figures))
                }
            }
        }
    }
}

fn of_pairs(texts: &Texts, truth: Option<&ReportTruth>) -> Markup {
    html! { (texts.say("report-pair")) " " (texts.say(if truth.is_some() { "report-pair-simulated" } else { "report-pair-other" })) }
}

fn of_matches(texts: &Texts, moments: &Study) -> String {
    let (matches, points) = (moments.result.matching.matches.len(), moments.result.left.points.len());
    let denominator = match moments.settings.matching.denominator {
        Denominator::Maxabs => "report-denominator-larger",
        Denominator::Floor => "report-denominator-median",
    };
    let figures = [
        ("denominator", texts.say(denominator)),
        ("inconsistent", texts.say(inconsistent(&moments.settings.matching))),
        ("matches", count(matches)),
        ("points", count(points)),
        ("share", percent(matches, points)),
        ("paper_matches", count(PAPER.points[2][0])),
        ("paper_points", count(PAPER.points[1][0])),
        ("paper_share", percent(PAPER.points[2][0], PAPER.points[1][0])),
    ];
    texts.with("report-matches-differ", figures)
}

/// Which matches the rules of consistency refuse, of those that are switched on: the name of its text.
fn inconsistent(options: &MatchOptions) -> &'static str {
    match (options.ambiguity() < 1.0, options.parallax_neighbours > 0) {
        (true, true) => "report-ambiguous-many-parallax",
        (true, false) => "report-ambiguous-many",
        (false, true) => "report-many-parallax",
        (false, false) => "report-many",
    }
}

fn of_precision(texts: &Texts, moments: &Study) -> Markup {
    html! {
        (texts.say("report-sigma-of-paper")) " "
        @if let Some(sigma0) = moments.sigma0_px() { (texts.with("report-sigma-here", [("sigma0", fixed(sigma0, 2))])) }
        @else { (texts.say("report-pair-not-oriented")) }
        @if let Some(sigma0) = moments.sigma0_of_all_px() { (texts.with("report-sigma-of-all-here", [("sigma0", fixed(sigma0, 2))])) }
        ". "
        @if let Some(scaled) = moments.standard_errors_at(PAPER.sigma0_mm, PAPER.points[2][0]) {
            (texts.say("report-errors-grow")) " "
            @for k in 0..5 { @if k > 0 { (texts.say("report-separator")) } (beside_printed(texts, k, scaled[k])) }
            ". "
            @let times = std::array::from_fn::<f64, 5, _>(|k| five(&PAPER.standard_errors)[k] / scaled[k]);
            @let [least, most] = [times.into_iter().fold(f64::INFINITY, f64::min), times.into_iter().fold(0.0, f64::max)].map(significant);
            (texts.with("report-printed-times", [("least", least), ("most", most)]))
        }
    }
}

/// The standard error of an unknown beside that of the paper.
fn beside_printed(texts: &Texts, unknown: usize, error: f64) -> Markup {
    let (symbol, unit) = UNKNOWNS[unknown];
    let value = fixed(error, digits_of_error(error, PRINTED_DIGITS));
    let value = if unit == "°" { value + unit } else { quantity(texts, value, unit) };
    let printed = fixed(five(&PAPER.standard_errors)[unknown], PRINTED_DIGITS);
    html! { i { (symbol) } " " (texts.with("report-beside-printed", [("value", value), ("printed", printed)])) }
}

/// The largest true error: of which strategy and unknown, and how many of its standard errors it is.
fn worst_ratio(report: &Report) -> Option<(&Study, usize, f64)> {
    let ratios = report.studies.iter().flat_map(|study| {
        let standard = study.result.orientation.as_ref().ok().and_then(|o| o.total_standard_errors.or(o.standard_errors)).map(|e| five(&e));
        let pairs = study.errors.zip(standard).into_iter();
        pairs.flat_map(move |(e, s)| (0..5).map(move |k| (study, k, (e[k] / s[k]).abs())))
    });
    ratios.filter(|(_, _, ratio)| ratio.is_finite()).max_by(|a, b| a.2.total_cmp(&b.2))
}
