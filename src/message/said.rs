//! What is said by name: texts of reports, which are no messages, labels of options, units.

use super::Texts;
use fluent_bundle::FluentArgs;

impl Texts {
    /// The text of a name.
    pub(crate) fn say(&self, name: &str) -> String {
        self.entry(name, None, &FluentArgs::new())
    }

    /// The text of a name with its figures, which are written already.
    pub(crate) fn with<const N: usize>(&self, name: &str, figures: [(&str, String); N]) -> String {
        self.entry(name, None, &FluentArgs::from_iter(figures))
    }

    /// Another text that belongs to a name.
    pub(crate) fn attribute(&self, name: &str, attribute: &str) -> String {
        self.entry(name, Some(attribute), &FluentArgs::new())
    }

    /// A unit in letters of the language; its sign where that has none.
    pub(crate) fn unit(&self, sign: &str) -> String {
        self.known(&format!("unit-{}", sign.replace(' ', "-").replace('µ', "u"))).unwrap_or_else(|| sign.into())
    }

    /// The label of an option by its key; `None` where it is as the option declares it.
    pub(crate) fn option(&self, key: &str) -> Option<String> {
        self.known(&key.replace(['.', '_'], "-"))
    }

    /// What this language alone says by a name.
    fn known(&self, name: &str) -> Option<String> {
        self.has(name, None).then(|| self.say(name))
    }
}
