//! The details of this run: interior orientation, residuals, reliability.

use super::steps::Report;
use super::unknowns::UNKNOWNS;
use super::{figures, picture};
use crate::html::{correlations, count, fixed, histogram, significant, strokes, typeset};
use crate::{Error, FiducialModel, PhotoInput, PointStatistics, RelativeOrientation, orient_fiducials};
use maud::{Markup, html};

/// Rows of the tables of single matches.
const ROWS: usize = 15;

/// The interior orientation of each photo by its fiducial marks.
pub fn interior(report: &Report) -> Result<Markup, Error> {
    let [left, right] = [&report.input.left, &report.input.right];
    if left.fiducials.is_empty() && right.fiducials.is_empty() {
        let known = report.studies[0].result.interior.is_some();
        return Ok(html! {
            p {
                @if known { "No fiducial marks: photo coordinates follow from the pixel size." }
                @else { "Neither fiducial marks nor a camera with its pixel size is known: there are no photo coordinates." }
            }
        });
    }
    let row = |name: &str, photo: &PhotoInput| -> Result<Markup, Error> {
        if photo.fiducials.is_empty() {
            return Ok(html! { tr { th { (name) } td { "no marks" } td {} td {} td {} } });
        }
        let found = orient_fiducials(&photo.fiducials, photo.model)?;
        let largest = found.residuals_mm.iter().map(|[x, y]| (x * x + y * y).sqrt()).fold(0.0, f64::max);
        let model = match photo.model {
            FiducialModel::Affine => "affine",
            FiducialModel::Similarity => "similarity",
        };
        Ok(html! {
            tr {
                th { (name) } td { (photo.fiducials.len()) } td { (model) }
                td { (fixed(found.sigma0_mm.map(|s| 1000.0 * s), 1)) " µm" } td { (fixed(1000.0 * largest, 1)) " µm" }
            }
        })
    };
    Ok(html! {
        table tabindex="0" {
            caption { "Interior orientation by fiducial marks" }
            thead { tr { th { "Photo" } th { "Marks" } th { "Transformation" } th { "σ₀" } th { "Largest residual" } } }
            tbody { (row("left", left)?) (row("right", right)?) }
        }
    })
}

/// The y-parallaxes that the adjustment left: over the left image, and as a histogram.
pub fn residuals(report: &Report, orientation: &RelativeOrientation) -> Markup {
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
    html! {
        div.pair {
            figure {
                (picture::picture(&picture::Ground::As("left-image", [left.width(), left.height()]), &layers, "Residual y-parallaxes over the left image"))
                figcaption { "Residual y-parallaxes, " (fixed(factor, 0)) " times enlarged; rejected ones in orange" }
            }
            (histogram(&used, 4.0 * sigma, "px", &format!("y-parallaxes of the {} matches used; their standard error is {} px", count(used.len()), fixed(sigma, 3))))
        }
    }
}

/// How well blunders would be found, and what they could do unfound.
pub fn reliability(report: &Report, orientation: &RelativeOrientation) -> Markup {
    let pixel = report.studies[0].result.interior.as_ref().map_or(f64::NAN, |interior| interior.left.pixel_mm());
    let used = |p: &&PointStatistics| p.weight > 0.0;
    let column = |of: fn(&PointStatistics) -> f64| {
        let mut values: Vec<f64> = orientation.points.iter().flatten().filter(used).map(of).filter(|v| v.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values.get(((values.len() as f64 - 1.0) * share).max(0.0) as usize).copied();
        [at(0.0), at(0.5), at(1.0)]
    };
    let rows: [(&str, [Option<f64>; 3], usize, f64); 4] = [
        ("redundancy number r", column(|p| p.redundancy), 4, 1.0),
        ("minimal detectable blunder, px", column(|p| p.detectable_mm), 3, 1.0 / pixel),
        ("external reliability δ", column(|p| p.influence), 3, 1.0),
        ("weight", column(|p| p.weight), 2, 1.0),
    ];
    let options = &report.settings.orientation;
    html! {
        table tabindex="0" {
            caption { "Reliability of the matches used (α₀ " (options.alpha0) ", β₀ " (options.beta0) ")" }
            thead { tr { td {} th { "least" } th { "median" } th { "largest" } } }
            tbody { @for (name, values, digits, scale) in rows { tr { th { (name) } @for value in values { td { (fixed(value.map(|v| v * scale), digits)) } } } } }
        }
        p.note {
            "r is the share of an error that shows in the residual. A blunder of the detectable size is found with the probability β₀; one that is not "
            "found changes no unknown by more than δ of its standard errors."
        }
        (extremes(report, orientation, "The largest standardised residuals w", pixel, |p| p.w.abs()))
        (extremes(report, orientation, "The matches that could do most unfound", pixel, |p| if p.weight > 0.0 { p.influence } else { 0.0 }))
    }
}

/// The matches for which a figure is largest.
fn extremes(report: &Report, orientation: &RelativeOrientation, title: &str, pixel: f64, of: fn(&PointStatistics) -> f64) -> Markup {
    let study = &report.studies[0];
    let mut listed: Vec<(usize, &PointStatistics)> =
        orientation.points.iter().enumerate().filter_map(|(i, p)| Some((i, p.as_ref()?))).collect();
    listed.sort_by(|a, b| of(b.1).total_cmp(&of(a.1)).then(a.0.cmp(&b.0)));
    html! {
        table tabindex="0" {
            caption { (title) }
            thead { tr { th { "Match" } th { "x px" } th { "y px" } th { "y-parallax px" } th { "r" } th { "w" } th { "∇ px" } th { "δ" } th { "state" } } }
            tbody {
                @for (i, p) in listed.into_iter().take(ROWS) {
                    @let [x, y] = study.result.matching.matches[i].left_px;
                    tr {
                        th { (i + 1) } td { (fixed(x, 1)) } td { (fixed(y, 1)) } td { (fixed(p.parallax_mm / pixel, 3)) } td { (fixed(p.redundancy, 4)) }
                        td { (fixed(p.w, 2)) } td { (fixed(p.detectable_mm / pixel, 3)) } td { (fixed(p.influence, 3)) }
                        td { (if p.weight > 0.0 { "used" } else { "gross error" }) }
                    }
                }
            }
        }
    }
}

/// The figures of the adjustment as a whole, and its pictures.
pub fn precision(report: &Report, orientation: &RelativeOrientation) -> Markup {
    let study = &report.studies[0];
    let base_errors = study.errors.map(|e| [e[3], e[4]]).filter(|e| e.iter().all(|v| v.is_finite()));
    html! {
        dl {
            dt { "σ₀ of a photo coordinate" } dd { (significant(orientation.sigma0_mm.map(|s| 1000.0 * s))) " µm = " (fixed(study.sigma0_px(), 3)) " px" }
            dt { "Degrees of freedom" } dd { (count(orientation.degrees_of_freedom)) }
            dt { "Matches used" } dd { (count(study.used())) " of " (count(study.result.matching.matches.len())) }
            @if let Some(ellipse) = &orientation.base_ellipse_95_mm {
                dt { "by and bz together, 95 %" }
                dd { "ellipse of " (significant(ellipse.semi_major)) " × " (significant(ellipse.semi_minor)) " mm" }
            }
            dt { "Condition" } dd { (fixed(orientation.condition, 0)) }
            dt { "Misfit to a plane" } dd { (fixed(orientation.plane_misfit, 1)) " σ₀" }
            dt { "Parallax beside a rotation" } dd { (significant(orientation.parallax_beside_rotation_mm)) " mm" }
            @if let Some(test) = &orientation.global_test {
                dt { "Global test" }
                dd { (fixed(test.statistic, 1)) ", expected between " (fixed(test.lower, 1)) " and " (fixed(test.upper, 1)) ": " (if test.passed { "passed" } else { "failed" }) }
            }
            @if orientation.turn_deg != 0.0 { dt { "Axes" } dd { "turned by 90°: x points up in the left image" } }
            @for warning in &orientation.warnings { dt { "Warning" } dd { (typeset(&warning.to_string())) } }
        }
        p.note { "σ₀ is computed from y-parallaxes: a wrong match along its epipolar line leaves it unchanged." }
        div.pair {
            (correlations(&UNKNOWNS.map(|(symbol, _)| symbol), &orientation.correlations, "Correlations of the unknowns"))
            @if let Some(ellipse) = &orientation.base_ellipse_mm { (figures::ellipse(ellipse, base_errors)) }
        }
    }
}
