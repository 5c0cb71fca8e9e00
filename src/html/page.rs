//! A page that holds all it needs: one style, no script, nothing loaded.

use crate::Texts;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// Whatever names and texts a report quotes: it runs no script and loads nothing.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// A report under its title, in the language of its texts.
pub(crate) fn page(texts: &Texts, title: &str, content: &Markup) -> Markup {
    let from_right = Some(texts.attribute("report-language", "direction")).filter(|direction| direction == "rtl");
    html! {
        (DOCTYPE)
        html lang=(texts.say("report-language")) dir=[&from_right] {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style {
                    (PreEscaped(include_str!("style.css")))
                    @if from_right.is_some() { (PreEscaped(include_str!("from-right.css"))) }
                }
            }
            body {
                main {
                    h1 { (title) }
                    (content)
                }
            }
        }
    }
}

/// What ends a report.
pub(crate) fn footer(texts: &Texts) -> Markup {
    html! { footer { (texts.with("report-footer", [("version", env!("CARGO_PKG_VERSION").into())])) } }
}
