//! Image observations: residuals, reliability, and what was rejected.

use super::range::{range, ranges, worst};
use super::subject::{Subject, WORST};
use crate::html::{count, fixed, head, histogram, in_unit, percent, significant};
use crate::outputs::precision::written_points;
use crate::{BlockObservation, ObservationStatistics, ObservationVerdict, ReconstructedModel, Texts};
use maud::{Markup, html};

/// An observation with what the adjustment says of it.
type Judged<'a> = (&'a BlockObservation, &'a ObservationStatistics);

fn observations(model: &ReconstructedModel) -> impl Iterator<Item = Judged<'_>> + Clone {
    model.adjusted.block.rays.iter().zip(&model.adjusted.rays)
}

fn accepted(model: &ReconstructedModel) -> impl Iterator<Item = Judged<'_>> + Clone {
    observations(model).filter(|(_, statistics)| statistics.verdict == ObservationVerdict::Accepted)
}

fn length(statistics: &ObservationStatistics) -> f64 {
    libm::hypot(statistics.residual_px[0], statistics.residual_px[1])
}

fn largest_w(statistics: &ObservationStatistics) -> Option<f64> {
    statistics.w.map(|[x, y]| x.abs().max(y.abs()))
}

fn largest(both: [Option<f64>; 2]) -> Option<f64> {
    both.into_iter().flatten().reduce(f64::max)
}

/// Residuals as a histogram, and by the number of rays of their points.
pub(super) fn residuals(texts: &Texts, model: &ReconstructedModel) -> Markup {
    let adjusted = &model.adjusted;
    let values: Vec<f64> = accepted(model).flat_map(|(_, statistics)| statistics.residual_px).collect();
    let sigma = adjusted.sigma0_px.or(adjusted.sigma0_a_priori_px).unwrap_or(adjusted.rmse_px).max(f64::MIN_POSITIVE);
    let figures = [("observations", count(values.len() / 2)), ("sigma0", fixed(adjusted.sigma0_px, 3))];
    let words = texts.with("report-residuals-of", figures);
    html! {
        h2 { (texts.say("report-residuals")) }
        div.pair {
            (histogram(texts, &values, 4.0 * sigma, "px", &words))
            table tabindex="0" {
                caption { (texts.say("report-by-rays")) }
                thead { tr { th { (texts.say("report-rays")) } th { (texts.say("report-points")) } th { (head(texts, "RMSE", "px")) } } }
                tbody { @for group in &adjusted.rmse_by_rays { tr { th { (group.rays) } td { (count(group.points)) } td { (fixed(group.rmse_px, 3)) } } } }
            }
        }
    }
}

/// How well gross errors would be found, and the observations that are worst in that.
pub(super) fn reliability(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let both = |of: &dyn Fn(&ObservationStatistics, usize) -> Option<f64>| {
        range(accepted(model).flat_map(|(_, statistics)| [0, 1].map(|k| of(statistics, k))).flatten())
    };
    let unchecked =
        accepted(model).filter(|(_, statistics)| statistics.redundancy.is_some() && statistics.detectable_px.contains(&None)).count();
    let texts = subject.texts;
    let rows = [
        (texts.say("report-redundancy-number"), both(&|statistics, k| Some(statistics.redundancy?[k]))),
        (in_unit(texts, &texts.say("report-detectable-error"), "px"), both(&|statistics, k| statistics.detectable_px[k])),
        (texts.say("report-influence"), both(&|statistics, k| statistics.influence[k])),
        (in_unit(texts, &texts.say("report-moves-its-point"), "m"), both(&|statistics, k| statistics.moves_point[k])),
        ("|w|".into(), both(&|statistics, k| Some(statistics.w?[k].abs()))),
    ];
    if rows.iter().all(|(_, range)| range.is_none()) {
        return html! { h2 { (texts.say("report-reliability")) } p { (texts.say("report-no-statistics")) } };
    }
    html! {
        h2 { (texts.say("report-reliability")) }
        (ranges(texts, "report-accepted-observations", &rows))
        p.note {
            (texts.say("report-reliability-of-block"))
            @if unchecked > 0 { " " (texts.with("report-unchecked", [("observations", count(unchecked))])) }
        }
        (listed(subject, model, "report-largest-w", worst(accepted(model), WORST, |(_, statistics)| largest_w(statistics))))
        (listed(subject, model, "report-largest-detectable", worst(accepted(model), WORST, |(_, statistics)| {
            largest(statistics.detectable_px)
        })))
        (listed(subject, model, "report-largest-influences", worst(accepted(model), WORST, |(_, statistics)| largest(statistics.influence))))
    }
}

/// What was rejected and why.
pub(super) fn rejected(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let number = |verdict| observations(model).filter(|(_, statistics)| statistics.verdict == verdict).count();
    let by_hand = model.rejected.iter().filter(|ray| ray.by_hand).count();
    let behind = model.rejected.iter().filter(|ray| !ray.by_hand && ray.residual_px.is_none()).count();
    let rows = [
        ("report-did-not-fit", model.rejected.len() - behind - by_hand),
        ("report-lay-behind", behind),
        ("report-by-hand", by_hand),
        ("report-snooped", number(ObservationVerdict::GrossError)),
        ("report-lies-behind", number(ObservationVerdict::Behind)),
        ("report-lost-point", number(ObservationVerdict::LostPoint)),
    ];
    let texts = subject.texts;
    let sum: usize = rows.iter().map(|(_, number)| number).sum();
    let all = model.adjusted.rays.len() + model.rejected.len();
    let snooped = observations(model).filter(|(_, statistics)| statistics.verdict == ObservationVerdict::GrossError);
    let largest = worst(snooped, WORST, |(_, statistics)| Some(largest_w(statistics).unwrap_or_else(|| length(statistics))));
    html! {
        h2 { (texts.say("report-rejected-observations")) }
        p { (texts.with("report-rejected-of", [("rejected", count(sum)), ("observations", count(all)), ("share", percent(sum, all))])) }
        @if sum > 0 {
            table tabindex="0" {
                thead { tr { th { (texts.say("report-reason")) } th { (texts.say("report-observations")) } } }
                tbody { @for (reason, number) in rows { @if number > 0 { tr { th { (texts.say(reason)) } td { (count(number)) } } } } }
            }
        }
        @if !largest.is_empty() { (listed(subject, model, "report-gross-errors", largest)) }
    }
}

fn listed(subject: &Subject<'_>, model: &ReconstructedModel, caption: &str, rows: Vec<Judged<'_>>) -> Markup {
    let (texts, points) = (subject.texts, written_points(model));
    html! {
        table tabindex="0" {
            caption { (texts.say(caption)) }
            thead {
                tr {
                    th { (texts.say("report-image")) } th { (texts.say("report-observed-point")) } @for axis in ["x", "y"] { th { (head(texts, axis, "px")) } }
                    (residual_heads(texts)) th { (texts.say("report-influence")) }
                    @if model.in_system { th { (head(texts, &texts.say("report-moves-by"), "m")) } }
                }
            }
            tbody {
                @for (ray, statistics) in rows {
                    tr {
                        th { (subject.name(model.images[ray.image])) }
                        td { (points[ray.point].map_or_else(|| "–".into(), |point| subject.point(point))) }
                        td { (fixed(ray.x_px, 1)) } td { (fixed(ray.y_px, 1)) }
                        @for value in statistics.residual_px { td { (fixed(value, 3)) } }
                        @for k in 0..2 { td { (fixed(statistics.w.map(|w| w[k]), 2)) } }
                        @for k in 0..2 { td { (fixed(statistics.redundancy.map(|r| r[k]), 3)) } }
                        @for k in 0..2 { td { (significant(statistics.detectable_px[k])) } }
                        td { (significant(largest(statistics.influence))) } @if model.in_system { td { (significant(largest(statistics.moves_point))) } }
                    }
                }
            }
        }
        p.note { (texts.say("report-points-numbered")) }
    }
}

/// The heads of what the adjustment says of an observation: its residuals, tests, redundancy numbers and detectable errors.
pub(super) fn residual_heads(texts: &Texts) -> Markup {
    html! {
        th { (head(texts, &texts.with("report-residual-of", [("axis", "x".into())]), "px")) } th { (head(texts, "y", "px")) }
        th { "w x" } th { "w y" } th { "r x" } th { "r y" } @for name in ["∇ x", "∇ y"] { th { (head(texts, name, "px")) } }
    }
}
