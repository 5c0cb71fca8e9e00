//! What reports say in their language: messages as sentences of a page, quantities and names with their units.

use crate::{Message, Texts};

/// The beginning of a part that runs as its first letter does, of one from right to left, and the end of either (Unicode UAX 9).
const FIRST: char = '\u{2068}';
const FROM_RIGHT: char = '\u{2067}';
const END: char = '\u{2069}';

/// The text of a message.
pub(crate) fn said<M: Message>(texts: &Texts, message: &M) -> String {
    flowing(&texts.text(message))
}

/// A value that is written already, with its unit.
pub(crate) fn quantity(texts: &Texts, value: String, unit: &str) -> String {
    texts.with("report-quantity", [("value", value), ("unit", texts.unit(unit))])
}

/// The head of a column, with its unit.
pub(crate) fn head(texts: &Texts, name: &str, unit: &str) -> String {
    texts.with("report-head", [("name", name.into()), ("unit", texts.unit(unit))])
}

/// The name of a row, with its unit.
pub(crate) fn in_unit(texts: &Texts, name: &str, unit: &str) -> String {
    texts.with("report-in-unit", [("name", name.into()), ("unit", texts.unit(unit))])
}

/// Items of a sentence, one after the other.
pub(crate) fn listed(texts: &Texts, items: impl IntoIterator<Item = String>) -> String {
    items.into_iter().collect::<Vec<_>>().join(&texts.say("report-separator"))
}

/// A sentence whose parts are set apart runs as a whole: a value with its error is one part, or both would change places, and a clause, which a space or
/// a comma begins, goes on as the sentence does.
fn flowing(text: &str) -> String {
    let figures = text.replace(&format!("{END}°"), &format!("°{END}")).replace(&format!("{END} ± {FIRST}"), " ± ");
    let clauses = [' ', '،', '؛', ',', ';', ':', '('];
    clauses.into_iter().fold(figures, |text, mark| text.replace(&format!("{FIRST}{mark}"), &format!("{FROM_RIGHT}{mark}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_and_its_error_are_one_part_and_a_clause_is_one_from_right_to_left() {
        assert_eq!(
            flowing("بمقدار \u{2068}0.1\u{2069}° ± \u{2068}0.2\u{2069}°\u{2068}، وω\u{2069}."),
            "بمقدار \u{2068}0.1° ± 0.2°\u{2069}\u{2067}، وω\u{2069}."
        );
        assert_eq!(flowing("by 0.1° ± 0.2°."), "by 0.1° ± 0.2°.");
    }

    #[test]
    fn quantities_have_the_letters_of_the_language() {
        let of = |texts| {
            [quantity(texts, "0.5".into(), "px"), quantity(texts, "0.5".into(), "σ₀"), in_unit(texts, "X₀", "m"), head(texts, "x", "px")]
        };
        assert_eq!(of(Texts::english()), ["0.5 px", "0.5 σ₀", "X₀, m", "x px"]);
        let plain = of(Texts::arabic()).map(|text| text.replace(|c: char| ('\u{2066}'..='\u{2069}').contains(&c), ""));
        assert_eq!(plain, ["0.5 بكسل", "0.5 σ₀", "X₀، م", "x (بكسل)"]);
    }
}
