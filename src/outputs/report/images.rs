//! Precision of images, and the images that are not in the model.

use super::interval::{ellipsoid, note, semi_axes, with_interval};
use super::range::{Named, range, range_head, ranges, worst};
use super::subject::{NAMED, Subject, WORST};
use crate::html::{count, fixed, head, in_unit, said};
use crate::outputs::ImageRow;
use crate::outputs::coverage::coverage;
use crate::outputs::images::image_rows;
use crate::outputs::precision::{CoordinateErrors, ImageErrors, image_errors, point_errors};
use crate::text::shorten;
use crate::{Factors95, ImageStatistics, ReconstructedModel, Texts};
use maud::{Markup, html};

const CENTRE: [&str; 3] = ["X₀", "Y₀", "Z₀"];
const ANGLES: [&str; 3] = ["ω", "φ", "κ"];
const AXES: [&str; 3] = ["X", "Y", "Z"];

/// Standard errors of images and points, the images with the fewest observations and the points that are known worst.
pub(super) fn precision(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let (texts, unit, factors) = (subject.texts, &subject.unit()[..], subject.factors_95());
    let images = &model.adjusted.images;
    let of = |k: usize, of: fn(&ImageStatistics) -> Option<[f64; 3]>| range(images.iter().filter_map(of).map(|errors| errors[k]));
    let (of_images, of_points) = (image_errors(subject.run), point_errors(subject.run));
    let of_point = |k: usize| range(of_points.iter().flatten().map(|known| known.errors[k]));
    let of_axis = |axis: &str| texts.with("report-point-coordinate", [("axis", axis.into())]);
    let rows: Vec<Named> = (CENTRE.into_iter().enumerate())
        .map(|(k, name)| (in_unit(texts, name, unit), of(k, |image| image.position_errors)))
        .chain(ANGLES.into_iter().enumerate().map(|(k, name)| (in_unit(texts, name, "°"), of(k, |image| image.angle_errors_deg))))
        .chain(AXES.into_iter().enumerate().map(|(k, name)| (in_unit(texts, &of_axis(name), unit), of_point(k))))
        .collect();
    let longest = |known: &CoordinateErrors| Some(ellipsoid(known, factors)?[0]);
    let of_centres = range(of_images.iter().filter_map(|image| image.position.as_ref()).filter_map(longest));
    let ellipsoids = [
        (in_unit(texts, &texts.say("report-projection-centres"), unit), of_centres),
        (in_unit(texts, &texts.say("report-points"), unit), range(of_points.iter().flatten().filter_map(longest))),
    ];
    html! {
        h2 { (texts.say("report-precision")) }
        @if rows.iter().any(|(_, range)| range.is_some()) {
            (standard_errors(texts, &rows, factors))
            @if ellipsoids.iter().any(|(_, range)| range.is_some()) { (ranges(texts, "report-longest-semi-axes", &ellipsoids)) }
            (note(texts, factors))
            @if !model.in_system { p.note { (texts.say("report-inner-constraints")) } }
        } @else { p { (texts.say("report-no-standard-errors")) } }
        (fewest(subject, model, &of_images))
        (worst_points(subject, &of_points))
    }
}

fn standard_errors(texts: &Texts, rows: &[Named], factors: Option<Factors95>) -> Markup {
    html! {
        table tabindex="0" {
            caption { (texts.say("report-standard-errors")) @if factors.is_some() { (texts.say("report-and-95")) } }
            (range_head(texts))
            tbody {
                @for (name, range) in rows {
                    @if let Some(range) = range { tr { th { (name) } @for error in range { td { (with_interval(Some(*error), factors)) } } } }
                }
            }
        }
    }
}

/// The images with the fewest observations.
fn fewest(subject: &Subject<'_>, model: &ReconstructedModel, errors: &[ImageErrors]) -> Markup {
    let (texts, unit, factors) = (subject.texts, &subject.unit()[..], subject.factors_95());
    let covered = coverage(&subject.run.model);
    let own = model.images.iter().copied().zip(&model.adjusted.images);
    let listed = worst(own, WORST, |(_, statistics)| Some(-(statistics.rays as f64)));
    html! {
        table tabindex="0" {
            caption { (texts.say("report-fewest-observations")) @if factors.is_some() { (texts.say("report-and-errors-95")) } }
            thead {
                tr {
                    @for name in ["report-image", "report-observations", "report-von-gruber"] { th { (texts.say(name)) } }
                    th { (head(texts, "RMSE", "px")) }
                    @for name in CENTRE { th { (head(texts, &format!("σ {name}"), unit)) } }
                    th { (head(texts, &texts.say("report-ellipsoid-95"), unit)) }
                    @for name in ANGLES { th { (head(texts, &format!("σ {name}"), "°")) } }
                }
            }
            tbody {
                @for (image, statistics) in listed {
                    @let ImageErrors { position, angles_deg } = &errors[image];
                    tr {
                        th { (subject.name(image)) } td { (count(statistics.rays)) } td { (texts.with("report-of-nine", [("positions", covered[image].positions.to_string())])) } td { (fixed(statistics.rmse_px, 3)) }
                        @for k in 0..3 { td { (with_interval(position.map(|position| position.errors[k]), factors)) } }
                        td { (semi_axes(position.as_ref().and_then(|position| ellipsoid(position, factors)))) }
                        @for k in 0..3 { td { (with_interval(angles_deg.map(|errors| errors[k]), factors)) } }
                    }
                }
            }
        }
    }
}

/// The points whose ellipsoids are the longest; nothing without standard errors.
fn worst_points(subject: &Subject<'_>, errors: &[Option<CoordinateErrors>]) -> Markup {
    let (texts, unit, factors) = (subject.texts, &subject.unit()[..], subject.factors_95());
    let known = errors.iter().enumerate().filter_map(|(point, known)| Some((point, known.as_ref()?)));
    let listed = worst(known, WORST, |(_, known)| Some(ellipsoid(known, factors)?[0]));
    html! {
        @if !listed.is_empty() {
            table tabindex="0" {
                caption { (texts.say("report-longest-ellipsoids")) }
                thead {
                    tr {
                        @for name in ["report-point", "report-observations"] { th { (texts.say(name)) } }
                        @for name in AXES { th { (head(texts, &format!("σ {name}"), unit)) } }
                        th { (head(texts, &texts.say("report-ellipsoid-95"), unit)) }
                    }
                }
                tbody {
                    @for (point, known) in listed {
                        tr {
                            th { (subject.point(point)) } td { (subject.run.model.points[point].rays.len()) }
                            @for error in known.errors { td { (with_interval(Some(error), factors)) } }
                            td { (semi_axes(ellipsoid(known, factors))) }
                        }
                    }
                }
            }
            p.note { (texts.say("report-points-numbered")) " " (texts.say("report-semi-axes")) }
        }
    }
}

/// Images that are not oriented in the model that is written, and those that could not be read.
pub(super) fn left_out(subject: &Subject<'_>) -> Markup {
    let texts = subject.texts;
    let reason = |row: ImageRow| Some((shorten(&row.name), said(texts, &row.reason?.message)));
    let unoriented: Vec<(String, String)> = image_rows(subject.run).into_iter().filter_map(reason).collect();
    let skipped = subject.summary.images.left_out.iter().map(|image| (shorten(&image.name), said(texts, &image.reason.message)));
    html! {
        @for (title, rows) in [("report-images-not-oriented", unoriented), ("report-images-not-read", skipped.collect())] {
            @if !rows.is_empty() {
                h2 { (texts.say(title)) }
                table tabindex="0" {
                    thead { tr { th { (texts.say("report-image")) } th { (texts.say("report-reason")) } } }
                    tbody { @for (name, reason) in rows.iter().take(NAMED) { tr { th { (name) } td.words { (reason) } } } }
                }
                @if rows.len() > NAMED { p.note { (texts.with("report-more-in-summary", [("number", count(rows.len() - NAMED))])) } }
            }
        }
    }
}
