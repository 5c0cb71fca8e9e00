//! What the adjustment says of observed positions, in columns: residuals, tests, redundancy numbers, detectable errors and what they do unfound.

use crate::html::{fixed, head, significant};
use crate::{PriorStatistics, Texts};
use maud::{Markup, html};

pub(super) const AXES: [&str; 3] = ["X", "Y", "Z"];

/// The heads of a table whose first columns have these names.
pub(super) fn judged_head(texts: &Texts, first: &[&str]) -> Markup {
    let of = |name: &str, axis: &str| head(texts, &texts.with(name, [("axis", axis.into())]), "m");
    html! {
        thead {
            tr {
                @for name in first { th { (texts.say(name)) } }
                @for axis in AXES { th { (of("report-residual-of", axis)) } }
                @for sign in ["w", "r"] { @for axis in AXES { th { (sign) " " (axis) } } }
                @for axis in AXES { th { (head(texts, &format!("∇ {axis}"), "m")) } }
                @for axis in AXES { th { (of("report-moves", axis)) } }
                th { (texts.say("report-influence")) } th { (texts.say("report-state")) }
            }
        }
    }
}

pub(super) fn judged(prior: &PriorStatistics) -> Markup {
    html! {
        @for k in 0..3 { td { (significant(Some(prior.residual[k]).filter(|_| observed(prior, k)))) } }
        @for k in 0..3 { td { (fixed(prior.w.filter(|_| observed(prior, k)).map(|w| w[k]), 2)) } }
        @for k in 0..3 { td { (fixed(prior.redundancy.filter(|_| observed(prior, k)).map(|r| r[k]), 3)) } }
        @for k in 0..3 { td { (significant(prior.detectable[k])) } }
        @for k in 0..3 { td { (significant(prior.moves[k])) } }
        td { (significant(prior.influence.into_iter().flatten().reduce(f64::max))) }
    }
}

/// Whether a coordinate was observed: what was not has neither residual nor redundancy.
pub(super) fn observed(prior: &PriorStatistics, k: usize) -> bool {
    prior.residual[k] != 0.0 || prior.redundancy.is_some_and(|redundancy| redundancy[k] != 0.0)
}

pub(super) fn largest_w(prior: &PriorStatistics) -> Option<f64> {
    prior.w.map(|w| w.iter().fold(0.0, |most: f64, w| most.max(w.abs())))
}

pub(super) fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}
