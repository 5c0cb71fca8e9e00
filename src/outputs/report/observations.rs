//! Image observations: residuals, reliability, and what was rejected.

use super::range::{range, ranges, worst};
use super::subject::{Subject, WORST};
use crate::html::{count, fixed, histogram, percent, significant};
use crate::outputs::precision::written_points;
use crate::{BlockObservation, ObservationStatistics, ObservationVerdict, ReconstructedModel};
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
pub(super) fn residuals(model: &ReconstructedModel) -> Markup {
    let adjusted = &model.adjusted;
    let values: Vec<f64> = accepted(model).flat_map(|(_, statistics)| statistics.residual_px).collect();
    let sigma = adjusted.sigma0_px.or(adjusted.sigma0_a_priori_px).unwrap_or(adjusted.rmse_px).max(f64::MIN_POSITIVE);
    let words = format!(
        "Residuals of {} accepted observations, columns and rows; σ₀ is {} px",
        count(values.len() / 2),
        fixed(adjusted.sigma0_px, 3)
    );
    html! {
        h2 { "Residuals" }
        div.pair {
            (histogram(&values, 4.0 * sigma, "px", &words))
            table tabindex="0" {
                caption { "By the number of rays of their points" }
                thead { tr { th { "Rays" } th { "points" } th { "RMSE px" } } }
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
    let rows = [
        ("redundancy number r", both(&|statistics, k| Some(statistics.redundancy?[k]))),
        ("detectable error, px", both(&|statistics, k| statistics.detectable_px[k])),
        ("influence", both(&|statistics, k| statistics.influence[k])),
        ("undetected, it moves its point by, m", both(&|statistics, k| statistics.moves_point[k])),
        ("|w|", both(&|statistics, k| Some(statistics.w?[k].abs()))),
    ];
    if rows.iter().all(|(_, range)| range.is_none()) {
        return html! { h2 { "Reliability" } p { "There are no statistics." } };
    }
    html! {
        h2 { "Reliability" }
        (ranges("Columns and rows of all accepted observations", &rows))
        p.note {
            "r is the share of an error that shows in the residual. An error of the detectable size is found with a probability of 0.80. Undetected, it moves no unknown by more than the influence, in standard errors."
            @if unchecked > 0 { " " (count(unchecked)) " observations have a coordinate that nothing checks." }
        }
        (listed(subject, model, "The largest standardised residuals w", worst(accepted(model), WORST, |(_, statistics)| largest_w(statistics))))
        (listed(subject, model, "The largest detectable errors", worst(accepted(model), WORST, |(_, statistics)| {
            largest(statistics.detectable_px)
        })))
        (listed(subject, model, "The largest influences", worst(accepted(model), WORST, |(_, statistics)| largest(statistics.influence))))
    }
}

/// What was rejected and why.
pub(super) fn rejected(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let number = |verdict| observations(model).filter(|(_, statistics)| statistics.verdict == verdict).count();
    let by_hand = model.rejected.iter().filter(|ray| ray.by_hand).count();
    let behind = model.rejected.iter().filter(|ray| !ray.by_hand && ray.residual_px.is_none()).count();
    let rows = [
        ("it did not fit its point while the block grew", model.rejected.len() - behind - by_hand),
        ("its point lay behind the image while the block grew", behind),
        ("it was rejected by hand", by_hand),
        ("data snooping found a gross error", number(ObservationVerdict::GrossError)),
        ("its point lies behind the image", number(ObservationVerdict::Behind)),
        ("its point has fewer than two rays left, or rays that do not meet", number(ObservationVerdict::LostPoint)),
    ];
    let sum: usize = rows.iter().map(|(_, number)| number).sum();
    let all = model.adjusted.rays.len() + model.rejected.len();
    let snooped = observations(model).filter(|(_, statistics)| statistics.verdict == ObservationVerdict::GrossError);
    let largest = worst(snooped, WORST, |(_, statistics)| Some(largest_w(statistics).unwrap_or_else(|| length(statistics))));
    html! {
        h2 { "Rejected observations" }
        p { (count(sum)) " of " (count(all)) " observations (" (percent(sum, all)) ") were rejected." }
        @if sum > 0 {
            table tabindex="0" {
                thead { tr { th { "Reason" } th { "observations" } } }
                tbody { @for (reason, number) in rows { @if number > 0 { tr { th { (reason) } td { (count(number)) } } } } }
            }
        }
        @if !largest.is_empty() { (listed(subject, model, "Gross errors with the largest standardised residuals w", largest)) }
    }
}

fn listed(subject: &Subject<'_>, model: &ReconstructedModel, caption: &str, rows: Vec<Judged<'_>>) -> Markup {
    let points = written_points(model);
    html! {
        table tabindex="0" {
            caption { (caption) }
            thead {
                tr {
                    th { "Image" } th { "point" } th { "x px" } th { "y px" } th { "residual x px" } th { "y px" } th { "w x" } th { "w y" } th { "r x" } th { "r y" }
                    th { "∇ x px" } th { "∇ y px" } th { "influence" } @if model.in_system { th { "moves its point by m" } }
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
        p.note { "Points are numbered as in points.csv, ground control and check points with their names." }
    }
}
