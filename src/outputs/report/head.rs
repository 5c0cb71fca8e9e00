//! What the block is worth, its figures, and what is weak about it.

use super::subject::{NAMED, Subject};
use crate::html::{count, fixed, listed, quantity, said, significant};
use crate::outputs::orientation_summary::{ModelSummary, OrientationSummary};
use crate::outputs::warning::overview_warnings;
use crate::text::shorten;
use crate::{BlockScore, Datum, ResultSystem, Texts};
use maud::{Markup, html};

/// Verdict and figures.
pub(super) fn head(subject: &Subject<'_>) -> Markup {
    let (texts, summary) = (subject.texts, subject.summary);
    let with_observations =
        |points: usize, rays: usize| texts.with("report-with-observations", [("points", count(points)), ("observations", count(rays))]);
    let (oriented, models) = match &summary.orientation {
        OrientationSummary::Failed { oriented, .. } => (*oriented, &[][..]),
        OrientationSummary::Done(done) => (done.oriented, &done.models[..]),
    };
    html! {
        p { strong { (said(texts, &summary.verdict.message)) } }
        dl {
            dt { (texts.say("report-images")) }
            dd {
                (texts.with("report-oriented-of", [("oriented", count(oriented)), ("read", count(summary.images.read))]))
                @if !summary.images.left_out.is_empty() { (texts.with("report-not-read", [("images", count(summary.images.left_out.len()))])) }
                @if summary.images.masked > 0 { (texts.with("report-with-masks", [("images", count(summary.images.masked))])) }
            }
            dt { (texts.say("report-pairs")) }
            dd { (texts.with("report-connected-of", [("connected", count(summary.pairs.connected)), ("tried", count(summary.pairs.tried))])) }
            @if let Some(points) = &summary.points {
                dt { (texts.say("report-points-found")) } dd { (with_observations(points.found, points.rays)) }
            }
            dt { (texts.say("report-points-written")) } dd { (with_observations(summary.selection.points, summary.selection.rays)) }
            @if let Some(model) = models.first() { (adjustment(texts, model, summary.crs.as_ref())) }
            @if let Some(crs) = &summary.crs {
                dt { (texts.say("report-coordinate-system")) } dd { (crs.name) }
                dt { (texts.say("report-axes-of-report")) } dd { (texts.say("report-axes-local")) }
            }
            @if let Some(edited) = &subject.run.edited { dt { (texts.say("report-edits-of-block")) } dd { (count(edited.edits.len())) } }
            @if let Some(score) = &summary.score { (truth(texts, score)) }
        }
        @if models.len() > 1 {
            @let images = listed(texts, models.iter().take(NAMED).map(|model| count(model.images)));
            p { (texts.with("report-models", [("models", models.len().to_string()), ("images", images)])) }
        }
    }
}

fn adjustment(texts: &Texts, model: &ModelSummary, crs: Option<&ResultSystem>) -> Markup {
    html! {
        dt { (texts.say("report-georeferenced-by")) } dd { (texts.say(datum(model))) }
        dt { "σ₀" } dd { (quantity(texts, fixed(model.sigma0_px, 3), "px")) }
        dt { (texts.say("report-rmse-of-observations")) } dd { (quantity(texts, fixed(model.rmse_px, 3), "px")) }
        dt { (texts.say("report-degrees-of-freedom")) } dd { (count(model.degrees_of_freedom)) }
        dt { (texts.say("report-observations-rejected")) } dd { (count(model.rays_rejected)) }
        @if let Some(rmse) = model.position_rmse_m {
            dt { (texts.say("report-rmse-of-gnss")) } dd { (texts.with("report-in-xyz", in_xyz(rmse))) }
        }
        @if let Some(checks) = &model.checks {
            @let ([x, y, z], [mean_x, mean_y, mean_z]) = (in_xyz(checks.rmse_m), checks.mean_m.map(|mean| fixed(mean, 3)));
            @let plan = ("plan", significant(checks.plan_rmse_m));
            dt { (texts.with("report-rmse-of-checks", [("points", checks.points.to_string())])) }
            dd {
                (texts.with("report-checks", [x, y, z, plan, ("mean_x", mean_x), ("mean_y", mean_y), ("mean_z", mean_z)]))
                @if let Some(crs) = crs { (texts.with("report-along-axes", [("crs", shorten(&crs.name))])) }
                @if let Some(ratio) = checks.ratio { (texts.with("report-ratio-of-checks", [("ratio", fixed(ratio, 2))])) }
            }
        }
    }
}

fn in_xyz([x, y, z]: [f64; 3]) -> [(&'static str, String); 3] {
    [("x", significant(x)), ("y", significant(y)), ("z", significant(z))]
}

/// The name of what says how the block is georeferenced.
fn datum(model: &ModelSummary) -> &'static str {
    match (model.in_system, model.datum) {
        (false, _) => "report-datum-none",
        (true, Datum::Control) => "report-datum-control",
        (true, Datum::GnssAndControl) => "report-datum-gnss-and-control",
        (true, Datum::Gnss | Datum::Free) => "report-datum-gnss",
    }
}

fn truth(texts: &Texts, score: &BlockScore) -> Markup {
    html! {
        dt { (texts.say("report-block-against-truth")) }
        dd {
            (texts.with("report-right-points", [("right", count(score.right_points)), ("points", count(score.points))]))
            @if let Some(rmse) = score.position_rmse_m { (texts.with("report-truth-positions", in_xyz(rmse))) }
            @if let Some(angle) = score.angle_rmse_deg { (texts.with("report-truth-angles", [("angle", significant(angle))])) }
        }
    }
}

/// Warnings about the block, and remarks about what was given for it.
pub(super) fn remarks(subject: &Subject<'_>) -> Markup {
    let (texts, remarks) = (subject.texts, &subject.summary.remarks);
    let warnings = overview_warnings(subject.run);
    html! {
        @if !warnings.is_empty() {
            h2 { (texts.say("report-warnings")) }
            ul { @for warning in &warnings { li { (said(texts, warning)) } } }
        }
        @if !remarks.is_empty() {
            h2 { (texts.say("report-remarks")) }
            ul { @for remark in remarks.iter().take(NAMED) { li { (said(texts, &remark.message)) } } }
            @if remarks.len() > NAMED { p.note { (texts.with("report-more-in-summary", [("number", count(remarks.len() - NAMED))])) } }
        }
    }
}
