//! Cameras: given and calibrated values, standard errors, correlations, residual fields.

use super::field::field;
use super::subject::{Subject, WORST};
use crate::html::{correlations, count, significant, with_error};
use crate::text::shorten;
use crate::{Camera, CameraStatistics, ReconstructedModel, Texts};
use maud::{Markup, html};

/// Symbols and units, in the order of the standard errors.
const PARAMETERS: [(&str, &str); 8] = [("c", "px"), ("x₀", "px"), ("y₀", "px"), ("k₁", ""), ("k₂", ""), ("k₃", ""), ("p₁", ""), ("p₂", "")];

/// The cameras with most images first.
pub(super) fn cameras(subject: &Subject<'_>, model: &ReconstructedModel) -> Markup {
    let texts = subject.texts;
    let images = |camera: usize| model.adjusted.block.images.iter().filter(|image| image.camera == camera).count();
    let mut listed: Vec<(usize, usize)> = (0..model.cameras.len()).map(|camera| (camera, images(camera))).collect();
    listed.sort_by_key(|(camera, images)| (std::cmp::Reverse(*images), *camera));
    html! {
        h2 { (texts.say("report-cameras")) }
        @for (camera, images) in listed.iter().take(WORST) { (one(subject, model, *camera, *images)) }
        @if listed.len() > WORST { p.note { (texts.with("report-more-cameras", [("number", count(listed.len() - WORST))])) } }
    }
}

fn one(subject: &Subject<'_>, model: &ReconstructedModel, camera: usize, images: usize) -> Markup {
    let (texts, place) = (subject.texts, model.cameras[camera]);
    let Some(initial) = subject.run.cameras.get(place) else { return html! {} };
    let calibrated = values(&model.adjusted.block.cameras[camera]);
    let given = initial.known().map(|camera| values(&camera));
    let statistics = &model.adjusted.cameras[camera];
    let factors = subject.factors_95();
    let estimated: Vec<&str> =
        PARAMETERS.iter().zip(&statistics.standard_errors).filter_map(|((symbol, _), error)| error.map(|_| *symbol)).collect();
    let title = [
        ("number", (place + 1).to_string()),
        ("label", shorten(&initial.label)),
        ("images", count(images)),
        ("size", format!("{} × {}", initial.width_px, initial.height_px)),
    ];
    html! {
        h3 { (texts.with("report-camera", title)) }
        table tabindex="0" {
            thead {
                tr {
                    td {} @for name in ["report-given", "report-calibrated", "report-standard-error"] { th { (texts.say(name)) } }
                    th { "95 %: ±" } th { (texts.say("report-state")) }
                }
            }
            tbody {
                @for (k, (symbol, unit)) in PARAMETERS.into_iter().enumerate() {
                    @let error = statistics.standard_errors[k];
                    tr {
                        th { i { (symbol) } @if !unit.is_empty() { " " small { (texts.unit(unit)) } } }
                        td { (given.map_or_else(|| "–".into(), |given| with_error(given[k], None))) }
                        td { (with_error(calibrated[k], error)) }
                        td { (significant(error)) }
                        td { (significant(error.zip(factors).map(|(error, factors)| factors.interval * error))) }
                        td.words { (state(texts, statistics, k)) }
                    }
                }
            }
        }
        div.pair {
            (field(texts, &model.adjusted, camera))
            @if estimated.len() > 1 && statistics.correlations.len() == estimated.len() {
                (correlations(&estimated, &statistics.correlations, &texts.say("report-parameter-correlations")))
            }
        }
    }
}

/// Why a parameter has no standard error.
fn state(texts: &Texts, statistics: &CameraStatistics, k: usize) -> String {
    let fixed = statistics.fixed.iter().find(|fixed| fixed.parameter.place() == k);
    match (fixed, statistics.standard_errors[k]) {
        (Some(fixed), _) => match fixed.effect_px {
            Some(effect) => texts.with("report-not-determined-by", [("effect", significant(effect))]),
            None => texts.say("report-not-determined"),
        },
        (None, None) => texts.say("report-not-estimated"),
        (None, Some(_)) => String::new(),
    }
}

fn values(camera: &Camera) -> [f64; 8] {
    let [x, y] = camera.principal_point_px;
    let ([k1, k2, k3], [p1, p2]) = (camera.radial, camera.tangential);
    [camera.focal_px, x, y, k1, k2, k3, p1, p2]
}
