//! The details of this run: interior orientation, residuals, reliability.

use super::steps::Report;
use super::unknowns::UNKNOWNS;
use super::{figures, picture};
use crate::html::{correlations, count, fixed, head, histogram, in_unit, quantity, said, significant, strokes, typeset};
use crate::{Error, FiducialModel, PhotoInput, PointStatistics, RelativeOrientation, Texts, orient_fiducials};
use maud::{Markup, html};

/// Rows of the tables of single matches.
const ROWS: usize = 15;

/// The interior orientation of each photo by its fiducial marks.
pub fn interior(texts: &Texts, report: &Report) -> Result<Markup, Error> {
    let [left, right] = [&report.input.left, &report.input.right];
    if left.fiducials.is_empty() && right.fiducials.is_empty() {
        let known = report.studies[0].result.interior.is_some();
        return Ok(html! {
            p {
                (texts.say(if known { "report-photo-coordinates" } else { "report-no-photo-coordinates" }))
            }
        });
    }
    let row = |name: &str, photo: &PhotoInput| -> Result<Markup, Error> {
        if photo.fiducials.is_empty() {
            return Ok(html! { tr { th { (texts.say(name)) } td { (texts.say("report-no-marks")) } td {} td {} td {} } });
        }
        let found = orient_fiducials(&photo.fiducials, photo.model)?;
        let largest = found.residuals_mm.iter().map(|[x, y]| (x * x + y * y).sqrt()).fold(0.0, f64::max);
        let model = match photo.model {
            FiducialModel::Affine => "report-affine",
            FiducialModel::Similarity => "report-similarity",
        };
        Ok(html! {
            tr {
                th { (texts.say(name)) } td { (photo.fiducials.len()) } td { (texts.say(model)) }
                td { (quantity(texts, fixed(found.sigma0_mm.map(|s| 1000.0 * s), 1), "µm")) } td { (quantity(texts, fixed(1000.0 * largest, 1), "µm")) }
            }
        })
    };
    Ok(html! {
        table tabindex="0" {
            caption { (texts.say("report-interior-by-marks")) }
            thead {
                tr {
                    th { (texts.say("report-photo")) } th { (texts.say("report-marks")) } th { (texts.say("report-transformation")) } th { "σ₀" }
                    th { (texts.say("report-largest-residual")) }
                }
            }
            tbody { (row("report-left-photo", left)?) (row("report-right-photo", right)?) }
        }
    })
}

/// The y-parallaxes that the adjustment left: over the left image, and as a histogram.
pub fn residuals(texts: &Texts, report: &Report, orientation: &RelativeOrientation) -> Markup {
    let study = &report.studies[0];
    let pixel = study.result.interior.as_ref().map_or(f64::NAN, |interior| interior.left.pixel_mm());
    let matches = &study.result.matching.matches;
    let parallax = |i: usize| orientation.points[i].map_or(f64::NAN, |p| p.parallax_mm / pixel);
    let mut rejected = vec![false; matches.len()];
    orientation.rejected.iter().for_each(|i| rejected[*i] = true);
    let used: Vec<f64> = (0..matches.len()).filter(|i| !rejected[*i]).map(parallax).filter(|v| v.is_finite()).collect();
    let sigma = std::f64::consts::SQRT_2 * study.sigma0_px().unwrap_or(f64::NAN);
    // So long that the standard error of a y-parallax is a hundredth of the image.
    let left = &report.images[0].grey;
    let factor = 0.012 * left.height() as f64 / sigma;
    let drawn = |wanted: bool| {
        let vectors = (0..matches.len()).filter(|i| rejected[*i] == wanted && parallax(*i).is_finite());
        strokes(vectors.map(|i| (matches[i].left_px, [0.0, -factor * parallax(i)])))
    };
    let layers = [picture::Layer { class: "vector", path: drawn(false) }, picture::Layer { class: "vector rejected", path: drawn(true) }];
    let ground = picture::Ground::As("left-image", [left.width(), left.height()]);
    let words = texts.with("report-y-parallaxes-of", [("matches", count(used.len())), ("sigma", fixed(sigma, 3))]);
    html! {
        div.pair {
            figure {
                (picture::picture(&ground, &layers, &texts.say("report-y-parallaxes")))
                figcaption { (texts.with("report-y-parallaxes-enlarged", [("factor", fixed(factor, 0))])) }
            }
            (histogram(texts, &used, 4.0 * sigma, "px", &words))
        }
    }
}

/// How well blunders would be found, and what they could do unfound.
pub fn reliability(texts: &Texts, report: &Report, orientation: &RelativeOrientation) -> Markup {
    let pixel = report.studies[0].result.interior.as_ref().map_or(f64::NAN, |interior| interior.left.pixel_mm());
    let used = |p: &&PointStatistics| p.weight > 0.0;
    let column = |of: fn(&PointStatistics) -> f64| {
        let mut values: Vec<f64> = orientation.points.iter().flatten().filter(used).map(of).filter(|v| v.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values.get(((values.len() as f64 - 1.0) * share).max(0.0) as usize).copied();
        [at(0.0), at(0.5), at(1.0)]
    };
    let rows: [(String, [Option<f64>; 3], usize, f64); 4] = [
        (texts.say("report-redundancy-number"), column(|p| p.redundancy), 4, 1.0),
        (in_unit(texts, &texts.say("report-detectable-blunder"), "px"), column(|p| p.detectable_mm), 3, 1.0 / pixel),
        (texts.say("report-external"), column(|p| p.influence), 3, 1.0),
        (texts.say("report-weight"), column(|p| p.weight), 2, 1.0),
    ];
    let options = &report.settings.orientation;
    html! {
        table tabindex="0" {
            caption { (texts.with("report-reliability-of", [("alpha0", options.alpha0.to_string()), ("beta0", options.beta0.to_string())])) }
            thead { tr { td {} @for name in ["report-least", "report-median", "report-largest"] { th { (texts.say(name)) } } } }
            tbody { @for (name, values, digits, scale) in rows { tr { th { (name) } @for value in values { td { (fixed(value.map(|v| v * scale), digits)) } } } } }
        }
        p.note { (texts.say("report-reliability-of-pair")) }
        (extremes(texts, report, orientation, "report-largest-w", pixel, |p| p.w.abs()))
        (extremes(texts, report, orientation, "report-most-unfound", pixel, |p| if p.weight > 0.0 { p.influence } else { 0.0 }))
    }
}

/// The matches for which a figure is largest, under the title of this name.
fn extremes(
    texts: &Texts,
    report: &Report,
    orientation: &RelativeOrientation,
    title: &str,
    pixel: f64,
    of: fn(&PointStatistics) -> f64,
) -> Markup {
    let study = &report.studies[0];
    let mut listed: Vec<(usize, &PointStatistics)> =
        orientation.points.iter().enumerate().filter_map(|(i, p)| Some((i, p.as_ref()?))).collect();
    listed.sort_by(|a, b| of(b.1).total_cmp(&of(a.1)).then(a.0.cmp(&b.0)));
    html! {
        table tabindex="0" {
            caption { (texts.say(title)) }
            thead {
                tr {
                    th { (texts.say("report-match")) } th { (head(texts, "x", "px")) } th { (head(texts, "y", "px")) }
                    th { (head(texts, &texts.say("report-y-parallax"), "px")) } th { "r" } th { "w" } th { (head(texts, "∇", "px")) } th { "δ" }
                    th { (texts.say("report-state")) }
                }
            }
            tbody {
                @for (i, p) in listed.into_iter().take(ROWS) {
                    @let [x, y] = study.result.matching.matches[i].left_px;
                    tr {
                        th { (i + 1) } td { (fixed(x, 1)) } td { (fixed(y, 1)) } td { (fixed(p.parallax_mm / pixel, 3)) } td { (fixed(p.redundancy, 4)) }
                        td { (fixed(p.w, 2)) } td { (fixed(p.detectable_mm / pixel, 3)) } td { (fixed(p.influence, 3)) }
                        td { (texts.say(if p.weight > 0.0 { "report-state-used" } else { "report-state-gross-error" })) }
                    }
                }
            }
        }
    }
}

/// The figures of the adjustment as a whole, and its pictures.
pub fn precision(texts: &Texts, report: &Report, orientation: &RelativeOrientation) -> Markup {
    let study = &report.studies[0];
    let base_errors = study.errors.map(|e| [e[3], e[4]]).filter(|e| e.iter().all(|v| v.is_finite()));
    let sigma0 = [("um", significant(orientation.sigma0_mm.map(|s| 1000.0 * s))), ("px", fixed(study.sigma0_px(), 3))];
    html! {
        dl {
            dt { (texts.say("report-sigma-of-coordinate")) } dd { (texts.with("report-sigma-value", sigma0)) }
            dt { (texts.say("report-degrees-of-freedom")) } dd { (count(orientation.degrees_of_freedom)) }
            dt { (texts.say("report-matches-used")) }
            dd { (texts.with("report-of", [("part", count(study.used().unwrap_or(0))), ("all", count(study.result.matching.matches.len()))])) }
            @if let Some(ellipse) = &orientation.base_ellipse_95_mm {
                @let axes = format!("{} × {}", significant(ellipse.semi_major), significant(ellipse.semi_minor));
                dt { (texts.say("report-base-together")) } dd { (texts.with("report-ellipse-of", [("axes", axes)])) }
            }
            dt { (texts.say("report-condition")) } dd { (fixed(orientation.condition, 0)) }
            dt { (texts.say("report-plane-misfit")) } dd { (quantity(texts, fixed(orientation.plane_misfit, 1), "σ₀")) }
            dt { (texts.say("report-parallax-beside")) } dd { (quantity(texts, significant(orientation.parallax_beside_rotation_mm), "mm")) }
            @if let Some(test) = &orientation.global_test {
                @let name = if test.passed { "report-global-passed" } else { "report-global-failed" };
                @let figures = [("statistic", fixed(test.statistic, 1)), ("lower", fixed(test.lower, 1)), ("upper", fixed(test.upper, 1))];
                dt { (texts.say("report-global-test")) } dd { (texts.with(name, figures)) }
            }
            @if orientation.turn_deg != 0.0 { dt { (texts.say("report-axes")) } dd { (texts.say("report-axes-turned")) } }
            @for warning in &orientation.warnings { dt { (texts.say("report-warning")) } dd { (typeset(&said(texts, warning))) } }
        }
        p.note { (texts.say("report-sigma-from-parallaxes")) }
        div.pair {
            (correlations(&UNKNOWNS.map(|(symbol, _)| symbol), &orientation.correlations, &texts.say("report-correlations")))
            @if let Some(ellipse) = &orientation.base_ellipse_mm { (figures::ellipse(texts, ellipse, orientation.base_ellipse_95_mm.as_ref(), base_errors)) }
        }
    }
}
