//! What the block is worth, its figures, and what is weak about it.

use super::subject::{NAMED, Subject};
use crate::html::{count, fixed, significant};
use crate::outputs::summary::{ModelSummary, OrientationSummary};
use crate::outputs::warning::overview_warnings;
use crate::text::shorten;
use crate::{BlockScore, Datum, ResultSystem};
use maud::{Markup, html};

/// Verdict and figures.
pub(super) fn head(subject: &Subject<'_>) -> Markup {
    let summary = subject.summary;
    let (oriented, models) = match &summary.orientation {
        OrientationSummary::Failed { oriented, .. } => (*oriented, &[][..]),
        OrientationSummary::Done(done) => (done.oriented, &done.models[..]),
    };
    html! {
        p { strong { (summary.verdict.text) } }
        dl {
            dt { "Images" }
            dd {
                (count(oriented)) " oriented of " (count(summary.images.read)) " read"
                @if !summary.images.left_out.is_empty() { "; " (count(summary.images.left_out.len())) " could not be read" }
                @if summary.images.masked > 0 { "; " (count(summary.images.masked)) " with masks" }
            }
            dt { "Pairs" } dd { (count(summary.pairs.connected)) " connected of " (count(summary.pairs.tried)) " tried" }
            @if let Some(points) = &summary.points { dt { "Tie points found" } dd { (count(points.found)) " with " (count(points.rays)) " observations" } }
            dt { "Tie points written" } dd { (count(summary.selection.points)) " with " (count(summary.selection.rays)) " observations" }
            @if let Some(model) = models.first() { (adjustment(model, summary.crs.as_ref())) }
            @if let Some(crs) = &summary.crs {
                dt { "Coordinate system of the tables" } dd { (crs.name) }
                dt { "Axes of this report" } dd { "X east, Y north, Z up in the middle of the block, in m" }
            }
            @if let Some(edited) = &subject.run.edited { dt { "Edits by hand" } dd { (count(edited.edits.len())) } }
            @if let Some(score) = &summary.score { (truth(score)) }
        }
        @if models.len() > 1 {
            p { "The block fell apart into " (models.len()) " models, of " @for (k, model) in models.iter().enumerate().take(NAMED) { @if k > 0 { ", " } (count(model.images)) } " images. This report is of the first." }
        }
    }
}

fn adjustment(model: &ModelSummary, crs: Option<&ResultSystem>) -> Markup {
    html! {
        dt { "Georeferenced by" } dd { (datum(model)) }
        dt { "σ₀" } dd { (fixed(model.sigma0_px, 3)) " px" }
        dt { "RMSE of observations" } dd { (fixed(model.rmse_px, 3)) " px" }
        dt { "Degrees of freedom" } dd { (count(model.degrees_of_freedom)) }
        dt { "Observations rejected" } dd { (count(model.rays_rejected)) }
        @if let Some([x, y, z]) = model.position_rmse_m {
            dt { "RMSE of GNSS positions" } dd { (significant(x)) ", " (significant(y)) ", " (significant(z)) " m in X, Y, Z" }
        }
        @if let Some(checks) = &model.checks {
            @let [x, y, z] = checks.rmse_m;
            @let [mean_x, mean_y, mean_z] = checks.mean_m.map(|mean| fixed(mean, 3));
            dt { "RMSE of " (checks.points) " check points" }
            dd {
                (significant(x)) ", " (significant(y)) ", " (significant(z)) " m in X, Y, Z (plan " (significant(checks.plan_rmse_m)) " m), mean "
                (mean_x) ", " (mean_y) ", " (mean_z) " m"
                @if let Some(crs) = crs { ", along the axes of " (shorten(&crs.name)) }
                @if let Some(ratio) = checks.ratio { "; " (fixed(ratio, 2)) " of their standard errors" }
            }
        }
    }
}

fn datum(model: &ModelSummary) -> &'static str {
    match (model.in_system, model.datum) {
        (false, _) => "nothing: position, rotation and scale mean nothing",
        (true, Datum::Control) => "ground control points",
        (true, Datum::GnssAndControl) => "GNSS positions and ground control points",
        (true, Datum::Gnss | Datum::Free) => "GNSS positions",
    }
}

fn truth(score: &BlockScore) -> Markup {
    html! {
        dt { "Against the truth" }
        dd {
            (count(score.right_points)) " of " (count(score.points)) " points are right"
            @if let Some([x, y, z]) = score.position_rmse_m { "; after a similarity that brings it onto the truth, RMSE of positions " (significant(x)) ", " (significant(y)) ", " (significant(z)) " m" }
            @if let Some(angle) = score.angle_rmse_deg { ", of angles " (significant(angle)) "°" }
        }
    }
}

/// Warnings about the block, and remarks about what was given for it.
pub(super) fn remarks(subject: &Subject<'_>) -> Markup {
    let warnings = overview_warnings(subject.run);
    let remarks = &subject.summary.remarks;
    html! {
        @if !warnings.is_empty() {
            h2 { "Warnings" }
            ul { @for warning in &warnings { li { (warning) } } }
        }
        @if !remarks.is_empty() {
            h2 { "Remarks on what was given" }
            ul { @for remark in remarks.iter().take(NAMED) { li { (remark.text) } } }
            @if remarks.len() > NAMED { p.note { (count(remarks.len() - NAMED)) " more are in summary.json." } }
        }
    }
}
