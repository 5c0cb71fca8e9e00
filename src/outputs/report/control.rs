//! Ground control and check points.

use super::interval::with_interval;
use super::observations::residual_heads;
use super::priors::{AXES, judged, judged_head, length};
use super::range::worst;
use super::subject::{NAMED, Subject, WORST};
use crate::html::{count, fixed, head, significant};
use crate::outputs::given_points::absent_points;
use crate::outputs::inspection::{surveyed, surveyed_index};
use crate::outputs::tables::use_of;
use crate::text::shorten;
use crate::{ControlRole, ObservationVerdict, PointSource, PriorStatistics, ReconstructedModel, SurveyedPoint, Texts};
use maud::{Markup, html};

/// Ground control and check points; nothing without any.
pub(super) fn control(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    if model.surveyed.is_empty() {
        return without_figures(subject);
    }
    let all = surveyed_points(subject, model);
    let in_crs = subject.summary.crs.as_ref().map(|crs| shorten(&crs.name));
    let of = |role: ControlRole| all.iter().filter(move |(point, _)| point.role == role);
    let size = |point: &SurveyedPoint| length(point.difference_m);
    let left_out = all.iter().filter_map(|(point, _)| Some((*point, point.left_out?)));
    let alone = worst(left_out, NAMED, |(_, left)| Some(length(left.difference)));
    let alone: Vec<Difference<'_>> =
        alone.into_iter().map(|(point, left)| (point, left.difference, left.standard_errors.map(Some))).collect();
    let (texts, most) = (subject.texts, || [("most", NAMED.to_string())]);
    let along = |name: &str, crs: &str| texts.with(name, [("crs", crs.into())]);
    html! {
        @if of(ControlRole::Control).next().is_some() {
            h2 { (texts.say("report-control")) }
            table tabindex="0" {
                (judged_head(texts, &["report-point", "report-image-measurements"]))
                tbody {
                    @for (point, prior) in worst(of(ControlRole::Control), NAMED, |(point, _)| Some(size(point))) {
                        tr {
                            th { (shorten(&point.name)) } td { (point.rays) }
                            @if let Some(prior) = prior { (judged(prior)) } @else { (without(point)) }
                            td { (state(texts, point.state())) }
                        }
                    }
                }
            }
            p.note {
                (texts.say("report-control-residuals")) " " (texts.with("report-control-as-gnss", most()))
                @if let Some(crs) = &in_crs { " " (along("report-control-axes", crs)) }
            }
            @if !alone.is_empty() {
                h3 { (texts.say("report-left-out")) }
                (differences(subject, alone.into_iter()))
                p.note { (texts.say("report-left-out-is")) }
            }
        }
        @if of(ControlRole::Check).next().is_some() {
            @let checks = worst(of(ControlRole::Check), NAMED, |(point, _)| Some(size(point))).into_iter();
            h2 { (texts.say("report-check-points")) }
            (differences(subject, checks.map(|(point, _)| (*point, point.difference_m, point.standard_errors_m))))
            p.note {
                @if let Some(crs) = &in_crs { (along("report-check-differences-along", crs)) }
                @else { (texts.say("report-check-differences")) }
            }
        }
        (without_figures(subject))
        (measurements(subject, model))
    }
}

/// What became of a point.
fn state(texts: &Texts, state: &str) -> String {
    texts.say(&format!("report-state-{}", state.replace(' ', "-")))
}

/// Points that were given and that the block has no place of; nothing where there are none.
fn without_figures(subject: &Subject<'_>) -> Markup {
    let absent = absent_points(subject.run, &subject.surveyed);
    if absent.is_empty() {
        return html! {};
    }
    let texts = subject.texts;
    html! {
        h2 { (texts.say("report-without-figures")) }
        table tabindex="0" {
            thead { tr { @for name in ["report-point", "report-use", "report-state"] { th { (texts.say(name)) } } } }
            tbody {
                @for point in absent.iter().take(NAMED) {
                    @let role = format!("report-use-{}", use_of(point.role));
                    tr { th { (shorten(&point.name)) } td { (texts.say(&role)) } td { (state(texts, point.absence.state())) } }
                }
            }
        }
        p.note {
            (texts.say("report-states-explained"))
            @if absent.len() > NAMED { " " (texts.with("report-points-beyond", [("most", NAMED.to_string())])) }
        }
    }
}

/// A surveyed point with a difference from it and the standard errors of that.
type Difference<'a> = (&'a SurveyedPoint, [f64; 3], [Option<f64>; 3]);

fn differences<'a>(subject: &Subject<'_>, rows: impl Iterator<Item = Difference<'a>>) -> Markup {
    let (texts, factors) = (subject.texts, subject.factors_95());
    html! {
        table tabindex="0" {
            thead {
                tr {
                    th { (texts.say("report-point")) } th { (texts.say("report-image-measurements")) }
                    @for axis in AXES { th { (head(texts, &format!("d{axis}"), "m")) } }
                    @for axis in AXES { th { (head(texts, &format!("σ d{axis}"), "m")) @if factors.is_some() { (texts.say("report-and-95")) } } }
                    @for axis in AXES { th { "d" (axis) " / σ" } }
                }
            }
            tbody {
                @for (point, difference, errors) in rows {
                    tr {
                        th { (shorten(&point.name)) } td { (point.rays) }
                        @for value in difference { td { (significant(value)) } }
                        @for error in errors { td { (with_interval(error, factors)) } }
                        @for k in 0..3 { td { (fixed(errors[k].map(|error| difference[k] / error), 2)) } }
                    }
                }
            }
        }
    }
}

/// The surveyed points in the system of the tables, with what the adjustment says of them: nothing of check points, which took no part. Detectable errors
/// are those of the tests of control points, and what they do if they are not found.
fn surveyed_points<'a>(subject: &'a Subject<'_>, model: &'a ReconstructedModel) -> Vec<(&'a SurveyedPoint, Option<PriorStatistics>)> {
    let adjusted = &model.adjusted;
    let statistics = |place: usize| {
        let control = adjusted.block.control.iter().position(|control| control.point == place)?;
        let prior = adjusted.control[control].as_ref()?;
        let detectable = surveyed(model, place)?.detectable_m;
        let times = |of: [Option<f64>; 3]| [0, 1, 2].map(|k| Some(of[k]? * (detectable[k]? / prior.detectable[k]?)));
        Some(PriorStatistics { detectable, moves: times(prior.moves), influence: times(prior.influence), ..*prior })
    };
    let surveyed = |place: usize| subject.surveyed.get(surveyed_index(model, place)?);
    (0..model.points.len()).filter_map(|place| Some((surveyed(place)?, statistics(place)))).collect()
}

/// Image measurements of surveyed points.
fn measurements(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let adjusted = &model.adjusted;
    let own: Vec<_> = (adjusted.block.rays.iter().zip(&adjusted.rays))
        .filter(|(ray, _)| matches!(model.points[ray.point], PointSource::GroundControl(_)))
        .collect();
    let squares = own.iter().filter(|(_, ray)| ray.verdict == ObservationVerdict::Accepted).map(|(_, ray)| {
        let [x, y] = ray.residual_px;
        x * x + y * y
    });
    let (number, sum) = squares.fold((0_u32, 0.0), |(number, sum), square| (number + 1, sum + square));
    let name = |place: usize| surveyed(model, place).map_or_else(String::new, |point| shorten(&point.name));
    let listed = worst(own.iter(), WORST, |(_, ray)| Some(libm::hypot(ray.residual_px[0], ray.residual_px[1])));
    let texts = subject.texts;
    let took_part = |number: u32| {
        let rmse = fixed((sum / f64::from(number)).sqrt(), 3);
        texts.with("report-measurements-took-part", [("part", number.to_string()), ("all", count(own.len())), ("rmse", rmse)])
    };
    html! {
        @if number > 0 {
            h3 { (texts.say("report-measurements")) }
            p { (took_part(number)) }
            table tabindex="0" {
                caption { (texts.say("report-largest-residuals")) }
                thead {
                    tr {
                        th { (texts.say("report-point")) } th { (texts.say("report-image")) } (residual_heads(texts))
                        th { (head(texts, &texts.say("report-moves-point-by"), "m")) } th { (texts.say("report-influence")) } th { (texts.say("report-state")) }
                    }
                }
                tbody {
                    @for (ray, statistics) in listed {
                        @let is_used = statistics.verdict == ObservationVerdict::Accepted;
                        tr {
                            th { (name(ray.point)) } td { (subject.name(model.images[ray.image])) }
                            @for value in statistics.residual_px { td { (fixed(value, 3)) } }
                            @for k in 0..2 { td { (fixed(statistics.w.map(|w| w[k]), 2)) } }
                            @for k in 0..2 { td { (fixed(statistics.redundancy.map(|r| r[k]), 3)) } }
                            @for k in 0..2 { td { (significant(statistics.detectable_px[k])) } }
                            @for both in [statistics.moves_point, statistics.influence] { td { (significant(both.into_iter().flatten().reduce(f64::max))) } }
                            td { (texts.say(if is_used { "report-state-used" } else { "report-state-rejected" })) }
                        }
                    }
                }
            }
        }
    }
}

/// A control point that takes no part, as [`judged`] gives one that does.
fn without(point: &SurveyedPoint) -> Markup {
    html! {
        @for difference in point.difference_m { td { (significant(-difference)) } }
        @for k in 0..3 { td { (fixed(point.standard_errors_m[k].map(|error| -point.difference_m[k] / error), 2)) } }
        @for _ in 0..3 { td { "–" } }
        @for detectable in point.detectable_m { td { (significant(detectable)) } }
        @for _ in 0..4 { td { "–" } }
    }
}
