//! What the residuals say of stated standard errors.

use super::super::place_group::PlaceGroup;
use crate::html::{count, fixed, said};
use crate::{ReconstructedModel, Texts, VarianceComponent};
use maud::{Markup, html};

/// Nothing where none are stated.
pub(super) fn components(texts: &Texts, model: &ReconstructedModel) -> Markup {
    let components = &model.adjusted.components;
    if components.is_empty() {
        return html! {};
    }
    let heads = ["report-group", "report-coordinates", "report-redundancy", "report-by-residuals", "report-interval", "report-weights-by"];
    html! {
        h2 { (texts.say("report-stated-errors")) }
        table tabindex="0" {
            thead { tr { @for name in heads { th { (texts.say(name)) } } } }
            tbody {
                @for component in components {
                    tr {
                        th { (name(texts, component, model)) } td { (count(component.observations)) } td { (fixed(component.redundancy, 1)) }
                        td { (fixed(Some(component.factor).filter(|_| !component.held), 2)) }
                        td { @if let Some([low, high]) = component.interval { (fixed(low, 2)) " – " (fixed(high, 2)) } @else { "–" } }
                        td { (texts.say(weighted_by(component))) }
                    }
                }
            }
        }
        p.note {
            (texts.say("report-components-explained"))
            " " (texts.say(if model.adjusted.weighting.is_some() { "report-weights-follow" } else { "report-weights-stated" }))
            @if let Some(weighting) = model.adjusted.weighting {
                " " (texts.with("report-rounds", [("rounds", weighting.rounds.to_string())]))
                @if !weighting.converged { " " (texts.say("report-weights-did-not-converge")) }
            }
        }
    }
}

fn name(texts: &Texts, component: &VarianceComponent, model: &ReconstructedModel) -> String {
    PlaceGroup::of(component.group, &model.surveyed).map_or_else(|| said(texts, &component.group), |group| said(texts, &group))
}

/// The name of what the weights follow.
fn weighted_by(component: &VarianceComponent) -> &'static str {
    match (component.applied, component.held) {
        (true, _) => "report-by-their-residuals",
        (false, true) => "report-by-stated-held",
        (false, false) => "report-by-stated",
    }
}
