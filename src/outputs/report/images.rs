//! Precision of images, and the images that are not in the model.

use super::range::{range, ranges, worst};
use super::subject::{NAMED, Subject, WORST};
use crate::html::{count, fixed, significant};
use crate::outputs::coverage::coverage;
use crate::outputs::images::image_rows;
use crate::outputs::precision::{image_errors, point_errors};
use crate::text::shorten;
use crate::{ImageStatistics, ReconstructedModel};
use maud::{Markup, html};

/// Standard errors of images and points, and the images with the fewest observations.
pub(super) fn precision(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let unit = subject.unit();
    let images = &model.adjusted.images;
    let of = |k: usize, of: fn(&ImageStatistics) -> Option<[f64; 3]>| range(images.iter().filter_map(of).map(|errors| errors[k]));
    let point = point_errors(subject.run);
    let of_point = |k: usize| range(point.iter().flatten().map(|errors| errors[k]));
    let rows: Vec<(String, Option<[f64; 3]>)> = (["X₀", "Y₀", "Z₀"].into_iter().enumerate())
        .map(|(k, name)| (format!("{name}, {unit}"), of(k, |image| image.position_errors)))
        .chain(["ω", "φ", "κ"].into_iter().enumerate().map(|(k, name)| (format!("{name}, °"), of(k, |image| image.angle_errors_deg))))
        .chain(["X", "Y", "Z"].into_iter().enumerate().map(|(k, name)| (format!("points, {name}, {unit}"), of_point(k))))
        .collect();
    let rows: Vec<(&str, Option<[f64; 3]>)> = rows.iter().map(|(name, range)| (&name[..], *range)).collect();
    html! {
        h2 { "Precision" }
        @if rows.iter().any(|(_, range)| range.is_some()) {
            (ranges("Standard errors of projection centres, angles and points", &rows))
            @if !model.in_system { p.note { "With respect to the inner constraints of a free network." } }
        } @else { p { "There are no standard errors." } }
        (fewest(subject, model))
    }
}

/// The images with the fewest observations.
fn fewest(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let (errors, covered) = (image_errors(subject.run), coverage(&subject.run.model));
    let own = model.images.iter().copied().zip(&model.adjusted.images);
    let listed = worst(own, WORST, |(_, statistics)| Some(-(statistics.rays as f64)));
    html! {
        table tabindex="0" {
            caption { "The images with the fewest observations" }
            thead {
                tr {
                    th { "Image" } th { "observations" } th { "von Gruber positions" } th { "RMSE px" }
                    @for name in ["X₀", "Y₀", "Z₀"] { th { "σ " (name) " " (subject.unit()) } }
                    @for name in ["ω", "φ", "κ"] { th { "σ " (name) " °" } }
                }
            }
            tbody {
                @for (image, statistics) in listed {
                    tr {
                        th { (subject.name(image)) } td { (count(statistics.rays)) } td { (covered[image].positions) " of 9" } td { (fixed(statistics.rmse_px, 3)) }
                        @for k in 0..3 { td { (significant(errors[image].position.map(|errors| errors[k]))) } }
                        @for k in 0..3 { td { (significant(errors[image].angles_deg.map(|errors| errors[k]))) } }
                    }
                }
            }
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
