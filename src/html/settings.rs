//! Every parameter of a run with its value.

use crate::{Parameter, Texts};
use maud::{Markup, html};
use serde::Serialize;
use serde_json::Value;

/// The parameters of `given` settings; the ones that are not as in the `standard` settings are marked.
pub(crate) fn settings_table<S: Serialize>(
    texts: &Texts,
    parameters: impl Iterator<Item = &'static Parameter>,
    given: &S,
    standard: &S,
) -> Markup {
    let json = |settings: &S| serde_json::to_value(settings).expect("settings are plain data");
    let (given, standard) = (json(given), json(standard));
    let value = |from: &Value, key: &str| key.split('.').fold(from.clone(), |at, name| at[name].clone());
    let written = |value: &Value| match value {
        Value::Null => texts.say("report-default"),
        Value::String(word) => word.clone(),
        other => other.to_string(),
    };
    html! {
        table.settings tabindex="0" {
            caption { (texts.say("report-settings")) }
            tbody {
                @for p in parameters {
                    @let (own, usual) = (value(&given, p.key), value(&standard, p.key));
                    tr.changed[own != usual] {
                        th { (texts.option(p.key).as_deref().unwrap_or(p.label)) @if !p.unit.is_empty() { " " small { (texts.unit(p.unit)) } } }
                        td { code { (p.key) } } td { (written(&own)) } td { @if own != usual { (texts.with("report-default-is", [("value", written(&usual))])) } }
                    }
                }
            }
        }
    }
}
