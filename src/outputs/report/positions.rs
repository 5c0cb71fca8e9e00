//! Observed positions: GNSS positions of images, ground control and check points.

use super::interval::with_interval;
use super::range::{range, ranges, worst};
use super::subject::{NAMED, Subject, WORST};
use crate::html::{count, fixed, significant};
use crate::outputs::given_points::absent_points;
use crate::outputs::inspection::{surveyed, surveyed_index};
use crate::outputs::tables::use_of;
use crate::text::shorten;
use crate::{
    ControlRole, Factors95, ObservationVerdict, PointSource, PriorStatistics, ReconstructedModel, SurveyedPoint, VarianceComponent,
};
use maud::{Markup, html};

const AXES: [&str; 3] = ["X", "Y", "Z"];

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
    let is_in_strips = model.adjusted.systematic.as_ref().is_some_and(|systematic| !systematic.left_out.is_empty());
    let accepted: Vec<&PriorStatistics> = all.iter().map(|(_, prior)| *prior).filter(|prior| prior.accepted).collect();
    let of = |of: &dyn Fn(&PriorStatistics, usize) -> Option<f64>, k: usize| range(accepted.iter().filter_map(|prior| of(prior, k)));
    let rows: Vec<(String, Option<[f64; 3]>)> = (0..3)
        .flat_map(|k| {
            [
                (format!("|residual| {}, m", AXES[k]), of(&|prior, k| observed(prior, k).then(|| prior.residual[k].abs()), k)),
                (
                    format!("redundancy number r {}", AXES[k]),
                    of(&|prior, k| prior.redundancy.filter(|_| observed(prior, k)).map(|r| r[k]), k),
                ),
                (format!("detectable error {}, m", AXES[k]), of(&|prior, k| prior.detectable[k], k)),
                (format!("undetected, it moves {} by, m", AXES[k]), of(&|prior, k| prior.moves[k], k)),
                (format!("influence of {}", AXES[k]), of(&|prior, k| prior.influence[k], k)),
            ]
        })
        .collect();
    let rows: Vec<(&str, Option<[f64; 3]>)> = rows.iter().map(|(name, range)| (&name[..], *range)).collect();
    let listed = worst(all.iter(), WORST, |(_, prior)| Some(largest_w(prior).unwrap_or_else(|| length(prior.residual))));
    html! {
        h2 { "GNSS positions" }
        p { (count(accepted.len())) " of " (count(all.len())) " took part" @if accepted.len() < all.len() { "; the others lie too far from where the images have them" @if is_in_strips { ", or are in no strip" } } "." }
        (ranges("GNSS positions that took part", &rows))
        table tabindex="0" {
            caption { @if listed.len() < all.len() { "The largest standardised residuals w" } @else { "All GNSS positions, the largest standardised residuals w first" } }
            (judged_head("Image", "m", &[]))
            tbody {
                @for (image, prior) in listed {
                    tr { th { (subject.name(*image)) } (judged(prior)) td { (if prior.accepted { "used" } else { "rejected" }) } }
                }
            }
        }
        p.note { "Residual: observed minus adjusted. r is the share of an error that shows in the residual; a detectable error is found with a probability of 0.80. Undetected, it moves the adjusted coordinate by \"moves\", and no unknown by more than \"influence\", in standard errors." }
    }
}

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
    html! {
        @if of(ControlRole::Control).next().is_some() {
            h2 { "Ground control points" }
            table tabindex="0" {
                (judged_head("Point", "m", &["image measurements"]))
                tbody {
                    @for (point, prior) in worst(of(ControlRole::Control), NAMED, |(point, _)| Some(size(point))) {
                        tr {
                            th { (shorten(&point.name)) } td { (point.rays) }
                            @if let Some(prior) = prior { (judged(prior)) } @else { (without(point)) }
                            td { (point.state()) }
                        }
                    }
                }
            }
            p.note {
                "Residual: surveyed minus adjusted; w is that of a new observation where a point was rejected, since the other observations contradict it. A point that is doubtful contradicts them, too, and is used since too few are left to tell which is wrong. "
                "r, ∇, moves and influence as for GNSS positions: what an undetected error of the size ∇ moves the point by, and the most that it moves any unknown by, in standard errors. Points beyond "
                (NAMED) " are in surveyed.csv."
                @if let Some(crs) = &in_crs { " Residuals of points that are used count along the axes of the adjustment, those of refused points, and all differences, along those of " (crs) "." }
            }
            @if !alone.is_empty() {
                h3 { "The same points without themselves" }
                (differences(subject.factors_95(), alone.into_iter()))
                p.note { "Where all other observations have each of these points, minus surveyed: what it is worth as a check point." }
            }
        }
        @if of(ControlRole::Check).next().is_some() {
            h2 { "Check points" }
            (differences(subject.factors_95(), worst(of(ControlRole::Check), NAMED, |(point, _)| Some(size(point))).into_iter().map(|(point, _)| (*point, point.difference_m, point.standard_errors_m))))
            p.note { "Differences: adjusted minus surveyed" @if let Some(crs) = &in_crs { ", along the axes of " (crs) } ". They took no part in the adjustment." }
        }
        (without_figures(subject))
        (measurements(subject, model))
    }
}

/// Points that were given and that the block has no place of; nothing where there are none.
fn without_figures(subject: &Subject<'_>) -> Markup {
    let absent = absent_points(subject.run, &subject.surveyed);
    if absent.is_empty() {
        return html! {};
    }
    html! {
        h2 { "Control and check points without figures" }
        table tabindex="0" {
            thead { tr { th { "Point" } th { "use" } th { "state" } } }
            tbody {
                @for point in absent.iter().take(NAMED) {
                    tr { th { (shorten(&point.name)) } td { (use_of(point.role)) } td { (point.absence.state()) } }
                }
            }
        }
        p.note {
            "Not measured: no image measurement names the point. Untested, not determined: fewer than two image measurements of the point fit the block; a control point takes no part then. Not placed: no control points place the block. Rejected: a place of the orthophoto that contradicts the others."
            @if absent.len() > NAMED { " Points beyond " (NAMED) " are in surveyed.csv." }
        }
    }
}

/// What the residuals say of stated standard errors; nothing where none are stated.
pub(super) fn components(model: &ReconstructedModel) -> Markup {
    let components = &model.adjusted.components;
    if components.is_empty() {
        return html! {};
    }
    html! {
        h2 { "Stated standard errors" }
        table tabindex="0" {
            thead { tr { th { "Observations" } th { "coordinates" } th { "redundancy" } th { "by residuals / stated" } th { "95 % interval" } th { "weights by" } } }
            tbody {
                @for component in components {
                    tr {
                        th { (component.group.label()) } td { (count(component.observations)) } td { (fixed(component.redundancy, 1)) }
                        td { (fixed(Some(component.factor).filter(|_| !component.held), 2)) }
                        td { @if let Some([low, high]) = component.interval { (fixed(low, 2)) " – " (fixed(high, 2)) } @else { "–" } }
                        td { (weighted_by(component)) }
                    }
                }
            }
        }
        p.note {
            "Variance components: standard errors by the residuals beside stated standard errors. Weights follow the residuals where 1 lies outside the interval, and stays there once they do. A factor that the redundancy does not determine is held at 1."
            @if let Some(weighting) = model.adjusted.weighting {
                " Rounds of weighting: " (weighting.rounds) "."
                @if !weighting.converged { " The weights did not converge." }
            }
        }
    }
}

/// Systematic errors of GNSS positions; nothing where none were to be estimated.
pub(super) fn systematic(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let Some(systematic) = model.adjusted.systematic.as_ref().filter(|systematic| !systematic.errors.is_empty()) else {
        return html! {};
    };
    let ends = |images: &[usize]| [images.first(), images.last()].map(|image| image.map(|image| subject.name(model.images[*image])));
    html! {
        h2 { "Systematic errors of GNSS positions" }
        table tabindex="0" {
            thead { tr { th { "Error" } @for axis in AXES { th { (axis) " m" } } @for axis in AXES { th { "σ " (axis) " m, ± 95 %" } } th { "test" } th { "limit" } th { "state" } } }
            tbody {
                @for error in &systematic.errors {
                    tr {
                        th { (error.error.label()) }
                        @for axis in 0..3 { td { (significant(error.value(axis))) } }
                        @for value in error.standard_errors { td { (with_interval(value, subject.factors_95())) } }
                        td { (fixed(error.test, 2)) } td { (fixed(error.limit, 2)) } td { (error.verdict.label()) }
                    }
                }
            }
        }
        @for (number, strip) in systematic.strips.iter().enumerate() {
            @if let [Some(first), Some(last)] = ends(&strip.images) {
                p { "Strip " (number + 1) ": " (strip.images.len()) " images from " (first) " to " (last) "." }
            }
        }
        p.note {
            "Observed position = projection centre + error. A lever arm is in the axes of the camera (x right, y up, z against the direction of view); a drift is what the error grows by from the first image of a strip to the last. Test: the mean square in standard errors, above the limit not by chance."
            @if systematic.constraints > 0 { " There are too few ground control points: what the errors would move, turn or scale the block by as a whole is none of theirs." }
        }
    }
}

fn weighted_by(component: &VarianceComponent) -> &'static str {
    match (component.applied, component.held) {
        (true, _) => "residuals",
        (false, true) => "stated standard errors (held)",
        (false, false) => "stated standard errors",
    }
}

/// A surveyed point with a difference from it and the standard errors of that.
type Difference<'a> = (&'a SurveyedPoint, [f64; 3], [Option<f64>; 3]);

fn differences<'a>(factors: Option<Factors95>, rows: impl Iterator<Item = Difference<'a>>) -> Markup {
    html! {
        table tabindex="0" {
            thead {
                tr {
                    th { "Point" } th { "image measurements" }
                    @for axis in AXES { th { "d" (axis) " m" } } @for axis in AXES { th { "σ d" (axis) " m" @if factors.is_some() { ", ± 95 %" } } } @for axis in AXES { th { "d" (axis) " / σ" } }
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
    let (number, sum) = squares.fold((0, 0.0), |(number, sum), square| (number + 1, sum + square));
    let name = |place: usize| surveyed(model, place).map_or_else(String::new, |point| shorten(&point.name));
    let listed = worst(own.iter(), WORST, |(_, ray)| Some(libm::hypot(ray.residual_px[0], ray.residual_px[1])));
    html! {
        @if number > 0 {
            h3 { "Image measurements of these points" }
            p { (count(number)) " of " (count(own.len())) " took part; RMSE " (fixed((sum / f64::from(number as u32)).sqrt(), 3)) " px." }
            table tabindex="0" {
                caption { "The largest residuals" }
                thead { tr { th { "Point" } th { "Image" } th { "residual x px" } th { "y px" } th { "w x" } th { "w y" } th { "r x" } th { "r y" } th { "∇ x px" } th { "∇ y px" } th { "moves the point by m" } th { "influence" } th { "state" } } }
                tbody {
                    @for (ray, statistics) in listed {
                        tr {
                            th { (name(ray.point)) } td { (subject.name(model.images[ray.image])) }
                            @for value in statistics.residual_px { td { (fixed(value, 3)) } }
                            @for k in 0..2 { td { (fixed(statistics.w.map(|w| w[k]), 2)) } }
                            @for k in 0..2 { td { (fixed(statistics.redundancy.map(|r| r[k]), 3)) } }
                            @for k in 0..2 { td { (significant(statistics.detectable_px[k])) } }
                            @for both in [statistics.moves_point, statistics.influence] { td { (significant(both.into_iter().flatten().reduce(f64::max))) } }
                            td { (if statistics.verdict == ObservationVerdict::Accepted { "used" } else { "rejected" }) }
                        }
                    }
                }
            }
        }
    }
}

fn judged_head(what: &str, unit: &str, more: &[&str]) -> Markup {
    html! {
        thead {
            tr {
                th { (what) }
                @for name in more { th { (name) } }
                @for axis in AXES { th { "residual " (axis) " " (unit) } } @for axis in AXES { th { "w " (axis) } } @for axis in AXES { th { "r " (axis) } }
                @for axis in AXES { th { "∇ " (axis) " " (unit) } } @for axis in AXES { th { "moves " (axis) " " (unit) } }
                th { "influence" }
                th { "state" }
            }
        }
    }
}

fn judged(prior: &PriorStatistics) -> Markup {
    html! {
        @for k in 0..3 { td { (significant(Some(prior.residual[k]).filter(|_| observed(prior, k)))) } }
        @for k in 0..3 { td { (fixed(prior.w.filter(|_| observed(prior, k)).map(|w| w[k]), 2)) } }
        @for k in 0..3 { td { (fixed(prior.redundancy.filter(|_| observed(prior, k)).map(|r| r[k]), 3)) } }
        @for k in 0..3 { td { (significant(prior.detectable[k])) } }
        @for k in 0..3 { td { (significant(prior.moves[k])) } }
        td { (significant(prior.influence.into_iter().flatten().reduce(f64::max))) }
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

/// Whether a coordinate was observed: what was not has neither residual nor redundancy.
fn observed(prior: &PriorStatistics, k: usize) -> bool {
    prior.residual[k] != 0.0 || prior.redundancy.is_some_and(|redundancy| redundancy[k] != 0.0)
}

fn largest_w(prior: &PriorStatistics) -> Option<f64> {
    prior.w.map(|w| w.iter().fold(0.0, |most: f64, w| most.max(w.abs())))
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}
