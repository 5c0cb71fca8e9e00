//! GNSS positions of images, and their systematic errors.

use super::interval::with_interval;
use super::priors::{AXES, judged, judged_head, largest_w, length, observed};
use super::range::{Named, range, ranges, worst};
use super::subject::{Subject, WORST};
use crate::html::{count, fixed, head, in_unit, said, significant};
use crate::{PriorStatistics, ReconstructedModel};
use maud::{Markup, html};

/// GNSS positions that the datum uses; nothing without any.
pub(super) fn gnss(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let all: Vec<(usize, &PriorStatistics)> = model
        .images
        .iter()
        .zip(&model.adjusted.images)
        .filter_map(|(image, statistics)| Some((*image, statistics.gnss.as_ref()?)))
        .collect();
    if all.is_empty() {
        return html! {};
    }
    let texts = subject.texts;
    let is_in_strips = model.adjusted.systematic.as_ref().is_some_and(|systematic| !systematic.left_out.is_empty());
    let accepted: Vec<&PriorStatistics> = all.iter().map(|(_, prior)| *prior).filter(|prior| prior.accepted).collect();
    let took_part = match (accepted.len() < all.len(), is_in_strips) {
        (false, _) => "report-all-took-part",
        (true, false) => "report-part-took-part",
        (true, true) => "report-part-took-part-in-strips",
    };
    let of = |of: &dyn Fn(&PriorStatistics, usize) -> Option<f64>, k: usize| range(accepted.iter().filter_map(|prior| of(prior, k)));
    let name = |name: &str, k: usize| texts.with(name, [("axis", AXES[k].into())]);
    let in_m = |of: &str, k: usize| in_unit(texts, &name(of, k), "m");
    let redundancy = |prior: &PriorStatistics, k: usize| prior.redundancy.filter(|_| observed(prior, k)).map(|r| r[k]);
    let rows: Vec<Named> = (0..3)
        .flat_map(|k| {
            [
                (in_m("report-absolute-residual", k), of(&|prior, k| observed(prior, k).then(|| prior.residual[k].abs()), k)),
                (name("report-redundancy-of", k), of(&redundancy, k)),
                (in_m("report-detectable-error-of", k), of(&|prior, k| prior.detectable[k], k)),
                (in_m("report-moves-of", k), of(&|prior, k| prior.moves[k], k)),
                (name("report-influence-of", k), of(&|prior, k| prior.influence[k], k)),
            ]
        })
        .collect();
    let listed = worst(all.iter(), WORST, |(_, prior)| Some(largest_w(prior).unwrap_or_else(|| length(prior.residual))));
    html! {
        h2 { (texts.say("report-gnss")) }
        p { (texts.with(took_part, [("part", count(accepted.len())), ("all", count(all.len()))])) }
        (ranges(texts, "report-gnss-that-took-part", &rows))
        table tabindex="0" {
            caption { (texts.say(if listed.len() < all.len() { "report-largest-w" } else { "report-all-gnss" })) }
            (judged_head(texts, &["report-image"]))
            tbody {
                @for (image, prior) in listed {
                    @let state = if prior.accepted { "report-state-used" } else { "report-state-rejected" };
                    tr { th { (subject.name(*image)) } (judged(prior)) td { (texts.say(state)) } }
                }
            }
        }
        p.note { (texts.say("report-gnss-residuals")) }
    }
}

/// Systematic errors of GNSS positions; nothing where none were to be estimated.
pub(super) fn systematic(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let Some(systematic) = model.adjusted.systematic.as_ref().filter(|systematic| !systematic.errors.is_empty()) else {
        return html! {};
    };
    let (texts, factors) = (subject.texts, subject.factors_95());
    html! {
        h2 { (texts.say("report-systematic")) }
        table tabindex="0" {
            thead {
                tr {
                    th { (texts.say("report-error")) } @for axis in AXES { th { (head(texts, axis, "m")) } }
                    @for axis in AXES { th { (head(texts, &format!("σ {axis}"), "m")) (texts.say("report-and-95")) } }
                    @for name in ["report-test", "report-limit", "report-state"] { th { (texts.say(name)) } }
                }
            }
            tbody {
                @for error in &systematic.errors {
                    tr {
                        th { (said(texts, &error.error)) }
                        @for axis in 0..3 { td { (significant(error.value(axis))) } }
                        @for value in error.standard_errors { td { (with_interval(value, factors)) } }
                        td { (fixed(error.test, 2)) } td { (fixed(error.limit, 2)) } td { (said(texts, &error.verdict)) }
                    }
                }
            }
        }
        @for (number, strip) in systematic.strips.iter().enumerate() {
            @if let [Some(first), Some(last)] = [strip.images.first(), strip.images.last()].map(|image| Some(subject.name(model.images[*image?]))) {
                @let figures = [("number", (number + 1).to_string()), ("images", strip.images.len().to_string()), ("first", first), ("last", last)];
                p { (texts.with("report-strip", figures)) }
            }
        }
        p.note {
            (texts.say("report-systematic-explained"))
            @if systematic.constraints > 0 { " " (texts.say("report-few-control")) }
        }
    }
}
