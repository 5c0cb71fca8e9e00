//! Precision of images, and the images that are not in the model.

use super::interval::{ellipsoid, note, semi_axes, with_interval};
use super::range::{range, ranges, worst};
use super::subject::{NAMED, Subject, WORST};
use crate::html::{count, fixed};
use crate::outputs::coverage::coverage;
use crate::outputs::images::image_rows;
use crate::outputs::precision::{CoordinateErrors, ImageErrors, image_errors, point_errors};
use crate::text::shorten;
use crate::{Factors95, ImageStatistics, ReconstructedModel};
use maud::{Markup, html};

/// A quantity with its standard errors: the smallest, median and largest one.
type Precision = (String, Option<[f64; 3]>);

/// Standard errors of images and points, the images with the fewest observations and the points that are known worst.
pub(super) fn precision(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let (unit, factors) = (subject.unit(), subject.factors_95());
    let images = &model.adjusted.images;
    let of = |k: usize, of: fn(&ImageStatistics) -> Option<[f64; 3]>| range(images.iter().filter_map(of).map(|errors| errors[k]));
    let (of_images, of_points) = (image_errors(subject.run), point_errors(subject.run));
    let of_point = |k: usize| range(of_points.iter().flatten().map(|known| known.errors[k]));
    let rows: Vec<Precision> = (["X₀", "Y₀", "Z₀"].into_iter().enumerate())
        .map(|(k, name)| (format!("{name}, {unit}"), of(k, |image| image.position_errors)))
        .chain(["ω", "φ", "κ"].into_iter().enumerate().map(|(k, name)| (format!("{name}, °"), of(k, |image| image.angle_errors_deg))))
        .chain(["X", "Y", "Z"].into_iter().enumerate().map(|(k, name)| (format!("points, {name}, {unit}"), of_point(k))))
        .collect();
    let longest = |known: &CoordinateErrors| Some(ellipsoid(known, factors)?[0]);
    let ellipsoids = [
        (format!("projection centres, {unit}"), range(of_images.iter().filter_map(|image| image.position.as_ref()).filter_map(longest))),
        (format!("points, {unit}"), range(of_points.iter().flatten().filter_map(longest))),
    ];
    let ellipsoids = ellipsoids.each_ref().map(|(name, range)| (&name[..], *range));
    html! {
        h2 { "Precision" }
        @if rows.iter().any(|(_, range)| range.is_some()) {
            (standard_errors(&rows, factors))
            @if ellipsoids.iter().any(|(_, range)| range.is_some()) { (ranges("Longest semi-axes of the 95 % ellipsoids", &ellipsoids)) }
            (note(factors))
            @if !model.in_system { p.note { "With respect to the inner constraints of a free network." } }
        } @else { p { "There are no standard errors." } }
        (fewest(subject, model, &of_images))
        (worst_points(subject, &of_points))
    }
}

fn standard_errors(rows: &[Precision], factors: Option<Factors95>) -> Markup {
    html! {
        table tabindex="0" {
            caption { "Standard errors of projection centres, angles and points" @if factors.is_some() { ", ± 95 %" } }
            thead { tr { td {} th { "minimum" } th { "median" } th { "maximum" } } }
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
    let (unit, factors, covered) = (subject.unit(), subject.factors_95(), coverage(&subject.run.model));
    let own = model.images.iter().copied().zip(&model.adjusted.images);
    let listed = worst(own, WORST, |(_, statistics)| Some(-(statistics.rays as f64)));
    html! {
        table tabindex="0" {
            caption { "The images with the fewest observations" @if factors.is_some() { "; standard errors ± 95 %" } }
            thead {
                tr {
                    th { "Image" } th { "observations" } th { "von Gruber positions" } th { "RMSE px" }
                    @for name in ["X₀", "Y₀", "Z₀"] { th { "σ " (name) " " (unit) } }
                    th { "95 % ellipsoid " (unit) }
                    @for name in ["ω", "φ", "κ"] { th { "σ " (name) " °" } }
                }
            }
            tbody {
                @for (image, statistics) in listed {
                    @let ImageErrors { position, angles_deg } = &errors[image];
                    tr {
                        th { (subject.name(image)) } td { (count(statistics.rays)) } td { (covered[image].positions) " of 9" } td { (fixed(statistics.rmse_px, 3)) }
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
    let (unit, factors) = (subject.unit(), subject.factors_95());
    let known = errors.iter().enumerate().filter_map(|(point, known)| Some((point, known.as_ref()?)));
    let listed = worst(known, WORST, |(_, known)| Some(ellipsoid(known, factors)?[0]));
    html! {
        @if !listed.is_empty() {
            table tabindex="0" {
                caption { "The points with the longest 95 % ellipsoids; standard errors ± 95 %" }
                thead { tr { th { "Point" } th { "observations" } @for name in ["X", "Y", "Z"] { th { "σ " (name) " " (unit) } } th { "95 % ellipsoid " (unit) } } }
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
            p.note { "Points are numbered as in points.csv, ground control and check points with their names. Ellipsoid: its semi-axes, the longest first." }
        }
    }
}

/// Images that are not oriented in the model that is written, and those that could not be read.
pub(super) fn left_out(subject: &Subject<'_>) -> Markup {
    let reason = |row: crate::outputs::ImageRow| Some((shorten(&row.name), row.reason?.text));
    let unoriented: Vec<(String, String)> = image_rows(subject.run).into_iter().filter_map(reason).collect();
    let skipped: Vec<(String, String)> =
        subject.summary.images.left_out.iter().map(|image| (shorten(&image.name), image.reason.text.clone())).collect();
    html! {
        @for (title, rows) in [("Images that are not oriented", unoriented), ("Images that could not be read", skipped)] {
            @if !rows.is_empty() {
                h2 { (title) }
                table tabindex="0" {
                    thead { tr { th { "Image" } th { "Reason" } } }
                    tbody { @for (name, reason) in rows.iter().take(NAMED) { tr { th { (name) } td.words { (reason) } } } }
                }
                @if rows.len() > NAMED { p.note { (count(rows.len() - NAMED)) " more are in summary.json." } }
            }
        }
    }
}
